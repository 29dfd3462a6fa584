// What the files of a request hold, as one source.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "operations/import_request.h"

namespace coapt {

/// A finite element model of a valve that need not be mitral, if that is what `files` are. Errors: "/files/I", beside others.
Expected<std::optional<NamedFile>> model_among(const std::vector<NamedFile>& files);

class RequestedSource {
 public:
  /// Pointers of errors are the request's.
  Expected<ImportSource> read(ImportRequest asked);

  /// Those of an import of that source, by what the request calls its parts and files.
  Errors as_requested(Errors errors) const;

 private:
  Expected<ImportSource> read_folder(const ImportRequest& asked);
  Errors add_named(ImportRequest& asked, ImportFiles& files);
  std::string place_of(const std::string& pointer) const;

  bool is_folder_ = false;  ///< of SlicerHeart
  std::vector<std::pair<std::string, std::string>>
      places_;         ///< a pointer into ImportFiles, that of the request
  std::string whole_;  ///< of the one file that holds both leaflets; empty: none
};

}  // namespace coapt
