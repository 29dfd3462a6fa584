#include "core/closure/prepared_valve.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/closure/closure.h"
#include "core/presets/presets.h"

namespace coapt {
namespace {

Valve small_valve() { return *make_preset("human-functional-mr", 300); }

Valve with_tips_moved(const Valve& valve, double by_mm) {
  Valve moved = valve;
  for (PapillaryHead& head : moved.heads) head.tip_mm += Vec3(by_mm, 0.5 * by_mm, -by_mm);
  return moved;
}

TEST(PreparedValve, ClosesOtherTipsAndAnnuliToTheSameBits) {
  const Valve valve = small_valve();
  const PreparedValve prepared(valve, {});
  Valve moved = with_tips_moved(valve, 0.7);
  moved.annulus_mm *= 0.97;
  ASSERT_TRUE(prepared.serves(moved, {}));
  for (const Membrane membrane : {Membrane::Continuum, Membrane::Springs}) {
    ClosureOptions options;
    options.membrane = membrane;
    const PreparedValve of_membrane(valve, options);
    const ClosureResult alone = close_valve(moved, options),
                        closed = close_valve(of_membrane, moved, options);
    EXPECT_EQ(closed.steps, alone.steps);
    EXPECT_EQ(closed.closed_mm, alone.closed_mm);
    const ClosureResult from_there = close_valve(of_membrane, valve, options, &closed);
    EXPECT_EQ(from_there.closed_mm, close_valve(valve, options, &alone).closed_mm);
  }
}

TEST(PreparedValve, HalfOfTheLoadOnEachFaceIsHalfOfThePressure) {
  Valve valve = small_valve();
  const PreparedValve halved(valve, {}, std::vector<double>(valve.faces.rows(), 0.5));
  const ClosureResult closed = close_valve(halved, valve, {});
  valve.pressure_kpa *= 0.5;
  EXPECT_EQ(closed.closed_mm, close_valve(valve).closed_mm);
}

TEST(PreparedValve, ServesNoOtherValve) {
  const Valve valve = small_valve();
  const PreparedValve prepared(valve, {});
  const std::vector<std::function<void(Valve&)>> changes = {
      [](Valve& v) { v.rest_mm(5, 2) += 1e-9; },
      [](Valve& v) { v.tissue.bending_n_mm *= 2.0; },
      [](Valve& v) { v.pressure_kpa += 1.0; },
      [](Valve& v) { v.chordae[0].segments[0].rest_length_mm += 0.1; },
      [](Valve& v) { v.chordae.back().ruptured = true; },
      [](Valve& v) { v.chordae.pop_back(); },
      [](Valve& v) { v.heads[0].rest_mm.x() += 1.0; },
      [](Valve& v) { v.fibre.row(0) *= -1.0; },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Valve changed = valve;
    changes[i](changed);
    EXPECT_FALSE(prepared.serves(changed, {})) << i;
  }
  EXPECT_FALSE(prepared.serves(*make_preset("human-functional-mr", 650), {}));
  EXPECT_FALSE(prepared.serves(valve, {.membrane = Membrane::Springs}));
  EXPECT_FALSE(prepared.serves(valve, {.contact_pressure_mpa = 1.0}));
  EXPECT_FALSE(prepared.serves(valve, {.self_contact = SelfContact::None}));
  EXPECT_TRUE(prepared.serves(valve, {.residual_tolerance = 0.1}));
}

}  // namespace
}  // namespace coapt
