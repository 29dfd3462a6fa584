#include "core/repair/describe.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/repair/limits.h"
#include "core/valve/annulus_frame.h"
#include "core/valve/counted.h"
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

/// What steps are described by. Leaflet coordinates, if they are not at hand, are made once, and only for steps that need them.
class Anatomy {
 public:
  Anatomy(const Valve& of, const LeafletCoordinates* coordinates)
      : valve(of), coordinates_(coordinates) {}

  std::string segment(const LeafletPoint& point) {
    if (coordinates_ == nullptr) coordinates_ = &own_.emplace(leaflet_coordinates(valve));
    return words(valve.segments[locate(valve, *coordinates_, point).face]);
  }

  std::string place(const LeafletPoint& point) {
    const std::string segment = this->segment(point);
    if (point.height >= kFreeEdge) return "the free edge of " + segment;
    return segment + " at " + std::to_string(static_cast<int>(100.0 * point.height + 0.5)) +
           " % of its height";
  }

  /// Of the posterior free edge before a place and after it: "between P1 and P2", "in P2".
  std::string either_side(double along) {
    constexpr double kBeside = 0.04;
    const std::string before = segment({Leaflet::Posterior, along - kBeside, 1.0});
    const std::string after = segment({Leaflet::Posterior, along + kBeside, 1.0});
    return before == after ? "in " + before : "between " + before + " and " + after;
  }

  const Valve& valve;

 private:
  const LeafletCoordinates* coordinates_;
  std::optional<LeafletCoordinates> own_;
};

std::string words(Anatomy& anatomy, const Annuloplasty& step) {
  if (const auto* ring = std::get_if<CatalogueRing>(&step.ring))
    return "annuloplasty: " + ring->shape + " ring, size " + shown(ring->size_mm) + " mm";
  if (const auto* ring = std::get_if<DesignedRing>(&step.ring))
    return "annuloplasty: designed ring " + ring->shape.name + ", size " + shown(ring->size_mm) +
           " mm";
  const int below = std::get<OwnRing>(step.ring).sizes_below;
  const double transverse = transverse_diameter_mm(anatomy.valve);
  if (below == 0)
    return "annuloplasty: ring in the annulus's own shape and size (transverse " +
           with_decimals(transverse, 1) + " mm)";
  return "annuloplasty: ring in the annulus's own shape, " +
         undersizing_words(std::get<OwnRing>(step.ring)) + " (transverse " +
         with_decimals(transverse, 1) + " to " +
         with_decimals(transverse - kRingSizeStep_mm * below, 1) + " mm)";
}

std::string words(Anatomy& anatomy, const Neochorda& step) {
  return "neochorda " + shown(step.length_mm) + " mm from " + step.head + " to " +
         anatomy.place(step.insertion);
}

std::string words(Anatomy&, const ChordalLengthChange& step) {
  const bool shorter = step.change_mm < 0.0;
  return std::string(shorter ? "shorten" : "lengthen") + " chorda " + step.chorda + " by " +
         shown(shorter ? -step.change_mm : step.change_mm) + " mm";
}

std::string words(Anatomy&, const ChordalExcision& step) { return "excise chorda " + step.chorda; }

std::string words(Anatomy& anatomy, const ChordalTransfer& step) {
  return "transfer chorda " + step.chorda + " to " + anatomy.place(step.insertion);
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

std::string words(Anatomy&, const PapillaryApproximation& step) {
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
  return std::string("papillary relocation: ") + to_string(step.side) + " muscle to " + anchor +
         ", suture " + shown(step.suture_length_mm) + " mm";
}

std::string words(Anatomy& anatomy, const LeafletResection& step) {
  const std::string middle = anatomy.place({step.leaflet, step.along, 1.0});
  const std::string cut = std::string(to_string(step.shape)) + " resection at " + middle + ", " +
                          shown(step.width_mm) + " mm wide";
  if (step.shape == ResectionShape::Triangular)
    return cut + ", over " + std::to_string(static_cast<int>(100.0 * step.height + 0.5)) +
           " % of the height";
  return cut + (step.sliding ? ", with sliding plasty" : ", with plication of the annulus");
}

std::string words(Anatomy& anatomy, const EdgeToEdge& step) {
  if (step.device == EdgeDevice::CleftSuture)
    return "suture of the cleft " + anatomy.either_side(step.along) + ", " + shown(step.width_mm) +
           " mm from its root";
  const std::string tied = std::string("edge-to-edge ") + to_string(step.device) + ", " +
                           shown(step.width_mm) + " mm wide, " +
                           anatomy.place({Leaflet::Anterior, step.along, 1.0}) + " to " +
                           anatomy.place({Leaflet::Posterior, step.along, 1.0});
  if (step.device != EdgeDevice::Clip) return tied;
  return tied + ", " + shown(step.grasp_mm) + " mm of each leaflet grasped, annulus reduced by " +
         shown(step.annulus_drawn_in_percent) + " %";
}

}  // namespace

std::vector<std::string> describe(const Valve& valve, const RepairPlan& plan,
                                  const LeafletCoordinates* coordinates) {
  Anatomy anatomy(valve, coordinates);
  std::vector<std::string> lines;
  for (const RepairStep& step : plan.steps)
    lines.push_back(std::visit([&anatomy](const auto& s) { return words(anatomy, s); }, step));
  return lines;
}

std::string undersizing_words(const OwnRing& ring) {
  return ring.sizes_below == 0 ? "not undersized"
                               : "undersized by " + counted(ring.sizes_below, "size");
}

}  // namespace coapt
