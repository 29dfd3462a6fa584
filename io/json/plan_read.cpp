#include <cmath>

#include "core/repair/limits.h"
#include "io/json/json_reader.h"
#include "io/json/parse_json.h"
#include "io/json/plan_json.h"
#include "io/json/ring_json.h"
#include "io/json/valve_json.h"

namespace coapt {
namespace {

constexpr std::size_t kMaxSteps = 100;

std::function<void(const JsonPlace&)> number_into(double& target, Range range,
                                                  const char* unit = "") {
  return into(target, [=](const JsonPlace& place) { return read_number_in(place, range, unit); });
}

// Already read: it told which fields to expect.
JsonField tag(std::string_view name) {
  return {name, [](const JsonPlace&) {}};
}

Leaflet read_leaflet(const JsonPlace& place) {
  return read_name<Leaflet>(place, {Leaflet::Anterior, Leaflet::Posterior});
}

Anchor read_anchor(const JsonPlace& place) {
  return read_name<Anchor>(place,
                           {Anchor::IpsilateralTrigone, Anchor::SaddlePeak, Anchor::AnnulusPoint});
}

LeafletPoint read_leaflet_point(const JsonPlace& place) {
  LeafletPoint point;
  read_fields(place, {{"leaflet", into(point.leaflet, read_leaflet)},
                      {"along", number_into(point.along, kShare)},
                      {"height", number_into(point.height, kShare)}});
  return point;
}

double read_ring_size(const JsonPlace& place) {
  const double size = read_number_in(place, kRingSizesMm, " mm");
  if (size >= kRingSizesMm.min && size <= kRingSizesMm.max &&
      std::fmod(size, kRingSizeStep_mm) != 0.0) {
    add_problem(place, ErrorCode::OutOfRange,
                "is " + shown(size) + ", must be " + shown(kRingSizesMm) + " in steps of " +
                    shown(kRingSizeStep_mm) + " mm");
  }
  return size;
}

RepairStep read_annuloplasty(const JsonPlace& place) {
  Annuloplasty step;
  const auto shape = read_member(place, "shape");
  if (!shape) return step;
  const std::string name = read_string(*shape);
  if (name == kOwnShape) {
    OwnRing ring;
    const auto read_sizes = [](const JsonPlace& sizes) {
      return read_integer_in(sizes, static_cast<int>(kSizesBelow.min),
                             static_cast<int>(kSizesBelow.max));
    };
    read_fields(place,
                {tag("step"), tag("shape"), {"sizes_below", into(ring.sizes_below, read_sizes)}});
    step.ring = ring;
  } else if (name == kDesignedShape) {
    DesignedRing ring;
    read_fields(place, {tag("step"),
                        tag("shape"),
                        {"ring", into(ring.shape, read_designed_shape)},
                        {"size_mm", into(ring.size_mm, read_ring_size)}});
    step.ring = ring;
  } else {
    CatalogueRing ring{name};
    read_fields(place,
                {tag("step"), tag("shape"), {"size_mm", into(ring.size_mm, read_ring_size)}});
    step.ring = ring;
  }
  return step;
}

RepairStep read_neochorda(const JsonPlace& place) {
  Neochorda step;
  read_fields(place, {tag("step"),
                      {"head", into(step.head, read_string)},
                      {"insertion", into(step.insertion, read_leaflet_point)},
                      {"length_mm", number_into(step.length_mm, kNeochordaMm, " mm")}});
  return step;
}

RepairStep read_length_change(const JsonPlace& place) {
  ChordalLengthChange step;
  read_fields(place, {tag("step"),
                      {"chorda", into(step.chorda, read_string)},
                      {"change_mm", number_into(step.change_mm, kLengthChangeMm, " mm")}});
  return step;
}

RepairStep read_excision(const JsonPlace& place) {
  ChordalExcision step;
  read_fields(place, {tag("step"), {"chorda", into(step.chorda, read_string)}});
  return step;
}

RepairStep read_transfer(const JsonPlace& place) {
  ChordalTransfer step;
  read_fields(place, {tag("step"),
                      {"chorda", into(step.chorda, read_string)},
                      {"insertion", into(step.insertion, read_leaflet_point)}});
  return step;
}

RepairStep read_approximation(const JsonPlace& place) {
  PapillaryApproximation step;
  const auto anchor = read_member(place, "anchor");
  if (!anchor) return step;
  step.anchor = read_anchor(*anchor);
  const JsonField side = {"side", into(step.side, read_side)};
  const JsonField length = {"suture_length_mm",
                            number_into(step.suture_length_mm, kSutureMm, " mm")};
  if (step.anchor == Anchor::AnnulusPoint) {
    read_fields(place, {tag("step"),
                        side,
                        tag("anchor"),
                        length,
                        {"annulus_around", number_into(step.annulus_around, kShare)}});
  } else {
    read_fields(place, {tag("step"), side, tag("anchor"), length});
  }
  return step;
}

RepairStep read_edge_to_edge(const JsonPlace& place) {
  EdgeToEdge step;
  const auto read_device = [](const JsonPlace& device) {
    return read_name<EdgeDevice>(device,
                                 {EdgeDevice::Stitch, EdgeDevice::Clip, EdgeDevice::CleftSuture});
  };
  const auto read_rows = [](const JsonPlace& rows) {
    return read_integer_in(rows, static_cast<int>(kClipRows.min), static_cast<int>(kClipRows.max));
  };
  read_fields(place, {tag("step"),
                      {"device", into(step.device, read_device)},
                      {"along", number_into(step.along, kEdgeAlong)},
                      {"width_mm", number_into(step.width_mm, kEdgeWidthMm, " mm")},
                      {"grasp_mm", number_into(step.grasp_mm, kGraspMm, " mm"), false},
                      {"rows", into(step.rows, read_rows), false},
                      {"annulus_drawn_in_percent",
                       number_into(step.annulus_drawn_in_percent, kDrawnInPercent, " %"), false}});
  return step;
}

RepairStep read_resection(const JsonPlace& place) {
  LeafletResection step;
  const auto shape = read_member(place, "shape");
  if (!shape) return step;
  const auto choice = read_choice(*shape, {"triangular", "quadrangular"});
  if (!choice) return step;
  step.shape = *choice == 0 ? ResectionShape::Triangular : ResectionShape::Quadrangular;
  const JsonField along = {"along", number_into(step.along, kResectionAlong)};
  if (step.shape == ResectionShape::Quadrangular) {
    read_fields(place, {tag("step"),
                        tag("shape"),
                        along,
                        {"width_mm", number_into(step.width_mm, kQuadrangularMm, " mm")},
                        {"sliding", into(step.sliding, read_boolean)}});
  } else {
    read_fields(place, {tag("step"),
                        tag("shape"),
                        {"leaflet", into(step.leaflet, read_leaflet)},
                        along,
                        {"width_mm", number_into(step.width_mm, kTriangularMm, " mm")},
                        {"height", number_into(step.height, kTriangularHeight)}});
  }
  return step;
}

RepairStep read_step(const JsonPlace& place) {
  const auto kind = read_member(place, "step");
  if (!kind) return {};
  const auto choice = read_choice(
      *kind, {"annuloplasty", "neochorda", "chordal_length_change", "chordal_excision",
              "chordal_transfer", "papillary_approximation", "edge_to_edge", "leaflet_resection"});
  if (!choice) return {};
  constexpr std::array readers = {read_annuloplasty, read_neochorda, read_length_change,
                                  read_excision,     read_transfer,  read_approximation,
                                  read_edge_to_edge, read_resection};
  static_assert(readers.size() == std::variant_size_v<RepairStep>);
  return readers[*choice](place);
}

RepairPlan read_plan_at(const JsonPlace& place, bool schema_required) {
  RepairPlan plan;
  const auto read_steps = [&](const JsonPlace& steps) {
    if (steps.value.is_array() && steps.value.size() > kMaxSteps) {
      add_problem(steps, ErrorCode::OutOfRange,
                  "has " + std::to_string(steps.value.size()) + " steps, at most 100 are accepted");
      return;
    }
    plan.steps = read_list(steps, read_step);
  };
  read_fields(place,
              {{"schema", [](const JsonPlace& schema) { read_schema(schema, "coapt.plan/1"); },
                schema_required},
               {"steps", read_steps}});
  return plan;
}

}  // namespace

Expected<RepairPlan> plan_from_json(const Json& json) {
  ProblemList problems;
  RepairPlan plan = read_plan_at({json, problems}, true);
  if (!problems.empty()) return std::move(problems).take();
  return plan;
}

RepairPlan read_plan_within(const JsonPlace& place) { return read_plan_at(place, false); }

Expected<RepairPlan> read_plan(std::string_view text) {
  const auto json = parse_json(text);
  if (!json) return json.errors();
  return plan_from_json(*json);
}

}  // namespace coapt
