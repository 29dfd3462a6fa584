#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/material_option.h"
#include "core/presets/presets.h"
#include "io/command_line/command_line.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/json/dimensions_json.h"
#include "io/json/valve_json.h"
#include "io/mesh/import_readers.h"

namespace coapt {
namespace {

constexpr const char* kDimensions =
    "Dimensions, instead of a preset (leaflets of the unpressurised heart)";

struct ValveMakeArguments {
  std::string preset, file, name, annulus, tips;
  std::vector<std::optional<double>> given;  ///< order of dimension_table()
  int triangles = 0;
  std::string output;
};

/// Reads a contour into `points`; returns an exit code.
int read_contour(const std::string& path, std::optional<Points>& points) {
  const Expected<std::string> text = read_input(path);
  if (!text) return report_errors(path, text.errors());
  const Expected<Points> read = read_points_csv(*text);
  if (!read) return report_errors(path, read.errors());
  points = *read;
  return exit_code::kOk;
}

int run(const ValveMakeArguments& arguments) {
  HumanValve valve;
  if (!arguments.file.empty()) {
    const Expected<std::string> text = read_input(arguments.file);
    if (!text) return report_errors(arguments.file, text.errors());
    Expected<HumanValve> read = read_dimensions(*text);
    if (!read) return report_errors(arguments.file, read.errors());
    valve = *std::move(read);
  }
  ParametricValve& dimensions = valve.dimensions;
  if (!arguments.name.empty()) dimensions.name = arguments.name;
  if (arguments.triangles > 0) dimensions.triangles = arguments.triangles;
  for (std::size_t d = 0; d < arguments.given.size(); ++d)
    if (arguments.given[d]) dimension_table()[d].set(dimensions, *arguments.given[d]);
  if (!arguments.annulus.empty()) {
    if (const int failed = read_contour(arguments.annulus, dimensions.annulus_mm)) return failed;
    if (const int failed = read_contour(arguments.tips, dimensions.tips_mm)) return failed;
    dimensions.annulus_source = arguments.annulus;
    dimensions.tips_source = arguments.tips;
  }
  const Expected<Valve> made = arguments.preset.empty()
                                   ? make_human_valve(valve)
                                   : make_preset(arguments.preset, arguments.triangles);
  if (!made) {
    return report_option_errors(
        "valve make", made.errors(),
        {{"/annulus_mm", "--annulus"}, {"/tips_mm", "--tips"}, {"/pressure_mmhg", "--pressure"}});
  }
  return write_output(arguments.output, write_valve(*made));
}

}  // namespace

void add_valve_make(Command parent, int& status) {
  const auto arguments = std::make_shared<ValveMakeArguments>();
  Command command = parent.add_command("make", "Make a valve from a preset or from dimensions");
  command.add_option("preset", arguments->preset, "Name of a preset").one_of(preset_names());
  command.add_option("--triangles", arguments->triangles, "Approximate number of triangles")
      .check(number_from(100, 50000));
  command.add_option("-o,--output", arguments->output, "File to write, - for standard output")
      .required();

  command
      .add_option(
          "--dimensions", arguments->file,
          "File of dimensions and disease (coapt.dimensions/1); the options below override it")
      .group(kDimensions)
      .show_argument("FILE");
  command.add_option("--name", arguments->name, "Name of the valve").group(kDimensions);
  const ParametricValve usual;
  arguments->given.resize(dimension_table().size());
  for (std::size_t d = 0; d < arguments->given.size(); ++d) {
    const Dimension& dimension = dimension_table()[d];
    const std::optional<double> value = dimension.get(usual);
    command.add_option(flag_of(dimension), arguments->given[d], dimension.what)
        .group(kDimensions)
        .show_default(value ? shown(*value) : "");
  }
  Option annulus = command
                       .add_option("--annulus", arguments->annulus,
                                   "Measured annular contour (CSV, lines x,y,z)")
                       .group(kDimensions);
  Option tips = command.add_option("--tips", arguments->tips, "Measured papillary tips (CSV)")
                    .group(kDimensions);
  annulus.needs(tips);
  tips.needs(annulus);
  command.footer(
      "Examples:\n"
      "  coapt valve make human-normal -o normal.json\n"
      "  coapt valve make porcine-1 --triangles 2600 -o porcine-1.json\n"
      "  coapt valve make --ap-mm 34 --tip-depth-mm 26 -o large.json\n"
      "  coapt valve make --dimensions human-normal.json --strut-slack 0.92 --pressure 150 -o "
      "normal.json");
  command.on_run([=, &status] {
    if (!arguments->preset.empty()) command.refuse_group("preset", kDimensions);
    status = run(*arguments);
  });
}

}  // namespace coapt
