// The commands of coapt, one file each.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "core/closure/accuracy.h"
#include "search/plans/plan_search.h"

namespace coapt {

/// Each adds one command to `parent`. A command chosen on the command line runs while CLI11 parses,
/// and leaves its exit code in `status`.
void add_valve_make(CLI::App& parent, int& status);
void add_valve_import(CLI::App& parent, int& status);
void add_valve_check(CLI::App& parent, int& status);
void add_valve_info(CLI::App& parent, int& status);
void add_valve_remodel(CLI::App& parent, int& status);
void add_close(CLI::App& parent, int& status);
void add_evaluate(CLI::App& parent, int& status);
void add_export(CLI::App& parent, int& status);
void add_bench(CLI::App& parent, int& status);
void add_chart(CLI::App& parent, int& status);
void add_plan(CLI::App& parent, int& status);
void add_study(CLI::App& parent, int& status);
/// Below bench.
void add_bench_search(CLI::App& bench, int& status);
/// Below study.
void add_calibrate(CLI::App& parent, int& status);
void add_anchor_question(CLI::App& parent, int& status);
void add_generality(CLI::App& parent, int& status);

/// --method.
void add_method_option(CLI::App& command, Method& method);

/// --membrane.
void add_membrane_option(CLI::App& command, Membrane& membrane);

/// --accuracy.
void add_accuracy_option(CLI::App& command, std::optional<double>& accuracy_mm2);

/// Puts the tolerances for --accuracy, if it was given, into `closure` and says on standard error which
/// they are. Errors point to "/accuracy".
Expected<std::optional<AccuracyTier>> apply_accuracy(std::optional<double> accuracy_mm2,
                                                     ClosureOptions& closure);

/// --threads and --region-points.
void add_region_options(CLI::App& command, SearchOptions& options);

}  // namespace coapt
