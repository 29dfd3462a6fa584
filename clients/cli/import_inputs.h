// The files that `coapt valve import` is given, by options or bare, as one source.
#pragma once

#include <string>
#include <vector>

#include "operations/import_request.h"

namespace coapt {

struct ImportInputs {
  std::vector<std::string>
      bare;  ///< files whose part is guessed, a folder of such, of SlicerHeart, or of a DICOM series
  std::vector<std::string> leaflets;
  std::string annulus, chordae, tips, landmarks, labels, slicerheart, series, abaqus;
  std::vector<std::string> label_numbers;  ///< "anterior=1"
  std::optional<PatientAxes> axes;
  int phase = 0;  ///< of a label map of several, from 1; 0: the first that has labels
};

/// Where a part came from, for messages: a pointer into the request and the path of the file.
using ImportPlaces = std::vector<std::pair<std::string, std::string>>;

struct ReadInputs {
  int failed = 0;  ///< an exit code; what is wrong was said on standard error
  ImportRequest request;
  ImportPlaces places;
  std::vector<ImportDecision> decisions;  ///< on what of folders is used
};

/// The files of a folder but hidden ones, in the order of their names. Errors have no path.
Expected<std::vector<std::string>> files_of(const std::string& folder);

/// Of these what may be a part of a valve, by name, and how many are not.
struct FolderFiles {
  std::vector<std::string> paths;
  std::vector<ImportDecision> decisions;
};
FolderFiles importable(const std::vector<std::string>& paths);

/// The files at these paths and, as further ones, those that they name. Errors: at the path of the file.
Expected<std::vector<NamedFile>> read_with_companions(std::vector<std::string>& paths);

/// A file of those, a DICOM segmentation as the label map that it holds. @param is_map whatever its name: as large as maps may be,
/// where other files may have kMostInputBytes. Errors have no path.
Expected<NamedFile> read_import_file(const std::string& path, bool is_map = false);

/// @param draws_chordae chordae are to be drawn. Problems are said with the file's own path.
ReadInputs read_import_inputs(ImportInputs inputs, bool draws_chordae);

/// Prints errors of an import made of such inputs by the file that each is of; returns kBadInput.
int report_import_errors(const Errors& errors, const ImportPlaces& places);

}  // namespace coapt
