#include "search/plans/rules.h"

#include <cmath>

#include "tests/search/plans/search_scene.h"

namespace coapt {
namespace {

std::vector<std::string> paths(const SearchRules& rules) {
  std::vector<std::string> found;
  for (const Error& error : check_rules(small_valve(), rules)) found.push_back(error.path);
  return found;
}

using Paths = std::vector<std::string>;

TEST(Rules, TheDefaultsAreAccepted) { EXPECT_EQ(paths({}), Paths{}); }

TEST(Rules, AWordForbidsATechniqueOrOneKindOfIt) {
  SearchRules rules;
  rules.forbidden = {"annuloplasty:own", "papillary_approximation"};
  EXPECT_TRUE(is_forbidden(rules, "annuloplasty", "own"));
  EXPECT_FALSE(is_forbidden(rules, "annuloplasty", "generic-classic"));
  EXPECT_FALSE(is_forbidden(rules, "annuloplasty", ""));
  EXPECT_TRUE(is_forbidden(rules, "papillary_approximation", "saddle_peak"));
  EXPECT_TRUE(is_forbidden(rules, "papillary_approximation", ""));
  EXPECT_FALSE(is_forbidden(rules, "neochorda", "anterior"));
  EXPECT_EQ(paths(rules), Paths{});
}

TEST(Rules, EveryKnownWordIsAccepted) {
  SearchRules rules;
  rules.forbidden = {"annuloplasty",
                     "annuloplasty:own",
                     "annuloplasty:generic-classic",
                     "annuloplasty:generic-etlogix-like",
                     "annuloplasty:generic-geoform-like",
                     "papillary_approximation",
                     "papillary_approximation:anterolateral",
                     "papillary_approximation:posteromedial",
                     "papillary_approximation:ipsilateral_trigone",
                     "papillary_approximation:saddle_peak",
                     "papillary_approximation:annulus_point",
                     "neochorda",
                     "neochorda:anterior",
                     "neochorda:posterior",
                     "chordal_length_change",
                     "chordal_excision",
                     "chordal_transfer",
                     "edge_to_edge",
                     "edge_to_edge:stitch",
                     "edge_to_edge:clip",
                     "leaflet_resection",
                     "leaflet_resection:triangular",
                     "leaflet_resection:quadrangular",
                     "leaflet_resection:anterior",
                     "leaflet_resection:posterior"};
  EXPECT_EQ(paths(rules), Paths{});
}

TEST(Rules, AWordThatSaysNothingIsRefusedWithThoseThatDo) {
  SearchRules rules;
  rules.forbidden = {"annuloplasty:own", "annuloplasty:huge", "", "papillary_approximation:"};
  EXPECT_EQ(paths(rules), (Paths{"/forbidden/1", "/forbidden/2", "/forbidden/3"}));
  const Errors errors = check_rules(small_valve(), rules);
  EXPECT_EQ(errors.at(0).code, ErrorCode::BadReference);
  EXPECT_NE(errors[0].message.find("annuloplasty:generic-classic, "), std::string::npos)
      << errors[0].message;
}

TEST(Rules, NumbersHaveTheirRangesAndNaNNone) {
  SearchRules rules;
  rules.most_neochordae = -1;
  rules.suture_lattice_mm = 0.09;
  rules.neochorda_lattice_mm = 5.1;
  rules.most_movement_mm = std::nan("");
  EXPECT_EQ(paths(rules), (Paths{"/most_neochordae", "/suture_lattice_mm", "/neochorda_lattice_mm",
                                 "/most_movement_mm"}));
  rules.most_neochordae = 4;
  rules.suture_lattice_mm = 0.1;
  rules.neochorda_lattice_mm = 5.0;
  rules.most_movement_mm = 15.0;
  EXPECT_EQ(paths(rules), Paths{});
}

TEST(Rules, AnImpossibleFixedStepIsAnErrorAtItsPlace) {
  SearchRules rules;
  rules.fixed = scene::both(scene::own_ring(1), scene::suture(Side::Anterolateral, 99.0));
  EXPECT_EQ(paths(rules), Paths{"/fixed/steps/1/suture_length_mm"});
}

TEST(Rules, AStepThatIsFixedAndForbiddenIsAContradiction) {
  SearchRules rules;
  rules.fixed = scene::both(scene::own_ring(1), scene::suture(Side::Anterolateral, 24.0));
  const auto with = [&rules](const std::string& word) {
    rules.forbidden = {word};
    return paths(rules);
  };
  EXPECT_EQ(with("annuloplasty"), Paths{"/fixed/steps/0"});
  EXPECT_EQ(with("annuloplasty:own"), Paths{"/fixed/steps/0"});
  EXPECT_EQ(with("annuloplasty:generic-classic"), Paths{});
  EXPECT_EQ(with("papillary_approximation"), Paths{"/fixed/steps/1"});
  EXPECT_EQ(with("papillary_approximation:anterolateral"), Paths{"/fixed/steps/1"});
  EXPECT_EQ(with("papillary_approximation:ipsilateral_trigone"), Paths{"/fixed/steps/1"});
  EXPECT_EQ(with("papillary_approximation:saddle_peak"), Paths{});
}

TEST(Rules, ChordalStepsAreContradictedToo) {
  SearchRules rules;
  rules.fixed = {{ChordalLengthChange{"AL1-P1-marginal-1", -2.0}, ChordalExcision{"PM1-A2-strut-1"},
                  Neochorda{"PM1", {Leaflet::Anterior, 0.6, 1.0}, 20.0}}};
  rules.forbidden = {"chordal_length_change", "chordal_excision", "neochorda:anterior"};
  EXPECT_EQ(paths(rules), (Paths{"/fixed/steps/0", "/fixed/steps/1", "/fixed/steps/2"}));
}

}  // namespace
}  // namespace coapt
