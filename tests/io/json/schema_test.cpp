// The JSON Schemas say what the readers do. `accepts` knows just the keywords that they use.

#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/repair/apply_plan.h"
#include "core/repair/limits.h"
#include "core/repair/rings.h"
#include "io/json/json.h"
#include "io/json/plan_json.h"
#include "io/json/ring_json.h"
#include "io/json/search_options_json.h"
#include "io/json/valve_json.h"
#include "search/plans/search_option_table.h"
#include "tests/io/json/found.h"
#include "tests/io/plans_scene.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

Json schema_of(const std::string& name) {
  std::ifstream file(COAPT_SOURCE_DIR "/io/schema/" + name + ".schema.json");
  return Json::parse(file);
}

bool has_type(const Json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  return type == "number" && value.is_number();
}

class Schema {
 public:
  explicit Schema(const std::string& name) : root_(schema_of(name)) {}

  bool accepts(const Json& value) const { return accepts(root_, value); }
  const Json& root() const { return root_; }

 private:
  bool accepts(const Json& schema, const Json& value) const {
    return std::all_of(schema.items().begin(), schema.items().end(), [&](const auto& keyword) {
      return obeys(schema, keyword.key(), keyword.value(), value);
    });
  }

  bool obeys(const Json& schema, const std::string& word, const Json& argument,
             const Json& value) const {
    const auto fits = [&](const Json& branch) { return accepts(branch, value); };
    if (word == "$ref") return fits_reference(argument, value);
    if (word == "type") return has_type(value, argument);
    if (word == "const") return value == argument;
    if (word == "enum") return std::count(argument.begin(), argument.end(), value) == 1;
    if (word == "oneOf") return std::count_if(argument.begin(), argument.end(), fits) == 1;
    if (word == "minimum") return value.is_number() && value >= argument;
    if (word == "maximum") return value.is_number() && value <= argument;
    if (word == "multipleOf") return std::fmod(value.get<double>(), argument.get<double>()) == 0.0;
    if (word == "minItems") return value.size() >= argument;
    if (word == "maxItems") return value.size() <= argument;
    if (word == "minLength") return value.is_string() && value != "";
    if (word == "maxLength") return value.get<std::string>().size() <= argument;
    if (word == "items") {
      return std::all_of(value.begin(), value.end(),
                         [&](const Json& entry) { return accepts(argument, entry); });
    }
    if (word == "required") {
      return std::all_of(argument.begin(), argument.end(), [&](const std::string& name) {
        return value.is_object() && value.contains(name);
      });
    }
    if (word == "properties" || word == "additionalProperties") {
      const Json& properties = schema["properties"];
      return value.is_object() &&
             std::all_of(value.items().begin(), value.items().end(), [&](const auto& member) {
               if (!properties.contains(member.key())) return false;
               return accepts(properties[member.key()], member.value());
             });
    }
    const std::vector<std::string> words_without_force = {
        "$schema", "$id", "$defs", "title", "description", "default", "discriminator"};
    EXPECT_EQ(std::count(words_without_force.begin(), words_without_force.end(), word), 1) << word;
    return true;
  }

  // "#/$defs/rules", or "../plan/1#/..." into plan.schema.json.
  bool fits_reference(const std::string& reference, const Json& value) const {
    const std::size_t hash = reference.find('#');
    const Json::json_pointer at(reference.substr(hash + 1));
    if (hash == 0) return accepts(root_[at], value);
    const std::size_t name = reference.find("../") + 3;
    const Schema other(reference.substr(name, reference.find("/1#") - name));
    return other.accepts(other.root_[at], value);
  }

  Json root_;
};

Json small_document() { return Json::parse(write_valve(small_valve())); }

