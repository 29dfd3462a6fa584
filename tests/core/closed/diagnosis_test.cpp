#include "core/closed/diagnosis.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/closed/closed_valve.h"
#include "core/closed/diagnosis_sentence.h"
#include "core/presets/human_presets.h"
#include "core/valve/remodel.h"
#include "core/valve/ruptures.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

std::optional<Diagnosis> diagnosis_of(const Valve& valve) {
  const ClosedValve closed = close_and_measure(valve);
  return diagnose(closed.valve, closed.closure, closed.measure);
}

Diagnosis of_preset(const std::string& name) { return *diagnosis_of(shared_preset(name, 650)); }

std::vector<Segment> names(const std::vector<SegmentDiagnosis>& segments) {
  std::vector<Segment> found;
  for (const SegmentDiagnosis& segment : segments) found.push_back(segment.segment);
  return found;
}

TEST(Diagnosis, PresetsHaveTheTypeOfTheirDisease) {
  for (const char* name : {"human-normal", "hypertrophic", "porcine-1", "porcine-4"}) {
    const Diagnosis found = of_preset(name);
    EXPECT_TRUE(found.competent) << name;
    EXPECT_TRUE(found.types.empty()) << name;
  }
  for (const char* name : {"human-functional-mr", "secondary-mr"})
    EXPECT_EQ(of_preset(name).types, std::vector{CarpentierType::IIIb}) << name;
  for (const char* name : {"human-p2-prolapse", "fibroelastic-flail", "barlow", "marfan"}) {
    const Diagnosis found = of_preset(name);
    EXPECT_EQ(found.types, std::vector{CarpentierType::II}) << name;
    EXPECT_TRUE(found.type_sure) << name;
    const std::vector<Segment> segments = names(prolapsing(found));
    EXPECT_NE(std::find(segments.begin(), segments.end(), Segment::P2), segments.end()) << name;
  }
}

TEST(Diagnosis, ADilatedAnnulusWithTipsInPlaceIsTypeI) {
  const auto dilated = remodel(shared_preset("human-normal", 650),
                               {.ap_dilation_percent = 30.0, .annular_height_percent = 50.0});
  const Diagnosis found = *diagnosis_of(*dilated);
  EXPECT_EQ(found.types, std::vector{CarpentierType::I});
  EXPECT_TRUE(found.annulus_dilated);
  EXPECT_TRUE(prolapsing(found).empty());
}

TEST(Diagnosis, ADisplacedMuscleIsTypeIIIbOfItsSide) {
  const auto displaced =
      remodel(shared_preset("human-normal", 650),
              {.ap_dilation_percent = 12.0, .posteromedial_mm = Vec3(6.0, 6.0, 8.0)});
  const Diagnosis found = *diagnosis_of(*displaced);
  ASSERT_EQ(found.types, std::vector{CarpentierType::IIIb});
  EXPECT_EQ(found.tethered_side, Side::Posteromedial);
  EXPECT_EQ(found.segments[5].finding, SegmentFinding::Tethered) << "P3";
  EXPECT_EQ(found.segments[3].finding, SegmentFinding::Normal) << "P1";
}

TEST(Diagnosis, ARuptureIsFoundWhereItIs) {
  Remodelling change{.ap_dilation_percent = 8.0};
  change.ruptured = {Segment::P2};
  const Diagnosis found = *diagnosis_of(*remodel(shared_preset("human-normal", 650), change));
  EXPECT_EQ(names(prolapsing(found)), std::vector{Segment::P2});
  EXPECT_EQ(found.segments[4].finding, SegmentFinding::Flail);
  EXPECT_GT(found.segments[4].ruptured, 0);
  EXPECT_GT(found.segments[4].width_mm, 5.0);
  EXPECT_EQ(found.segments[1].ruptured, 0);
}

TEST(Diagnosis, SaysFirstWhatObservationsLeaveOfTheLeak) {
  const std::string sentence = sentence_of(of_preset("human-functional-mr"),
                                           {58.0, Interval{52.0, 64.0}, Interval{21.2, 37.4}});
  EXPECT_EQ(sentence.rfind("The valve leaks 21 to 37 mm² (58 mm² with the tissue of its file) ", 0),
            0u)
      << sentence;
}

