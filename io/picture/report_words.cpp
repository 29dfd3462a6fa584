#include "io/picture/report_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "core/repair/apply_plan.h"
#include "core/repair/describe.h"
#include "core/repair/limits.h"
#include "core/repair/ring_sizing.h"
#include "core/repair/rings.h"
#include "core/valve/counted.h"
#include "io/json/plan_json.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr double kFarthest_mm = 1.0, kFarthest_deg = 5.0;  // borders of the region: see LeakMargin
constexpr double kTold_mm = 0.5;    // parts of a movement below it are not told
constexpr double kFreeEdge = 0.95;  // heights from here on are the free edge, as describe() says
constexpr std::size_t kOpeningsTold = 3, kNamesTold = 4;

std::string mm(double value) { return with_unit(value, 1, "mm"); }

std::string capitalised(std::string words) {
  if (!words.empty())
    words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
  return words;
}

/// The plan with the valve before and, where it can be done, after.
struct Operated {
  const ClosedValve& before;
  const RankedPlan& plan;
  Expected<Valve> repaired;
};

std::string ring_words(const OwnRing& ring) {
  return "Annuloplasty ring in the annulus's own shape, " + undersizing_words(ring);
}
std::string ring_words(const CatalogueRing& ring) {
  return "Annuloplasty ring, size " + fixed(ring.size_mm, 0) + " mm, shape " + ring.shape;
}
std::string ring_words(const DesignedRing& ring) {
  return "Annuloplasty ring, size " + fixed(ring.size_mm, 0) + " mm, designed shape " +
         ring.shape.name;
}

/// Against the ring that a surgeon would call of the true size.
std::string size_words(const Effort& effort, const Valve& valve) {
  constexpr double kLeast = 0.05;  // sizes that are printed
  const std::string true_size = "the true size of " + fixed(true_ring_size_mm(valve), 1) + " mm";
  return effort.sizes_below < kLeast
             ? "of " + true_size + " or larger."
             : fixed(effort.sizes_below, 1) + " sizes of 2 mm below " + true_size + ".";
}

StepWords words(const Operated& operated, const Annuloplasty& step, std::size_t) {
  const Valve& valve = operated.before.valve;
  const AnnulusMeasure& was = operated.before.measure.annulus;
  const AnnulusMeasure& is = operated.plan.measure.annulus;
  StepWords told;
  told.step = std::visit([](const auto& ring) { return ring_words(ring); }, step.ring);
  if (const RingShape* shape = find_ring(shape_of(step)))
    told.detail = capitalised(std::string(shape->note)) + ". ";
  told.detail += "Annulus from " + fixed(was.al_pm_mm, 1) + " × " + fixed(was.ap_mm, 1) + " to " +
                 fixed(is.al_pm_mm, 1) + " × " + fixed(is.ap_mm, 1) +
                 " mm (transverse × anteroposterior), " + size_words(operated.plan.effort, valve);
  return told;
}

std::string anchor_words(const PapillaryApproximation& step) {
  constexpr std::array kBorders = {"posteromedial commissure", "saddle peak",
                                   "anterolateral commissure", "mid-posterior point",
                                   "posteromedial commissure"};
  switch (step.anchor) {
    case Anchor::IpsilateralTrigone:
      return std::string("the ") + to_string(step.side) + " trigone";
    case Anchor::SaddlePeak:
      return "the saddle peak (middle of the anterior annulus)";
    case Anchor::AnnulusPoint:
      break;
  }
  const double quarters = 4.0 * std::clamp(step.annulus_around, 0.0, 1.0);
  const auto first = static_cast<std::size_t>(std::min(3.0, std::floor(quarters)));
  return std::string("the annulus, ") + percent(quarters - static_cast<double>(first)) +
         " of the way from " + kBorders[first] + " to " + kBorders[first + 1];
}

/// The parts of a movement, the largest first; `inwards`: the sign of x towards the middle.
std::string direction_words(const Vec3& movement_mm, double inwards) {
  struct Part {
    double mm;
    const char *along, *against;
  };
  std::array<Part, 3> parts = {
      Part{movement_mm.z(), "up towards the annulus", "down towards the apex"},
      Part{movement_mm.y(), "anteriorly", "posteriorly"},
      Part{movement_mm.x() * inwards, "towards the other muscle", "outwards"}};
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Part& a, const Part& b) { return std::abs(a.mm) > std::abs(b.mm); });
  std::string told;
  for (const Part& part : parts)
    if (std::abs(part.mm) >= kTold_mm)
      told += (told.empty() ? "" : ", ") + mm(std::abs(part.mm)) + " " +
              (part.mm > 0.0 ? part.along : part.against);
  return told;
}