Json plan_document() {
  const LeafletPoint point = {Leaflet::Posterior, 0.5, 1.0};
  const RepairPlan plan = {
      {Annuloplasty{OwnRing{2}}, Annuloplasty{CatalogueRing{"generic-classic", 30.0}},
       Neochorda{"AL1", point, 18.5}, ChordalLengthChange{"a", -1.25}, ChordalExcision{"b"},
       ChordalTransfer{"c", point},
       PapillaryApproximation{Side::Anterolateral, Anchor::IpsilateralTrigone, 0.25, 24.0},
       PapillaryApproximation{Side::Posteromedial, Anchor::AnnulusPoint, 0.9, 25.0},
       EdgeToEdge{EdgeDevice::Clip, 0.4, 6.0},
       LeafletResection{.leaflet = Leaflet::Anterior, .width_mm = 8.0},
       LeafletResection{.shape = ResectionShape::Quadrangular, .sliding = false},
       Annuloplasty{DesignedRing{{"mine", {.p3_inset = 0.05, .saddle = 0.1}}, 30.0}}}};
  return to_json(plan);
}

// Pointers to all objects inside `value`, itself included.
std::vector<Json::json_pointer> objects_in(const Json& value,
                                           const Json::json_pointer& at = Json::json_pointer()) {
  std::vector<Json::json_pointer> list;
  if (value.is_object()) list.push_back(at);
  if (!value.is_structured()) return list;
  for (const auto& [name, member] : value.items()) {
    const auto below = objects_in(
        member, value.is_object() ? at / name : at / static_cast<std::size_t>(std::stoul(name)));
    list.insert(list.end(), below.begin(), below.end());
  }
  return list;
}

// Fields that came after release 0.1; files without them still open.
const std::set<std::string> kLaterFields = {"reference",
                                            "circumferential_prestretch",
                                            "radial_prestretch",
                                            "bending_n_mm",
                                            "zone_mm",
                                            "grasp_mm",
                                            "rows",
                                            "annulus_drawn_in_percent"};

// Takes each member away in turn, and adds one that nobody knows.
template <class Reads>
void expect_agreement_on_fields(const Schema& schema, const Json& good, Reads reads) {
  for (const auto& object : objects_in(good)) {
    const Json members = good[object];
    for (const auto& [name, member] : members.items()) {
      Json poorer = good;
      poorer[object].erase(name);
      EXPECT_EQ(schema.accepts(poorer), kLaterFields.contains(name)) << object / name;
      EXPECT_EQ(reads(poorer), kLaterFields.contains(name)) << object / name;
    }
    Json richer = good;
    richer[object]["unknown"] = 1;
    EXPECT_FALSE(schema.accepts(richer)) << object;
    EXPECT_FALSE(reads(richer)) << object;
  }
}

// The ends of the schema's range are accepted, what lies beyond is not.
template <class Reads>
void expect_agreement_on_range(const Json& range, const Json& good, const std::string& at,
                               Reads reads) {
  for (const char* end : {"minimum", "maximum"}) {
    Json document = good;
    Json& number = document[Json::json_pointer(at)];
    number = range[end];
    EXPECT_TRUE(reads(document)) << at << ' ' << end;
    const double outwards = end == std::string("minimum") ? -1.0 : 1.0;
    const double limit = range[end];
    number = std::nextafter(limit, outwards * INFINITY);
    EXPECT_FALSE(reads(document)) << at << ' ' << end;
  }
}

bool reads_valve(const Json& document) { return bool(read_valve(document.dump())); }
bool reads_plan(const Json& document) { return bool(read_plan(document.dump())); }

TEST(ValveSchema, AcceptsWhatIsWritten) { EXPECT_TRUE(Schema("valve").accepts(small_document())); }

TEST(ValveSchema, AgreesWithTheReaderOnEveryField) {
  expect_agreement_on_fields(Schema("valve"), small_document(), reads_valve);
}

TEST(ValveSchema, AgreesWithTheReaderOnRanges) {
  const Schema schema("valve");
  const Json& fields = schema.root()["properties"];
  expect_agreement_on_range(fields["pressure_kpa"], small_document(), "/pressure_kpa", reads_valve);
  for (const auto& [name, range] : fields["tissue"]["properties"].items()) {
    if (range["type"] == "string") continue;
    expect_agreement_on_range(range, small_document(), "/tissue/" + name, reads_valve);
  }
  for (const std::string name : {"rest_length_mm", "diameter_mm", "zone_mm"}) {
    expect_agreement_on_range(schema.root()["$defs"]["segment"]["properties"][name],
                              small_document(), "/chordae/0/segments/1/" + name, reads_valve);
  }
}

