#include "io/exchange/file_roles.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "core/valve/problem_list.h"
#include "io/exchange/companion_files.h"
#include "io/exchange/landmark_files.h"
#include "io/exchange/markups.h"
#include "io/exchange/part_names.h"
#include "io/image/label_map.h"
#include "io/json/json_reader.h"
#include "io/json/parse_json.h"
#include "io/mesh/csv_table.h"
#include "io/mesh/import_readers.h"

namespace coapt {
namespace {

constexpr std::array<std::string_view, 8> kMeshFormats = {"obj",  "ply", "stl", "glb",
                                                          "gltf", "vtk", "vtp", "vtu"};
constexpr std::size_t kChordaFields = 8;  // id, papillary, insertion, tip

bool is_mesh(const std::string& name) {
  const std::string format = format_of(name);
  return std::find(kMeshFormats.begin(), kMeshFormats.end(), format) != kMeshFormats.end();
}

bool is_companion_format(const std::string& format) {
  return format == "vtm" || format == "raw" || format == "zraw" || format == "bin";
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
      return {FileRole::Annulus, "it has a closed curve from Slicer"};
    for (const std::string& label : markup.labels)
      tips = tips || label.starts_with("AL") || label.starts_with("PM");
  }
  if (has_commissures(bytes, "json"))
    return {FileRole::Landmarks, "it has points labelled ALC or PMC"};
  if (tips) return {FileRole::Tips, "it has points labelled AL or PM"};
  return {};
}

GuessedRole role_of_table(const std::string& bytes) {
  const Expected<CsvTable> table = read_csv(bytes, {"x", "papillary", "ins_x"});
  if (!table || table->rows.empty()) return {};
  const std::vector<std::string_view>& row = table->rows[0].fields;
  if (has_commissures(bytes, "csv"))
    return {FileRole::Landmarks, "its points are labelled ALC or PMC"};
  const bool points = !table->names.empty() && !table->has("papillary") && !table->has("ins_x");
  if (points && (table->has("label") || table->has("name")) && read_tips_csv(bytes))
    return {FileRole::Tips, "its points are labelled AL or PM"};
  if (points) return {FileRole::Annulus, "its columns are x, y, z"};
  if (table->has("ins_x") || row.size() >= kChordaFields)
    return {FileRole::Chordae, "its columns are those of chordae"};
  if (table->has("papillary") || (row.size() == 4 && !table->number(row[0])))
    return {FileRole::Tips, "its columns are papillary, x, y, z"};
  if (row.size() == 3 && table->number(row[0]))
    return {FileRole::Annulus, "its columns are x, y, z"};
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
    case NamedPart::Commissure:
    case NamedPart::Other:
    case NamedPart::OtherLeaflet:
      break;
  }
  return FileRole::None;
}

/// Of meshes whose names say nothing: by their order, or by what the other one is.
constexpr const char* kBoth = "it is the only mesh";
constexpr const char* kUnnamed = "there are two meshes, and their names do not distinguish them";

void guess_meshes(const std::vector<std::size_t>& meshes, std::vector<GuessedRole>& roles) {
  if (meshes.size() == 1) {
    roles[meshes[0]] = {FileRole::Anterior, kBoth};
    return;
  }
  if (meshes.size() != 2) return;
  GuessedRole &first = roles[meshes[0]], &second = roles[meshes[1]];
  if (first.role == FileRole::None && second.role == FileRole::None) {
    first = {FileRole::Anterior, kUnnamed};
    second = {FileRole::Posterior, kUnnamed};
  } else if (first.role == FileRole::None || second.role == FileRole::None) {
    const bool anterior = first.role == FileRole::Anterior || second.role == FileRole::Anterior;
    (first.role == FileRole::None ? first : second) = {
        anterior ? FileRole::Posterior : FileRole::Anterior, "the other mesh is the other leaflet"};
  }
}

std::optional<NamedPart> part_of_file(const std::string& name) {
  return part_named(name.substr(0, name.rfind('.')));
}

