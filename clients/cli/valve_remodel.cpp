#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/read_argument.h"
#include "core/valve/remodel.h"
#include "core/valve/ruptures.h"
#include "io/command_line/files.h"
#include "io/json/dimensions_json.h"
#include "io/json/valve_json.h"

namespace coapt {
namespace {

constexpr const char* kChanges = "Disease";

struct ValveRemodelArguments {
  std::string valve, file, name, output;
  Remodelling change;
  std::vector<double> anterolateral_mm = {0.0, 0.0, 0.0};
  std::vector<double> posteromedial_mm = {0.0, 0.0, 0.0};
  std::vector<std::string> ruptured;
};

int run(ValveRemodelArguments arguments) {
  const Expected<Valve> valve = read_valve_argument(arguments.valve);
  if (!valve) return report_errors(arguments.valve, valve.errors());
  arguments.change.anterolateral_mm = Vec3(arguments.anterolateral_mm.data());
  arguments.change.posteromedial_mm = Vec3(arguments.posteromedial_mm.data());
  for (const Segment segment : kScallops)
    if (std::find(arguments.ruptured.begin(), arguments.ruptured.end(), to_string(segment)) !=
        arguments.ruptured.end())
      arguments.change.ruptured.push_back(segment);
  if (!arguments.file.empty()) {
    const Expected<std::string> text = read_input(arguments.file);
    if (!text) return report_errors(arguments.file, text.errors());
    const Expected<HumanValve> read = read_dimensions(*text);
    if (!read) return report_errors(arguments.file, read.errors());
    arguments.change = read->change.value_or(Remodelling{});
  }
  const Expected<Valve> remodelled = remodel(*valve, arguments.change);
  if (!remodelled && !arguments.file.empty()) {
    ProblemList problems;
    add_below(problems, "/remodelling", remodelled.errors());
    return report_errors(arguments.file, std::move(problems).take());
  }
  if (!remodelled) {
    return report_option_errors("valve remodel", remodelled.errors(),
                                {{"/ap_dilation_percent", "--ap-dilation"},
                                 {"/annular_height_percent", "--annular-height"},
                                 {"/anterolateral_mm", "--displace-al"},
                                 {"/posteromedial_mm", "--displace-pm"},
                                 {"/leaflet_growth_percent", "--leaflet-growth"},
                                 {"/ruptured", "--rupture"}});
  }
  Valve named = *remodelled;
  named.name = arguments.name.empty() ? valve->name + " remodelled" : arguments.name;
  return write_output(arguments.output, write_valve(named));
}

}  // namespace

void add_valve_remodel(Command parent, int& status) {
  const auto arguments = std::make_shared<ValveRemodelArguments>();
  Command command = parent.add_command(
      "remodel",
      "Apply disease to a valve: dilate or flatten the annulus, displace papillary tips, enlarge "
      "leaflets, rupture or elongate chordae, change tissue");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  command
      .add_option("--dimensions", arguments->file,
                  "Take the remodelling, including growth, chordae and tissue, from this file "
                  "(coapt.dimensions/1) instead of the options below")
      .show_argument("FILE");
  command
      .add_option("--ap-dilation", arguments->change.ap_dilation_percent,
                  "Anteroposterior dilation, per cent; the transverse diameter is unchanged")
      .group(kChanges)
      .show_default();
  command
      .add_option("--annular-height", arguments->change.annular_height_percent,
                  "Saddle height, per cent of its present value")
      .group(kChanges)
      .show_default();
  const auto displacement = [&](const char* name, std::vector<double>& value, const char* help) {
    command.add_option(name, value, help).split_at(',').count(3, 3).group(kChanges).show_default();
  };
  displacement("--displace-al", arguments->anterolateral_mm,
               "Displacement of the anterolateral tip: outwards,posterior,apical in mm");
  displacement("--displace-pm", arguments->posteromedial_mm,
               "Displacement of the posteromedial tip: outwards,posterior,apical in mm");
  command
      .add_option("--leaflet-growth", arguments->change.leaflet_growth_percent,
                  "Increase of the leaflet heights, per cent")
      .group(kChanges)
      .show_default();
  std::vector<std::string> scallops;
  for (const Segment segment : kScallops) scallops.emplace_back(to_string(segment));
  command.add_option("--rupture", arguments->ruptured, "Rupture the marginal chordae of a segment")
      .one_of(scallops)
      .one_at_a_time()
      .group(kChanges);
  command.add_option("--name", arguments->name, "Name of the new valve")
      .show_default("the old name and \"remodelled\"");
  command.add_option("-o,--output", arguments->output, "File to write, - for standard output")
      .required();
  command.footer(
      "Examples:\n"
      "  coapt valve remodel human-normal --ap-dilation 15 --displace-pm 4,2,3 -o leaking.json\n"
      "  coapt valve remodel normal.json --leaflet-growth 10 --rupture P2 -o flail.json\n"
      "  coapt valve remodel patient.json --dimensions examples/calibration/barlow.json -o "
      "sick.json");
  command.on_run([=, &status] {
    if (!arguments->file.empty()) command.refuse_group("--dimensions", kChanges);
    status = run(*arguments);
  });
}

}  // namespace coapt
