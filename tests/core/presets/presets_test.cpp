#include "core/presets/presets.h"

#include <gtest/gtest.h>

#include <map>

#include "core/closure/closure.h"
#include "core/closure/tauten.h"
#include "core/metrics/measure.h"
#include "core/valve/leaflet_point.h"
#include "core/valve/remodel.h"
#include "core/valve/validate.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

class HealthyPreset : public testing::TestWithParam<const char*> {};

TEST_P(HealthyPreset, IsCompetentTouchesAtNineSectionsAndDoesNotCross) {
  const Valve& valve = shared_preset(GetParam());
  EXPECT_TRUE(validate(valve).empty());
  const ClosureResult closed = close_valve(valve);
  EXPECT_EQ(closed.status, ClosureStatus::Converged);
  EXPECT_FALSE(closed.crossing);
  const ValveMeasure measured = measure(valve, closed);
  EXPECT_LT(measured.leak.area_mm2, 1.0);
  for (const CoaptationSection& section : measured.coaptation.sections)
    EXPECT_TRUE(section.contact) << "at " << section.along << ": " << section.distance_mm << " mm";
}

INSTANTIATE_TEST_SUITE_P(All, HealthyPreset,
                         testing::Values("porcine-1", "porcine-2", "porcine-3", "porcine-4",
                                         "porcine-5", "human-normal"));

TEST(Preset, OfEveryNameIsAValidValveWithTheDiametersOfItsTable) {
  for (const std::string& name : preset_names()) {
    const Expected<Valve> valve = make_preset(name);
    ASSERT_TRUE(valve) << name;
    EXPECT_TRUE(validate(*valve).empty()) << name;
    EXPECT_EQ(valve->name, name);
  }
  const Valve& porcine = shared_preset("porcine-3");
  const AnnulusMeasure annulus = measure(porcine, close_valve(porcine)).annulus;
  EXPECT_NEAR(annulus.ap_mm, 25.9, 0.2);
  EXPECT_NEAR(annulus.al_pm_mm, 41.3, 0.3);
}

TEST(Preset, OfAnUnknownNameNamesTheKnownOnes) {
  const Expected<Valve> valve = make_preset("ovine-1");
  ASSERT_FALSE(valve);
  EXPECT_EQ(valve.errors()[0].code, ErrorCode::Unsupported);
  EXPECT_NE(valve.errors()[0].message.find("human-normal"), std::string::npos);
}

TEST(Preset, HasTheSameChordaeLengthsAtEveryResolution) {
  const Valve &coarse = shared_preset("porcine-1", 650), &fine = shared_preset("porcine-1", 2600);
  EXPECT_NEAR(static_cast<double>(fine.faces.rows()), 2600.0, 130.0);
  ASSERT_EQ(coarse.chordae.size(), fine.chordae.size());
  for (std::size_t c = 0; c < coarse.chordae.size(); ++c)
    for (std::size_t s = 0; s < coarse.chordae[c].segments.size(); ++s)
      EXPECT_EQ(coarse.chordae[c].segments[s].rest_length_mm,
                fine.chordae[c].segments[s].rest_length_mm);
}

TEST(TautValve, HasEachGroupOfChordaeByItsOwnSlack) {
  ParametricValve d;
  d.triangles = 300;
  const Valve taut = *make_taut_valve(d);
  d.slack = {1.1, 1.2, 0.95, 0.9, 1.05};
  const Valve slack = *make_taut_valve(d);
  for (std::size_t c = 0; c < taut.chordae.size(); ++c) {
    const Chorda& chorda = taut.chordae[c];
    const bool commissural = chorda.id.find("C-marginal") != std::string::npos;
    const bool posterior = chorda.id.find("-P1-") != std::string::npos ||
                           chorda.id.find("-P2-") != std::string::npos ||
                           chorda.id.find("-P3-") != std::string::npos;
    const double expected = chorda.kind == ChordaKind::Strut   ? 0.9
                            : chorda.kind == ChordaKind::Basal ? 1.05
                            : commissural                      ? 0.95
                            : posterior                        ? 1.2
                                                               : 1.1;
    for (std::size_t s = 0; s < chorda.segments.size(); ++s)
      EXPECT_NEAR(slack.chordae[c].segments[s].rest_length_mm,
                  expected * chorda.segments[s].rest_length_mm, 1e-9)
          << chorda.id;
  }
}

TEST(Preset, OfAProlapseHasTwoRupturedChordae) {
  for (const int triangles : {0, 1000, 2000}) {
    std::vector<std::string> ruptured;
    const Valve& valve = shared_preset("human-p2-prolapse", triangles);
    for (const Chorda& chorda : valve.chordae)
      if (chorda.ruptured) ruptured.push_back(chorda.id);
    EXPECT_EQ(ruptured, (std::vector<std::string>{"AL3-P2-marginal-5", "PM3-P2-marginal-5"}));
  }
}

