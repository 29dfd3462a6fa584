#include "lab/indications/indications.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coapt {
namespace {

const RepairStep kClassic = Annuloplasty{CatalogueRing{"generic-classic", 32.0}};
const RepairStep kShort = Annuloplasty{CatalogueRing{"generic-etlogix-like", 32.0}};
const RepairStep kOwn = Annuloplasty{OwnRing{2}};
const RepairStep kSuture =
    PapillaryApproximation{.side = Side::Posteromedial, .suture_length_mm = 26.0};
const RepairStep kNeochorda = Neochorda{"PM1", {Leaflet::Posterior, 0.5, 1.0}, 18.0};

bool is_indicated(std::vector<RepairStep> steps, const std::string& type) {
  RankedPlan plan;
  plan.plan.steps = std::move(steps);
  return coapt::is_indicated(plan, type);
}

TEST(Indications, AreThoseOfTheDisease) {
  EXPECT_TRUE(is_indicated({}, "competent"));
  EXPECT_FALSE(is_indicated({kClassic}, "competent"));
  EXPECT_TRUE(is_indicated({kClassic}, "I"));
  EXPECT_FALSE(is_indicated({}, "I"));
  EXPECT_FALSE(is_indicated({kShort}, "I"));
  EXPECT_FALSE(is_indicated({kClassic, kSuture}, "I"));
  EXPECT_TRUE(is_indicated({kClassic, kNeochorda}, "II"));
  EXPECT_TRUE(is_indicated({kClassic, LeafletResection{}}, "II"));
  EXPECT_FALSE(is_indicated({kClassic}, "II"));
  EXPECT_FALSE(is_indicated({kNeochorda}, "II"));
  EXPECT_FALSE(is_indicated({kShort, kNeochorda}, "II"));
  EXPECT_TRUE(is_indicated({kShort, kSuture}, "IIIb"));
  EXPECT_TRUE(is_indicated({kClassic}, "IIIb"));
  EXPECT_FALSE(is_indicated({kOwn, kSuture}, "IIIb"));
}

TEST(Indications, AnAvoidableWarningSpeaksAgainstAPlan) {
  RankedPlan plan;
  plan.plan.steps = {kClassic};
  plan.gates = {{"coaptation_height", GateSeverity::Warn, "", ""},
                {"ring_stenosis", GateSeverity::Pass, "", ""}};
  EXPECT_TRUE(coapt::is_indicated(plan, "I"));
  plan.gates.push_back({"ring_stenosis", GateSeverity::Warn, "", ""});
  EXPECT_FALSE(coapt::is_indicated(plan, "I"));
}

TEST(Indications, EveryLineOfTheTableHasEveryColumn) {
  IndicationRow plain{.valve = "a", .type = "I", .diagnosed = "I", .first_plan = "ring; suture"};
  IndicationRow asked = plain;
  asked.same_class = 3;
  asked.challenge = Challenge{.plans = 12, .acceptable = 2, .ring_alone = "ring"};
  const std::string csv = indications_csv({plain, asked});
  std::vector<std::ptrdiff_t> commas;
  for (std::size_t from = 0; from < csv.size();) {
    const std::size_t to = csv.find('\n', from);
    commas.push_back(std::count(csv.begin() + static_cast<std::ptrdiff_t>(from),
                                csv.begin() + static_cast<std::ptrdiff_t>(to), ','));
    from = to + 1;
  }
  ASSERT_EQ(commas.size(), 3u);
  EXPECT_EQ(commas[1], commas[0]);
  EXPECT_EQ(commas[2], commas[0]);
}

TEST(Indications, ThresholdsWereChosenOnTwelveValves) {
  const Expected<std::vector<KnownDisease>> known = known_presets();
  ASSERT_TRUE(known);
  EXPECT_EQ(known->size(), 12u);
}

}  // namespace
}  // namespace coapt
