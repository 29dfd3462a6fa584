#include "io/json/subject.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "core/presets/presets.h"
#include "io/json/valve_json.h"
#include "search/studies/orifice_table.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

TEST(Fnv1a128, GivesThePublishedValues) {
  EXPECT_EQ(fnv1a_128(""), "6c62272e07bb014262b821756295c58d");
  EXPECT_EQ(fnv1a_128("a"), "d228cb696f1a8caf78912b704e4a8964");
  EXPECT_EQ(fnv1a_128("foobar"), "343e1662793c64bf6f0d3597ba446f18");
}

TEST(Subject, IsTheSameForTheSameValveReadBack) {
  const Valve valve = small_valve();
  const Expected<Valve> read = read_valve(write_valve(valve));
  ASSERT_TRUE(read);
  const std::string subject = subject_of(valve, {});
  EXPECT_EQ(subject_of(*read, {}), subject);
  EXPECT_EQ(subject.size(), 32u);
  EXPECT_EQ(subject.find_first_not_of("0123456789abcdef"), std::string::npos);
}

TEST(Subject, IsNotOfNameAndProvenance) {
  Valve valve = small_valve();
  const std::string subject = subject_of(valve, {});
  valve.name = "another";
  valve.provenance.push_back("copied");
  EXPECT_EQ(subject_of(valve, {}), subject);
}

TEST(Subject, OneBitOfAnyCoordinateMakesAnother) {
  const Valve valve = small_valve();
  std::set<std::string> subjects = {subject_of(valve, {})};
  std::size_t valves = 1;
  const auto add_nudged = [&](auto value_of) {
    Valve nudged = valve;
    double& value = value_of(nudged);
    value = std::nextafter(value, std::numeric_limits<double>::infinity());
    subjects.insert(subject_of(nudged, {}));
    ++valves;
  };
  for (Eigen::Index i = 0; i < valve.rest_mm.size(); ++i)
    add_nudged([i](Valve& v) -> double& { return v.rest_mm.data()[i]; });
  for (Eigen::Index i = 0; i < valve.annulus_mm.size(); ++i)
    add_nudged([i](Valve& v) -> double& { return v.annulus_mm.data()[i]; });
  add_nudged([](Valve& v) -> double& { return v.heads[0].tip_mm.x(); });
  add_nudged([](Valve& v) -> double& { return v.chordae[0].segments[0].rest_length_mm; });
  add_nudged([](Valve& v) -> double& { return v.tissue.radial_transition; });
  add_nudged([](Valve& v) -> double& { return v.pressure_kpa; });
  EXPECT_EQ(subjects.size(), valves);
}

TEST(Subject, EveryClosureOptionMakesAnother) {
  const Valve valve = small_valve();
  const std::vector<ClosureOptions> all = {{},
                                           {.method = Method::Thesis},
                                           {.membrane = Membrane::Springs},
                                           {.residual_tolerance = 0.004},
                                           {.way_tolerance_mm = 0.01},
                                           {.max_steps = 1},
                                           {.contact_pressure_mpa = 0.7},
                                           {.speed = 0.5},
                                           {.damping_per_ms = 2.0},
                                           {.samples = kThesisSamples},
                                           {.edge_contact = true},
                                           {.self_contact = SelfContact::None}};
  std::set<std::string> subjects;
  for (const ClosureOptions& options : all) subjects.insert(subject_of(valve, options));
  EXPECT_EQ(subjects.size(), all.size());
}

TEST(PlanSubject, IsNeverTheSubjectAndChangesWithIt) {
  Valve valve = small_valve();
  const std::string subject = plan_subject_of(valve, {});
  EXPECT_EQ(subject.size(), 32u);
  EXPECT_EQ(subject.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_NE(subject, subject_of(valve, {}));
  EXPECT_NE(subject, plan_subject_of(valve, {.max_steps = 1}));
  valve.name = "another";
  EXPECT_EQ(plan_subject_of(valve, {}), subject);
  valve.pressure_kpa = std::nextafter(valve.pressure_kpa, 0.0);
  EXPECT_NE(plan_subject_of(valve, {}), subject);
}

TEST(Subject, NamesARevisionOfTheClosureThatStillHolds) {
  // If this fails, what stores hold no longer is what would be closed: raise kClosureRevision
  // (io/store/subject.cpp) and put the new number here.
  OrificeTable table(*make_preset("porcine-1"), {});
  const Configuration displaced = displacement(Displaced::Both, Vec3(3.0, 2.0, 4.0));
  EXPECT_NEAR(table.at({&displaced, 1}).front().area_mm2, 23.757007, 1e-3);
}

}  // namespace
}  // namespace coapt
