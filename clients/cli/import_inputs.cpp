#include "clients/cli/import_inputs.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>
#include <map>

#include "core/valve/printable.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/dicom/segmentation.h"
#include "io/dicom/series_geometry.h"
#include "io/exchange/companion_files.h"
#include "io/exchange/file_roles.h"
#include "io/exchange/slicerheart.h"
#include "io/image/detached.h"
#include "io/image/write_label_map.h"
#include "io/mesh/text_scan.h"

namespace coapt {
namespace {

namespace fs = std::filesystem;

/// The files of a folder that a valve can be made of.
Expected<std::vector<NamedFile>> read_folder(const std::string& folder) {
  const Expected<std::vector<std::string>> paths = files_of(folder);
  if (!paths) return paths.errors();
  std::vector<NamedFile> files;
  for (const std::string& path : *paths) {
    const std::string format = format_of(path);
    if (format != "vtk" && format != "csv" && format != "json") continue;
    const std::string name = fs::path(path).filename();
    Expected<std::string> bytes = read_input(path);
    if (!bytes) return Error{ErrorCode::InputOutput, name, "cannot be read"};
    files.push_back({name, *std::move(bytes)});
  }
  return files;
}

int refuse(const std::string& why) {
  std::cerr << "coapt: valve import: " << printable(why) << '\n';
  return exit_code::kBadInput;
}

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

/// Folders among the bare files: a DICOM series, one of SlicerHeart, or files as if they were named one by one.
int take_folders(ImportInputs& inputs, std::vector<ImportDecision>& decisions) {
  std::vector<std::string> inside;
  for (const std::string& path : inputs.bare) {
    if (!is_folder(path)) continue;
    const Expected<std::vector<std::string>> files = files_of(path);
    if (!files) return report_errors(path, files.errors());
    const bool dicom = std::any_of(files->begin(), files->end(), is_dicom_file);
    if (!dicom && !is_slicerheart_folder(*files)) {
      FolderFiles found = importable(*files);
      if (found.paths.empty())
        return refuse(path +
                      ": has no file that a valve can be made of (label maps, meshes, "
                      "markups, tables)");
      inside.insert(inside.end(), found.paths.begin(), found.paths.end());
      decisions.insert(decisions.end(), found.decisions.begin(), found.decisions.end());
      continue;
    }
    std::string& place = dicom ? inputs.series : inputs.slicerheart;
    if (!place.empty())
      return refuse(path + ": is a second folder of the same kind; only one is accepted");
    place = path;
  }
  std::erase_if(inputs.bare, is_folder);
  inputs.bare.insert(inputs.bare.end(), inside.begin(), inside.end());
  const bool others = !inputs.bare.empty() || !inputs.leaflets.empty() || !inputs.labels.empty() ||
                      !inputs.annulus.empty() || !inputs.tips.empty();
  if (!inputs.slicerheart.empty() && others)
    return refuse("a SlicerHeart folder cannot be combined with other files");
  return exit_code::kOk;
}

int read_file(const std::string& path, const std::string& pointer, std::optional<NamedFile>& file,
              ImportPlaces& places) {
  if (path.empty()) return exit_code::kOk;
  Expected<NamedFile> read = read_import_file(path, pointer == "/labels");
  if (!read) return report_errors(path, read.errors());
  file = *std::move(read);
  places.emplace_back(pointer, path);
  return exit_code::kOk;
}

int read_bare(std::vector<std::string> paths, std::vector<NamedFile>& files, ImportPlaces& places) {
  Expected<std::vector<NamedFile>> read = read_with_companions(paths);
  if (!read) {
    for (const Error& error : read.errors())
      report_errors(error.path, {{error.code, "", error.message}});
    return exit_code::kBadInput;
  }
  for (std::size_t i = 0; i < paths.size(); ++i)
    places.emplace_back("/files/" + std::to_string(i), paths[i]);
  files = *std::move(read);
  return exit_code::kOk;
}

/// Of a header whose voxels are in a file beside it.
int attach_voxels(const std::string& path, NamedFile& map) {
  const Expected<std::vector<std::string>> companions = companions_of(map);
  if (!companions) return report_errors(path, companions.errors());
  if (companions->empty()) return exit_code::kOk;
  const std::string beside = fs::path(path).parent_path() / companions->front();
  const Expected<std::string> voxels = read_input(beside, most_map_bytes(kMostVoxels));
  if (!voxels) return report_errors(beside, voxels.errors());
  map.bytes = attached(map.bytes, *voxels);
  return exit_code::kOk;
}

int read_named(const ImportInputs& inputs, bool draws_chordae, ImportRequest& request,
               ImportPlaces& places) {
  for (const std::string& path : inputs.leaflets) {
    if (!request.leaflets) request.leaflets.emplace();
    std::optional<NamedFile> file;
    const std::string pointer = "/leaflets/" + std::to_string(request.leaflets->size());
    if (const int failed = read_file(path, pointer, file, places)) return failed;
    request.leaflets->push_back(*std::move(file));
  }
  const std::string chordae = draws_chordae ? "" : inputs.chordae;
  for (const auto& [path, pointer, file] :
       {std::tuple(inputs.annulus, "/annulus", &request.annulus),
        {chordae, "/chordae", &request.chordae},
        {inputs.tips, "/tips", &request.tips},
        {inputs.landmarks, "/landmarks", &request.landmarks_file},
        {inputs.labels, "/labels", &request.labels}})
    if (const int failed = read_file(path, pointer, *file, places)) return failed;
  return inputs.labels.empty() ? exit_code::kOk : attach_voxels(inputs.labels, *request.labels);
}

int read_label_numbers(const std::vector<std::string>& words, LabelNumbers& numbers) {
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    const std::string part = word.substr(0, equals);
    std::vector<int>* const number = part == "anterior"    ? &numbers.anterior
                                     : part == "posterior" ? &numbers.posterior
                                     : part == "annulus"   ? &numbers.annulus
                                                           : nullptr;
    const auto value =
        equals == std::string::npos ? std::nullopt : to_integer(word.substr(equals + 1));
    if (number == nullptr || !value || *value < 1 || *value > 65535)
      return refuse("--label: is " + word +
                    ", must be anterior=N, posterior=N or annulus=N, N from 1 to 65535");
    number->push_back(static_cast<int>(*value));
  }
  return exit_code::kOk;
}

int read_series(const std::string& folder, std::optional<ImageGeometry>& series) {
  if (folder.empty()) return exit_code::kOk;
  const Expected<std::vector<std::string>> files = files_of(folder);
  if (!files) return report_errors(folder, files.errors());
  Expected<ImageGeometry> read = read_series_geometry(*files);
  if (!read) return report_errors(folder, read.errors());
  series = *std::move(read);
  return exit_code::kOk;
}

constexpr std::size_t kMostAlike = 3;

std::string without_numbers(const Error& error) {
  std::string text = error.path + ' ' + error.message;
  std::erase_if(text, [](unsigned char c) { return std::isdigit(c) != 0; });
  return text;
}

/// What a user calls members of the request: options that were given, else the things themselves.
std::map<std::string, std::string> words_of_request(const ImportPlaces& places) {
  std::map<std::string, std::string> words = {{"/label_numbers", "--label"},
                                              {"/frame", "--frame"},
                                              {"/grid", "--series"},
                                              {"/closed", "--state"},
                                              {"/chordae_seed", "--chordae synthesise"},
                                              {"/thickness_measured", "--thickness"},
                                              {"/thickness_mm", "--thickness"},
                                              {"/files", "the files"}};
  for (const auto& [pointer, option, thing] : {std::tuple("/leaflets", "--leaflet", "the leaflets"),
                                               {"/labels", "--labels", "the label map"},
                                               {"/annulus", "--annulus", "the annulus"},
                                               {"/chordae", "--chordae", "the chordae"},
                                               {"/tips", "--tips", "the papillary tips"}}) {
    const bool given = std::any_of(
        places.begin(), places.end(),
        [member = pointer](const auto& place) { return place.first.starts_with(member); });
    words[pointer] = given ? option : thing;
  }
  return words;
}

/// Whether a file may hold the voxels of a map, by its name.
bool may_hold_voxels(const std::string& path) {
  const std::string format = format_of(path);
  return is_label_map_format(format) || format == "raw" || format == "zraw";
}

}  // namespace

