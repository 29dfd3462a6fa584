#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/exit_code.h"
#include "clients/cli/files.h"
#include "clients/cli/number_option.h"
#include "io/json/valve_json.h"
#include "io/mesh/import_valve.h"

namespace coapt {
namespace {

struct Arguments {
  std::vector<std::string> leaflets;
  std::string annulus, chordae;
  std::string name;
  std::vector<std::string> provenance;
  ImportOptions options;
  std::string output;
};

/// "obj" of "Leaflet.OBJ".
std::string format_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// Reads the file at `path` with `parse` into `value`; returns an exit code.
template <class T, class Parse>
int read_part(const std::string& path, const Parse& parse, T& value) {
  const Expected<std::string> bytes = read_input(path);
  if (!bytes) return report_errors(path, bytes.errors());
  Expected<T> parsed = parse(*bytes, format_of(path));
  if (!parsed) return report_errors(path, parsed.errors());
  value = *std::move(parsed);
  return exit_code::kOk;
}

int run(const Arguments& arguments) {
  ImportSource source;
  source.name = arguments.name;
  source.provenance = arguments.provenance;
  for (const std::string& path : arguments.leaflets) {
    source.leaflets.emplace_back();
    if (const int failed = read_part(path, read_mesh, source.leaflets.back())) return failed;
  }
  const auto read_contour = [](std::string_view text, const std::string& /*format*/) {
    return read_points_csv(text);
  };
  if (const int failed = read_part(arguments.annulus, read_contour, source.annulus_mm)) {
    return failed;
  }
  if (const int failed = read_part(arguments.chordae, read_chordae, source.chordae)) return failed;
  const Expected<Valve> valve = import_valve(source, arguments.options);
  if (!valve) {
    return report_option_errors("valve import", valve.errors(),
                                {{"/leaflets", "--leaflet"}, {"/annulus_mm", "--annulus"}});
  }
  return write_output(arguments.output, write_valve(*valve));
}

}  // namespace

void add_valve_import(CLI::App& parent, int& status) {
  const auto arguments = std::make_shared<Arguments>();
  ImportOptions& options = arguments->options;
  CLI::App* command =
      parent.add_subcommand("import", "Make a valve from leaflet meshes, annulus and chordae");
  command
      ->add_option(
          "--leaflet", arguments->leaflets,
          "Leaflet mesh (OBJ, PLY or STL, millimetres): anterior and posterior, or one skirt")
      ->required()
      ->expected(1, 2);
  command->add_option("--annulus", arguments->annulus, "Closed loop, CSV of x,y,z lines")
      ->required();
  command->add_option("--chordae", arguments->chordae, "Insertions and papillary tips, CSV or JSON")
      ->required();
  command->add_option("-o,--output", arguments->output, "File to write, - for standard output")
      ->required();
  command->add_option("--triangles", options.triangles, "About how many triangles")
      ->capture_default_str()
      ->check(number_from(100, 100000));
  command->add_option("--branches", options.branches, "Insertions per chorda")
      ->capture_default_str()
      ->check(number_from(1, 5));
  command->add_option("--branch-at", options.branch_at, "Share of the way from tip to insertion")
      ->capture_default_str();
  command->add_option("--slack", options.slack, "Chordae lengths over straight distances")
      ->capture_default_str();
  command->add_option("--name", arguments->name, "Name of the valve")->default_str("imported");
  command->add_option("--provenance", arguments->provenance,
                      "Source or licence, kept in the valve");
  command->footer(
      "Example:\n"
      "  coapt valve import --leaflet anterior.obj posterior.obj --annulus annulus.csv \\\n"
      "    --chordae chordae.csv --triangles 1400 -o valve.json");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
