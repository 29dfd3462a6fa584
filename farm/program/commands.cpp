#include "farm/program/commands.h"

namespace coapt {

const char* const kFarmFooter =
    "Examples:\n"
    "  coapt-farm init --db postgresql://boss@db.example/farm     # once\n"
    "  coapt-farm work --db postgresql://anna@db.example/farm     # on each machine, as many as "
    "wanted\n"
    "  coapt study generality -o out --farm postgresql://boss@db.example/farm\n"
    "  coapt-farm status --watch\n"
    "The address may come from the environment: COAPT_FARM. Its password belongs into PGPASSFILE.\n"
    "Each command's --help has more; `man coapt-farm` has all.\n\n"
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
