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

/// Parts that have a member of their own, beside those that were sorted.
Errors add_named(ImportRequest& asked, ImportFiles& files) {
  ProblemList problems;
  const auto add = [&](auto given, auto& place, bool is_there, const char* path) {
    if (!given) return;
    if (is_there) problems.add(ErrorCode::UnknownField, path, "is also among the files");
    place = *std::move(given);
  };
  Expected<std::optional<NamedFile>> labels = whole_labels(asked);
  if (!labels) return labels.errors();
  add(*std::move(labels), files.labels, files.labels.has_value(), "/labels");
  add(std::move(asked.annulus), files.annulus, files.annulus.has_value(), "/annulus");
  add(std::move(asked.chordae), files.chordae, files.chordae.has_value(), "/chordae");
  add(std::move(asked.tips), files.tips, files.tips.has_value(), "/tips");
  add(std::move(asked.landmarks_file), files.landmarks, files.landmarks.has_value(), "/landmarks");
  if (asked.leaflets) {
    add(std::move(asked.leaflets), files.leaflets, !files.leaflets.empty(), "/leaflets");
    files.posterior_from.reset();
    files.order = {};
  }
  return std::move(problems).take();
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

Expected<ImportSource> RequestedSource::read_folder(const std::vector<NamedFile>& folder,
                                                    const char* member,
                                                    const ImportRequest& asked) {
  folder_ = member;
  Expected<ImportSource> source = read_slicerheart(folder);
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

Expected<ImportSource> RequestedSource::read(ImportRequest asked) {
  if (asked.slicerheart) return read_folder(*asked.slicerheart, "/slicerheart", asked);
  ImportFiles files;
  std::vector<ImportDecision> decisions;
  if (asked.files) {
    std::vector<std::string> names;
    for (const NamedFile& file : *asked.files) names.push_back(file.name);
    if (is_slicerheart_folder(names)) return read_folder(*asked.files, "/files", asked);
    Expected<SortedFiles> sorted = sorted_files(*std::move(asked.files));
    if (!sorted) return sorted.errors();
    for (const auto& [pointer, file] : sorted->places)
      places_.emplace_back(pointer, "/files/" + std::to_string(file));
    files = std::move(sorted->files);
    decisions = std::move(sorted->decisions);
  }
  if (Errors errors = add_named(asked, files); !errors.empty()) return errors;
  const LabelNumbers& numbers = asked.reading.labels;
  const bool numbered =
      !numbers.anterior.empty() || !numbers.posterior.empty() || !numbers.annulus.empty();
  if (numbered && !files.labels && files.leaflets.size() != 1)
    return Error{ErrorCode::UnknownField, "/label_numbers",
                 "requires a label map, or one file with several parts"};
  if (files.leaflets.empty() && !files.labels && !asked.reading.series)
    return Error{ErrorCode::MissingField, "/leaflets",
                 "is missing: none of the files has the leaflets (meshes or a label map)"};
  Expected<ImportSource> source = read_import_files(files, asked.reading);
  if (!source) return as_requested(source.errors());
  source->decisions.insert(source->decisions.begin(), decisions.begin(), decisions.end());
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
    if (!folder_.empty()) {
      if (error.path.starts_with("/landmarks")) continue;
      if (!error.path.empty()) error.message = error.path + ": " + error.message;
      error.path = folder_;
      continue;
    }
    const auto place = std::find_if(places_.begin(), places_.end(), [&](const auto& from_to) {
      return is_at(error.path, from_to.first);
    });
    if (place != places_.end()) {
      // Chordae and tips are numbered by their lists.
      const bool is_list = place->first == "/chordae" || place->first == "/tips";
      error.path = place->second + error.path.substr(is_list ? 0 : place->first.size());
    } else if (places_.size() == 1 &&
               (is_at(error.path, "/leaflets") || is_at(error.path, "/annulus"))) {
      error.path = places_[0].second;  // leaflets and annulus of one file are its parts
    }
  }
  return errors;
}

}  // namespace coapt
