// A leaking valve, a repair by hand, and what a small search finds instead. Takes no arguments.
#include <cstdio>
#include <string>

#include "core/closure/closure.h"
#include "core/metrics/measure.h"
#include "core/presets/presets.h"
#include "core/repair/apply_plan.h"
#include "search/plans/plan_search.h"

namespace {

int fail(const coapt::Errors& errors) {
  for (const auto& error : errors)
    std::fprintf(stderr, "%s: %s\n", error.path.c_str(), error.message.c_str());
  return 1;
}

void print_closed(const char* title, const coapt::Valve& valve) {
  const coapt::ClosureResult closure = coapt::close_valve(valve);
  const coapt::ValveMeasure measure = coapt::measure(valve, closure);
  std::printf("%-10s %s, leak %.1f mm2, coaptation height %.1f mm, annulus %.1f x %.1f mm\n", title,
              coapt::to_string(closure.status), measure.leak.area_mm2,
              measure.coaptation.height_mean_mm, measure.annulus.ap_mm, measure.annulus.al_pm_mm);
}

coapt::RepairPlan ring_and_suture() {
  const coapt::Annuloplasty ring{coapt::CatalogueRing{"generic-classic", 34.0}};
  coapt::PapillaryApproximation suture;
  suture.side = coapt::Side::Posteromedial;
  suture.suture_length_mm = 26.0;
  return {{ring, suture}};
}

/// Sixty closures and seventeen nodes of each reported plan's region: a few seconds, not a result to rely on.
coapt::SearchOptions small_search() {
  coapt::SearchOptions options;
  options.evaluations = 60;
  options.plans = 2;
  options.region_points = 17;
  options.evidence = false;
  return options;
}

void print_ranked(const coapt::RankedPlan& ranked) {
  std::printf("%d. leak %.1f mm2 as planned, %.1f (sd %.1f) over its region\n", ranked.rank,
              ranked.region.leak_mm2.nominal, ranked.region.leak_mm2.mean,
              ranked.region.leak_mm2.sd);
  for (const std::string& line : ranked.description) std::printf("   %s\n", line.c_str());
}

}  // namespace

int main() {
  const auto valve = coapt::make_preset("human-functional-mr");
  if (!valve) return fail(valve.errors());
  print_closed("Before:", *valve);

  const auto repaired = coapt::apply_plan(*valve, ring_and_suture());
  if (!repaired) return fail(repaired.errors());
  print_closed("By hand:", *repaired);

  const auto found = coapt::search_plans(*valve, small_search(), {});
  if (!found) return fail(found.errors());
  for (const auto& plan : found->plans) print_ranked(plan);
}
