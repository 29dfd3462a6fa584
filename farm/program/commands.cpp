#include "farm/program/commands.h"

namespace coapt {

const char* const kFarmFooter =
    "Examples:\n"
    "  coapt-farm init --db postgresql://boss@db.example/farm     # once\n"
    "  coapt-farm work --db postgresql://anna@db.example/farm     # on each machine, as many as "
    "wanted\n"
    "  coapt study generality -o out --farm postgresql://boss@db.example/farm\n"
    "  coapt-farm status --watch\n"
    "The environment variable COAPT_FARM can hold the address. Keep the password in "
    "PGPASSFILE.\nSee `coapt-farm COMMAND --help` for details and `man coapt-farm` for the "
    "manual.\n\n"
    "Exit codes: 0 done; 1 it failed; 2 bad input or usage; 4 a run ended with holes; 130 "
    "interrupted,\nthe run stays.";

void add_farm_commands(Command app, int& status, const FarmKinds& kinds) {
  add_init(app, status);
  add_add(app, status, kinds);
  add_work(app, status, kinds);
  add_status(app, status);
  add_fetch(app, status, kinds);
  add_cancel(app, status);
  add_forget(app, status);
}

}  // namespace coapt