/// Lines without a surface, of the formats that an annulus may come in.
bool is_line(const std::string& bytes, const std::string& format) {
  if (format == "obj")
    return bytes.find("\nl ") != std::string::npos && bytes.find("\nf ") == std::string::npos;
  if (format == "vtp")
    return bytes.find("NumberOfPolys=\"0\"") != std::string::npos &&
           bytes.find("NumberOfStrips=\"0\"") != std::string::npos &&
           bytes.find("NumberOfLines=\"") != std::string::npos &&
           bytes.find("NumberOfLines=\"0\"") == std::string::npos;
  return format == "vtk" && bytes.find("\nLINES ") != std::string::npos &&
         bytes.find("\nPOLYGONS ") == std::string::npos;
}

/// Scallops, or a leaflet and its commissures.
bool are_of_one_leaflet(const NamedFile& a, const NamedFile& b) {
  return (is_scallop(a.name) && is_scallop(b.name)) ||
         part_of_file(a.name) == NamedPart::Commissure ||
         part_of_file(b.name) == NamedPart::Commissure;
}

bool is_leaflet(FileRole role) { return role == FileRole::Anterior || role == FileRole::Posterior; }

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
    case FileRole::Landmarks:
      return "landmarks of the annulus";
    case FileRole::None:
      break;
  }
  return "an unknown role";
}

}  // namespace

bool may_have_role(const std::string& name) {
  const std::string format = format_of(name);
  std::string file = name.substr(name.find_last_of("/\\") + 1);
  std::transform(file.begin(), file.end(), file.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const char* told : {"license", "readme", "copying", "notice"})
    if (file.starts_with(told)) return false;
  return is_label_map_format(format) || is_table_format(format) || is_mesh(name) ||
         format == "json" || format == "inp" || is_companion_format(format);
}

std::vector<GuessedRole> guessed_roles(const std::vector<NamedFile>& files) {
  std::vector<GuessedRole> roles(files.size());
  std::vector<std::size_t> meshes, rings;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string format = format_of(files[i].name);
    const std::optional<NamedPart> part = part_of_file(files[i].name);
    if (is_label_map_format(format)) {
      roles[i] = {FileRole::Labels, "it is an image, ." + format};
    } else if (format == "json") {
      roles[i] = role_of_json(files[i].bytes);
    } else if (is_table_format(format)) {
      roles[i] = role_of_table(files[i].bytes);
    } else if (is_mesh(files[i].name)) {
      if (is_line(files[i].bytes, format)) {
        roles[i] = {FileRole::Annulus, "it has lines but no surface"};
        continue;
      }
      if (part == NamedPart::Annulus) {
        rings.push_back(i);
        continue;
      }
      meshes.push_back(i);
      if (part == NamedPart::Anterior || part == NamedPart::Posterior)
        roles[i] = {role_of(*part), "recognised by its name"};
      else if (part == NamedPart::Commissure)
        roles[i] = {FileRole::Posterior, "its name contains a commissure"};
      continue;
    }
    const bool is_leaflet = part == NamedPart::Anterior || part == NamedPart::Posterior;
    if (roles[i].role == FileRole::None && part && !is_leaflet &&
        (format == "json" || is_table_format(format)))
      roles[i] = {role_of(*part), "recognised by its name"};
  }
  if (meshes.empty()) std::swap(meshes, rings);  // both leaflets and the annulus in one file
  for (const std::size_t ring : rings) roles[ring] = {FileRole::Annulus, "recognised by its name"};
  guess_meshes(meshes, roles);
  return roles;
}

