// coapt-lab: measures coapt and what it was chosen over.
#include "io/command_line/program.h"
#include "lab/cli/commands.h"

namespace {

using namespace coapt;

void add_commands(Command app, int& status) {
  Command bench =
      app.add_command("bench", "Measure the speed and accuracy of closures and of the search");
  bench.require_command();
  add_bench_closures(bench, status);
  add_bench_search(bench, status);
  add_bench_front(bench, status);
  add_bench_indications(bench, status);
  add_chart(app, status);
  add_leak(app, status);
}

constexpr Program kLab = {
    "coapt-lab", "Measures how fast and how accurate coapt is, and compares it with other methods.",
    "Examples:\n"
    "  coapt-lab bench closures human-normal --count 200\n"
    "  coapt-lab chart stability --scene porcine-1 -o charts\n"
    "See `coapt-lab COMMAND --help` for details and `man coapt-lab` for the manual.\n\n"
    "Exit codes: 0 done; 1 coapt-lab failed; 2 bad input or usage; 3 a closure did not converge or "
    "leaflets\n"
    "cross; 130 interrupted.",
    add_commands};

}  // namespace

int main(int argc, char** argv) { return run_program(kLab, argc, argv); }
