#include "io/json/dimensions_json.h"

#include <charconv>

#include "core/valve/dimension_table.h"
#include "core/valve/ruptures.h"
#include "io/json/parse_json.h"

namespace coapt {
namespace {

constexpr const char* kSchema = "coapt.dimensions/1";

Segment read_scallop(const JsonPlace& place) {
  return read_name(place, std::vector<Segment>(kScallops.begin(), kScallops.end()));
}

SystolicMotion read_motion(const JsonPlace& place) {
  SystolicMotion motion;
  read_fields(place, {{"annular_contraction", into(motion.annular_contraction, read_number)},
                      {"tip_approach", into(motion.tip_approach, read_number)}});
  return motion;
}

ChordalElongation read_elongation(const JsonPlace& place) {
  ChordalElongation further;
  read_fields(place, {{"segment", into(further.segment, read_scallop)},
                      {"percent", into(further.percent, read_number)}});
  return further;
}

TissueChange read_tissue_change(const JsonPlace& place) {
  TissueChange tissue;
  read_fields(place, {{"thickness_percent", into(tissue.thickness_percent, read_number), false},
                      {"extension_percent", into(tissue.extension_percent, read_number), false},
                      {"circumferential_stiffness_percent",
                       into(tissue.circumferential_stiffness_percent, read_number), false},
                      {"radial_stiffness_percent",
                       into(tissue.radial_stiffness_percent, read_number), false}});
  return tissue;
}

Json tissue_json(const TissueChange& tissue) {
  return {{"thickness_percent", tissue.thickness_percent},
          {"extension_percent", tissue.extension_percent},
          {"circumferential_stiffness_percent", tissue.circumferential_stiffness_percent},
          {"radial_stiffness_percent", tissue.radial_stiffness_percent}};
}

Json vector_json(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }

Json remodelling_json(const Remodelling& change) {
  Json json = {{"growth_percent", change.growth_percent},
               {"ap_dilation_percent", change.ap_dilation_percent},
               {"annular_height_percent", change.annular_height_percent},
               {"anterolateral_mm", vector_json(change.anterolateral_mm)},
               {"posteromedial_mm", vector_json(change.posteromedial_mm)},
               {"leaflet_growth_percent", change.leaflet_growth_percent},
               {"chordal_elongation_percent", change.chordal_elongation_percent},
               {"tissue", tissue_json(change.tissue)}};
  for (const ChordalElongation& further : change.elongated)
    json["elongated"].push_back(
        {{"segment", to_string(further.segment)}, {"percent", further.percent}});
  for (const Segment segment : change.ruptured) json["ruptured"].push_back(to_string(segment));
  if (change.systole)
    json["systole"] = {{"annular_contraction", change.systole->annular_contraction},
                       {"tip_approach", change.systole->tip_approach}};
  return json;
}

}  // namespace

double six_digits(double value) {
  const std::string text = shown(value);
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

void read_dimension_fields(const JsonPlace& place, ParametricValve& dimensions) {
  std::vector<JsonField> fields;
  for (const Dimension& dimension : dimension_table())
    fields.push_back({dimension.name,
                      [&dimensions, &dimension](const JsonPlace& at) {
                        dimension.set(dimensions,
                                      read_number_in(at, dimension.accepted, dimension.unit));
                      },
                      false});
  fields.push_back({"triangles",
                    [&dimensions](const JsonPlace& at) {
                      dimensions.triangles = read_integer_in(at, 100, 50000);
                    },
                    false});
  read_fields(place, fields);
}

Remodelling read_remodelling(const JsonPlace& place) {
  Remodelling change;
  read_fields(
      place,
      {{"growth_percent", into(change.growth_percent, read_number), false},
       {"ap_dilation_percent", into(change.ap_dilation_percent, read_number), false},
       {"annular_height_percent", into(change.annular_height_percent, read_number), false},
       {"anterolateral_mm", into(change.anterolateral_mm, read_vector), false},
       {"posteromedial_mm", into(change.posteromedial_mm, read_vector), false},
       {"leaflet_growth_percent", into(change.leaflet_growth_percent, read_number), false},
       {"chordal_elongation_percent", into(change.chordal_elongation_percent, read_number), false},
       {"elongated",
        [&](const JsonPlace& at) { change.elongated = read_list(at, read_elongation); }, false},
       {"tissue", into(change.tissue, read_tissue_change), false},
       {"ruptured", [&](const JsonPlace& at) { change.ruptured = read_list(at, read_scallop); },
        false},
       {"systole", into(change.systole, read_motion), false}});
  add_below(place.problems, pointer(place), check_remodelling(change));
  return change;
}

Expected<HumanValve> read_dimensions(std::string_view text) {
  const Expected<Json> json = parse_json(text);
  if (!json) return json.errors();
  ProblemList problems;
  HumanValve valve;
  read_fields(
      {*json, problems},
      {{"schema", [](const JsonPlace& place) { read_schema(place, kSchema); }},
       {"name", into(valve.dimensions.name, read_string), false},
       {"dimensions",
        [&](const JsonPlace& place) { read_dimension_fields(place, valve.dimensions); }, false},
       {"remodelling", into(valve.change, read_remodelling), false},
       {"disease", into(valve.disease, read_string), false}});
  if (!problems.empty()) return std::move(problems).take();
  return valve;
}

std::string write_dimensions(const HumanValve& valve) {
  Json json = {{"schema", kSchema}, {"name", valve.dimensions.name}};
  Json& dimensions = json["dimensions"] = Json::object();
  for (const Dimension& dimension : dimension_table())
    if (const std::optional<double> value = dimension.get(valve.dimensions))
      dimensions[dimension.name] = six_digits(*value);
  if (valve.change) json["remodelling"] = remodelling_json(*valve.change);
  if (!valve.disease.empty()) json["disease"] = valve.disease;
  return json.dump(2) + "\n";
}

}  // namespace coapt
