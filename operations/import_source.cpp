#include "operations/import_source.h"

#include <algorithm>

#include "io/exchange/file_roles.h"
#include "io/exchange/slicerheart.h"
#include "io/image/detached.h"

namespace coapt {
namespace {

constexpr const char* kModelFormat = "inp";

bool is_at(const std::string& path, const std::string& pointer) {
  return path == pointer || path.starts_with(pointer + '/');
}

/// A header with its voxels.
Expected<std::optional<NamedFile>> whole_labels(const ImportRequest& asked) {
  if (!asked.labels || !asked.voxels) return asked.labels;
  const Expected<std::optional<std::string>> named = data_file_of(asked.labels->bytes);
  if (!named) return Error{named.errors()[0].code, "/labels", named.errors()[0].message};
  if (!*named)
    return Error{ErrorCode::UnknownField, "/voxels",
                 "is not allowed, because labels refers to no separate voxel file"};
  return std::optional(
      NamedFile{asked.labels->name, attached(asked.labels->bytes, asked.voxels->bytes)});
}

}  // namespace

Expected<std::optional<NamedFile>> model_among(const std::vector<NamedFile>& files) {
  const auto model = std::find_if(files.begin(), files.end(), [](const NamedFile& file) {
    return format_of(file.name) == kModelFormat;
  });
  if (model == files.end()) return std::optional<NamedFile>();
  if (files.size() > 1)
    return Error{ErrorCode::Unsupported, "/files/" + std::to_string(model - files.begin()),
                 "is a finite element model with its own leaflets and chordae; it cannot be "
                 "combined with other files"};
  return std::optional(*model);
}

Expected<ImportSource> RequestedSource::read_folder(const ImportRequest& asked) {
  is_folder_ = true;
  ProblemList problems;
  for (const auto& [given, path] : {std::pair(asked.reading.labels.any(), "/label_numbers"),
                                    {asked.reading.phase > 0, "/phase"},
                                    {asked.reading.series.has_value(), "/grid"}})
    if (given)
      problems.add(ErrorCode::UnknownField, path,
                   "applies to label maps and cannot be given with a SlicerHeart folder");
  if (!problems.empty()) return std::move(problems).take();
  Expected<ImportSource> source = read_slicerheart(*asked.slicerheart);
  if (!source) return as_requested(source.errors());
  if (!asked.landmarks_file) return source;
  ImportFiles landmarks;
  landmarks.landmarks = asked.landmarks_file;
  ImportReading reading;
  reading.axes = asked.reading.axes;
  Expected<ImportSource> placed = read_import_files(landmarks, reading);
  if (!placed) return placed.errors();
  source->landmarks = placed->landmarks;
  source->decisions.insert(source->decisions.end(), placed->decisions.begin(),
                           placed->decisions.end());
  return source;
}

/// Empty: nothing that the request names.
std::string RequestedSource::place_of(const std::string& pointer) const {
  const auto place = std::find_if(places_.begin(), places_.end(),
                                  [&](const auto& from_to) { return from_to.first == pointer; });
  return place == places_.end() ? "" : place->second;
}

/// Parts that have a member of their own, beside those that were detected.
Errors RequestedSource::add_named(ImportRequest& asked, ImportFiles& files) {
  ProblemList problems;
  const auto add = [&](auto given, auto& place, const std::string& path) {
    if (!given) return;
    const std::string detected = place_of(path == "/leaflets" ? "/leaflets/0" : path);
    if (!detected.empty())
      problems.add(ErrorCode::UnknownField, path,
                   "cannot be given, because file " +
                       std::to_string(std::stoi(detected.substr(detected.rfind('/') + 1)) + 1) +
                       " of the files is that part, too");
    place = *std::move(given);
    if (path != "/leaflets") places_.emplace_back(path, path);
  };
  Expected<std::optional<NamedFile>> labels = whole_labels(asked);
  if (!labels) return labels.errors();
  add(*std::move(labels), files.labels, "/labels");
  add(std::move(asked.annulus), files.annulus, "/annulus");
  add(std::move(asked.chordae), files.chordae, "/chordae");
  add(std::move(asked.tips), files.tips, "/tips");
  add(std::move(asked.landmarks_file), files.landmarks, "/landmarks");
  if (asked.leaflets) {
    add(std::move(asked.leaflets), files.leaflets, "/leaflets");
    files.posterior_from.reset();
    files.order = {};
    for (std::size_t i = 0; i < files.leaflets.size(); ++i) {
      const std::string path = "/leaflets/" + std::to_string(i);
      places_.emplace_back(path, path);
    }
  }
  return std::move(problems).take();
}

Expected<ImportSource> RequestedSource::read(ImportRequest asked) {
  if (asked.slicerheart) return read_folder(asked);
  ImportFiles files;
  std::vector<ImportDecision> decisions;
  if (asked.files) {
    Expected<SortedFiles> sorted = sorted_files(*std::move(asked.files));
    if (!sorted) return sorted.errors();
    for (const auto& [pointer, file] : sorted->places)
      places_.emplace_back(pointer, "/files/" + std::to_string(file));
    files = std::move(sorted->files);
    decisions = std::move(sorted->decisions);
  }
  if (Errors errors = add_named(asked, files); !errors.empty()) return errors;
  if (files.labels)
    whole_ = place_of("/labels");
  else if (files.leaflets.size() == 1)
    whole_ = place_of("/leaflets/0");
  if (asked.reading.labels.any() && whole_.empty())
    return Error{ErrorCode::UnknownField, "/label_numbers",
                 "requires a label map, or one file with several parts"};
  if (files.leaflets.empty() && !files.labels && !asked.reading.series)
    return Error{ErrorCode::MissingField, "/files",
                 "include neither meshes nor a label map of the leaflets"};
  Expected<ImportSource> source = read_import_files(files, asked.reading);
  if (!source) return as_requested(source.errors());
  source->decisions.insert(source->decisions.begin(), decisions.begin(), decisions.end());
  if (asked.reading.phase > 0 && !files.labels)
    source->decisions.push_back(
        {"options", "phase not used", "there is no label map of several phases", true});
  return source;
}

Errors RequestedSource::as_requested(Errors errors) const {
  for (Error& error : errors) {
    for (const std::string given : {"/annulus", "/tips"})
      if (error.path.starts_with(given + "_mm")) error.path.erase(given.size(), 3);
    if (error.path == "/tissue/thickness_mm") error.path = "/thickness_mm";
    if (error.path.starts_with("/landmarks/") && error.path.ends_with("_mm"))
      error.path.resize(error.path.size() - 3);
    if (error.path == "/series") error.path = "/grid";
    if (is_folder_) {
      if (error.path.starts_with("/landmarks")) continue;
      if (!error.path.empty()) error.message = error.path + ": " + error.message;
      error.path = "/slicerheart";
      continue;
    }
    const auto place = std::find_if(places_.begin(), places_.end(), [&](const auto& from_to) {
      return is_at(error.path, from_to.first);
    });
    if (place != places_.end()) {
      // Chordae and tips are numbered by their lists.
      const bool is_list = place->first == "/chordae" || place->first == "/tips";
      if (place->first != place->second)
        error.path = place->second + error.path.substr(is_list ? 0 : place->first.size());
    } else if (!whole_.empty() &&
               (is_at(error.path, "/leaflets") || is_at(error.path, "/annulus"))) {
      error.path = whole_;  // they are its parts
    }
  }
  return errors;
}

}  // namespace coapt
