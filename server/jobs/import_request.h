// The body of a request that asks for an import.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/metrics/shape_comparison.h"
#include "io/exchange/import_files.h"
#include "io/json/json_reader.h"
#include "search/fit/fit.h"
#include "server/limits.h"

namespace coapt {

/// "fit": a closed surface that the imported valve is fitted to.
struct FitRequest {
  std::optional<NamedFile> surface;  ///< none: the leaflets themselves, which were imaged closed
  MeasuredSide side = MeasuredSide::Atrial;
  std::optional<double> leak_mm2;
  double leak_sd_mm2 = MeasuredClosure{}.leak_sd_mm2;
  FitOptions options;
};

struct ImportRequest {
  std::optional<std::vector<NamedFile>> leaflets, slicerheart;
  std::optional<NamedFile> annulus, chordae, tips, labels,
      voxels;  ///< of labels that are a header alone
  ImportReading reading;
  GivenLandmarks landmarks;
  std::string name = "imported";
  std::vector<std::string> provenance;
  ImportOptions options;
  std::optional<FitRequest> fit;
};

NamedFile read_file(const JsonPlace& place);
LengthUnit read_unit(const JsonPlace& place);

/// All but "fit". `request` must outlive them.
std::vector<JsonField> import_fields(ImportRequest& request);
JsonField fit_field(ImportRequest& request);

/// What goes together and what does not, and whether the service takes a valve of so many triangles.
Errors check_import(const ImportRequest& request, const ServiceLimits& limits);

/// Pointers of errors are those of the request; Busy if the budget was cancelled. @pre check_import() is empty.
Expected<ImportedValve> make_import(const ImportRequest& request, const ClosureBudget& budget);

/// The measured surface of request.fit in the valve's frame. Errors: "/fit/surface". @pre request.fit
Expected<LeafletMesh> fit_surface(const ImportRequest& request, const ImportedValve& imported);

}  // namespace coapt