StepWords words(const Operated& operated, const PapillaryApproximation& step, std::size_t) {
  const bool al = step.side == Side::Anterolateral;
  const double moved_mm = al ? operated.plan.effort.anterolateral_movement_mm
                             : operated.plan.effort.posteromedial_movement_mm;
  StepWords told{capitalised(to_string(step.side)) + " papillary muscle tied to " +
                     anchor_words(step) + ", suture " + mm(step.suture_length_mm),
                 "Moves the muscle by " + mm(moved_mm) + ", from " +
                     fixed(step.suture_length_mm + moved_mm, 1) + " to " +
                     mm(step.suture_length_mm) + " from its anchor"};
  if (operated.repaired) {
    const Vec3 movement_mm = papillary_tip_mm(*operated.repaired, step.side) -
                             papillary_tip_mm(operated.before.valve, step.side);
    if (const std::string parts = direction_words(movement_mm, al ? 1.0 : -1.0); !parts.empty())
      told.detail += ": " + parts;
  }
  told.detail += ".";
  return told;
}

StepWords words_as_described(const Operated& operated, std::size_t step) {
  const std::vector<std::string>& lines = operated.plan.description;
  return {capitalised(step < lines.size() ? lines[step] : "a step"), ""};
}

std::string place_words(const Valve& valve, const LeafletPoint& point) {
  const Insertion insertion = locate(valve, leaflet_coordinates(valve), point);
  const std::string segment = to_string(valve.segments[static_cast<std::size_t>(insertion.face)]);
  if (point.height >= kFreeEdge) return "the free edge of " + segment;
  return "the belly of " + segment + ", " + percent(point.height) +
         " of the way from annulus to free edge";
}

StepWords words(const Operated& operated, const Neochorda& step, std::size_t) {
  const Valve& valve = operated.before.valve;
  const auto head = std::find_if(valve.heads.begin(), valve.heads.end(),
                                 [&](const PapillaryHead& one) { return one.id == step.head; });
  const std::string from = head == valve.heads.end()
                               ? step.head
                               : std::string("the ") + to_string(head->side) +
                                     " papillary muscle (head " + step.head + ")";
  return {"Neochorda of " + mm(step.length_mm) + " from " + from + " to " +
              place_words(valve, step.insertion),
          ""};
}

StepWords words(const Operated& operated, const EdgeToEdge& step, std::size_t index) {
  if (step.device == EdgeDevice::CleftSuture) return words_as_described(operated, index);
  const Valve& valve = operated.before.valve;
  return {std::string(step.device == EdgeDevice::Clip ? "Clip" : "Edge-to-edge stitch") + ", " +
              mm(step.width_mm) + " wide, from " +
              place_words(valve, {Leaflet::Anterior, step.along, 1.0}) + " to " +
              place_words(valve, {Leaflet::Posterior, step.along, 1.0}),
          ""};
}

StepWords words(const Operated& operated, const LeafletResection& step, std::size_t) {
  const std::string middle = place_words(operated.before.valve, {step.leaflet, step.along, 1.0});
  const char* chordae = "Chordae of the resected tissue are cut.";
  if (step.shape == ResectionShape::Triangular)
    return {"Triangular resection at " + middle + ", " + mm(step.width_mm) +
                " wide at the free edge, " + percent(step.height) + " of the way to the annulus",
            chordae};
  return {"Quadrangular resection at " + middle + ", " + mm(step.width_mm) + " wide, " +
              (step.sliding ? "with sliding plasty" : "with plication of the annulus"),
          chordae};
}

StepWords words(const Operated& operated, const ChordalLengthChange&, std::size_t index) {
  return words_as_described(operated, index);
}
StepWords words(const Operated& operated, const ChordalExcision&, std::size_t index) {
  return words_as_described(operated, index);
}
StepWords words(const Operated& operated, const ChordalTransfer&, std::size_t index) {
  return words_as_described(operated, index);
}

std::string in_short(const Annuloplasty& step) {
  if (const auto* own = std::get_if<OwnRing>(&step.ring))
    return "ring in the annulus's own shape, " + undersizing_words(*own);
  const double size_mm = std::holds_alternative<CatalogueRing>(step.ring)
                             ? std::get<CatalogueRing>(step.ring).size_mm
                             : std::get<DesignedRing>(step.ring).size_mm;
  return "ring " + shape_of(step) + " " + fixed(size_mm, 0);
}
std::string in_short(const PapillaryApproximation& step) {
  const char* anchor = step.anchor == Anchor::IpsilateralTrigone ? "trigone"
                       : step.anchor == Anchor::SaddlePeak       ? "saddle peak"
                                                                 : "annulus";
  return std::string(step.side == Side::Anterolateral ? "AL" : "PM") + " muscle to " + anchor +
         ", " + mm(step.suture_length_mm);
}
std::string in_short(const Neochorda& step) {
  return "neochorda " + step.head + " to " + to_string(step.insertion.leaflet) + " leaflet, " +
         mm(step.length_mm);
}
std::string in_short(const EdgeToEdge& step) {
  const char* device = step.device == EdgeDevice::Clip     ? "clip"
                       : step.device == EdgeDevice::Stitch ? "edge-to-edge stitch"
                                                           : "cleft sutured";
  return std::string(device) + ", " + mm(step.width_mm);
}
std::string in_short(const LeafletResection& step) {
  return std::string(to_string(step.shape)) + " resection of the " + to_string(step.leaflet) +
         " leaflet, " + mm(step.width_mm);
}
std::string in_short(const ChordalLengthChange& step) {
  return step.chorda + (step.change_mm < 0.0 ? " shortened" : " lengthened");
}
std::string in_short(const ChordalExcision& step) { return step.chorda + " cut"; }
std::string in_short(const ChordalTransfer& step) { return step.chorda + " transferred"; }

