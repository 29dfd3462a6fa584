// What the answers that fuzz_answers reads were asked for, by their first byte.
#pragma once

#include <array>
#include <cstddef>
#include <cstdlib>
#include <utility>

#include "farm/work/import_work.h"
#include "farm/work/orifice_work.h"
#include "farm/work/plan_work.h"
#include "farm/work/population_work.h"
#include "io/json/population_prior_json.h"
#include "tests/scenes/small_valve.h"

namespace coapt {

inline constexpr std::size_t kAskedKinds = 5, kAskedRecords = 2, kAskedPlans = 3;

/// Of one item each: an orifice, a member, a record, a search on small_valve(), an import.
inline std::array<Work, kAskedKinds> asked_works() {
  const auto opened = [](const Expected<WorkRequest>& request) {
    Expected<Work> work = request ? open_work(*request) : request.errors();
    if (!work) std::abort();
    return *std::move(work);
  };
  Population population{adult_prior(), 1, {}};
  population.members.push_back({.leak_mm2 = 40.0});
  SearchOptions search;
  search.evaluations = 4;
  search.plans = 2;
  search.region_points = 1;
  search.evidence = false;
  search.openings = false;
  search.fine_levels = 0;
  search.model_draws = 0;
  return {opened(orifice_request(small_valve(), {}, {ConfigurationKey{}})),
          opened(members_request(population.prior, 1, 1)),
          opened(records_request(population, 1, {.nodes = 1})),
          opened(plan_request({small_valve()}, search)),
          opened(imports_request({{"skirt", {{"skirt.obj", "f 1 2 3"}}}}, {}))};
}

}  // namespace coapt
