#pragma once

#include <string>
#include <vector>

#include "core/closed/closed_valve.h"
#include "io/picture/view_frame.h"

namespace coapt {

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

/// The largest scale at which the annulus with its labels fits into a box.
double atrial_scale(const Box& box, const ClosedValve& closed);

}  // namespace coapt
