#include "core/repair/plan.h"

namespace coapt {

std::string shape_of(const Annuloplasty& step) {
  if (const auto* ring = std::get_if<CatalogueRing>(&step.ring)) return ring->shape;
  if (const auto* ring = std::get_if<DesignedRing>(&step.ring)) return ring->shape.name;
  return kOwnShape;
}

Vec3 anchor_mm(const Valve& valve, const PapillaryApproximation& step) {
  const Landmarks& marks = valve.landmarks;
  switch (step.anchor) {
    case Anchor::IpsilateralTrigone:
      return annulus_position_mm(valve, step.side == Side::Anterolateral
                                            ? marks.anterolateral_trigone
                                            : marks.posteromedial_trigone);
    case Anchor::SaddlePeak:
      return annulus_position_mm(valve, marks.saddle_peak);
    case Anchor::AnnulusPoint:
      return annulus_point_mm(valve, step.annulus_around);
  }
  return Vec3::Zero();
}

const char* to_string(Anchor anchor) {
  switch (anchor) {
    case Anchor::IpsilateralTrigone:
      return "ipsilateral_trigone";
    case Anchor::SaddlePeak:
      return "saddle_peak";
    case Anchor::AnnulusPoint:
      return "annulus_point";
  }
  return "";
}

const char* to_string(ResectionShape shape) {
  return shape == ResectionShape::Triangular ? "triangular" : "quadrangular";
}

const char* to_string(EdgeDevice device) {
  switch (device) {
    case EdgeDevice::Stitch:
      return "stitch";
    case EdgeDevice::Clip:
      return "clip";
    case EdgeDevice::CleftSuture:
      return "cleft_suture";
  }
  return "";
}

}  // namespace coapt
