// coapt: the command line.
#include "clients/cli/commands.h"
#include "io/command_line/program.h"

namespace {

using namespace coapt;

void add_commands(Command app, int& status) {
  Command valve =
      app.add_command("valve", "Make, import, check, describe, remodel and calibrate valves");
  valve.require_command();
  add_valve_make(valve, status);
  add_valve_import(valve, status);
  add_valve_check(valve, status);
  add_valve_info(valve, status);
  add_valve_remodel(valve, status);
  add_valve_calibrate(valve, status);
  add_close(app, status);
  add_compare(app, status);
  add_design(app, status);
  add_diagnose(app, status);
  add_evaluate(app, status);
  add_export(app, status);
  add_fit(app, status);
  add_observe(app, status);
  add_open(app, status);
  add_operations(app, status);
  add_plan(app, status);
  add_population(app, status);
  add_prefer(app, status);
  add_presets(app, status);
  add_study(app, status);
  add_train(app, status);
  add_moved(app, status);
}

constexpr Program kCoapt = {
    "coapt", "Closes a mitral valve in simulation, measures what leaks, and searches for repairs.",
    "Examples:\n"
    "  coapt close human-functional-mr                  # leak of a preset: area and location\n"
    "  coapt plan human-functional-mr -o report.html    # ranked repair plans\n"
    "  coapt valve import --leaflet a.obj p.obj --annulus ring.csv --chordae chordae.csv -o "
    "mine.json\n"
    "  coapt plan mine.json --server http://127.0.0.1:8080\n"
    "See `coapt COMMAND --help` for details and `man coapt` for the manual.\n\nExit codes: 0 "
    "success; 1 internal error; 2 bad input or usage; 3 the closure did not converge\nor leaflets "
    "cross; 4 no plan is acceptable; 130 interrupted, with the best result so far printed.",
    add_commands};

}  // namespace

int main(int argc, char** argv) { return run_program(kCoapt, argc, argv); }
