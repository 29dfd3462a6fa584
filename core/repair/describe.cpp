#include "core/repair/describe.h"

#include <algorithm>
#include <array>

#include "core/repair/limits.h"
#include "core/valve/annulus_frame.h"
#include "core/valve/number_text.h"

namespace coapt {
namespace {

constexpr double kFreeEdge = 0.95;  // heights from here on are called the free edge

std::string words(Segment segment) {
  switch (segment) {
    case Segment::AC:
      return "the anterolateral commissure";
    case Segment::PC:
      return "the posteromedial commissure";
    case Segment::A1:
    case Segment::A2:
    case Segment::A3:
    case Segment::P1:
    case Segment::P2:
    case Segment::P3:
      return to_string(segment);
  }
  return "";
}

std::string place(const Valve& valve, const LeafletPoint& point) {
  const Insertion insertion = locate(valve, leaflet_coordinates(valve), point);
  const std::string segment = words(valve.segments[insertion.face]);
  if (point.height >= kFreeEdge) return "the free edge of " + segment;
  return segment + " at " + std::to_string(static_cast<int>(100.0 * point.height + 0.5)) +
         " % of its height";
}

std::string words(const Valve& valve, const Annuloplasty& step) {
  if (const auto* ring = std::get_if<CatalogueRing>(&step.ring))
    return "annuloplasty: " + ring->shape + " ring, size " + shown(ring->size_mm) + " mm";
  if (const auto* ring = std::get_if<DesignedRing>(&step.ring))
    return "annuloplasty: designed ring " + ring->shape.name + ", size " + shown(ring->size_mm) +
           " mm";
  const int below = std::get<OwnRing>(step.ring).sizes_below;
  const double transverse = transverse_diameter_mm(valve);
  if (below == 0)
    return "annuloplasty: ring in the annulus's own shape and size (transverse " +
           with_decimals(transverse, 1) + " mm)";
  return "annuloplasty: ring in the annulus's own shape, undersized by " + std::to_string(below) +
         (below == 1 ? " size" : " sizes") + " (transverse " + with_decimals(transverse, 1) +
         " to " + with_decimals(transverse - kRingSizeStep_mm * below, 1) + " mm)";
}

std::string words(const Valve& valve, const Neochorda& step) {
  return "neochorda " + shown(step.length_mm) + " mm from " + step.head + " to " +
         place(valve, step.insertion);
}

std::string words(const Valve&, const ChordalLengthChange& step) {
  const bool shorter = step.change_mm < 0.0;
  return std::string(shorter ? "shorten" : "lengthen") + " chorda " + step.chorda + " by " +
         shown(shorter ? -step.change_mm : step.change_mm) + " mm";
}

std::string words(const Valve&, const ChordalExcision& step) {
  return "excise chorda " + step.chorda;
}

std::string words(const Valve& valve, const ChordalTransfer& step) {
  return "transfer chorda " + step.chorda + " to " + place(valve, step.insertion);
}

/// "the annulus, 30 % of the way from the anterolateral commissure to mid-posterior".
std::string annulus_place(double around) {
  static constexpr std::array kLandmarks = {"the posteromedial commissure", "the saddle peak",
                                            "the anterolateral commissure", "mid-posterior"};
  const double quarters = 4.0 * std::clamp(around, 0.0, 1.0);
  const std::size_t from = std::min<std::size_t>(static_cast<std::size_t>(quarters), 3);
  const int percent = static_cast<int>(100.0 * (quarters - static_cast<double>(from)) + 0.5);
  const std::size_t to = (from + 1) % kLandmarks.size();
  if (percent == 0) return std::string("the annulus at ") + kLandmarks[from];
  if (percent == 100) return std::string("the annulus at ") + kLandmarks[to];
  return "the annulus, " + std::to_string(percent) + " % of the way from " + kLandmarks[from] +
         " to " + kLandmarks[to];
}

std::string words(const Valve&, const PapillaryApproximation& step) {
  std::string anchor;
  switch (step.anchor) {
    case Anchor::IpsilateralTrigone:
      anchor = "its trigone";
      break;
    case Anchor::SaddlePeak:
      anchor = "the saddle peak";
      break;
    case Anchor::AnnulusPoint:
      anchor = annulus_place(step.annulus_around);
      break;
  }
  return std::string("papillary approximation: ") + to_string(step.side) + " muscle to " + anchor +
         ", suture " + shown(step.suture_length_mm) + " mm";
}

std::string words(const Valve& valve, const LeafletResection& step) {
  const std::string middle = place(valve, {step.leaflet, step.along, 1.0});
  const std::string cut = std::string(to_string(step.shape)) + " resection at " + middle + ", " +
                          shown(step.width_mm) + " mm wide";
  if (step.shape == ResectionShape::Triangular)
    return cut + ", over " + std::to_string(static_cast<int>(100.0 * step.height + 0.5)) +
           " % of the height";
  return cut + (step.sliding ? ", with sliding plasty" : ", with plication of the annulus");
}

std::string words(const Valve& valve, const EdgeToEdge& step) {
  const std::string tied = std::string("edge-to-edge ") + to_string(step.device) + ", " +
                           shown(step.width_mm) + " mm wide, " +
                           place(valve, {Leaflet::Anterior, step.along, 1.0}) + " to " +
                           place(valve, {Leaflet::Posterior, step.along, 1.0});
  if (step.device == EdgeDevice::Stitch) return tied;
  return tied + ", " + shown(step.grasp_mm) + " mm of each leaflet grasped, annulus reduced by " +
         shown(step.annulus_drawn_in_percent) + " %";
}

}  // namespace

std::vector<std::string> describe(const Valve& valve, const RepairPlan& plan) {
  std::vector<std::string> lines;
  for (const RepairStep& step : plan.steps)
    lines.push_back(std::visit([&valve](const auto& s) { return words(valve, s); }, step));
  return lines;
}

}  // namespace coapt