std::string margin(double value, double farthest, int decimals) {
  return (value >= farthest ? "> " : "") + fixed(value, decimals);
}

/// " at P2, A2"; empty where there are none.
std::string at_segments(const std::vector<Segment>& segments) {
  std::string told;
  for (const Segment segment : segments)
    told += (told.empty() ? " at " : ", ") + std::string(to_string(segment));
  return told;
}

}  // namespace

std::string with_unit(double value, int decimals, const char* unit) {
  const std::string text = fixed(value, decimals);
  return std::isfinite(value) ? text + " " + unit : text;
}

std::vector<StepWords> surgical_words(const ClosedValve& before, const RankedPlan& plan) {
  std::vector<StepWords> told;
  if (plan.plan.steps.empty()) {
    for (const std::string& line : plan.description) told.push_back({capitalised(line), ""});
    if (told.empty()) told.push_back({"No repair", "The unrepaired valve."});
    return told;
  }
  const Operated operated{before, plan, apply_plan(before.valve, plan.plan)};
  for (std::size_t i = 0; i < plan.plan.steps.size(); ++i)
    told.push_back(
        std::visit([&](const auto& step) { return words(operated, step, i); }, plan.plan.steps[i]));
  return told;
}

std::string short_words(const RankedPlan& plan) {
  std::string told;
  for (const RepairStep& step : plan.plan.steps)
    told += (told.empty() ? "" : " + ") +
            std::visit([](const auto& one) { return in_short(one); }, step);
  if (!told.empty()) return told;
  for (const std::string& line : plan.description) told += (told.empty() ? "" : " + ") + line;
  return told.empty() ? "no repair" : told;
}

std::string valve_words(const ClosedValve& before) {
  const ValveMeasure& measure = before.measure;
  const std::vector<LeakOpening>& openings = measure.leak.openings;
  std::vector<std::string> ruptured;
  for (const Chorda& chorda : before.valve.chordae)
    if (chorda.ruptured) ruptured.push_back(chorda.id);
  std::string told = "Before repair the valve leaks through " +
                     with_error(measure.leak.area_mm2, measure.leak_error_mm2, "mm²");
  for (std::size_t i = 0; i < openings.size() && i < kOpeningsTold; ++i)
    told += (i == 0 ? " (" : ", ") + known_digits(openings[i].area_mm2, measure.leak_error_mm2) +
            " mm²" + at_segments(openings[i].segments);
  if (openings.size() > kOpeningsTold)
    told += ", " + std::to_string(openings.size() - kOpeningsTold) + " smaller";
  told += std::string(openings.empty() ? "" : ")") + ". Annulus " +
          fixed(measure.annulus.al_pm_mm, 1) + " mm transverse, " +
          fixed(measure.annulus.ap_mm, 1) + " mm anteroposterior; tenting height " +
          mm(measure.tenting_height_mm) + ".";
  for (std::size_t i = 0; i < ruptured.size() && i < kNamesTold; ++i)
    told += (i == 0 ? " Ruptured chordae: " : ", ") + ruptured[i];
  if (ruptured.size() > kNamesTold)
    told += " and " + std::to_string(ruptured.size() - kNamesTold) + " more";
  if (!ruptured.empty()) told += ".";
  return told;
}

std::vector<std::string> steps_of(const RankedPlan& plan) {
  return plan.description.empty() ? std::vector<std::string>{"no repair"} : plan.description;
}

std::string execution_words(const RankedPlan& plan) {
  const std::optional<Interval>& leak_mm2 = plan.estimates.leak_mm2.execution;
  return leak_mm2 ? interval_words(*leak_mm2) : "n/a";
}

std::string suture_margin(const LeakMargin& to_leak) {
  return margin(to_leak.suture_length_mm, kFarthest_mm, 2);
}

std::string angle_margin(const LeakMargin& to_leak) {
  return margin(to_leak.angle_deg, kFarthest_deg, 1);
}

}  // namespace coapt
