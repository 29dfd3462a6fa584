// How far a closed shape lies from a reference: each a valve, which is closed first, or a surface. Answers coapt.comparison/1.
#include <algorithm>
#include <utility>

#include "core/closed/closed_shape.h"
#include "core/closure/standing.h"
#include "core/metrics/coaptation.h"
#include "core/valve/patient_frame.h"
#include "io/json/comparison_json.h"
#include "operations/closing.h"
#include "operations/given_shape.h"
#include "operations/repair_request.h"
#include "operations/table.h"

namespace coapt {
namespace {

constexpr double kSamePlace_mm = 30.0;  // of the middles of two shapes in one patient
constexpr Range kContacts_mm = {0.001, 100.0};

struct Shape {
  GivenShape given{};
  std::optional<RepairRequest> valve{};  ///< to be closed; else `given` has the mesh
  std::optional<PatientFrame> patient{};
  bool in_own_axes = false;  ///< of a valve; a mesh lies where its file says
  std::string closure{}, doubt{};
};

struct CompareRequest {
  Shape closed{}, reference{};
  Alignment alignment = Alignment::Auto;
  Closing closing{};  ///< of those that are valves
  std::optional<double> contact_mm{};
  bool nodes = false;
};

/// A valve with or without a repair, or a surface.
std::function<void(const JsonPlace&)> shape_field(const Context& context, Shape& shape) {
  return [&context, &shape](const JsonPlace& place) {
    if (!place.value.is_object() || !place.value.contains("valve"))
      return read_given_shape(place, context, shape.given, Triangles::Required);
    RepairRequest asked;
    const Errors errors =
        read_repair(place.value, context, {source_field(shape.given.source)}, asked);
    if (!errors.empty()) return add_below(place.problems, pointer(place), errors);
    if (shape.given.source.empty()) shape.given.source = asked.valve.name;
    shape.given.thickness_mm = asked.repaired.tissue.thickness_mm;
    shape.patient = asked.repaired.patient;
    shape.in_own_axes = true;
    shape.valve = std::move(asked);
  };
}

Errors close_shape(Shape& shape, const Closing& closing, const char* path, Context& context) {
  if (!shape.valve) return {};
  Json finer;  // how: of no use here
  const Expected<ClosedValve> closed = close_as(shape.valve->repaired, closing, context, finer);
  if (!closed) return closed.errors();
  if (!closed->closure.closed_mm.allFinite())
    return {Error{ErrorCode::BadGeometry, path,
                  "diverged during closure; there is no closed shape to compare"}};
  shape.given.mesh = shape_of(*closed);
  shape.closure = closure_name(closed->closure);
  shape.doubt = doubt_about(closed->closure);
  return {};
}

Vec3 middle_mm(const Shape& shape) { return shape.given.mesh.vertices_mm.colwise().mean(); }

/// Valves that know where they lie in the patient go there, beside a mesh or another that knows it. @return whether one did
bool place_in_patient(Shape& closed, Shape& reference) {
  const bool both = closed.in_own_axes && reference.in_own_axes;
  if (both && (!(closed.patient && reference.patient) || closed.patient == reference.patient))
    return false;
  bool placed = false;
  for (Shape* shape : {&closed, &reference}) {
    if (!shape->patient) continue;
    shape->given.mesh.vertices_mm = to_patient(*shape->patient, shape->given.mesh.vertices_mm);
    placed = true;
  }
  return placed;
}

/// Shapes that their frames lay on each other stay there: a rigid motion would hide how far they are apart.
Alignment alignment_of(Alignment asked, bool placed, const Shape& closed, const Shape& reference) {
  const bool stays = asked == Alignment::Auto && placed &&
                     (middle_mm(closed) - middle_mm(reference)).norm() < kSamePlace_mm;
  return stays ? Alignment::None : asked;
}

Errors read_files(CompareRequest& asked, const Context& context) {
  return read_files_of({{asked.closed.given, "/closed"}, {asked.reference.given, "/reference"}},
                       context);
}

Expected<OperationAnswer> compare(CompareRequest& asked, Context& context) {
  if (Errors errors = read_files(asked, context); !errors.empty()) return errors;
  Shape closed = asked.closed, reference = asked.reference;
  for (auto& [shape, path] : {std::pair(&closed, "/closed"), {&reference, "/reference"}})
    if (Errors errors = close_shape(*shape, asked.closing, path, context); !errors.empty())
      return errors;
  const bool placed = place_in_patient(closed, reference);
  const double contact_mm = asked.contact_mm.value_or(
      kContactThicknesses *
      closed.given.thickness_mm.value_or(reference.given.thickness_mm.value_or(1.0)));
  const auto cancelled = [&context] { return context.cancelled(); };
  const auto compared = [&](const Shape& shape) {
    return ComparedShape{shape.given.source, shape.given.mesh,
                         nodes_in_contact(shape.given.mesh, contact_mm, cancelled), shape.closure,
                         shape.doubt};
  };
  const ComparedShape ours = compared(closed), theirs = compared(reference);
  if (context.cancelled()) return context.refusal();
  const ShapeComparison comparison = compare_shapes(
      ours.mesh, theirs.mesh, alignment_of(asked.alignment, placed, closed, reference), cancelled);
  if (context.cancelled()) return context.refusal();
  Json answer = comparison_to_json(comparison, ours, theirs, contact_mm);
  if (asked.nodes) answer["nodes"] = compared_nodes_json(comparison, ours);
  return OperationAnswer(std::move(answer));
}

Index size_of(const Shape& shape) {
  return shape.valve ? shape.valve->repaired.rest_mm.rows() : size_of(shape.given.mesh);
}

Index size_of(const CompareRequest& asked) {
  return std::max(size_of(asked.closed), size_of(asked.reference));
}

/// How valves are closed, where there is one.
void check_closing(const CompareRequest& asked, const Json& request, ProblemList& problems) {
  add_contradictions(asked.closing, problems);
  if (asked.closed.valve || asked.reference.valve) return;
  for (const char* name : {"method", "accuracy_mm2", "converge", "certainty"})
    if (request.contains(name))
      problems.add(ErrorCode::Unsupported, "/" + std::string(name),
                   "is about closing a valve; both shapes are surfaces");
}

}  // namespace

Expected<OperationTask> read_compare(const Json& request, const Context& context) {
  const auto asked = std::make_shared<CompareRequest>();
  const auto alignment = [](const JsonPlace& place) {
    return read_name(place, std::vector{Alignment::Auto, Alignment::None, Alignment::Rigid});
  };
  const auto contact = [](const JsonPlace& place) {
    return read_number_in(place, kContacts_mm, " mm");
  };
  ProblemList problems;
  std::vector<JsonField> fields = {{"closed", shape_field(context, asked->closed)},
                                   {"reference", shape_field(context, asked->reference)},
                                   {"align", into(asked->alignment, alignment), false},
                                   {"contact_mm", into(asked->contact_mm, contact), false},
                                   {"nodes", into(asked->nodes, read_boolean), false}};
  for (JsonField& field : closing_fields(asked->closing)) fields.push_back(std::move(field));
  read_fields({request, problems}, fields);
  if (problems.empty()) check_closing(*asked, request, problems);
  if (!problems.empty()) return std::move(problems).take();
  asked->closing = settled(asked->closing, true);
  OperationTask task{size_of(*asked), 2 * closures_of(asked->closing),
                     [asked](Context& within) { return compare(*asked, within); }};
  if (asked->closed.given.file || asked->reference.given.file)
    task.read_files = [asked](Context& within) -> Expected<Index> {
      if (Errors errors = read_files(*asked, within); !errors.empty()) return errors;
      return size_of(*asked);
    };
  return task;
}

}  // namespace coapt
