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
     "Compares loads, strains, rings and openings with published measurements.", kNative,
     read_physiology},
    {"report", "evaluate", "/v1/reports", "Writes a report on given plans.", kNative, read_report},
    {"export", "export", "/v1/exports", "Closes a valve and writes it in another file format.",
     kNative, read_export},
    {"export_files", "export", "/v1/exports:files",
     "Closes a valve and writes it in several file formats at once.", kNative, read_export_files},
    {"picture", "close", "/v1/pictures", "Closes a valve and draws it.", kNative, read_picture},
    {"prefer", "prefer", "/v1/preferences",
     "Learns cost weights from pairwise comparisons of plans.", kCommandLine | kService,
     read_prefer},
    {.name = "study",
     .command = "study thesis",
     .path = "/v1/studies",
     .what = "Tests the findings of the thesis on a valve.",
     .doors = kNative | kFarm,
     .needs_store = true},
    // A service reads strangers' files in a process apart, as a job of its own.
    {"import", "valve import", "/v1/imports", "Makes a valve from meshes, curves or label maps.",
     kNative, read_import, true},
    {"fit", "fit", "/v1/fits",
     "Fits parameters that images do not show to the imaged closed state.", kNative, read_fit, true,
     true},
    {"model", "study model", "/v1/model-studies",
     "Closes variants of tissue and chordae of a valve.", kNative, read_model, true, true},
    {.name = "imports",
     .command = "study imports",
     .path = "",
     .what = "Imports, closes and plans every label map of a folder.",
     .doors = kCommandLine | kFarm},
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
     .what = "Optimises the shape of a ring for a population.",
     .doors = kCommandLine},
    {.name = "calibrate",
     .command = "valve calibrate",
     .path = "",
     .what = "Adjusts dimensions of a valve to meet measured physiology.",
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