TEST(Diagnosis, DeepCleftsThatLeakAreTypeI) {
  HumanValve human = human_normal();
  human.dimensions.cleft_depth_mm = 8.0;
  const Diagnosis found = *diagnosis_of(*make_human_valve(human));
  ASSERT_EQ(found.clefts.size(), 2u);
  EXPECT_EQ(found.types.front(), CarpentierType::I);
  EXPECT_TRUE(clefts_explain(found));
  const Cleft &lateral = found.clefts[0], &medial = found.clefts[1];
  EXPECT_EQ(std::pair(lateral.first, lateral.second), std::pair(Segment::P1, Segment::P2));
  EXPECT_EQ(std::pair(medial.first, medial.second), std::pair(Segment::P2, Segment::P3));
  for (const Cleft& cleft : found.clefts) {
    EXPECT_NEAR(cleft.share, 0.5, 0.1);
    EXPECT_NEAR(cleft.depth_mm, 6.0, 1.5) << "the chord to the annulus is shorter than the leaflet";
    EXPECT_GT(cleft.leak_mm2, kMildLeak_mm2);
  }
  EXPECT_NEAR(lateral.along, 1.0 / 3.0, 0.05);
  EXPECT_NEAR(medial.along, 2.0 / 3.0, 0.05);
  const std::string sentence = sentence_of(found);
  EXPECT_NE(sentence.find("the clefts between P1 and P2 and between P2 and P3 leak"),
            std::string::npos)
      << sentence;
  human.dimensions.cleft_depth_mm = 3.0;
  EXPECT_TRUE(diagnosis_of(*make_human_valve(human))->clefts.empty()) << "an indentation seals";
}

TEST(Diagnosis, SaysInASentenceWhy) {
  const std::string flail = sentence_of(of_preset("human-p2-prolapse"));
  EXPECT_NE(flail.find("the chordae of P2 are ruptured"), std::string::npos) << flail;
  EXPECT_NE(flail.find("(Carpentier type II)."), std::string::npos) << flail;
  EXPECT_EQ(sentence_of(of_preset("human-normal")).rfind("The valve is competent: it leaks ", 0),
            0U);
  EXPECT_EQ(summary_of(of_preset("human-p2-prolapse")),
            "It leaks because the chordae of P2 are ruptured (Carpentier type II).");
  EXPECT_EQ(summary_of(of_preset("human-normal")), "The valve is competent.");
  Diagnosis doubtful;
  doubtful.leak_mm2 = 6.0;
  doubtful.annulus_dilated = true;
  doubtful.leak_error_mm2 = 2.0;
  doubtful.competent_sure = false;
  doubtful.types = {CarpentierType::I};
  doubtful.type_sure = false;
  doubtful.not_ruled_out = CarpentierType::IIIb;
  doubtful.ap_mm = 33.0;
  doubtful.transverse_mm = 36.0;
  EXPECT_EQ(sentence_of(doubtful),
            "The valve leaks 6.0 ± 2.0 mm², probably because the annulus is too wide for the "
            "leaflets: its diameters are 33 mm (anteroposterior) and 36 mm (transverse), a ratio "
            "of 0.92, "
            "where 0.75 is normal (Carpentier type I). Carpentier type IIIb is not ruled out. The "
            "leak is too close to 5 mm² to tell whether the valve is competent.");
  EXPECT_EQ(
      summary_of(doubtful),
      "It leaks, probably because the annulus is too wide for the leaflets (Carpentier type I). "
      "Carpentier type IIIb is not ruled out. The leak is too close to 5 mm² to tell whether the "
      "valve is competent.");
  Estimate leak{6.0, Interval{4.0, 8.0}, Interval{2.0, 16.0}, {}};
  EXPECT_EQ(sentence_of(doubtful, leak)
                .rfind("The valve leaks 6 mm² (2 to 16 mm² with tissue error), ", 0),
            0U);
  leak.tissue.reset();
  EXPECT_EQ(sentence_of(doubtful, leak), sentence_of(doubtful));
}

