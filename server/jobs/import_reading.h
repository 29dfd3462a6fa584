// All of an import that depends on what strangers' files hold, up to where a document is left: so that it can be done in a process
// apart (reader_processes.h).
#pragma once

#include <optional>
#include <string>

#include "core/closure/closure_options.h"
#include "operations/import_request.h"
#include "operations/surface_file.h"
#include "server/answer.h"
#include "server/limits.h"
#include "server/reader_processes.h"

namespace coapt {

/// What is asked of a body, and what a document has that answers it.
enum class ImportStep : char {
  Valve = 'v',       ///< what import_from() reads
  Submission = 's',  ///< of a body that may have "fit": the same and "fit", whether it has one
  Job =
      'j',  ///< of such a body that was taken: the same and "picture" (PNG in base64), for a fit "fit", as the body says it but
            ///< for its files, and "surface", what surface_from() reads
  Preview = 'p',  ///< {"files": what each holds}
  Form =
      'f',  ///< of a Content-Type, a line break and a form of that type: the same as JSON (form_body.h)
  Surface =
      'c'  ///< of a line of JSON with "name", "leaflet_array" and "displacement_array", and below it the file: what surface_from() reads
};

/// In this process. 200 with the document, or what is wrong with the body; none if it was cancelled.
std::optional<Answer> read_import(ImportStep step, std::string_view body,
                                  const ServiceLimits& limits, const ClosureBudget& budget);

/// The processes that do the same for a service.
std::unique_ptr<ReaderProcesses> import_processes(const ServiceLimits& limits);

struct ImportReader {
  const ServiceLimits& limits;
  const ReaderProcesses* apart =
      nullptr;  ///< null: who asks is trusted, and files are read in this process

  /// As read_import(), which a fault of a reader or more memory than limits.import_bytes ends with 422.
  /// @param seconds that it may compute, if apart
  std::optional<Answer> operator()(ImportStep step, std::string body, const ClosureBudget& budget,
                                   double seconds, int nice = 0) const;
};

/// Of such an answer. Errors: it cannot be read as JSON.
Expected<Json> answer_document(const Answer& answer);

/// With the valve, units, decisions, parts and thickness; of its input only whether it was closed. Whatever process the document
/// comes from, it is read as strictly as a client's.
Expected<ImportedValve> import_from(const Json& document);

/// What read_surface_file() reads, in the reader's process. Errors: its own, or why the process has none.
Expected<LeafletMesh> read_surface(const ImportReader& reader, const NamedFile& file,
                                   const ShapeFileOptions& options, const ClosureBudget& budget);

/// Errors: it is no mesh.
Expected<LeafletMesh> surface_from(const Json& document);

}  // namespace coapt
