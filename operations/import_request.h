// A request that asks for an import, and what is made of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/metrics/shape_comparison.h"
#include "io/exchange/import_files.h"
#include "io/json/json_reader.h"
#include "operations/context.h"
#include "operations/fit_request.h"

namespace coapt {

/// "fit": a closed surface that the imported valve is fitted to.
struct FitRequest {
  std::optional<NamedFile> surface;  ///< none: the leaflets themselves, which were imaged closed
  FitTarget target;
};

struct ImportRequest {
  std::optional<std::vector<NamedFile>>
      files;  ///< whose parts are detected; or a finite element model alone
  std::optional<std::vector<NamedFile>> leaflets, slicerheart;
  std::optional<NamedFile> annulus, chordae, tips, labels,
      voxels;  ///< of labels that are a header alone
  ImportReading reading;
  GivenLandmarks landmarks;
  std::optional<NamedFile> landmarks_file;
  std::vector<Observation> observed;
  std::string name = "imported";
  std::vector<std::string> provenance;
  ImportOptions options;
  int seed = 1;  ///< of chordae where files or a label map have none
  std::optional<FitRequest> fit;
};

LengthUnit read_unit(const JsonPlace& place);

/// All but "fit". `request` must outlive them.
std::vector<JsonField> import_fields(ImportRequest& request);
JsonField fit_field(ImportRequest& request);

/// What goes together and what does not, and whether the service takes a valve of so many triangles.
Errors check_import(const ImportRequest& request, const OperationLimits& limits);

/// Pointers of errors are those of the request; Busy if the budget was cancelled. @pre check_import() is empty.
Expected<ImportedValve> make_import(ImportRequest request, const ClosureBudget& budget);

/// The measured surface of request.fit in the valve's frame; of a file no more than surface_limits(). Errors: "/fit/surface".
/// @pre request.fit
Expected<LeafletMesh> fit_surface(const ImportRequest& request, const ImportedValve& imported,
                                  const OperationLimits& limits);

inline constexpr const char* kFittedSurface = "the closed surface";  // files have patients' names

/// What a fit has made of an imported valve.
struct FittedImport {
  Valve valve;
  ImportDecision decision;
  Json json;  ///< coapt.fit/1
};
/// @param imported_id of the valve before
FittedImport fitted_import(const ValveFit& fit, const MeasuredClosure& measured,
                           const std::string& imported_id);

/// coapt.import/2 with "valve" and "imported", their ids, "fit" (null without one) and "made", the valve.
Json import_answer(const ImportedValve& imported, const Valve& made, Json fit);

/// By which a valve is stored: of its document's bytes.
std::string valve_id(const Valve& valve);

}  // namespace coapt