Expected<std::vector<std::string>> files_of(const std::string& folder) {
  std::error_code failed;
  std::vector<std::string> paths;
  for (auto entry = fs::directory_iterator(folder, failed);
       !failed && entry != fs::directory_iterator(); entry.increment(failed)) {
    std::error_code ignored;
    const bool hidden = entry->path().filename().string().starts_with('.');
    if (!hidden && entry->is_regular_file(ignored)) paths.push_back(entry->path());
  }
  if (failed) return Error{ErrorCode::InputOutput, "", "cannot be opened as a folder"};
  std::sort(paths.begin(), paths.end());
  return paths;
}

FolderFiles importable(const std::vector<std::string>& paths) {
  FolderFiles found;
  std::copy_if(paths.begin(), paths.end(), std::back_inserter(found.paths), may_have_role);
  if (const std::size_t others = paths.size() - found.paths.size(); others > 0)
    found.decisions.push_back(
        {"files",
         std::to_string(others) + " of " + std::to_string(paths.size()) +
             " files of the folder not used",
         "their names are not those of label maps, meshes, markups or tables"});
  return found;
}

Expected<NamedFile> read_import_file(const std::string& path, bool is_map) {
  const std::string name = fs::path(path).filename();
  if (is_dicom_file(path)) {
    const Expected<LabelMap> map = read_dicom_segmentation(path);
    if (!map) return map.errors();
    return NamedFile{name + ".nrrd", write_nrrd(*map, "")};
  }
  Expected<std::string> bytes = is_map || may_hold_voxels(path)
                                    ? read_input(path, most_map_bytes(kMostVoxels))
                                    : read_input(path);
  if (!bytes) return bytes.errors();
  return NamedFile{name, *std::move(bytes)};
}

