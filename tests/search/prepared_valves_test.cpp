#include "search/prepared_valves.h"

#include <gtest/gtest.h>

#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

TEST(PreparedValves, KeepTheLastFew) {
  PreparedValves valves;
  const Valve& valve = small_preset("human-functional-mr");
  const auto first = valves.of(valve, {});
  Valve moved = valve;
  for (PapillaryHead& head : moved.heads) head.tip_mm.z() -= 1.0;
  EXPECT_EQ(valves.of(moved, {}), first);
  for (int i = 1; i <= 8; ++i) {
    Valve other = valve;
    other.pressure_kpa += i;
    EXPECT_NE(valves.of(other, {}), first);
  }
  EXPECT_NE(valves.of(valve, {}), first);
}

}  // namespace
}  // namespace coapt