// Where one number alone cannot be at the end of its range: the reader may find other faults, but
// does not call it out of range.
void expect_range_is_known(const Json& range, const std::string& at) {
  for (const char* end : {"minimum", "maximum"}) {
    const double limit = range[end];
    const double outwards = end == std::string("minimum") ? -1.0 : 1.0;
    for (const double number : {limit, std::nextafter(limit, outwards * INFINITY)}) {
      Json document = small_document();
      document[Json::json_pointer(at)] = number;
      const Found found = problems_of(read_valve(document.dump()));
      const auto here =
          std::count(found.begin(), found.end(), std::pair(ErrorCode::OutOfRange, at));
      EXPECT_EQ(here, number == limit ? 0 : 1) << at << ' ' << end;
    }
  }
}

TEST(ValveSchema, AgreesWithTheReaderOnPlacesAndWeights) {
  const Schema schema("valve");
  const Json& kinds = schema.root()["$defs"];
  for (const std::string at :
       {"/vertices_mm/9/0", "/annulus/positions_mm/2/1", "/papillary_heads/0/rest_mm/2",
        "/papillary_heads/1/tip_mm/0", "/chordae/0/segments/0/branch_point_mm/1"}) {
    expect_range_is_known(kinds["point"]["items"], at);
  }
  const Json& insertion = kinds["insertion"]["properties"];
  expect_range_is_known(insertion["weights"]["items"], "/chordae/0/segments/1/insertion/weights/0");
}

TEST(PlanSchema, AcceptsWhatIsWritten) { EXPECT_TRUE(Schema("plan").accepts(plan_document())); }

TEST(PlanSchema, AgreesWithTheReaderOnEveryField) {
  expect_agreement_on_fields(Schema("plan"), plan_document(), reads_plan);
}

TEST(PlanSchema, HasTheLimitsOfTheRepairSteps) {
  const Json steps = schema_of("plan")["$defs"];
  const auto range = [&](const char* step, const char* field) {
    const Json& limits = steps[step]["properties"][field];
    return std::pair(limits["minimum"].get<double>(), limits["maximum"].get<double>());
  };
  const auto pair = [](Range limits) { return std::pair(limits.min, limits.max); };
  EXPECT_EQ(range("own_ring", "sizes_below"), pair(kSizesBelow));
  EXPECT_EQ(range("catalogue_ring", "size_mm"), pair(kRingSizesMm));
  EXPECT_EQ(steps["catalogue_ring"]["properties"]["size_mm"]["multipleOf"], kRingSizeStep_mm);
  EXPECT_EQ(range("neochorda", "length_mm"), pair(kNeochordaMm));
  EXPECT_EQ(range("edge_to_edge", "along"), pair(kEdgeAlong));
  EXPECT_EQ(range("edge_to_edge", "width_mm"), pair(kEdgeWidthMm));
  EXPECT_EQ(range("edge_to_edge", "grasp_mm"), pair(kGraspMm));
  EXPECT_EQ(range("edge_to_edge", "rows"), pair(kClipRows));
  EXPECT_EQ(range("edge_to_edge", "annulus_drawn_in_percent"), pair(kDrawnInPercent));
  for (const char* shape : {"triangular_resection", "quadrangular_resection"})
    EXPECT_EQ(range(shape, "along"), pair(kResectionAlong));
  EXPECT_EQ(range("triangular_resection", "width_mm"), pair(kTriangularMm));
  EXPECT_EQ(range("triangular_resection", "height"), pair(kTriangularHeight));
  EXPECT_EQ(range("quadrangular_resection", "width_mm"), pair(kQuadrangularMm));
  EXPECT_EQ(range("chordal_length_change", "change_mm"), pair(kLengthChangeMm));
  EXPECT_EQ(range("approximation_to_landmark", "suture_length_mm"), pair(kSutureMm));
  EXPECT_EQ(range("approximation_to_point", "suture_length_mm"), pair(kSutureMm));
  EXPECT_EQ(range("approximation_to_point", "annulus_around"), pair(kShare));
  EXPECT_EQ(range("leaflet_point", "along"), pair(kShare));
  EXPECT_EQ(range("leaflet_point", "height"), pair(kShare));
}

