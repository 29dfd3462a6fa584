// Makes a valve from the files of a segmentation tool, and fits it to its closed leaflets. Answers coapt.import/2.
#include <algorithm>
#include <utility>

#include "operations/import_request.h"
#include "operations/table.h"

namespace coapt {
namespace {

/// The valve fitted to the surface that the request has.
Expected<FittedImport> fit_of(const ImportRequest& asked, const ImportedValve& imported,
                              Context& context) {
  const Expected<LeafletMesh> surface = fit_surface(asked, imported, context.limits);
  if (!surface) return surface.errors();
  const FitTarget& target = asked.fit->target;
  const MeasuredClosure measured{surface->vertices_mm, target.side, target.leak_mm2,
                                 target.leak_sd_mm2};
  const Expected<ValveFit> fit =
      fit_valve(imported.valve, measured, within(target.options, context));
  if (!fit) return as_fit_fields(fit.errors(), "/fit", "/fit");
  return fitted_import(*fit, measured, valve_id(imported.valve));
}

Expected<OperationAnswer> made_valve(const ImportRequest& asked, Context& context) {
  Expected<ImportedValve> imported = make_import(asked, context.budget());
  if (!imported) return imported.errors();
  if (Errors errors = check_size(imported->valve, context.limits); !errors.empty()) return errors;
  if (!asked.fit) return OperationAnswer(import_answer(*imported, imported->valve, nullptr));
  Expected<FittedImport> fitted = fit_of(asked, *imported, context);
  if (!fitted) return fitted.errors();
  if (context.abandoned && context.abandoned()) return context.refusal();
  imported->decisions.push_back(std::move(fitted->decision));
  return OperationAnswer(import_answer(*imported, fitted->valve, std::move(fitted->json)));
}

}  // namespace

Expected<OperationTask> read_import(const Json& request, const Context& context) {
  const auto asked = std::make_shared<ImportRequest>();
  std::vector<JsonField> fields = import_fields(*asked);
  fields.push_back(fit_field(*asked));
  ProblemList problems;
  read_fields({request, problems}, fields);
  if (!problems.empty()) return std::move(problems).take();
  if (Errors errors = check_import(*asked, context.limits); !errors.empty()) return errors;
  return OperationTask{0, std::numeric_limits<std::ptrdiff_t>::max(),
                       [asked](Context& within) { return made_valve(*asked, within); }};
}

}  // namespace coapt
