#include <memory>
#include <string>

#include "clients/cli/commands.h"
#include "core/presets/presets.h"
#include "io/command_line/command_line.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/json/valve_json.h"
#include "io/mesh/import_readers.h"

namespace coapt {
namespace {

constexpr const char* kDimensions =
    "Dimensions, instead of a preset (leaflets of the unpressurised heart)";

struct ValveMakeArguments {
  std::string preset, annulus, tips;
  ParametricValve dimensions;
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

int run(ValveMakeArguments arguments) {
  ParametricValve& dimensions = arguments.dimensions;
  if (arguments.triangles > 0) dimensions.triangles = arguments.triangles;
  if (!arguments.annulus.empty()) {
    if (const int failed = read_contour(arguments.annulus, dimensions.annulus_mm)) return failed;
    if (const int failed = read_contour(arguments.tips, dimensions.tips_mm)) return failed;
    dimensions.annulus_source = arguments.annulus;
    dimensions.tips_source = arguments.tips;
  }
  const Expected<Valve> valve = arguments.preset.empty()
                                    ? make_taut_valve(dimensions)
                                    : make_preset(arguments.preset, arguments.triangles);
  if (!valve) {
    return report_option_errors("valve make", valve.errors(),
                                {{"/annulus_mm", "--annulus"}, {"/tips_mm", "--tips"}});
  }
  return write_output(arguments.output, write_valve(*valve));
}

}  // namespace

void add_valve_make(Command parent, int& status) {
  const auto arguments = std::make_shared<ValveMakeArguments>();
  ParametricValve& dimensions = arguments->dimensions;
  Command command = parent.add_command("make", "Make a preset, or a valve from dimensions");
  command.add_option("preset", arguments->preset, "Name of a preset").one_of(preset_names());
  command.add_option("--triangles", arguments->triangles, "About how many triangles")
      .check(number_from(100, 50000));
  command.add_option("-o,--output", arguments->output, "File to write, - for standard output")
      .required();

  const auto dimension = [&](const char* name, auto& value, const char* help) {
    return command.add_option(name, value, help).group(kDimensions).show_default();
  };
  const auto proportion = [&](const char* name, std::optional<double>& value, const char* help) {
    return command.add_option(name, value, help).group(kDimensions);
  };
  dimension("--name", dimensions.name, "Name of the valve");
  dimension("--ap-mm", dimensions.ap_mm, "Annulus, anteroposterior");
  dimension("--al-pm-mm", dimensions.al_pm_mm, "Annulus, transverse");
  proportion("--saddle-height-mm", dimensions.saddle_height_mm,
             "Annulus, height of the saddle (6.8 on 39 mm al-pm, in proportion)");
  proportion("--anterior-height-mm", dimensions.anterior_height_mm,
             "Leaflet at A2 (23.5 on 29 mm ap, in proportion)");
  proportion("--posterior-height-mm", dimensions.posterior_height_mm,
             "Leaflet at P2 (15.25 on 29 mm ap, in proportion)");
  proportion("--lateral-height-mm", dimensions.lateral_height_mm,
             "Leaflet at P1 and P3 (14.25 on 39 mm al-pm, in proportion)");
  proportion("--commissure-height-mm", dimensions.commissure_height_mm,
             "Leaflet at a commissure (9 on 39 mm al-pm, in proportion)");
  dimension("--cleft-depth-mm", dimensions.cleft_depth_mm, "Between posterior scallops");
  dimension("--anterior-arc", dimensions.anterior_arc, "Anterior share of the annulus");
  dimension("--inclination-deg", dimensions.inclination_deg, "Leaflets from the vertical");
  dimension("--tip-depth-mm", dimensions.tip_depth_mm, "Papillary tips below the annulus");
  dimension("--tip-spread-mm", dimensions.tip_spread_mm, "Between the tips, transverse");
  dimension("--tip-posterior-mm", dimensions.tip_posterior_mm, "Tips behind the centre");
  dimension("--trigone-share", dimensions.trigone_share,
            "Trigones, share of the arc from saddle peak to commissure");
  dimension("--slack", dimensions.slack, "Chordae lengths over their taut lengths");
  dimension("--posterior-slack", dimensions.posterior_slack, "Times slack, posterior marginal");
  dimension("--strut-slack", dimensions.strut_slack, "Times slack, strut");
  dimension("--basal-slack", dimensions.basal_slack, "Times slack, basal");
  Option annulus =
      dimension("--annulus", arguments->annulus, "Measured contour, CSV of x,y,z lines");
  Option tips = dimension("--tips", arguments->tips, "Measured papillary tips, CSV");
  annulus.needs(tips);
  tips.needs(annulus);
  command.footer(
      "Examples:\n"
      "  coapt valve make human-normal -o normal.json\n"
      "  coapt valve make porcine-1 --triangles 2600 -o porcine-1.json\n"
      "  coapt valve make --ap-mm 34 --tip-depth-mm 26 -o large.json");
  command.on_run([=, &status] {
    if (!arguments->preset.empty()) command.refuse_group("preset", kDimensions);
    status = run(*arguments);
  });
}

}  // namespace coapt
