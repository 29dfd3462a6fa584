#include "core/presets/presets.h"

#include <iostream>
#include <memory>

#include "clients/cli/commands.h"
#include "io/command_line/exit_code.h"
#include "io/json/preset_words.h"
#include "io/json/version.h"

namespace coapt {
namespace {

void print_json() {
  Json presets = Json::array();
  for (const std::string& name : preset_names()) presets.push_back(preset_words(name));
  std::cout << json_text(Json{{"presets", presets}, {"notice", kResearchNotice}}, 2) << '\n';
}

void print_text() {
  for (const std::string& name : preset_names()) {
    const Json words = preset_words(name);
    std::cout << name << ": " << words["title"].get<std::string>() << ". "
              << words["about"].get<std::string>() << '\n';
  }
}

}  // namespace

void add_presets(Command parent, int& status) {
  const auto json = std::make_shared<bool>(false);
  Command command = parent.add_command("presets", "List the preset valves");
  command.add_flag("--json", *json, "Print JSON");
  command.footer(
      "Every command that takes a valve also accepts the name of a preset.\n\n"
      "Examples:\n  coapt presets\n  coapt presets --json");
  command.on_run([json, &status] {
    *json ? print_json() : print_text();
    status = exit_code::kOk;
  });
}

}  // namespace coapt
