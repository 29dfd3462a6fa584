#include "io/json/search_options_json.h"

#include "io/json/parse_json.h"
#include "tests/io/json/found.h"
#include "tests/io/plans_scene.h"

namespace coapt {
namespace {

using enum ErrorCode;

Expected<SearchOptions> read(const char* text) {
  return search_options_from_json(*parse_json(text));
}

std::string message_at(const char* text, const std::string& path) {
  const Expected<SearchOptions> options = read(text);
  if (options) return "";
  for (const Error& error : options.errors())
    if (error.path == path) return error.message;
  return "";
}

TEST(SearchOptionsJson, NoFieldIsRequired) {
  for (const char* nothing : {"{}", R"({"rules": {}, "weights": {}})"}) {
    const auto options = read(nothing);
    ASSERT_TRUE(options);
    EXPECT_EQ(to_json(*options), to_json(SearchOptions{}));
  }
}

TEST(SearchOptionsJson, EveryFieldIsRead) {
  const SearchOptions wanted = search_request().options;
  const Json asked = to_json(wanted), usual = to_json(SearchOptions{});
  for (const auto& [name, value] : asked.items()) EXPECT_NE(value, usual[name]) << name;
  for (const char* part : {"rules", "weights"})
    for (const auto& [name, value] : asked[part].items())
      EXPECT_NE(value, usual[part][name]) << name;
  const auto options = search_options_from_json(Json::parse(asked.dump()));
  ASSERT_TRUE(options);
  EXPECT_EQ(to_json(*options), asked);
  EXPECT_EQ(options->seed, 18446744073709551615u);
  EXPECT_EQ(options->target_mm2, 0.25);
  EXPECT_EQ(std::get<CatalogueRing>(std::get<Annuloplasty>(options->rules.fixed.steps.at(0)).ring)
                .size_mm,
            30.0);
  EXPECT_EQ(options->rules.forbidden.at(1), "papillary_approximation:saddle_peak");
  EXPECT_EQ(options->weights.untrusted, 17.0);
}

TEST(SearchOptionsJson, FixedStepsNeedNotSayTheirSchema) {
  const auto options = read(R"({"rules": {"fixed": {"steps": [
      {"step": "annuloplasty", "shape": "own", "sizes_below": 2}]}}})");
  ASSERT_TRUE(options);
  EXPECT_EQ(
      std::get<OwnRing>(std::get<Annuloplasty>(options->rules.fixed.steps.at(0)).ring).sizes_below,
      2);
}

TEST(SearchOptionsJson, ProblemsAreListed) {
  EXPECT_EQ(problems_of(read(
                R"({"evaluations": 0, "front_share": 11, "seed": -1, "threads": 1.5, "plans": 51,
      "region_points": 1090, "evidence": 1, "fine_levels": 3, "model_draws": 201, "seconds": -1, "no_improvement": -1,
      "target_mm2": -2, "speed": 3, "closure": {"max_steps": 10000000, "samples": 100}})")),
            (Found{{OutOfRange, "/evaluations"},
                   {OutOfRange, "/front_share"},
                   {OutOfRange, "/seed"},
                   {WrongType, "/threads"},
                   {OutOfRange, "/plans"},
                   {OutOfRange, "/region_points"},
                   {WrongType, "/evidence"},
                   {OutOfRange, "/fine_levels"},
                   {OutOfRange, "/model_draws"},
                   {OutOfRange, "/seconds"},
                   {OutOfRange, "/no_improvement"},
                   {OutOfRange, "/target_mm2"},
                   {UnknownField, "/closure"},
                   {UnknownField, "/speed"}}));
  EXPECT_EQ(problems_of(search_options_from_json(Json::array())), (Found{{WrongType, ""}}));
}

TEST(SearchOptionsJson, ProblemsOfRulesAndWeightsAreListedWhereTheyAre) {
  EXPECT_EQ(problems_of(read(R"({"rules": {"forbidden": ["neochorda", 3], "most_neochordae": 5,
      "chordal_excision": "yes", "suture_lattice_mm": 0.05, "neochorda_lattice_mm": 0.4,
      "most_movement_mm": 16, "own": 1},
      "weights": {"leak": -1, "steps": 2, "untrusted": 1e7}})")),
            (Found{{WrongType, "/rules/forbidden/1"},
                   {OutOfRange, "/rules/most_neochordae"},
                   {WrongType, "/rules/chordal_excision"},
                   {OutOfRange, "/rules/suture_lattice_mm"},
                   {OutOfRange, "/rules/neochorda_lattice_mm"},
                   {OutOfRange, "/rules/most_movement_mm"},
                   {UnknownField, "/rules/own"},
                   {OutOfRange, "/weights/leak"},
                   {OutOfRange, "/weights/untrusted"},
                   {UnknownField, "/weights/steps"}}));
}

TEST(SearchOptionsJson, ProblemsOfFixedStepsAreListedWhereTheyAre) {
  EXPECT_EQ(problems_of(read(R"({"rules": {"fixed": {"schema": "coapt.plan/2", "steps": [
      {"step": "annuloplasty", "shape": "own", "sizes_below": 7},
      {"step": "annuloplasty", "shape": "generic-classic", "size_mm": 31},
      {"step": "chordal_excision"}]}}})")),
            (Found{{Unsupported, "/rules/fixed/schema"},
                   {OutOfRange, "/rules/fixed/steps/0/sizes_below"},
                   {OutOfRange, "/rules/fixed/steps/1/size_mm"},
                   {MissingField, "/rules/fixed/steps/2/chorda"}}));
  EXPECT_EQ(problems_of(read(R"({"rules": {"fixed": {}}})")),
            (Found{{MissingField, "/rules/fixed/steps"}}));
}

TEST(SearchOptionsJson, AProblemSaysWhatIsAccepted) {
  EXPECT_EQ(message_at(R"({"evaluations": 0})", "/evaluations"), "is 0, must be from 1 to 1000000");
  EXPECT_EQ(message_at(R"({"rules": {"most_movement_mm": 16}})", "/rules/most_movement_mm"),
            "is 16, must be from 3 to 15 mm");
  EXPECT_EQ(
      message_at(R"({"weights": {"steps": 1}})", "/weights/steps"),
      "is not a field here, must be one of leak sd_share incompetence margin coaptation gap "
      "movement movement_above_10 undersizing undersizing_above_4 step tension gradient_above_3 "
      "gradient_above_5 durability untrusted; "
      "did you mean \"step\"?");
}

}  // namespace
}  // namespace coapt