Expected<std::vector<NamedFile>> read_with_companions(std::vector<std::string>& paths) {
  const auto errors_at = [](const std::string& path, Errors errors) {
    for (Error& error : errors) error.path = path;
    return errors;
  };
  const auto place = [](const fs::path& path) {
    std::error_code ignored;
    return fs::weakly_canonical(path, ignored);
  };
  std::vector<NamedFile> files;
  std::vector<std::string> named_by(paths.size());
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const fs::path path = paths[i];
    Expected<NamedFile> source = read_import_file(path, !named_by[i].empty());
    if (!source && !named_by[i].empty())
      return Error{
          ErrorCode::InputOutput, named_by[i],
          "refers to " + path.filename().string() + ", which " + source.errors()[0].message};
    if (!source) return errors_at(path, source.errors());
    files.push_back(*std::move(source));
    const Expected<std::vector<std::string>> companions = companions_of(files.back());
    if (!companions) return errors_at(path, companions.errors());
    for (const std::string& name : *companions) {
      const fs::path beside = path.parent_path() / name;
      if (std::any_of(paths.begin(), paths.end(),
                      [&](const std::string& known) { return place(known) == place(beside); }))
        continue;
      paths.push_back(beside);
      named_by.push_back(path);
    }
  }
  return files;
}

/// With what the pointer says inside the file; chordae and tips are numbered by their lists. What is the same but for its place is said
/// three times and counted.
int report_import_errors(const Errors& errors, const ImportPlaces& places) {
  std::map<std::string, std::size_t> count, told;
  for (const Error& error : errors) ++count[without_numbers(error)];
  for (Error error : errors) {
    const std::string kind = without_numbers(error);
    const std::size_t before = told[kind]++;
    if (before >= kMostAlike) continue;
    if (before + 1 == kMostAlike && count[kind] > kMostAlike)
      error.message +=
          " (and " + std::to_string(count[kind] - kMostAlike) + " more of the same kind)";
    std::string source = "valve import";
    bool of_file = false;
    for (const auto& [pointer, path] : places) {
      if (error.path != pointer && !error.path.starts_with(pointer + "/")) continue;
      source = path;
      of_file = true;
      if (pointer != "/chordae" && pointer != "/tips") error.path.erase(0, pointer.size());
    }
    if (of_file)
      report_errors(source, {error});
    else
      report_option_errors("valve import", {error}, words_of_request(places));
  }
  return exit_code::kBadInput;
}

ReadInputs read_import_inputs(ImportInputs inputs, bool draws_chordae) {
  ReadInputs read;
  ImportRequest& request = read.request;
  ImportReading& reading = request.reading;
  if ((read.failed = take_folders(inputs, read.decisions))) return read;
  if (!inputs.slicerheart.empty()) {
    Expected<std::vector<NamedFile>> folder = read_folder(inputs.slicerheart);
    if (!folder) read.failed = report_errors(inputs.slicerheart, folder.errors());
    if (!folder) return read;
    request.slicerheart = *std::move(folder);
    read.places.emplace_back("/slicerheart", inputs.slicerheart);
  }
  if (!inputs.abaqus.empty()) {
    std::optional<NamedFile> model;
    if ((read.failed = read_file(inputs.abaqus, "/files/0", model, read.places))) return read;
    request.files = {{"model.inp", std::move(model->bytes)}};
  }
  if (!inputs.bare.empty() &&
      (read.failed = read_bare(inputs.bare, request.files.emplace(), read.places)))
    return read;
  if ((read.failed = read_named(inputs, draws_chordae, request, read.places))) return read;
  if ((read.failed = read_label_numbers(inputs.label_numbers, reading.labels))) return read;
  if ((read.failed = read_series(inputs.series, reading.series))) return read;
  if (!inputs.series.empty()) read.places.emplace_back("/grid", inputs.series);
  reading.axes = inputs.axes;
  reading.most_unpacked = kMostUnpacked;
  reading.phase = inputs.phase;
  return read;
}

}  // namespace coapt