Expected<SortedFiles> sorted_files(std::vector<NamedFile> files) {
  const std::size_t count = files.size();
  Expected<CompleteFiles> complete = completed(std::move(files));
  if (!complete) return complete.errors();
  files = std::move(complete->files);
  const std::vector<std::size_t>& given = complete->given;
  const std::vector<GuessedRole> roles = guessed_roles(files);
  ProblemList problems;
  SortedFiles sorted;
  sorted.decisions = std::move(complete->decisions);
  std::map<FileRole, std::size_t> first;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string path = "/files/" + std::to_string(given[i]);
    const FileRole role = roles[i].role;
    if (role == FileRole::None && part_of_file(files[i].name) == NamedPart::OtherLeaflet) {
      problems.add(ErrorCode::Unsupported, path,
                   "is named as a leaflet of another valve (septal, tricuspid, aortic or "
                   "pulmonary); a mitral valve has an anterior and a posterior leaflet");
      continue;
    }
    if (role == FileRole::None) {
      problems.add(
          ErrorCode::Unsupported, path,
          "has an unknown role; must be a label map (.nrrd, .nii, .mha, .gz, .bz2), one or "
          "two meshes named anterior and posterior, or markups or a table of annulus, "
          "chordae or tips; or use the option for its role (--leaflet, --annulus, ...)");
      continue;
    }
    if (const auto [other, is_first] = first.try_emplace(role, i);
        !is_first && !(is_leaflet(role) && are_of_one_leaflet(files[i], files[other->second]))) {
      problems.add(ErrorCode::BadReference, path,
                   std::string("is ") + words_of(role) + ", as is file " +
                       std::to_string(given[other->second] + 1) +
                       "; only one file per role is allowed");
      continue;
    }
    sorted.decisions.push_back({"files",
                                "file " + std::to_string(given[i] + 1) + " of " +
                                    std::to_string(count) + " (." +
                                    format_of(files[i].name).substr(0, 8) + ") is " +
                                    (roles[i].reason == kBoth      ? "both leaflets"
                                     : roles[i].reason == kUnnamed ? "one of the leaflets"
                                                                   : words_of(role)),
                                roles[i].reason});
  }
  if (!problems.empty()) return std::move(problems).take();
  const auto place = [&](FileRole role, const std::string& pointer, auto take) {
    const auto found = first.find(role);
    if (found == first.end()) return;
    sorted.places.emplace_back(pointer, given[found->second]);
    take(std::move(files[found->second]));
  };
  ImportFiles& parts = sorted.files;
  const bool guessed = std::any_of(roles.begin(), roles.end(),
                                   [](const GuessedRole& of) { return of.reason == kUnnamed; });
  parts.order.claim = guessed ? LeafletClaim::Guessed : LeafletClaim::Named;
  if (guessed) parts.order.numbered[0] = "by their order";
  for (const FileRole side : {FileRole::Anterior, FileRole::Posterior}) {
    if (side == FileRole::Posterior) parts.posterior_from = parts.leaflets.size();
    std::string called;
    for (std::size_t i = 0; i < files.size(); ++i) {
      if (roles[i].role != side) continue;
      called += (called.empty() ? "" : ", ") + std::to_string(given[i] + 1);
      sorted.places.emplace_back("/leaflets/" + std::to_string(parts.leaflets.size()), given[i]);
      parts.leaflets.push_back(std::move(files[i]));
    }
    parts.order.called[side == FileRole::Anterior ? 0 : 1] =
        (called.find(',') == std::string::npos ? "file " : "the union of files ") + called;
  }
  parts.order.swap = "use --leaflet, with the anterior leaflet first";
  place(FileRole::Labels, "/labels", [&](NamedFile file) { parts.labels = std::move(file); });
  place(FileRole::Annulus, "/annulus", [&](NamedFile file) { parts.annulus = std::move(file); });
  place(FileRole::Chordae, "/chordae", [&](NamedFile file) { parts.chordae = std::move(file); });
  place(FileRole::Tips, "/tips", [&](NamedFile file) { parts.tips = std::move(file); });
  place(FileRole::Landmarks, "/landmarks",
        [&](NamedFile file) { parts.landmarks = std::move(file); });
  return sorted;
}

}  // namespace coapt