TEST(PlanSchema, HasTheRingShapesOfTheCatalogue) {
  const Json shape = schema_of("plan")["$defs"]["catalogue_shape"];
  std::vector<std::string> shapes;
  for (const RingShape& known : kRingShapes) shapes.emplace_back(known.name);
  EXPECT_EQ(shape["enum"].get<std::vector<std::string>>(), shapes);
}

TEST(PlanSchema, AgreesWithTheReaderOnRanges) {
  const Schema schema("plan");
  const Json& kinds = schema.root()["$defs"];
  const auto check = [&](const char* kind, const char* field, const std::string& at) {
    expect_agreement_on_range(kinds[kind]["properties"][field], plan_document(), at, reads_plan);
  };
  check("catalogue_ring", "size_mm", "/steps/1/size_mm");
  check("designed_ring", "size_mm", "/steps/11/size_mm");
  for (const RingTermRow& row : kRingTerms)
    check("designed_shape", row.name, std::string("/steps/11/ring/") + row.name);
  check("neochorda", "length_mm", "/steps/2/length_mm");
  check("leaflet_point", "along", "/steps/2/insertion/along");
  check("leaflet_point", "height", "/steps/5/insertion/height");
  check("chordal_length_change", "change_mm", "/steps/3/change_mm");
  check("approximation_to_landmark", "suture_length_mm", "/steps/6/suture_length_mm");
  check("approximation_to_point", "suture_length_mm", "/steps/7/suture_length_mm");
  check("approximation_to_point", "annulus_around", "/steps/7/annulus_around");
}

TEST(PlanSchema, AgreesWithTheReaderOnRingSizesBelow) {
  const Schema schema("plan");
  Json plan = plan_document();
  for (const int sizes : {-1, 0, 6, 7}) {
    plan["steps"][0]["sizes_below"] = sizes;
    EXPECT_EQ(schema.accepts(plan), sizes >= 0 && sizes <= 6);
    EXPECT_EQ(reads_plan(plan), sizes >= 0 && sizes <= 6);
  }
}

// What is read may be impossible on a valve, but is in range for the step.
TEST(PlanSchema, AgreesWithTheStepsOnRanges) {
  const Json kinds = Schema("plan").root()["$defs"];
  const LeafletPoint point = {Leaflet::Posterior, 0.5, 1.0};
  const auto refusals = [](const RepairStep& step) {
    return problems_of(apply_plan(small_valve(), {{step}}));
  };
  const auto check = [&](const char* kind, const char* field, const auto& step_with) {
    const Json& range = kinds[kind]["properties"][field];
    for (const double number : {range["minimum"].get<double>(), range["maximum"].get<double>()}) {
      for (const auto& [code, path] : refusals(step_with(number)))
        EXPECT_NE(code, ErrorCode::OutOfRange) << path << ' ' << number;
    }
    const double below = std::nextafter(range["minimum"].get<double>(), -INFINITY);
    const double above = std::nextafter(range["maximum"].get<double>(), INFINITY);
    EXPECT_NE(refusals(step_with(below)), Found{}) << field;
    EXPECT_NE(refusals(step_with(above)), Found{}) << field;
  };
  check("catalogue_ring", "size_mm", [](double size) {
    return Annuloplasty{CatalogueRing{"generic-classic", size}};
  });
  check("neochorda", "length_mm", [&](double length) { return Neochorda{"AL1", point, length}; });
  check("chordal_length_change", "change_mm", [](double change) {
    return ChordalLengthChange{"AL1-P1-marginal-1", change};
  });
  check("approximation_to_landmark", "suture_length_mm", [](double length) {
    return PapillaryApproximation{Side::Anterolateral, Anchor::SaddlePeak, 0.25, length};
  });
  check("approximation_to_point", "annulus_around", [](double around) {
    return PapillaryApproximation{Side::Anterolateral, Anchor::AnnulusPoint, around, 24.0};
  });
}

