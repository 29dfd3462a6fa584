// What the files of a request hold, as one source.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "operations/import_request.h"

namespace coapt {

/// A finite element model of a valve that need not be mitral, if that is what `files` are. Errors: "/files/I".
Expected<std::optional<NamedFile>> model_among(const std::vector<NamedFile>& files);

class RequestedSource {
 public:
  /// Pointers of errors are the request's.
  Expected<ImportSource> read(ImportRequest asked);

  /// Those of an import of that source, by what the request calls its parts and files.
  Errors as_requested(Errors errors) const;

 private:
  Expected<ImportSource> read_folder(const std::vector<NamedFile>& folder, const char* member,
                                     const ImportRequest& asked);

  std::string folder_;  ///< "/slicerheart" or "/files"; empty: none
  std::vector<std::pair<std::string, std::string>>
      places_;  ///< a pointer into ImportFiles, that of the request
};

}  // namespace coapt
