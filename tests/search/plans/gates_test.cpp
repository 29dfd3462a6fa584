#include "search/plans/gates.h"

#include <gtest/gtest.h>

#include <set>

#include "core/repair/apply_plan.h"
#include "tests/scenes/small_valve.h"
#include "tests/search/plans/gate_scene.h"

namespace coapt {
namespace {

const std::string kWide = "generic-geoform-like";  // 1.12 times its size

std::vector<Gate> gates(const RepairPlan& plan, const Valve& valve = fitting_valve()) {
  const Expected<Valve> repaired = apply_plan(valve, plan);
  EXPECT_TRUE(repaired);
  return operation_gates({plan, valve, *repaired});
}

std::vector<Gate> gates(const RepairStep& step) { return gates(RepairPlan{{step}}); }

RepairStep own_ring(int sizes_below) { return Annuloplasty{OwnRing{sizes_below}}; }
RepairStep ring(double size_mm, const std::string& shape = "generic-classic") {
  return Annuloplasty{CatalogueRing{shape, size_mm}};
}
// The anterolateral tip is 28.6 mm from its trigone and 31 mm from mid-posterior.
RepairStep suture(Anchor anchor, double length_mm, double around = 0.75) {
  return PapillaryApproximation{
      .anchor = anchor, .annulus_around = around, .suture_length_mm = length_mm};
}
RepairStep neochorda(const std::string& head, double along, double length_mm) {
  return Neochorda{head, {Leaflet::Posterior, along, 1.0}, length_mm};
}

TEST(Gates, EveryRuleIsStatedForEveryPlanInOneOrder) {
  const std::vector<std::string> rules = {"ring_width",         "ring_stenosis",  "undersizing",
                                          "papillary_movement", "suture_length",  "filling",
                                          "neochorda_length",   "neochorda_half", "native_chordae"};
  EXPECT_EQ(rules_of(gates(RepairPlan{})), rules);
  EXPECT_EQ(rules_of(gates(RepairPlan{
                {neochorda("AL1", 0.4, 20.0), own_ring(2), suture(Anchor::SaddlePeak, 25.0)}})),
            rules);
  for (const Gate& gate : gates(RepairPlan{})) {
    EXPECT_FALSE(gate.finding.empty()) << gate.rule;
    EXPECT_FALSE(gate.source.empty()) << gate.rule;
  }
}

TEST(Gates, ARuleWithoutASubjectPassesAndFillingIsNeverAssessed) {
  const std::vector<Gate> none = gates(RepairPlan{});
  expect_gate(none, "ring_width", GateSeverity::Pass, "no ring");
  expect_gate(none, "undersizing", GateSeverity::Pass, "no ring");
  expect_gate(none, "papillary_movement", GateSeverity::Pass, "no papillary muscle");
  expect_gate(none, "neochorda_half", GateSeverity::Pass, "no neochorda");
  for (const std::vector<Gate>& any : {none, gates(ring(26.0))})
    expect_gate(any, "filling", GateSeverity::NotAssessed, "not simulated");
  EXPECT_TRUE(warnings_of(none).empty());
  EXPECT_FALSE(is_rejected(none));
}

TEST(Gates, RingsWiderThanTheAnnulusStretchIt) {
  // The annulus is 36 mm wide.
  expect_gate(gates(ring(38.0)), "ring_width", GateSeverity::Warn, "38.0 mm versus 36.0 mm");
  expect_gate(gates(ring(36.0)), "ring_width", GateSeverity::Pass, "36.0 mm");
  expect_gate(gates(ring(34.0, kWide)), "ring_width", GateSeverity::Warn, "38.1 mm");
  expect_gate(gates(own_ring(0)), "ring_width", GateSeverity::Pass, "36.0 mm");
  Valve narrower = fitting_valve();
  narrower.annulus_mm.col(0) *= 35.2 / 36.0;
  expect_gate(gates({{ring(36.0)}}, narrower), "ring_width", GateSeverity::Pass,
              "ring is of the size closest to the annulus (36.0 mm versus 35.2 mm)");
}

TEST(Gates, RingsLabelled27OrLessPredictStenosis) {
  expect_gate(gates(ring(26.0)), "ring_stenosis", GateSeverity::Warn, "26.0 mm");
  expect_gate(gates(ring(26.0, kWide)), "ring_stenosis", GateSeverity::Warn, "26.0 mm");
  expect_gate(gates(ring(28.0)), "ring_stenosis", GateSeverity::Pass, "28.0 mm");
  expect_gate(gates(own_ring(4)), "ring_stenosis", GateSeverity::Pass, "28.0 mm");
  expect_gate(gates(own_ring(5)), "ring_stenosis", GateSeverity::Warn, "26.0 mm");
}

TEST(Gates, MoreThanFourSizesBelowTheTrueOneIsRejectedByArea) {
  EXPECT_FALSE(is_rejected(gates(own_ring(4))));
  expect_gate(gates(own_ring(4)), "undersizing", GateSeverity::Pass,
              "3.7 sizes below the true size of 36.0 mm");
  expect_gate(gates(own_ring(5)), "undersizing", GateSeverity::Reject, "4.8 sizes");
  expect_gate(gates(ring(26.0)), "undersizing", GateSeverity::Reject, "not used in practice");
  // 28 x 1.12 = 31.4 mm, but half as deep: by area 31.4 x 16.0 of 36 x 27 is a third less of either.
  expect_gate(gates(ring(28.0, kWide)), "undersizing", GateSeverity::Reject, "more than 4");
  EXPECT_TRUE(is_rejected(gates(own_ring(5))));
  // Leaflets of 19 mm are too short for its annulus: their ring has 26 mm.
  expect_gate(gates(RepairPlan{{own_ring(5)}}, small_valve()), "undersizing", GateSeverity::Pass,
              "of the true size or larger, which is 25.9 mm");
}

TEST(Gates, WhereNothingTethersTheLeafletsRingsAreOfTheTrueSizeOrTheNextBelow) {
  const auto of_free_leaflets = [](int sizes_below) {
    const Valve valve = fitting_valve();
    const RepairPlan plan{{own_ring(sizes_below)}};
    return operation_gates({plan, valve, *apply_plan(valve, plan), true});
  };
  expect_gate(of_free_leaflets(1), "undersizing", GateSeverity::Pass, "0.7 sizes below");
  expect_gate(of_free_leaflets(2), "undersizing", GateSeverity::Warn,
              "up to 1.5 sizes below are used in practice where no leaflet is tethered");
  EXPECT_EQ(avoidable_warnings(of_free_leaflets(2)), 1);
  expect_gate(gates(own_ring(2)), "undersizing", GateSeverity::Pass, "up to 4 sizes");
  expect_gate(of_free_leaflets(5), "undersizing", GateSeverity::Reject, "more than 4");
}

TEST(Gates, MusclesMoveByTenMillimetresAndNoneByMoreThanFifteen) {
  expect_gate(gates(suture(Anchor::IpsilateralTrigone, 20.0)), "papillary_movement",
              GateSeverity::Pass, "anterolateral papillary muscle is relocated by 8.6 mm");
  expect_gate(gates(suture(Anchor::IpsilateralTrigone, 17.0)), "papillary_movement",
              GateSeverity::Warn, "11.6 mm");
  Valve deep = fitting_valve();
  deep.heads[0].tip_mm.z() -= 10.0;
  RepairPlan both{{suture(Anchor::IpsilateralTrigone, 20.0),
                   PapillaryApproximation{.side = Side::Posteromedial, .suture_length_mm = 17.0}}};
  expect_gate(gates(both, deep), "papillary_movement", GateSeverity::Reject, "anterolateral");
  const std::string finding = gate_of(gates(both, deep), "papillary_movement").finding;
  EXPECT_EQ(finding.find("posteromedial"), std::string::npos) << "the lesser is not told";
}

TEST(Gates, SuturesAreAsLongAsTheyMustBeOrThePlanIsNone) {
  expect_gate(gates(suture(Anchor::IpsilateralTrigone, 20.0)), "suture_length", GateSeverity::Pass,
              "20.0 mm");
  EXPECT_FALSE(apply_plan(fitting_valve(), {{suture(Anchor::IpsilateralTrigone, 14.0)}}));
}

TEST(Gates, AnchorsOnThePosteriorAnnulusImpairFilling) {
  expect_gate(gates(suture(Anchor::AnnulusPoint, 25.0)), "filling", GateSeverity::Warn,
              "posterior");
  for (const double around : {0.5, 1.0, 0.25})  // the commissures, the saddle peak
    expect_gate(gates(suture(Anchor::AnnulusPoint, 26.0, around)), "filling",
                GateSeverity::NotAssessed, "not simulated");
  expect_gate(gates(suture(Anchor::SaddlePeak, 25.0)), "filling", GateSeverity::NotAssessed, "");
}

TEST(Gates, NeochordaeAreOfUsualLengthAndStayInTheirHalf) {
  expect_gate(gates(neochorda("AL1", 0.5, 10.0)), "neochorda_length", GateSeverity::Pass, "10.0");
  expect_gate(gates(neochorda("AL1", 0.5, 10.0)), "neochorda_half", GateSeverity::Pass, "AL1");
  expect_gate(gates(neochorda("PM1", 0.5, 30.0)), "neochorda_half", GateSeverity::Pass, "PM1");
  expect_gate(gates(neochorda("PM1", 0.6, 31.0)), "neochorda_length", GateSeverity::Warn,
              "31.0 mm");
  expect_gate(gates(neochorda("PM1", 0.6, 9.0)), "neochorda_length", GateSeverity::Warn,
              "10 to 30");
  expect_gate(gates(neochorda("AL1", 0.6, 20.0)), "neochorda_half", GateSeverity::Warn, "AL1");
  expect_gate(gates(neochorda("PM1", 0.4, 20.0)), "neochorda_half", GateSeverity::Warn, "half");
  const std::vector<Gate> four =
      gates(RepairPlan{{neochorda("AL1", 0.4, 20.0), neochorda("AL1", 0.45, 32.0),
                        neochorda("PM1", 0.55, 33.0), neochorda("PM1", 0.6, 20.0)}});
  EXPECT_EQ(gate_of(four, "neochorda_length").finding,
            "the neochorda is 32.0 mm long (10 to 30 mm is usual); the neochorda is 33.0 mm long "
            "(10 to 30 mm is usual)");
}

TEST(Gates, CuttingWhatHoldsTheFreeEdgeIsWarnedOf) {
  expect_gate(gates(ChordalExcision{"AL1-P1-marginal-1"}), "native_chordae", GateSeverity::Warn,
              "free edge");
  expect_gate(gates(ChordalExcision{"PM1-A2-strut-1"}), "native_chordae", GateSeverity::Pass,
              "PM1-A2-strut-1 is cut");
  expect_gate(gates(ChordalTransfer{"PM1-A2-strut-1", {Leaflet::Anterior, 0.6, 1.0}}),
              "native_chordae", GateSeverity::Pass, "transferred");
  expect_gate(gates(ChordalLengthChange{"PM1-A2-strut-1", -2.0}), "native_chordae",
              GateSeverity::Pass, "length");
}

TEST(Gates, WarningsAreTheFindingsThatWarnOrReject) {
  const std::vector<Gate> some = {{"a", GateSeverity::Pass, "quiet", ""},
                                  {"b", GateSeverity::Warn, "look", ""},
                                  {"c", GateSeverity::NotAssessed, "unseen", ""},
                                  {"d", GateSeverity::Reject, "no", ""}};
  EXPECT_EQ(warnings_of(some), (std::vector<std::string>{"look", "no"}));
  EXPECT_TRUE(is_rejected(some));
  EXPECT_FALSE(is_rejected({some[0], some[1], some[2]}));
  std::set<std::string> words;
  for (const Gate& gate : some) words.insert(to_string(gate.severity));
  EXPECT_EQ(words, (std::set<std::string>{"pass", "warn", "reject", "not_assessed"}));
}

}  // namespace
}  // namespace coapt
