// The commands of coapt, one file each.
#pragma once

#include "io/command_line/command_line.h"
#include "search/plans/plan_search.h"

namespace coapt {

/// Each adds one command to `parent`. A command chosen on the command line runs while the line is parsed,
/// and leaves its exit code in `status`.
void add_valve_make(Command parent, int& status);
void add_valve_calibrate(Command parent, int& status);
void add_valve_import(Command parent, int& status);
void add_valve_check(Command parent, int& status);
void add_valve_info(Command parent, int& status);
void add_valve_remodel(Command parent, int& status);
void add_close(Command parent, int& status);
void add_compare(Command parent, int& status);
void add_design(Command parent, int& status);
void add_diagnose(Command parent, int& status);
void add_evaluate(Command parent, int& status);
void add_export(Command parent, int& status);
void add_fit(Command parent, int& status);
void add_observe(Command parent, int& status);
void add_open(Command parent, int& status);
void add_operations(Command parent, int& status);
void add_plan(Command parent, int& status);
void add_population(Command parent, int& status);
void add_prefer(Command parent, int& status);
void add_presets(Command parent, int& status);
void add_study(Command parent, int& status);
void add_train(Command parent, int& status);
/// Below train.
void add_train_exam(Command parent, int& status);
void add_train_power(Command parent, int& status);
void add_train_raters(Command parent, int& status);
void add_train_score(Command parent, int& status);
/// Below study.
void add_calibrate(Command parent, int& status);
void add_anchor_question(Command parent, int& status);
void add_generality(Command parent, int& status);
void add_study_imports(Command parent, int& status);
void add_study_information(Command parent, int& status);
void add_study_model(Command parent, int& status);
void add_study_physiology(Command parent, int& status);
void add_study_population(Command parent, int& status);
/// Commands that moved to coapt-lab: hidden from the help, they say where they went.
void add_moved(Command parent, int& status);

}  // namespace coapt
