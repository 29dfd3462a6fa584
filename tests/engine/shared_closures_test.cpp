#include "clients/engine/shared_closures.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <vector>

#include "core/closure/closure.h"
#include "tests/scenes/leaflet_valves.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

TEST(SharedClosures, HaveTheBitsOfWhatWasClosed) {
  const ClosureResult closed = close_valve(small_valve(), {.samples = 2, .motion = true});
  const std::string bytes = bytes_of(closed);
  const ClosureResult taken = closure_from(bytes);
  EXPECT_EQ(taken.closed_mm, closed.closed_mm);
  EXPECT_EQ(taken.samples_mm.size(), closed.samples_mm.size());
  EXPECT_EQ(taken.tension_n, closed.tension_n);
  EXPECT_EQ(taken.attempts.front().how, closed.attempts.front().how);
  EXPECT_EQ(taken.steps, closed.steps);
  EXPECT_EQ(bytes_of(taken), bytes);
}

TEST(SharedClosures, AreKnownByAllThatTheyDependOn) {
  const ClosureResult closed = close_valve(small_valve());
  ClosureResult moved = closed, predicted = closed;
  moved.closed_mm(5, 2) += 1e-12;
  predicted.predicted = true;
  std::set<ClosureKey> keys = {closure_key(small_valve(), {}, nullptr),
                               closure_key(small_valve(), {}, &closed),
                               closure_key(small_valve(), {}, &moved),
                               closure_key(small_valve(), {}, &predicted),
                               closure_key(small_valve(), {.method = Method::Thesis}, nullptr),
                               closure_key(small_valve(), {.residual_tolerance = 0.01}, nullptr),
                               closure_key(three_leaflets(), {}, nullptr),
                               opening_key(small_valve())};
  EXPECT_EQ(keys.size(), 8);
  const std::vector<std::function<void(Valve&)>> changes = {
      [](Valve& valve) { valve.rest_mm(3, 1) += 1e-12; },
      [](Valve& valve) { valve.annulus_mm(0, 2) += 1e-12; },
      [](Valve& valve) { valve.heads[0].tip_mm.x() += 1e-12; },
      [](Valve& valve) { valve.chordae[0].segments[1].rest_length_mm += 1e-12; },
      [](Valve& valve) { valve.chordae[1].ruptured = true; },
      [](Valve& valve) { valve.tissue.radial_pre_kpa += 1e-12; },
      [](Valve& valve) { valve.pressure_kpa += 1e-12; },
      [](Valve& valve) { valve.ties.push_back({}); },
      [](Valve& valve) { std::swap(valve.faces(0, 0), valve.faces(0, 1)); }};
  for (const auto& change : changes) {
    Valve valve = small_valve();
    change(valve);
    EXPECT_TRUE(keys.insert(closure_key(valve, {}, nullptr)).second) << keys.size();
  }
  Valve renamed = small_valve();
  renamed.name = "another";
  EXPECT_EQ(closure_key(renamed, {}, nullptr), closure_key(small_valve(), {}, nullptr));
}

}  // namespace
}  // namespace coapt
