#include "search/plans/closure_gates.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/search/plans/gate_scene.h"

namespace coapt {
namespace {

Evaluation quiet() {
  Evaluation evaluation;
  evaluation.measure.leak.area_mm2 = 0.0;
  for (CoaptationSection& section : evaluation.measure.coaptation.sections)
    section = {.height_mm = 8.0, .contact = true};
  evaluation.measure.tension_max_n = 1.0;
  evaluation.measure.anterior_length_mm = 20.0;
  evaluation.measure.posterior_length_mm = 10.0;
  return evaluation;
}

TEST(ClosureGates, EveryRuleIsStatedAndAQuietClosurePasses) {
  const std::vector<Gate> all = closure_gates(quiet(), quiet());
  EXPECT_EQ(rules_of(all),
            (std::vector<std::string>{"convergence", "crossing", "contact", "coaptation_height",
                                      "chordal_tension", "systolic_anterior_motion",
                                      "regurgitation_grade"}));
  EXPECT_TRUE(warnings_of(all).empty());
  expect_gate(all, "contact", GateSeverity::Pass, "all 9");
  expect_gate(all, "coaptation_height", GateSeverity::Pass, "8.0 mm");
  expect_gate(all, "chordal_tension", GateSeverity::Pass, "1.0 N");
  expect_gate(all, "regurgitation_grade", GateSeverity::NotAssessed, "anatomic");
  for (const Gate& gate : all) EXPECT_FALSE(gate.source.empty()) << gate.rule;
}

TEST(ClosureGates, ALongPosteriorLeafletIsASignOfSystolicAnteriorMotion) {
  constexpr const char* kRule = "systolic_anterior_motion";
  Evaluation repaired = quiet();
  expect_gate(closure_gates(repaired, quiet()), kRule, GateSeverity::Pass, "2.0 (20 / 10 mm)");
  repaired.measure.posterior_length_mm = 16.0;
  expect_gate(closure_gates(repaired, quiet()), kRule, GateSeverity::Warn, "below 1.3");
  expect_gate(closure_gates(repaired, quiet(), true), kRule, GateSeverity::NotAssessed, "tether");
  expect_gate(closure_gates(repaired, repaired), kRule, GateSeverity::Pass,
              "not lower than before the repair (1.2)");
  Evaluation unknown = repaired, higher = repaired;
  unknown.measure.posterior_length_mm = std::numeric_limits<double>::quiet_NaN();
  higher.measure.posterior_length_mm = 15.0;
  expect_gate(closure_gates(repaired, unknown), kRule, GateSeverity::Warn, "below 1.3");
  expect_gate(closure_gates(repaired, higher), kRule, GateSeverity::Warn, "below 1.3");
  repaired.measure.posterior_length_mm = std::numeric_limits<double>::quiet_NaN();
  expect_gate(closure_gates(repaired, quiet()), kRule, GateSeverity::NotAssessed, "do not coapt");
}

TEST(ClosureGates, AClosureThatIsNotToBeTrustedIsRejectedAndItsFiguresAreNotAssessed) {
  Evaluation limited = quiet(), crossed = quiet(), lost = quiet();
  limited.status = ClosureStatus::StepLimit;
  crossed.crossing = true;
  lost.measure.leak.area_mm2 = std::numeric_limits<double>::quiet_NaN();
  expect_gate(closure_gates(limited, quiet()), "convergence", GateSeverity::Reject,
              "did not converge");
  expect_gate(closure_gates(lost, quiet()), "convergence", GateSeverity::Reject, "unreliable");
  expect_gate(closure_gates(crossed, quiet()), "crossing", GateSeverity::Reject, "leaflets cross");
  expect_gate(closure_gates(crossed, quiet()), "convergence", GateSeverity::Pass,
              "the closure converged");
  for (const Evaluation& bad : {limited, crossed, lost}) {
    const std::vector<Gate> all = closure_gates(bad, quiet());
    EXPECT_TRUE(is_rejected(all));
    EXPECT_EQ(warnings_of(all).size(), 1u);
    for (std::size_t i = 2; i < all.size(); ++i)
      EXPECT_EQ(all[i].severity, GateSeverity::NotAssessed) << all[i].rule;
  }
}

TEST(ClosureGates, LeafletsTouchAtAllNineSections) {
  Evaluation apart = quiet();
  apart.measure.coaptation.sections[2].contact = false;
  expect_gate(closure_gates(apart, quiet()), "contact", GateSeverity::Warn, "1 of 9");
}

TEST(ClosureGates, CoaptationOfA2WithP2IsAnAim) {
  Evaluation low = quiet();
  for (const std::size_t i : {3u, 4u, 5u}) low.measure.coaptation.sections[i].height_mm = 5.0;
  expect_gate(closure_gates(low, quiet()), "coaptation_height", GateSeverity::Warn, "5.0 mm");
  expect_gate(closure_gates(low, quiet()), "coaptation_height", GateSeverity::Warn,
              "below the target of 8 mm");
  for (const std::size_t i : {3u, 4u, 5u}) low.measure.coaptation.sections[i].height_mm = 7.96;
  expect_gate(closure_gates(low, quiet()), "coaptation_height", GateSeverity::Pass,
              "8.0 mm, at or above");
  low = quiet();
  low.measure.coaptation.sections[0].height_mm = 1.0;  // no part of A2 and P2
  expect_gate(closure_gates(low, quiet()), "coaptation_height", GateSeverity::Pass, "evidence");
}

TEST(ClosureGates, PeakTensionMayNotRiseMoreThanThreefold) {
  Evaluation taut = quiet();
  taut.measure.tension_max_n = 3.0;
  expect_gate(closure_gates(taut, quiet()), "chordal_tension", GateSeverity::Pass, "1.0 to 3.0 N");
  taut.measure.tension_max_n = 3.1;
  expect_gate(closure_gates(taut, quiet()), "chordal_tension", GateSeverity::Warn, "1.0 to 3.1 N");
  Evaluation slack = quiet();
  slack.measure.tension_max_n = 0.0;  // a rise from next to nothing means nothing
  Evaluation slightly = quiet();
  slightly.measure.tension_max_n = 0.5;
  expect_gate(closure_gates(slightly, slack), "chordal_tension", GateSeverity::Pass, "0.5 N");
  Evaluation unknown = quiet();
  unknown.crossing = true;
  expect_gate(closure_gates(taut, unknown), "chordal_tension", GateSeverity::NotAssessed,
              "unrepaired");
}

}  // namespace
}  // namespace coapt
