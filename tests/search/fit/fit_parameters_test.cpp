#include "search/fit/fit_parameters.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/valve/leaflet_coordinates.h"
#include "tests/scenes/leaflet_valves.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

struct Example {
  Valve valve;
  std::vector<FitParameter> parameters;

  std::vector<double> priors() const {
    std::vector<double> values;
    for (const FitParameter& parameter : parameters) values.push_back(parameter.prior);
    return values;
  }
  std::size_t place(const std::string& name) const {
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const FitParameter& p) { return p.name == name; });
    return static_cast<std::size_t>(found - parameters.begin());
  }
  Valve with(const std::string& name, double value) const {
    std::vector<double> values = priors();
    values.at(place(name)) = value;
    Expected<Valve> changed = with_parameters(valve, parameters, values);
    EXPECT_TRUE(changed) << name;
    return *changed;
  }
};

Example human() {
  Valve valve = small_preset("human-normal");
  std::vector<FitParameter> parameters = fit_parameters(valve, {});
  return {std::move(valve), std::move(parameters)};
}

TEST(FitParameters, PriorsAreTheValveItself) {
  const Example example = human();
  const Expected<Valve> same = with_parameters(example.valve, example.parameters, example.priors());
  ASSERT_TRUE(same);
  EXPECT_EQ(same->rest_mm, example.valve.rest_mm);
  EXPECT_EQ(same->chordae, example.valve.chordae);
  EXPECT_EQ(same->tissue, example.valve.tissue);
  EXPECT_LT((same->fibre - example.valve.fibre).norm(), 1e-12);
}

TEST(FitParameters, StiffnessIsOfTheModuliAboveTheTransitionAlone) {
  const Example example = human();
  const Tissue &own = example.valve.tissue, stiff = example.with("stiffness", 2.0).tissue;
  EXPECT_EQ(stiff.circumferential_post_kpa, 2.0 * own.circumferential_post_kpa);
  EXPECT_EQ(stiff.radial_post_kpa, 2.0 * own.radial_post_kpa);
  EXPECT_EQ(stiff.circumferential_pre_kpa, own.circumferential_pre_kpa);
  EXPECT_EQ(stiff.chordae_kpa, own.chordae_kpa);
}

TEST(FitParameters, EveryChordaBelongsToOneGroup) {
  const Example example = human();
  std::vector<int> held(example.valve.chordae.size(), 0);
  for (const FitParameter& parameter : example.parameters)
    if (const auto* group = std::get_if<ChordalGroup>(&parameter.changes))
      for (const int chorda : group->chordae) ++held[static_cast<std::size_t>(chorda)];
  EXPECT_EQ(held, std::vector<int>(held.size(), 1));
}

TEST(FitParameters, SlackMakesTheGroupsPiecesLongerAndNoOthers) {
  const Example example = human();
  const Valve slack = example.with("slack_strut_AL", 1.1);
  for (std::size_t c = 0; c < slack.chordae.size(); ++c) {
    const Chorda &was = example.valve.chordae[c], &is = slack.chordae[c];
    const bool of_group =
        was.kind == ChordaKind::Strut &&
        slack.heads[static_cast<std::size_t>(was.head)].side == Side::Anterolateral;
    for (std::size_t s = 0; s < is.segments.size(); ++s)
      EXPECT_DOUBLE_EQ(is.segments[s].rest_length_mm,
                       (of_group ? 1.1 : 1.0) * was.segments[s].rest_length_mm);
  }
}

TEST(FitParameters, ATipTakesAllHeadsOfItsMuscleAlong) {
  const Example example = human();
  const Valve moved = example.with("tip_PM_z", -2.0);
  for (std::size_t h = 0; h < moved.heads.size(); ++h) {
    const double by = moved.heads[h].side == Side::Posteromedial ? -2.0 : 0.0;
    EXPECT_DOUBLE_EQ(moved.heads[h].tip_mm.z(), example.valve.heads[h].tip_mm.z() + by);
    EXPECT_DOUBLE_EQ(moved.heads[h].tip_mm.x(), example.valve.heads[h].tip_mm.x());
  }
}

TEST(FitParameters, HiddenHeightLengthensTheLeafletBelowItsMiddle) {
  const Example example = human();
  const Valve taller = example.with("hidden_anterior", 2.0);
  const LeafletCoordinates at = leaflet_coordinates(example.valve);
  double most = 0.0;
  for (Eigen::Index v = 0; v < taller.rest_mm.rows(); ++v) {
    const auto i = static_cast<std::size_t>(v);
    const double moved = (taller.rest_mm.row(v) - example.valve.rest_mm.row(v)).norm();
    if (at.height[i] <= 0.5 || at.around[i] >= 0.5) {
      EXPECT_EQ(moved, 0.0);
    }
    most = std::max(most, moved);
  }
  EXPECT_NEAR(most, 2.0, 1e-3);  // at the free edge of A2
}

TEST(FitParameters, AnExcisedValveHasNoPrestretch) {
  Valve valve = small_preset("human-normal");
  valve.tissue.reference = TissueReference::Excised;
  for (const FitParameter& parameter : fit_parameters(valve, {}))
    EXPECT_FALSE(std::holds_alternative<Prestretch>(parameter.changes));
}

TEST(FitParameters, ChordaeThatNobodyHasSeenAreGroupedByScallop) {
  Valve valve = small_preset("human-normal");
  valve.drawn_chordae = DrawnChordae{};
  const std::vector<FitParameter> parameters = fit_parameters(valve, {});
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [](const FitParameter& p) { return p.name == "slack_P2_AL"; });
  ASSERT_NE(found, parameters.end());
  EXPECT_GT(found->prior_sd, FitUnknowns{}.slack_sd);
}

TEST(FitParameters, MusclesOfAValveThatIsNotMitralAreHeadsNearEachOther) {
  Valve valve = three_leaflets();
  std::vector<std::string> names;
  for (const FitParameter& parameter : fit_parameters(valve, {})) {
    names.push_back(parameter.name);
    if (const auto* tip = std::get_if<TipPlace>(&parameter.changes)) {
      EXPECT_FALSE(tip->heads.empty());
    }
  }
  // Each muscle has its three coordinates, and each leaflet that it holds a slack.
  const std::string first = valve.heads.front().id;
  EXPECT_EQ(std::count(names.begin(), names.end(), "tip_" + first + "_x"), 1);
  PapillaryHead beside = valve.heads.front();
  beside.id = "beside";
  beside.rest_mm.x() += 1.0;
  valve.heads.push_back(beside);
  EXPECT_EQ(fit_parameters(valve, {}).size(), names.size());
  valve.heads.back().rest_mm.x() += 10.0 + 1000.0;
  EXPECT_EQ(fit_parameters(valve, {}).size(), names.size() + 3);
}

}  // namespace
}  // namespace coapt