TEST(Diagnosis, SaysThatOtherTissueMayLeak) {
  Diagnosis closed;
  closed.competent = true;
  Estimate leak{0.0, Interval{0.0, 1.0}, Interval{0.0, 14.0}, {}};
  EXPECT_EQ(sentence_of(closed, leak),
            "The valve is competent: it leaks 0 mm² (0 to 14 mm² with tissue error). The tissue "
            "error includes leaks above 5 mm², the limit of competence.");
  EXPECT_FALSE(is_competence_sure(closed, leak));
  leak.tissue->high = 5.0;
  EXPECT_TRUE(is_competence_sure(closed, leak));
  EXPECT_TRUE(is_competence_sure(closed, {}));
  Diagnosis leaks;
  leaks.leak_mm2 = 20.0;
  leaks.types = {CarpentierType::I};
  leak = {20.0, Interval{19.0, 21.0}, Interval{4.0, 40.0}, {}};
  const std::string sentence = sentence_of(leaks, leak);
  EXPECT_TRUE(
      sentence.ends_with("The tissue error includes leaks below 5 mm², the limit of competence."))
      << sentence;
  leak.tissue->low = 6.0;
  EXPECT_TRUE(is_competence_sure(leaks, leak));
  closed.competent_sure = false;
  EXPECT_FALSE(is_competence_sure(closed, {}));
}

TEST(Diagnosis, BothSidesOfACommissureAreOneLesion) {
  Diagnosis lateral;
  lateral.leak_mm2 = 30.0;
  lateral.types = {CarpentierType::II};
  for (std::size_t i = 0; i < lateral.segments.size(); ++i)
    lateral.segments[i].segment = kScallops[i];
  for (SegmentDiagnosis& one : lateral.segments)
    if (one.segment == Segment::A1 || one.segment == Segment::P1) {
      one.finding = SegmentFinding::Prolapse;
      one.highest_mm = 3.0;
    }
  const auto says = [&](const char* words) {
    return sentence_of(lateral).find(words) != std::string::npos;
  };
  EXPECT_TRUE(says("because the anterolateral commissure (A1 and P1) prolapses"));
  lateral.segments[4].finding = SegmentFinding::Prolapse;
  EXPECT_TRUE(says("the anterolateral commissure (A1 and P1) and P2 prolapse:"));
}

TEST(Diagnosis, IsTheSameHoweverTheValveLies) {
  const Valve& valve = shared_preset("human-functional-mr", 650);
  const ClosedValve closed = close_and_measure(valve);
  const Diagnosis straight = *diagnose(closed.valve, closed.closure, closed.measure);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -1.0).normalized()).matrix();
  const auto turned = [&](const Points& points) -> Points { return points * turn.transpose(); };
  ClosedValve moved = closed;
  moved.valve.annulus_mm = turned(moved.valve.annulus_mm);
  moved.valve.rest_mm = turned(moved.valve.rest_mm);
  moved.closure.closed_mm = turned(moved.closure.closed_mm);
  for (PapillaryHead& head : moved.valve.heads) head.tip_mm = turn * head.tip_mm;
  const Diagnosis same = *diagnose(moved.valve, moved.closure, moved.measure);
  EXPECT_NEAR(same.tethering, straight.tethering, 1e-9);
  for (int s = 0; s < 6; ++s)
    EXPECT_NEAR(same.segments[s].override_mm, straight.segments[s].override_mm, 1e-9);
}

TEST(Diagnosis, LeafletsThatHardlyOpenAreTypeIIIa) {
  const ClosedValve closed = close_and_measure(shared_preset("human-normal", 650));
  EXPECT_EQ(diagnose(closed.valve, closed.closure, closed.measure, 120.0)->types,
            std::vector{CarpentierType::IIIa});
  EXPECT_TRUE(diagnose(closed.valve, closed.closure, closed.measure, 400.0)->types.empty());
}

TEST(Diagnosis, NothingIsSaidOfAClosureThatIsNotToBeTrusted) {
  ClosedValve closed = close_and_measure(shared_preset("human-functional-mr", 650));
  closed.closure.crossing = true;
  EXPECT_FALSE(diagnose(closed.valve, closed.closure, closed.measure));
}

}  // namespace
}  // namespace coapt
