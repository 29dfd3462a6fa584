#include "clients/cli/run_options.h"

namespace coapt {

void add_threads_option(Command command, int& threads) {
  command
      .add_option("--threads", threads,
                  "Number of threads (0: all cores); does not change the result")
      .check(number_from(0, 1024))
      .show_default();
}

void add_seed_option(Command command, std::uint64_t& seed, const std::string& what) {
  command.add_option("--seed", seed, what)
      .check(number_from(std::uint64_t{0}, std::uint64_t{1} << 62))
      .show_default();
}

}  // namespace coapt
