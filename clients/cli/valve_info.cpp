#include <iostream>
#include <map>
#include <memory>
#include <string>

#include "clients/cli/commands.h"
#include "clients/cli/read_argument.h"
#include "core/valve/pressure_unit.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/json/json.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

struct ValveInfoArguments {
  std::string valve;
  bool json = false;
};

/// What a valve is before it is closed.
struct Summary {
  double saddle_to_mid_posterior_mm = 0.0;  ///< under pressure
  double commissures_mm = 0.0;              ///< under pressure, one to the other
  double leaflet_area_mm2 = 0.0;            ///< unstressed
  std::map<std::string, int> chordae;       ///< how many of each kind
  int ruptured = 0;
};

Summary summarize(const Valve& valve) {
  Summary summary;
  const auto distance_mm = [&](int from, int to) {
    return (annulus_position_mm(valve, from) - annulus_position_mm(valve, to)).norm();
  };
  const Landmarks& landmarks = valve.landmarks;
  summary.saddle_to_mid_posterior_mm = distance_mm(landmarks.saddle_peak, landmarks.mid_posterior);
  summary.commissures_mm =
      distance_mm(landmarks.anterolateral_commissure, landmarks.posteromedial_commissure);
  for (Eigen::Index face = 0; face < valve.faces.rows(); ++face) {
    const Vec3 a = valve.rest_mm.row(valve.faces(face, 0));
    const Vec3 b = valve.rest_mm.row(valve.faces(face, 1));
    const Vec3 c = valve.rest_mm.row(valve.faces(face, 2));
    summary.leaflet_area_mm2 += 0.5 * (b - a).cross(c - a).norm();
  }
  for (const Chorda& chorda : valve.chordae) {
    ++summary.chordae[to_string(chorda.kind)];
    if (chorda.ruptured) ++summary.ruptured;
  }
  return summary;
}

void print_json(const Valve& valve, const Summary& summary) {
  const Json json = {{"name", valve.name},
                     {"triangles", valve.faces.rows()},
                     {"vertices", valve.rest_mm.rows()},
                     {"annulus_points", valve.annulus.size()},
                     {"papillary_heads", valve.heads.size()},
                     {"chordae", summary.chordae},
                     {"ruptured_chordae", summary.ruptured},
                     {"saddle_to_mid_posterior_mm", summary.saddle_to_mid_posterior_mm},
                     {"commissures_mm", summary.commissures_mm},
                     {"leaflet_area_mm2", summary.leaflet_area_mm2},
                     {"pressure_kpa", valve.pressure_kpa},
                     {"provenance", valve.provenance}};
  std::cout << json_text(json, 2) << '\n';
}

void print_text(const Valve& valve, const Summary& summary) {
  std::cout << printable(valve.name) << '\n'
            << "  mesh            " << valve.faces.rows() << " triangles, " << valve.rest_mm.rows()
            << " vertices, " << valve.annulus.size() << " on the annulus\n"
            << "  annulus         saddle peak to mid-posterior "
            << fixed(summary.saddle_to_mid_posterior_mm, 1) << ", between commissures "
            << fixed(summary.commissures_mm, 1) << " mm\n"
            << "  leaflets        " << fixed(summary.leaflet_area_mm2, 0) << " mm2 (unstressed)\n"
            << "  papillary heads " << valve.heads.size() << '\n'
            << "  chordae         " << valve.chordae.size();
  for (const auto& [kind, count] : summary.chordae) std::cout << ", " << count << ' ' << kind;
  std::cout << "; " << summary.ruptured << " ruptured\n"
            << "  pressure        " << fixed(kMmhgPerKpa * valve.pressure_kpa, 0) << " mmHg\n";
  for (const std::string& line : valve.provenance) std::cout << "  - " << printable(line) << '\n';
}

int run(const ValveInfoArguments& arguments) {
  const Expected<Valve> valve = read_valve_argument(arguments.valve);
  if (!valve) return report_errors(arguments.valve, valve.errors());
  const Summary summary = summarize(*valve);
  if (arguments.json) {
    print_json(*valve, summary);
  } else {
    print_text(*valve, summary);
  }
  return exit_code::kOk;
}

}  // namespace

void add_valve_info(Command parent, int& status) {
  const auto arguments = std::make_shared<ValveInfoArguments>();
  Command command = parent.add_command("info", "Describe a valve");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  command.add_flag("--json", arguments->json, "Print JSON");
  command.footer("Example:\n  coapt valve info human-p2-prolapse");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
