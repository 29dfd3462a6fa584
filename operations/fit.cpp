// Fits what images do not show of a valve to its closed state, as it was imaged. Answers coapt.fit/1 with the "fitted" valve.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/valve/patient_frame.h"
#include "io/json/fit_json.h"
#include "io/json/named_file.h"
#include "io/json/valve_json.h"
#include "io/picture/fit_picture.h"
#include "operations/fit_request.h"
#include "operations/given_shape.h"
#include "operations/repair_request.h"
#include "operations/table.h"

namespace coapt {
namespace {

constexpr Range kSeconds = {0.1, 1e6};

enum class SurfaceFrame { Patient, PatientIfKnown, Valve };

struct FitAsked {
  Valve valve{};
  std::string source{};  ///< of the valve, as the answer calls it
  GivenShape surface{};
  FitTarget target{};
  SurfaceFrame frame = SurfaceFrame::PatientIfKnown;
  bool map = false;
};

SurfaceFrame read_surface_frame(const JsonPlace& place) {
  return read_choice(place, {"patient", "valve"}).value_or(0) == 0 ? SurfaceFrame::Patient
                                                                   : SurfaceFrame::Valve;
}

Errors check_frame(const FitAsked& asked) {
  if (asked.frame != SurfaceFrame::Patient || asked.valve.patient) return {};
  return {Error{ErrorCode::MissingField, "/valve/patient_frame",
                "is missing in the valve: it was not made from images, or by an older version; "
                "use the frame valve if the surface is in the valve's own frame"}};
}

/// In the valve's frame.
LeafletMesh placed_surface(const FitAsked& asked) {
  LeafletMesh surface = asked.surface.mesh;
  if (asked.frame != SurfaceFrame::Valve && asked.valve.patient)
    surface.vertices_mm = from_patient(*asked.valve.patient, surface.vertices_mm);
  return surface;
}

Expected<OperationAnswer> fit(FitAsked& asked, Context& context) {
  if (Errors errors = read_files_of({{asked.surface, "/surface"}}, context); !errors.empty())
    return errors;
  const LeafletMesh surface = placed_surface(asked);
  const MeasuredClosure measured{surface.vertices_mm, asked.target.side, asked.target.leak_mm2,
                                 asked.target.leak_sd_mm2};
  const Expected<ValveFit> found =
      fit_valve(asked.valve, measured, within(asked.target.options, context));
  if (!found) return as_fit_fields(found.errors(), "", "/valve");
  if (context.abandoned && context.abandoned()) return context.refusal();
  Valve fitted = found->closed.valve;
  fitted.provenance.push_back(fit_sentence(*found, asked.surface.source));
  Json answer = fit_to_json(*found, {asked.source, asked.surface.source, measured});
  answer["fitted"] = Json::parse(write_valve(fitted));
  if (asked.map && surface.faces.rows() > 0)
    answer["map"] = to_json(NamedFile{
        "fit.png", fit_map_png(surface, *found, asked.target.side, asked.surface.source)});
  return OperationAnswer(std::move(answer));
}

}  // namespace

Expected<OperationTask> read_fit(const Json& request, const Context& context) {
  const auto asked = std::make_shared<FitAsked>();
  FitOptions& options = asked->target.options;
  const auto membrane = [](const JsonPlace& place) {
    return read_name(place, std::vector{Membrane::Continuum, Membrane::Springs});
  };
  const auto seconds = [](const JsonPlace& place) { return read_number_in(place, kSeconds, " s"); };
  const auto surface = [&](const JsonPlace& place) {
    read_given_shape(place, context, asked->surface, Triangles::Optional);
  };
  std::vector<JsonField> fields = fit_fields(asked->target);
  fields.insert(fields.begin(), {{"valve", valve_field(context, asked->valve, AcceptedValve::Any)},
                                 {"surface", surface},
                                 source_field(asked->source),
                                 {"frame", into(asked->frame, read_surface_frame), false},
                                 {"ruptured", into(options.ruptures, read_boolean), false},
                                 {"seconds", into(options.most_seconds, seconds), false},
                                 {"membrane", into(options.closure.membrane, membrane), false},
                                 {"map", into(asked->map, read_boolean), false}});
  ProblemList problems;
  read_fields({request, problems}, fields);
  if (!problems.empty()) return std::move(problems).take();
  if (asked->source.empty()) asked->source = asked->valve.name;
  if (Errors errors = check_frame(*asked); !errors.empty()) return errors;
  const Index vertices = asked->valve.rest_mm.rows();
  OperationTask task{vertices, std::numeric_limits<std::ptrdiff_t>::max(),
                     [asked](Context& within) { return fit(*asked, within); }};
  if (asked->surface.file)
    task.read_files = [asked, vertices](Context& within) -> Expected<Index> {
      if (Errors errors = read_files_of({{asked->surface, "/surface"}}, within); !errors.empty())
        return errors;
      return vertices;
    };
  return task;
}

}  // namespace coapt
