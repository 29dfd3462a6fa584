#include <cstdio>

#include "core/repair/apply_plan.h"
#include "core/repair/limits.h"
#include "core/valve/annulus_frame.h"
#include "core/valve/problem_list.h"

namespace coapt {
namespace {

constexpr double kFreeEdge = 0.95;  // heights from here on are called the free edge

std::string one_decimal(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", number);
  return text;
}

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
  const std::string segment = words(valve.segments[static_cast<std::size_t>(insertion.face)]);
  if (point.height >= kFreeEdge) return "the free edge of " + segment;
  return segment + " at " + std::to_string(static_cast<int>(100.0 * point.height + 0.5)) +
         " % of its height";
}

std::string words(const Valve& valve, const Annuloplasty& step) {
  if (step.shape != "own")
    return "annuloplasty: " + step.shape + " ring, size " + shown(step.size_mm) + " mm";
  const double transverse = transverse_diameter_mm(valve, annulus_frame(valve));
  if (step.sizes_below == 0)
    return "annuloplasty: ring of the annulus's own shape and size (transverse " +
           one_decimal(transverse) + " mm)";
  return "annuloplasty: ring of the annulus's own shape, " + std::to_string(step.sizes_below) +
         (step.sizes_below == 1 ? " size" : " sizes") + " below it (transverse " +
         one_decimal(transverse) + " to " +
         one_decimal(transverse - kRingSizeStep_mm * step.sizes_below) + " mm)";
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
      anchor = "the annulus at " + shown(step.annulus_around) +
               " turns from the posteromedial commissure, over the saddle peak";
      break;
  }
  return std::string("papillary approximation: ") + to_string(step.side) + " muscle to " + anchor +
         ", suture " + shown(step.suture_length_mm) + " mm";
}

}  // namespace

std::vector<std::string> describe(const Valve& valve, const RepairPlan& plan) {
  std::vector<std::string> lines;
  for (const RepairStep& step : plan.steps)
    lines.push_back(std::visit([&valve](const auto& s) { return words(valve, s); }, step));
  return lines;
}

}  // namespace coapt
