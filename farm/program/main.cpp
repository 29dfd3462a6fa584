// coapt-farm: closures and searches shared among machines.
#include "farm/program/commands.h"
#include "farm/work/work.h"
#include "io/command_line/program.h"

namespace {

using namespace coapt;

void add_commands(Command app, int& status) {
  add_farm_commands(app, status, {make_work_opener(), work_revision()});
}

}  // namespace

int main(int argc, char** argv) {
  const Program farm = {"coapt-farm", kFarmDescription, kFarmFooter, add_commands};
  return run_program(farm, argc, argv);
}
