// The two drawings of a closed valve that pictures are composed of.
#pragma once

#include "core/closed/closed_valve.h"
#include "io/picture/canvas.h"

namespace coapt {

struct ViewFrame {
  Box box;
  double pixels_per_mm = 12.0;
};

/// As the surgeon sees it: anterior up, anterolateral left. Orifices in blue with their areas.
void draw_atrial_view(const Canvas& canvas, const ViewFrame& frame, const ClosedValve& closed);

/// Of an open valve; `words` are its area.
struct OpenPassage {
  std::vector<Vec3> outline_mm;  ///< closed; empty: it is not known
  std::string words;
};

/// A valve in diastole, alike: the outline of its narrowest passage over it.
void draw_open_atrial_view(const Canvas& canvas, const ViewFrame& frame, const ClosedValve& open,
                           const OpenPassage& passage);

/// Long-axis section through the saddle peak and mid-posterior: atrium up, anterior left. Leaflets of
/// `before` stand behind in grey, cut by the same plane.
void draw_section_view(const Canvas& canvas, const ViewFrame& frame, const ClosedValve& closed,
                       const ClosedValve* before = nullptr);

/// Of a valve in diastole, alike: where the plane meets its narrowest passage, that line.
void draw_open_section_view(const Canvas& canvas, const ViewFrame& frame, const ClosedValve& open,
                            const std::vector<Vec3>& passage_mm);

/// The largest scales at which the annulus with its labels, and the section down to the papillary
/// tips, fit into a box.
double atrial_scale(const Box& box, const ClosedValve& closed);
double section_scale(const Box& box, const ClosedValve& closed);

/// 10 mm, in the lower left corner.
void draw_scale_bar(const Canvas& canvas, const ViewFrame& frame);

/// Said in place of a drawing that would need points that are not there.
void draw_unknown(const Canvas& canvas, const ViewFrame& frame);

}  // namespace coapt
