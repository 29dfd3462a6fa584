#include "server/jobs/import_reading.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "io/exchange/decisions_json.h"
#include "io/exchange/file_preview.h"
#include "io/json/base64.h"
#include "io/json/parse_json.h"
#include "io/json/result_json.h"
#include "io/json/valve_json.h"
#include "io/picture/import_picture.h"
#include "operations/given_shape.h"
#include "server/form_body.h"
#include "server/json_body.h"
#include "server/turns.h"

namespace coapt {
namespace {

constexpr std::size_t kMostFiles = 100;                // that are looked at in one request
constexpr std::size_t kMostShown = 1'000'000;          // of their points and triangles
constexpr Eigen::Index kMostNumbers = 3 * kMostShown;  // 25 MB of answer

/// Numbers one after the other, to a millionth: what is looked at needs no more.
template <class Rows>
Json flat(const Rows& rows) {
  Json list = Json::array();
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    for (Eigen::Index k = 0; k < rows.cols(); ++k)
      if constexpr (std::is_floating_point_v<typename Rows::Scalar>)
        list.push_back(std::round(1e6 * rows(i, k)) * 1e-6);
      else
        list.push_back(rows(i, k));
  return list;
}

/// Takes what it shows off the numbers that are `left`; without them it is named alone.
Json preview_json(const NamedFile& file, Eigen::Index& left) {
  FilePreview preview = preview_file(file, {kMostShown, kMostShown});
  if (const Eigen::Index numbers = preview.points.size() + preview.faces.size(); numbers > left)
    preview = {preview.content,
               {},
               {},
               {},
               {Error{ErrorCode::OutOfRange, "",
                      "cannot be previewed: it has " + std::to_string(preview.points.rows()) +
                          " points and " + std::to_string(preview.faces.rows()) +
                          " triangles, and the files of one request may have 1,000,000 in total"}},
               std::move(preview.parts)};
  left -= preview.points.size() + preview.faces.size();
  return {{"name", file.name},
          {"content", to_string(preview.content)},
          {"points", flat(preview.points)},
          {"faces", flat(preview.faces)},
          {"labels", preview.labels},
          {"parts", to_json(preview.parts)},
          {"problems", to_json(preview.problems)}};
}

std::vector<NamedFile> read_files(const JsonPlace& place) {
  std::vector<NamedFile> list = read_list(place, read_file);
  if (list.size() > kMostFiles)
    add_problem(place, ErrorCode::OutOfRange,
                "has " + std::to_string(list.size()) + " files, must have at most " +
                    std::to_string(kMostFiles));
  return list;
}

std::optional<Answer> previews(const Json& body, const ClosureBudget& budget) {
  std::vector<NamedFile> files;
  ProblemList problems;
  read_fields({body, problems}, {{"files", into(files, read_files)}});
  if (!problems.empty()) return problem(422, std::move(problems).take());
  Json list = Json::array();
  Eigen::Index left = kMostNumbers;
  for (const NamedFile& file : files) {
    if (budget.is_cancelled()) return std::nullopt;
    list.push_back(preview_json(file, left));
  }
  return json_answer(200, {{"files", std::move(list)}});
}

/// To the last bit, as what is fitted must be.
template <class Rows>
Json all_of(const Rows& rows) {
  return std::vector<typename Rows::Scalar>(rows.data(), rows.data() + rows.size());
}

/// What surface_from() reads.
Json surface_document(const LeafletMesh& surface) {
  return {{"vertices_mm", all_of(surface.vertices_mm)},
          {"faces", all_of(surface.faces)},
          {"names", surface.names},
          {"leaflets", surface.leaflets}};
}

/// The first line of a question, and what stands below it.
std::pair<std::string_view, std::string_view> first_line(std::string_view question) {
  const std::size_t end = std::min(question.find('\n'), question.size());
  return {question.substr(0, end), question.substr(std::min(end + 1, question.size()))};
}

Answer surface_answer(std::string_view question, const OperationLimits& limits) {
  const auto [line, bytes] = first_line(question);
  const Expected<Json> head = parse_json(line);
  if (!head) return problem(400, head.errors());
  NamedFile file{"", std::string(bytes)};
  ShapeFileOptions options{.limits = surface_limits(limits)};
  ProblemList problems;
  read_fields({*head, problems}, {{"name", into(file.name, read_string)},
                                  {"leaflet_array", into(options.leaflets, read_string)},
                                  {"displacement_array", into(options.displacement, read_string)}});
  if (!problems.empty()) return problem(422, std::move(problems).take());
  const Expected<LeafletMesh> surface = read_surface_file(file, options);
  if (!surface) return problem(422, surface.errors());
  if (const Errors errors = check_surface(*surface, limits); !errors.empty())
    return problem(422, errors);
  return {200, surface_document(*surface)};
}

/// What import_from() reads.
Json import_document(const ImportedValve& made) {
  return {{"valve", write_valve(made.valve)},     {"unit", to_string(made.unit)},
          {"closed", made.input.closed},          {"labels", to_json(made.parts)},
          {"thickness", to_json(made.thickness)}, {"decisions", to_json(made.decisions)}};
}

/// With what a job shows, and what its fit needs.
Json job_document(const Json& body, const ImportedValve& made, const LeafletMesh* surface) {
  Json document = import_document(made);
  document["picture"] = encoded_base64(import_picture_png(made, made.valve.name));
  if (!surface) return document;
  document["fit"] = body["fit"];
  document["fit"].erase("surface");
  document["surface"] = surface_document(*surface);
  return document;
}

ImportDecision read_decision(const JsonPlace& place) {
  ImportDecision decision;
  read_fields(place, {{"subject", into(decision.subject, read_string)},
                      {"value", into(decision.value, read_string)},
                      {"reason", into(decision.reason, read_string)},
                      {"look", into(decision.look, read_boolean)},
                      {"confidence", into(decision.confidence, read_number)}});
  return decision;
}

SourcePart read_part(const JsonPlace& place) {
  SourcePart part;
  const auto read_use = [](const JsonPlace& use) {
    return use.value.is_null() ? "" : read_string(use);
  };
  read_fields(place,
              {{"number", into(part.number, read_integer)}, {"part", into(part.part, read_use)}});
  return part;
}

MeasuredThickness read_thickness(const JsonPlace& place) {
  MeasuredThickness thickness;
  const auto read_leaflet = [](const JsonPlace& leaflet) {
    return static_cast<std::size_t>(read_integer_in(leaflet, 0, 1));
  };
  read_fields(place, {{"leaflet", into(thickness.leaflet, read_leaflet)},
                      {"mean_mm", into(thickness.mean_mm, read_number)},
                      {"p10_mm", into(thickness.p10_mm, read_number)},
                      {"p90_mm", into(thickness.p90_mm, read_number)}});
  return thickness;
}

template <class Read>
auto list_of(Read read) {
  return [read](const JsonPlace& place) { return read_list(place, read); };
}

std::optional<Answer> valve_of(ImportStep step, const Json& body, const ServiceLimits& limits,
                               const ClosureBudget& budget) {
  ImportRequest asked;
  std::vector<JsonField> fields = import_fields(asked);
  if (step != ImportStep::Valve) fields.push_back(fit_field(asked));
  ProblemList problems;
  read_fields({body, problems}, fields);
  if (!problems.empty()) return problem(422, std::move(problems).take());
  const bool was_taken = step == ImportStep::Job;
  if (!was_taken)
    if (const Errors errors = check_import(asked, operation_limits(limits)); !errors.empty())
      return problem(422, errors);
  const Expected<ImportedValve> made = make_import(asked, budget);
  if (!made && budget.is_cancelled()) return std::nullopt;
  if (!made) return problem(422, made.errors());
  if (!is_mitral(made->valve))
    return problem(422, {Error{ErrorCode::Unsupported, "/files/0",
                               "is a finite element model, and this service stores only mitral "
                               "valves; import it with coapt valve import, whose result can be "
                               "closed by POST /v1/closures"}});
  if (!was_taken)
    if (const Errors errors = check_size(made->valve, operation_limits(limits)); !errors.empty())
      return problem(422, errors);
  Expected<LeafletMesh> surface = LeafletMesh{};
  if (asked.fit)
    surface = fit_surface(asked, *made,
                          was_taken ? OperationLimits::unlimited() : operation_limits(limits));
  if (!surface) return problem(422, surface.errors());
  if (was_taken) return Answer{200, job_document(body, *made, asked.fit ? &*surface : nullptr)};
  Json document = import_document(*made);
  document["fit"] = asked.fit.has_value();
  return Answer{200, std::move(document)};
}

}  // namespace

std::optional<Answer> read_import(ImportStep step, std::string_view body,
                                  const ServiceLimits& limits, const ClosureBudget& budget) {
  if (step == ImportStep::Form) {
    const auto [type, parts] = first_line(body);
    Expected<std::string> form = json_of_form(parts, type);
    if (!form) return problem(400, form.errors());
    return Answer{200, Content{"application/json", *std::move(form)}};
  }
  if (step == ImportStep::Surface) return surface_answer(body, operation_limits(limits));
  const Expected<Json> json = parse_json(body, most_values(limits));
  if (!json) return problem(400, json.errors());
  return step == ImportStep::Preview ? previews(*json, budget)
                                     : valve_of(step, *json, limits, budget);
}

std::unique_ptr<ReaderProcesses> import_processes(const ServiceLimits& limits) {
  // A question is the step's letter and the body, an answer the three digits of its status and the document.
  return std::make_unique<ReaderProcesses>(
      [limits](std::string_view question) {
        const auto step = static_cast<ImportStep>(question.front());
        ClosureBudget budget;
        if (step != ImportStep::Job) budget.vertex_steps = limits.vertex_steps;
        const Answer answer = *read_import(step, question.substr(1), limits, budget);
        return std::to_string(answer.status) + content_bytes(answer);
      },
      limits.import_bytes, load_import_fonts);
}

std::optional<Answer> ImportReader::operator()(ImportStep step, std::string body,
                                               const ClosureBudget& budget, double seconds,
                                               int nice) const {
  if (apart == nullptr) return read_import(step, body, limits, budget);
  const ReaderProcesses::Order order{static_cast<int>(std::clamp(std::ceil(seconds), 1.0, 1e6)),
                                     nice};
  body.insert(body.begin(), static_cast<char>(step));
  const ReaderProcesses::Result result = apart->ask(body, order, budget.cancelled);
  constexpr std::size_t kDigits = 3;
  switch (result.end) {
    case ReaderProcesses::End::Cancelled:
      return std::nullopt;
    case ReaderProcesses::End::OutOfMemory:
      return problem(422, ErrorCode::OutOfRange,
                     "the files take more than " + std::to_string(limits.import_bytes >> 20) +
                         " MiB to read, the limit of this service; send fewer or coarser files, or "
                         "import them offline (coapt valve import)");
    case ReaderProcesses::End::OutOfTime:
      return problem(422, ErrorCode::OutOfRange,
                     "the files take more than " + std::to_string(order.cpu_seconds) +
                         " s to read, the limit of this service; send fewer or coarser files, or "
                         "import them offline (coapt valve import)");
    case ReaderProcesses::End::Answered:
      if (result.answer.size() > kDigits) {
        const int status = result.answer.starts_with("200")   ? 200
                           : result.answer.starts_with("400") ? 400
                                                              : 422;
        return Answer{status,
                      Content{status < 400 ? "application/json" : "application/problem+json",
                              result.answer.substr(kDigits)}};
      }
      [[fallthrough]];
    case ReaderProcesses::End::Died:
      break;
  }
  return problem(422, ErrorCode::InputOutput,
                 "the files could not be read, because the reading process crashed. Import them "
                 "offline (coapt valve import), and please report a bug if that also fails");
}

Expected<Json> answer_document(const Answer& answer) {
  if (const auto* json = std::get_if<Json>(&answer.body)) return *json;
  Expected<Json> json = parse_json(std::get<Content>(answer.body).bytes);
  if (json) return json;
  return Error{ErrorCode::InputOutput, "",
               "could not be read, because the answer of the reading process is not accepted: " +
                   json.errors().front().message};
}

Expected<ImportedValve> import_from(const Json& document) {
  ImportedValve made;
  std::string valve;
  ProblemList problems;
  const auto skipped = [](const JsonPlace& /*place*/) {};
  read_fields({document, problems}, {{"valve", into(valve, read_string)},
                                     {"unit", into(made.unit, read_unit)},
                                     {"closed", into(made.input.closed, read_boolean)},
                                     {"labels", into(made.parts, list_of(read_part))},
                                     {"thickness", into(made.thickness, list_of(read_thickness))},
                                     {"decisions", into(made.decisions, list_of(read_decision))},
                                     {"picture", skipped, false},
                                     {"fit", skipped, false},
                                     {"surface", skipped, false}});
  if (!problems.empty()) return std::move(problems).take();
  Expected<Valve> read = read_valve(valve);
  if (!read) return read.errors();
  made.valve = *std::move(read);
  return made;
}

Expected<LeafletMesh> read_surface(const ImportReader& reader, const NamedFile& file,
                                   const ShapeFileOptions& options, const ClosureBudget& budget) {
  if (reader.apart == nullptr) return read_surface_file(file, options);
  const Json head = {{"name", file.name},
                     {"leaflet_array", options.leaflets},
                     {"displacement_array", options.displacement}};
  const std::optional<Answer> answer =
      reader(ImportStep::Surface, json_text(head) + '\n' + file.bytes, budget,
             reader.limits.request_seconds + 1.0);
  if (!answer) return Error{ErrorCode::Busy, "", "took too long to read"};
  const Expected<Json> document = answer_document(*answer);
  if (!document) return document.errors();
  if (answer->status == 200) return surface_from(*document);
  return errors_from_json(document->value("problems", Json::array()));
}

Expected<LeafletMesh> surface_from(const Json& document) {
  ProblemList problems;
  std::vector<double> places;
  std::vector<int> corners;
  LeafletMesh surface;
  read_fields({document, problems}, {{"vertices_mm", into(places, list_of(read_number))},
                                     {"faces", into(corners, list_of(read_integer))},
                                     {"names", into(surface.names, list_of(read_string))},
                                     {"leaflets", into(surface.leaflets, list_of(read_integer))}});
  const auto vertices = static_cast<int>(places.size() / 3);
  if (places.size() % 3 != 0 || corners.size() % 3 != 0 ||
      std::any_of(corners.begin(), corners.end(),
                  [&](int corner) { return corner < 0 || corner >= vertices; }))
    problems.add(ErrorCode::BadTopology, "", "is not a mesh");
  if (!problems.empty()) return std::move(problems).take();
  surface.vertices_mm = Eigen::Map<const Points>(places.data(), vertices, 3);
  surface.faces =
      Eigen::Map<const Faces>(corners.data(), static_cast<Index>(corners.size() / 3), 3);
  return surface;
}

}  // namespace coapt
