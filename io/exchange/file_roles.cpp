#include "io/exchange/file_roles.h"

#include <algorithm>
#include <array>
#include <map>

#include "core/valve/problem_list.h"
#include "io/exchange/markups.h"
#include "io/exchange/part_names.h"
#include "io/image/label_map.h"
#include "io/json/json_reader.h"
#include "io/json/parse_json.h"
#include "io/mesh/csv_table.h"

namespace coapt {
namespace {

constexpr std::array<std::string_view, 6> kMeshFormats = {"obj", "ply", "stl", "vtk", "vtp", "vtu"};
constexpr std::size_t kChordaFields = 8;  // id, papillary, insertion, tip

bool is_mesh(const std::string& name) {
  const std::string format = format_of(name);
  return std::find(kMeshFormats.begin(), kMeshFormats.end(), format) != kMeshFormats.end();
}

GuessedRole role_of_json(const std::string& bytes) {
  if (const Expected<Json> document = parse_json(bytes);
      document && document->is_object() && document->contains("chordae"))
    return {FileRole::Chordae, "it has a list of chordae"};
  const Expected<std::vector<Markup>> markups = read_markups(bytes);
  if (!markups) return {};
  bool tips = false;
  for (const Markup& markup : *markups) {
    if (markup.type == MarkupType::ClosedCurve)
      return {FileRole::Annulus, "it has a closed curve of Slicer"};
    for (const std::string& label : markup.labels)
      tips = tips || label.starts_with("AL") || label.starts_with("PM");
  }
  if (tips) return {FileRole::Tips, "it has points labelled AL or PM"};
  return {};
}

GuessedRole role_of_table(const std::string& bytes) {
  const Expected<CsvTable> table = read_csv(bytes, {"x", "x_mm", "papillary", "ins_x"});
  if (!table || table->rows.empty()) return {};
  const auto has = [&](std::string_view column) {
    return std::find(table->names.begin(), table->names.end(), column) != table->names.end();
  };
  const std::vector<std::string_view>& row = table->rows[0].fields;
  if (has("ins_x") || row.size() >= kChordaFields)
    return {FileRole::Chordae, "its columns are those of chordae"};
  if (has("papillary") || (row.size() == 4 && !to_number(row[0])))
    return {FileRole::Tips, "its columns are papillary, x, y, z"};
  if (row.size() == 3 && to_number(row[0])) return {FileRole::Annulus, "its columns are x, y, z"};
  return {};
}

FileRole role_of(NamedPart part) {
  switch (part) {
    case NamedPart::Anterior:
      return FileRole::Anterior;
    case NamedPart::Posterior:
      return FileRole::Posterior;
    case NamedPart::Annulus:
      return FileRole::Annulus;
    case NamedPart::Chordae:
      return FileRole::Chordae;
    case NamedPart::Tips:
      return FileRole::Tips;
  }
  return FileRole::None;
}

/// Of meshes whose names say nothing: by their order, or by what the other one is.
void guess_meshes(const std::vector<std::size_t>& meshes, std::vector<GuessedRole>& roles) {
  if (meshes.size() == 1) {
    roles[meshes[0]] = {FileRole::Anterior, "it is the only mesh: both leaflets as one skirt"};
    return;
  }
  if (meshes.size() != 2) return;
  GuessedRole &first = roles[meshes[0]], &second = roles[meshes[1]];
  if (first.role == FileRole::None && second.role == FileRole::None) {
    first = {FileRole::Anterior, "of two meshes without telling names the anterior one comes first",
             true};
    second = {FileRole::Posterior, first.reason, true};
  } else if (first.role == FileRole::None || second.role == FileRole::None) {
    const bool anterior = first.role == FileRole::Anterior || second.role == FileRole::Anterior;
    (first.role == FileRole::None ? first : second) = {
        anterior ? FileRole::Posterior : FileRole::Anterior, "the other mesh is the other leaflet"};
  }
}

const char* words_of(FileRole role) {
  switch (role) {
    case FileRole::Labels:
      return "a label map";
    case FileRole::Anterior:
      return "the anterior leaflet";
    case FileRole::Posterior:
      return "the posterior leaflet";
    case FileRole::Annulus:
      return "the annulus";
    case FileRole::Chordae:
      return "chordae";
    case FileRole::Tips:
      return "the papillary tips";
    case FileRole::None:
      break;
  }
  return "nothing known";
}

}  // namespace

std::vector<GuessedRole> guessed_roles(const std::vector<NamedFile>& files) {
  std::vector<GuessedRole> roles(files.size());
  std::vector<std::size_t> meshes;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string format = format_of(files[i].name);
    const std::optional<NamedPart> part =
        part_named(files[i].name.substr(0, files[i].name.rfind('.')));
    if (is_label_map_format(format)) {
      roles[i] = {FileRole::Labels, "it is an image, ." + format};
    } else if (format == "json") {
      roles[i] = role_of_json(files[i].bytes);
    } else if (format == "csv" || format == "txt") {
      roles[i] = role_of_table(files[i].bytes);
    } else if (is_mesh(files[i].name)) {
      meshes.push_back(i);
      if (part == NamedPart::Anterior || part == NamedPart::Posterior)
        roles[i] = {role_of(*part), "its name says so"};
      continue;
    }
    const bool is_leaflet = part == NamedPart::Anterior || part == NamedPart::Posterior;
    if (roles[i].role == FileRole::None && part && !is_leaflet &&
        (format == "json" || format == "csv"))
      roles[i] = {role_of(*part), "its name says so"};
  }
  guess_meshes(meshes, roles);
  return roles;
}

