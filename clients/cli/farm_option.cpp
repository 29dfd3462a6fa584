#include "clients/cli/farm_option.h"

#include "farm/ask/farm.h"

namespace coapt {

void add_farm_option(Command command, std::string& url, const std::string& what) {
  command
      .add_option(
          "--farm", url,
          what +
              " on the workers of this farm (coapt-farm), postgresql://HOST/NAME; \"\": run here")
      .show_argument("URL")
      .environment("COAPT_FARM")
      .group("Farm");
}

Asker asker_of(const std::string& url, int threads) {
  return url.empty() ? ask_here(threads) : ask_farm(farm_at(url));
}

}  // namespace coapt
