#include "search/plans/plan_key.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace coapt {
namespace {

const Neochorda kNeochorda = {"AL1", {Leaflet::Posterior, 0.4, 1.0}, 20.0};
const PapillaryApproximation kSutureStep = {
    .side = Side::Posteromedial, .anchor = Anchor::AnnulusPoint, .suture_length_mm = 25.0};

std::string key(const RepairStep& step) { return plan_key({{step}}); }

std::vector<RepairStep> one_of_each() {
  return {Annuloplasty{CatalogueRing{"d", 32.0}},
          kNeochorda,
          ChordalLengthChange{"a", -2.0},
          ChordalExcision{"b"},
          ChordalTransfer{"c", {Leaflet::Anterior, 0.5, 1.0}},
          kSutureStep,
          EdgeToEdge{},
          LeafletResection{}};
}

TEST(PlanKey, DoesNotDependOnTheOrderOfTheSteps) {
  std::vector<RepairStep> steps = one_of_each();
  const std::string forwards = plan_key({steps});
  std::reverse(steps.begin(), steps.end());
  EXPECT_EQ(plan_key({steps}), forwards);
  EXPECT_EQ(forwards.find('\n'), std::string::npos);
}

TEST(PlanKey, OfNothingIsEmpty) { EXPECT_EQ(plan_key({}), ""); }

TEST(PlanKey, TellsStepsApart) {
  std::set<std::string> keys;
  for (const RepairStep& step : one_of_each()) keys.insert(key(step));
  EXPECT_EQ(keys.size(), 8u);
  EXPECT_NE(plan_key({{kNeochorda}}), plan_key({{kNeochorda, kNeochorda}}));
}

TEST(PlanKey, TellsEveryFieldApart) {
  Neochorda other = kNeochorda;
  other.insertion.leaflet = Leaflet::Anterior;
  EXPECT_NE(key(other), key(kNeochorda));
  other = kNeochorda;
  other.insertion.height = 0.9;
  EXPECT_NE(key(other), key(kNeochorda));
  PapillaryApproximation suture = kSutureStep;
  suture.side = Side::Anterolateral;
  EXPECT_NE(key(suture), key(kSutureStep));
  suture = kSutureStep;
  suture.annulus_around = 0.3;
  EXPECT_NE(key(suture), key(kSutureStep));
  const EdgeToEdge clip{EdgeDevice::Clip};
  EXPECT_NE(key(clip), key(EdgeToEdge{EdgeDevice::Stitch}));
  EXPECT_NE(key(EdgeToEdge{.device = EdgeDevice::Clip, .grasp_mm = 6.0}), key(clip));
  EXPECT_NE(key(EdgeToEdge{.device = EdgeDevice::Clip, .rows = 3}), key(clip));
  EXPECT_NE(key(EdgeToEdge{.device = EdgeDevice::Clip, .annulus_drawn_in_percent = 9.0}),
            key(clip));
  const LeafletResection wedge, strip{.shape = ResectionShape::Quadrangular};
  EXPECT_NE(key(LeafletResection{.height = 0.8}), key(wedge));
  EXPECT_NE(key(LeafletResection{.leaflet = Leaflet::Anterior}), key(wedge));
  EXPECT_NE(key(strip), key(wedge));
  EXPECT_NE(key(LeafletResection{.shape = ResectionShape::Quadrangular, .sliding = false}),
            key(strip));
  EXPECT_NE(key(Annuloplasty{OwnRing{2}}), key(Annuloplasty{OwnRing{3}}));
  const DesignedRing mine{{"mine", {}}, 30.0};
  DesignedRing other_ring = mine;
  other_ring.shape.terms.saddle = 0.1;
  EXPECT_NE(key(Annuloplasty{mine}), key(Annuloplasty{other_ring}));
  EXPECT_NE(key(Annuloplasty{mine}), key(Annuloplasty{CatalogueRing{"mine", 30.0}}));
}

TEST(PlanKey, APlaceThatDoesNotCountIsNotInIt) {
  PapillaryApproximation suture = kSutureStep;
  suture.anchor = Anchor::SaddlePeak;
  PapillaryApproximation elsewhere = suture;
  elsewhere.annulus_around = 0.9;
  EXPECT_EQ(key(elsewhere), key(suture));
}

TEST(PlanKey, RoundsToAMillionthOfAMillimetre) {
  Neochorda other = kNeochorda;
  other.length_mm = 20.0 + 4e-7;
  EXPECT_EQ(key(other), key(kNeochorda));
  other.length_mm = 20.0 - 4e-7;
  EXPECT_EQ(key(other), key(kNeochorda));
  other.length_mm = 20.0 + 6e-7;
  EXPECT_NE(key(other), key(kNeochorda));
}

TEST(PlanKey, MinusZeroIsZero) {
  const std::string zero = key(ChordalLengthChange{"a", 0.0});
  EXPECT_EQ(key(ChordalLengthChange{"a", -0.0}), zero);
  EXPECT_EQ(key(ChordalLengthChange{"a", -1e-7}), zero);
  EXPECT_NE(key(ChordalLengthChange{"a", -1e-6}), zero);
}

TEST(PlanKey, NoNameCanPassForAStep) {
  const std::string two = plan_key({{ChordalExcision{"a"}, ChordalExcision{"b"}}});
  for (const char* name : {"a; excision b", "a\"; excision \"b", "a\\\"; excision \\\"b"})
    EXPECT_NE(key(ChordalExcision{name}), two);
  EXPECT_NE(key(ChordalExcision{"a\nb"}), key(ChordalExcision{"a\\nb"}));
  EXPECT_EQ(key(ChordalExcision{"a\nb"}).find('\n'), std::string::npos);
}

}  // namespace
}  // namespace coapt
