// The bits of ten closures and one search, for whatever compiler and optimisation built this and
// for every instruction set of the processor (cmake/golden.sh builds it by several). A change that
// means to change results writes the values that the failing test shows into the tables.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <ostream>
#include <vector>

#include "core/closure/closure.h"
#include "core/closure/relaxation.h"
#include "core/metrics/measure.h"
#include "core/presets/presets.h"
#include "core/repair/apply_plan.h"
#include "core/valve/remodel.h"
#include "search/plans/plan_key.h"
#include "search/plans/plan_search.h"

namespace coapt {
namespace {

using kernels::InstructionSet;

/// FNV-1a (Fowler, Noll and Vo) over bytes.
class Hash {
 public:
  void add(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (int byte = 0; byte < 8; ++byte) add_byte(static_cast<unsigned char>(bits >> (8 * byte)));
  }
  void add(const std::string& text) {
    for (const char letter : text) add_byte(static_cast<unsigned char>(letter));
  }
  void add(const Points& points) {
    for (Index i = 0; i < points.rows(); ++i)
      for (int k = 0; k < 3; ++k) add(points(i, k));
  }
  std::uint64_t value() const { return value_; }

 private:
  void add_byte(unsigned char byte) { value_ = (value_ ^ byte) * 0x100000001b3; }
  std::uint64_t value_ = 0xcbf29ce484222325;
};

/// Shown in hexadecimal, as in the tables.
struct Bits {
  std::uint64_t value = 0;
  bool operator==(const Bits&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Bits& bits) {
  return out << "0x" << std::hex << bits.value << std::dec;
}

Bits bits_of(const ClosureResult& closure, const ValveMeasure& measure) {
  Hash hash;
  hash.add(closure.closed_mm);
  for (const auto& chorda : closure.tension_n)
    for (const double tension : chorda) hash.add(tension);
  for (const Points& branch : closure.branch_points_mm) hash.add(branch);
  hash.add(closure.residual);
  hash.add(closure.steps);
  hash.add(measure.leak.area_mm2);
  hash.add(measure.leak.lower_mm2);
  hash.add(measure.tenting_area_mm2);
  hash.add(measure.annulus.area_mm2);
  return {hash.value()};
}

Bits bits_of(const ClosureRun& run) {
  Hash hash;
  hash.add(run.x_mm);
  hash.add(run.residual);
  hash.add(run.steps);
  return {hash.value()};
}

Bits bits_of(const SearchResult& result) {
  Hash hash;
  for (const RankedPlan& plan : result.plans) {
    hash.add(plan_key(plan.plan));
    hash.add(plan.cost);
    hash.add(plan.region.leak_mm2.mean);
    hash.add(plan.region.leak_mm2.sd);
    hash.add(plan.probability_outranks_next);
  }
  for (const Progress& progress : result.progress) hash.add(progress.cost);
  hash.add(result.closures);
  return {hash.value()};
}

Valve repaired(const std::string& preset, const RepairStep& step) {
  return *apply_plan(*make_preset(preset, 300), {{step}});
}

Valve displaced() {
  Remodelling change;
  change.ap_dilation_percent = 12.0;
  change.posteromedial_mm = {4.0, 5.0, 3.0};
  return *remodel(*make_preset("human-normal", 300), change);
}

struct Scene {
  const char* name;
  Valve valve;
  Membrane membrane = Membrane::Springs;
  Method method = Method::Fast;
  Bits bits;
};

std::vector<Scene> scenes() {
  const auto preset = [](const char* name) { return *make_preset(name, 300); };
  const auto fast = Method::Fast;
  const auto springs = Membrane::Springs, continuum = Membrane::Continuum;
  return {
      {"normal", preset("human-normal"), springs, fast, {0xaca665ca8da9373f}},
      {"normal", preset("human-normal"), continuum, fast, {0xf26164dcb6a70bd6}},
      {"normal", preset("human-normal"), springs, Method::Thesis, {0xe932ce9c8f3407fa}},
      {"functional", preset("human-functional-mr"), springs, fast, {0x6ce0418b19877955}},
      {"prolapse", preset("human-p2-prolapse"), springs, fast, {0xf156e61585de1e2c}},
      {"porcine", preset("porcine-thesis"), continuum, fast, {0x531fa016d5602094}},
      {"displaced", displaced(), springs, fast, {0xfd940d8859a3d409}},
      {"displaced", displaced(), continuum, fast, {0xccc09c7f0f101bb9}},
      {"own ring",
       repaired("human-functional-mr", Annuloplasty{OwnRing{2}}),
       springs,
       fast,
       {0xd0280b67d52f7cc4}},
      {"suture",
       repaired("human-functional-mr",
                PapillaryApproximation{.side = Side::Posteromedial, .suture_length_mm = 26.0}),
       continuum,
       fast,
       {0xcb34cd87fcd9391f}},
  };
}

TEST(Golden, TenClosuresHaveTheirBits) {
  for (const Scene& scene : scenes()) {
    ClosureOptions options;
    options.membrane = scene.membrane;
    options.method = scene.method;
    const ClosureResult closure = close_valve(scene.valve, options);
    EXPECT_EQ(bits_of(closure, measure(scene.valve, closure)), scene.bits)
        << scene.name << ", " << to_string(scene.membrane) << ", " << to_string(scene.method);
  }
}

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> sets = {InstructionSet::Portable};
  for (const InstructionSet set :
       {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512})
    if (kernels::best_instruction_set() >= set) sets.push_back(set);
  return sets;
}

TEST(Golden, RelaxationsHaveTheirBitsOnEveryInstructionSet) {
  struct Golden {
    Membrane membrane;
    Bits single, twice;
  };
  const Valve valve = displaced();
  for (const Golden& golden :
       {Golden{Membrane::Springs, {0x7d2ca9660ea50bf9}, {0x4d6652d0dcc6565e}},
        Golden{Membrane::Continuum, {0x172e1c946d41d6ee}, {0x49032b554b1d5373}}}) {
    const ClosureModel model = make_closure_model(valve, golden.membrane);
    for (const InstructionSet set : instruction_sets()) {
      RelaxationSettings settings;
      settings.instructions = set;
      EXPECT_EQ(bits_of(relax<float>(model, settings)), golden.single)
          << to_string(golden.membrane) << ", " << to_string(set);
      EXPECT_EQ(bits_of(relax<double>(model, settings)), golden.twice)
          << to_string(golden.membrane) << ", " << to_string(set);
    }
  }
}

TEST(Golden, ASearchHasItsBits) {
  SearchOptions options;
  options.evaluations = 60;
  options.plans = 2;
  options.region_points = 9;
  options.threads = 2;
  options.evidence = false;
  const auto result = search_plans(*make_preset("human-functional-mr", 300), options, {});
  ASSERT_TRUE(result);
  EXPECT_EQ(bits_of(*result), Bits{0x3f1d37287045fbdd});
}

}  // namespace
}  // namespace coapt
