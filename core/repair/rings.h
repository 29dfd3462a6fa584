// The catalogue of ring shapes, and the contour of a ring.
#pragma once

#include <array>
#include <string_view>

#include "core/valve/valve.h"

namespace coapt {

/// A ring's shape as shares of its transverse size; generic, not a manufacturer's.
struct RingShape {
  std::string_view name;
  double ap_over_transverse = 0.75;
  double transverse_factor = 1.0;       ///< true transverse width over labelled size
  double saddle_over_transverse = 0.0;  ///< height of the saddle
  std::string_view note;
};

inline constexpr std::array<RingShape, 3> kRingShapes = {{
    {"generic-classic", 0.75, 1.0, 0.0, "flat, 3 : 4, like most rings for degenerative disease"},
    {"generic-etlogix-like", 0.68, 1.0, 0.0,
     "flat, shortened anteroposteriorly, like rings for ischaemic disease; its asymmetry at P3 is "
     "not "
     "modelled"},
    {"generic-geoform-like", 0.51, 1.12, 0.0,
     "markedly shortened anteroposteriorly, 12 % wider than its label, like rings for dilated "
     "ventricles; its posterior elevation is not modelled"},
}};

/// The shape of this name, or null.
const RingShape* find_ring(std::string_view name);

/// True transverse width of a catalogue ring.
double ring_width_mm(const RingShape& ring, double size_mm);

/// 720 points, counter-clockwise from the posteromedial end: x posteromedial, y anterior, z atrial.
/// The generic annulus contour with the ring's width, depth (ap_over_transverse of the width) and
/// saddle: an assumption that stands for any closed, rigid ring; no manufacturer's drawing.
Points ring_contour_mm(const RingShape& ring, double size_mm);

}  // namespace coapt