Expected<SortedFiles> sorted_files(std::vector<NamedFile> files) {
  const std::vector<GuessedRole> roles = guessed_roles(files);
  ProblemList problems;
  SortedFiles sorted;
  std::map<FileRole, std::size_t> first;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string path = "/files/" + std::to_string(i);
    const FileRole role = roles[i].role;
    if (role == FileRole::None) {
      problems.add(
          ErrorCode::Unsupported, path,
          "does not tell what it holds; must be a label map (.nrrd, .nii, .nii.gz), one or "
          "two meshes named anterior and posterior, or markups or a table of annulus, "
          "chordae or tips; or give it by its option (--leaflet, --annulus, ...)");
      continue;
    }
    if (const auto [other, is_first] = first.try_emplace(role, i); !is_first) {
      problems.add(ErrorCode::BadReference, path,
                   std::string("is ") + words_of(role) + ", as is file " +
                       std::to_string(other->second + 1) + "; must be one of each");
      continue;
    }
    const bool skirt =
        role == FileRole::Anterior && roles[i].reason.find("skirt") != std::string::npos;
    sorted.decisions.push_back({"files",
                                "file " + std::to_string(i + 1) + " of " +
                                    std::to_string(files.size()) + " (." +
                                    format_of(files[i].name).substr(0, 8) + ") is " +
                                    (skirt ? "both leaflets" : words_of(role)),
                                roles[i].reason, roles[i].look});
  }
  if (!problems.empty()) return std::move(problems).take();
  const auto place = [&](FileRole role, const std::string& pointer, auto take) {
    const auto found = first.find(role);
    if (found == first.end()) return;
    sorted.places.emplace_back(pointer, found->second);
    take(std::move(files[found->second]));
  };
  ImportFiles& parts = sorted.files;
  const auto leaflet = [&](NamedFile file) { parts.leaflets.push_back(std::move(file)); };
  place(FileRole::Anterior, "/leaflets/0", leaflet);
  place(FileRole::Posterior, "/leaflets/" + std::to_string(parts.leaflets.size()), leaflet);
  place(FileRole::Labels, "/labels", [&](NamedFile file) { parts.labels = std::move(file); });
  place(FileRole::Annulus, "/annulus", [&](NamedFile file) { parts.annulus = std::move(file); });
  place(FileRole::Chordae, "/chordae", [&](NamedFile file) { parts.chordae = std::move(file); });
  place(FileRole::Tips, "/tips", [&](NamedFile file) { parts.tips = std::move(file); });
  return sorted;
}

}  // namespace coapt