TEST(RingSchema, AgreesWithTheReaderOnEveryFieldAndRange) {
  const Schema schema("ring");
  const Json ring = Json::parse(to_json(RingDesign{{"mine", {}}, 0.9}, {}).dump());
  const auto reads = [](const Json& document) { return bool(ring_from_json(document)); };
  EXPECT_TRUE(schema.accepts(ring));
  expect_agreement_on_fields(schema, ring, reads);
  expect_agreement_on_range(
      schema.root()["properties"]["sizing"]["properties"]["width_over_transverse"], ring,
      "/sizing/width_over_transverse", reads);
}

Json full_search() { return Json::parse(to_json(search_request().options).dump()); }
bool reads_search(const Json& document) { return bool(search_options_from_json(document)); }

TEST(SearchSchema, AcceptsWhatIsWritten) {
  EXPECT_TRUE(Schema("search").accepts(full_search()));
  EXPECT_TRUE(Schema("search").accepts(Json::parse(to_json(SearchOptions{}).dump())));
}

TEST(SearchSchema, AgreesWithTheReaderThatNothingIsRequiredAndNothingElseAccepted) {
  const Schema schema("search");
  const Json good = full_search();
  for (const auto& object : objects_in(good)) {
    const bool step = object.to_string().find("/steps/") != std::string::npos;
    const Json members = good[object];
    for (const auto& [name, member] : members.items()) {
      Json poorer = good;
      poorer[object].erase(name);
      const bool optional = !step && name != "steps";
      EXPECT_EQ(schema.accepts(poorer), optional) << object / name;
      EXPECT_EQ(reads_search(poorer), optional) << object / name;
    }
    Json richer = good;
    richer[object]["unknown"] = 1;
    EXPECT_FALSE(schema.accepts(richer)) << object;
    EXPECT_FALSE(reads_search(richer)) << object;
  }
}

TEST(SearchSchema, AgreesWithTheReaderOnRangesAndDefaults) {
  const Json root = schema_of("search"), usual = Json::parse(to_json(SearchOptions{}).dump());
  const auto check = [&](const Json& fields, const std::string& object) {
    for (const auto& [name, field] : fields.items()) {
      const std::string at = object + "/" + name;
      if (field.contains("default")) {
        EXPECT_EQ(field["default"], usual[Json::json_pointer(at)]) << at;
      }
      if (field.value("type", "") == "number")
        expect_agreement_on_range(field, full_search(), at, reads_search);
      if (field.value("type", "") != "integer" || name == "seed") continue;
      for (const auto& [end, outwards] : {std::pair("minimum", -1), std::pair("maximum", 1)}) {
        Json document = full_search();
        document[Json::json_pointer(at)] = field[end];
        EXPECT_TRUE(reads_search(document)) << at << ' ' << end;
        document[Json::json_pointer(at)] = field[end].get<int>() + outwards;
        EXPECT_FALSE(reads_search(document)) << at << ' ' << end;
      }
    }
  };
  check(root["properties"], "");
  check(root["$defs"]["rules"]["properties"], "/rules");
  check(root["$defs"]["weights"]["properties"], "/weights");
}

template <class Options>
void expect_rows(std::span<const OptionRow<Options>> rows, const Json& fields) {
  for (const OptionRow<Options>& row : rows) {
    const Json field = fields.value(row.name, Json::object());
    EXPECT_EQ(field.value("description", ""), row.help) << row.name;
    const bool has_range = row.range.min < row.range.max;
    if (!has_range) continue;
    EXPECT_EQ(field["minimum"].get<double>(), row.range.min) << row.name;
    EXPECT_EQ(field["maximum"].get<double>(), row.range.max) << row.name;
  }
}

TEST(SearchSchema, SaysOfEachOptionWhatTheTableSays) {
  const Json root = schema_of("search"), rules = root["$defs"]["rules"]["properties"],
             weights = root["$defs"]["weights"]["properties"];
  expect_rows(search_option_rows(), root["properties"]);
  expect_rows(search_rule_rows(), rules);
  expect_rows(cost_weight_rows(), weights);
  EXPECT_EQ(root["properties"].size(), search_option_rows().size() + 2) << "rules and weights";
  EXPECT_EQ(rules.size(), search_rule_rows().size() + 3)
      << "fixed steps, forbidden words and shapes";
  EXPECT_EQ(weights.size(), cost_weight_rows().size());
}

}  // namespace
}  // namespace coapt