const ValveMeasure& closed_preset(const std::string& name) {
  static std::map<std::string, ValveMeasure> known;
  const auto found = known.find(name);
  if (found != known.end()) return found->second;
  const Valve& valve = shared_preset(name);
  const ClosureResult closed = close_valve(valve);
  EXPECT_EQ(closed.status, ClosureStatus::Converged) << name;
  EXPECT_FALSE(closed.crossing) << name;
  return known.emplace(name, measure(valve, closed)).first->second;
}

TEST(Preset, OfADiseaseHasTheAnnulusOfItsSourceAndItsLeak) {
  struct Disease {
    const char* name;
    double area, least_mm2, most_mm2;  // leaks: search/studies/physiology_ranges.cpp
  };
  const double normal = closed_preset("human-normal").annulus.area_mm2;
  for (const auto& [name, area, least_mm2, most_mm2] :
       {Disease{"barlow", 15.0 / 10.6, 20.0, 100.0},
        Disease{"fibroelastic-flail", 13.3 / 10.6, 20.0, 100.0},
        Disease{"marfan", 1.04 * 1.04 * 1.15, 20.0, 100.0},
        Disease{"secondary-mr", 802.0 / 608.0, 20.0, 60.0},
        Disease{"hypertrophic", 1.0, 0.0, 1.0}}) {
    const ValveMeasure& measured = closed_preset(name);
    EXPECT_NEAR(measured.annulus.area_mm2 / normal, area, 0.02) << name;
    EXPECT_GE(measured.leak.area_mm2, least_mm2) << name;
    EXPECT_LE(measured.leak.area_mm2, most_mm2) << name;
  }
}

TEST(Preset, OfDegenerativeDiseaseBillowsAndOneOfSecondaryRegurgitationTents) {
  const double normal = closed_preset("human-normal").tenting_height_mm;
  for (const char* name : {"barlow", "marfan"})
    EXPECT_LT(closed_preset(name).tenting_height_mm, 0.0) << name;
  // A2 is held as in health; where P2 has gone, its edge is the coaptation point.
  EXPECT_LT(closed_preset("fibroelastic-flail").tenting_height_mm, normal - 5.0);
  EXPECT_GT(closed_preset("secondary-mr").tenting_height_mm, normal + 2.0);
  EXPECT_GT(closed_preset("secondary-mr").tenting_area_mm2,
            1.5 * closed_preset("human-normal").tenting_area_mm2);
}

TEST(Preset, OfHypertrophicDiseaseHasTheLeafletsOfItsSource) {
  const auto height = [](const char* name, Leaflet leaflet) {
    // Of the middle of the leaflet: from annulus to free edge along a column of the skirt.
    const Valve& valve = shared_preset(name);
    const LeafletCoordinates coordinates = leaflet_coordinates(valve);
    double sum = 0.0;
    Vec3 last = Vec3::Zero();
    for (int step = 0; step <= 20; ++step) {
      const Insertion at = locate(valve, coordinates, {leaflet, 0.5, step / 20.0});
      const Vec3 here = position(at, valve.faces, valve.rest_mm);
      if (step > 0) sum += (here - last).norm();
      last = here;
    }
    return sum;
  };
  const double both = 0.5 * (26.0 / 19.0 + 14.0 / 10.0);  // one growth of both
  for (const Leaflet leaflet : {Leaflet::Anterior, Leaflet::Posterior})
    EXPECT_NEAR(height("hypertrophic", leaflet) / height("human-normal", leaflet), both, 0.01)
        << to_string(leaflet);
}

TEST(Preset, LeaksMoreTheFurtherTheAnnulusDilatesOrTheTipsDescend) {
  const Valve& valve = shared_preset("porcine-1");
  const auto leak = [&](const Remodelling& change) {
    const Valve changed = *remodel(valve, change);
    return measure(changed, close_valve(changed)).leak.area_mm2;
  };
  double before = 0.5;
  for (const double percent : {15.0, 22.0, 30.0}) {
    Remodelling change;
    change.ap_dilation_percent = percent;
    const double area = leak(change);
    EXPECT_GT(area, before) << percent << " %";
    before = area;
  }
  before = 0.5;
  for (const double apical_mm : {6.0, 8.0, 10.0}) {
    Remodelling change;
    change.anterolateral_mm = change.posteromedial_mm = Vec3(0.0, 0.0, apical_mm);
    const double area = leak(change);
    EXPECT_GT(area, before) << apical_mm << " mm";
    before = area;
  }
}

TEST(Presets, HumanNormalOfThinnerOrThickerTissueTouchesAtItsOwnThickness) {
  for (const double thickness : {0.6, 1.4}) {
    ParametricValve dimensions;
    Valve valve = *make_parametric_valve(dimensions);
    valve.tissue.thickness_mm = thickness;
    const ClosureResult open = close_valve(valve);
    const Valve taut = tauten(valve, open, 1.0);
    const ClosureResult closed = close_valve(taut);
    const ValveMeasure measured = measure(taut, closed);
    EXPECT_FALSE(closed.crossing) << thickness;
    EXPECT_LT(measured.leak.area_mm2, 1.0) << thickness;
    for (const CoaptationSection& section : measured.coaptation.sections)
      EXPECT_TRUE(section.contact) << thickness << ' ' << section.along;
  }
}

}  // namespace
}  // namespace coapt
