#include "operations/operations.h"

#include "operations/plan_operations.h"
#include "operations/table.h"
#include "operations/valve_operations.h"

namespace coapt {
namespace {

using namespace door;

constexpr unsigned kNative = kCommandLine | kService | kPython;

// Computed at once, as those of valve_operations(), and what runs as a job or on the command line alone.
constexpr Operation kOperations[] = {
    {"physiology", "study physiology", "/v1/physiology",
     "Sets loads, strains, rings and openings beside what was measured in hearts.", kNative,
     read_physiology},
    {"report", "evaluate", "/v1/reports", "Writes the report on plans of one's own.", kNative,
     read_report},
    {"export", "export", "/v1/exports", "Closes a valve and writes it as a file.", kNative,
     read_export},
    {"picture", "close", "/v1/pictures", "Closes a valve and draws it.", kNative, read_picture},
    {"prefer", "prefer", "/v1/preferences",
     "Learns the weights of the cost from comparisons of plans.", kCommandLine | kService,
     read_prefer},
    {.name = "study",
     .command = "study thesis",
     .path = "/v1/studies",
     .what = "Asks the thesis's questions of a valve, finding by finding.",
     .doors = kNative | kFarm,
     .needs_store = true},
    {.name = "import",
     .command = "valve import",
     .path = "/v1/imports",
     .what = "Makes a valve from meshes, curves or label maps.",
     .doors = kNative,
     .needs_store = true},
    {.name = "fit",
     .command = "fit",
     .path = "",
     .what = "Finds what images do not show of a valve from its closed state.",
     .doors = kCommandLine | kPython},
    {.name = "compare",
     .command = "compare",
     .path = "",
     .what = "Measures how far a closed valve lies from an image or another code's result.",
     .doors = kCommandLine | kPython},
    {.name = "model",
     .command = "study model",
     .path = "",
     .what = "Closes a valve under draws of tissue and chordae.",
     .doors = kCommandLine},
    {.name = "imports",
     .command = "study imports",
     .path = "",
     .what = "Imports, closes and plans every label map of a folder.",
     .doors = kCommandLine},
    {.name = "population",
     .command = "population",
     .path = "",
     .what = "Draws valves from published distributions.",
     .doors = kCommandLine},
    {.name = "population_study",
     .command = "study population",
     .path = "",
     .what = "Compares repairs across a population.",
     .doors = kCommandLine | kFarm},
    {.name = "design",
     .command = "design ring",
     .path = "",
     .what = "Searches for the shape of a ring that serves a population.",
     .doors = kCommandLine},
    {.name = "calibrate",
     .command = "valve calibrate",
     .path = "",
     .what = "Finds dimensions of a valve that meets measured physiology.",
     .doors = kCommandLine}};

}  // namespace

std::vector<Operation> operations() {
  const std::span<const Operation> on_a_valve = valve_operations();
  std::vector<Operation> all(on_a_valve.begin(), on_a_valve.end());
  const std::span<const Operation> on_plans = plan_operations();
  all.insert(all.end(), on_plans.begin(), on_plans.end());
  all.insert(all.end(), std::begin(kOperations), std::end(kOperations));
  return all;
}

}  // namespace coapt
