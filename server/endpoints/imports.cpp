#include "server/endpoints/imports.h"

#include "io/exchange/decisions_json.h"
#include "io/exchange/file_preview.h"
#include "server/answers.h"
#include "server/content_id.h"
#include "server/endpoints/valves.h"
#include "server/jobs/import_request.h"
#include "server/request_closures.h"

namespace coapt {
namespace {

constexpr std::size_t kMostFiles = 100;           // that are looked at in one request
constexpr Eigen::Index kMostNumbers = 3'000'000;  // of their points and faces: 25 MB of answer

/// As a closure, it ends when its client has gone or its time is over. Errors: make_import()'s, and a valve that is too large.
Expected<ImportedValve> make_checked(const ImportRequest& asked, const ServiceLimits& limits,
                                     RequestClosures& closures) {
  Expected<ImportedValve> done = make_import(asked, closures.budget());
  if (!done && closures.cancelled()) throw RequestClosures::Unfinished{};
  if (!done) return done;
  if (Errors errors = check_size(done->valve, limits); !errors.empty()) return errors;
  return done;
}

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
  FilePreview preview = preview_file(file);
  if (const Eigen::Index numbers = preview.points.size() + preview.faces.size(); numbers > left)
    preview = {preview.content,
               {},
               {},
               {},
               {Error{ErrorCode::OutOfRange, "",
                      "is not shown: it has " + std::to_string(preview.points.rows()) +
                          " points and " + std::to_string(preview.faces.rows()) +
                          " triangles, and the files of one request may have 1000000 together"}},
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

}  // namespace

Answer ImportValve::operator()(const Request& request) const {
  ImportRequest asked;
  if (auto refused = read_body(valves, request.body, import_fields(asked)))
    return *std::move(refused);
  if (const Errors errors = check_import(asked, valves.limits); !errors.empty())
    return problem(422, errors);
  return answer_in_turn(
      compute, valves.limits, request, TurnCost::Long, [&](RequestClosures& closures) {
        const Expected<ImportedValve> made = make_checked(asked, valves.limits, closures);
        if (!made) return problem(422, made.errors());
        return store_valve(store, valves.limits, made->valve,
                           {{"decisions", to_json(made->decisions)}});
      });
}

Answer PostImports::operator()(const Request& request) const {
  ImportRequest asked;
  std::vector<JsonField> fields = import_fields(asked);
  fields.push_back(fit_field(asked));
  if (auto refused = read_body(submitting.valves, request.body, fields)) return *std::move(refused);
  const ServiceLimits& limits = submitting.valves.limits;
  if (const Errors errors = check_import(asked, limits); !errors.empty())
    return problem(422, errors);
  std::optional<Valve> valve;
  const Answer refusal = answer_in_turn(
      compute, limits, request, TurnCost::Long, [&](RequestClosures& closures) -> Answer {
        Expected<ImportedValve> made = make_checked(asked, limits, closures);
        if (!made) return problem(422, made.errors());
        if (asked.fit)
          if (const auto surface = fit_surface(asked, *made); !surface)
            return problem(422, surface.errors());
        valve = std::move(made->valve);
        return {};
      });
  if (!valve) return refusal;
  return submit(submitting, request,
                {"import",
                 *valve,
                 {{"files", content_id(request.body)}, {"fit", asked.fit.has_value()}},
                 request.body});
}

Answer PreviewImport::operator()(const Request& request) const {
  std::vector<NamedFile> files;
  const auto read = [](const JsonPlace& place) {
    std::vector<NamedFile> list = read_list(place, read_file);
    if (list.size() > kMostFiles)
      add_problem(place, ErrorCode::OutOfRange,
                  "has " + std::to_string(list.size()) + " files, must have at most " +
                      std::to_string(kMostFiles));
    return list;
  };
  if (auto refused = read_body(valves, request.body, {{"files", into(files, read)}}))
    return *std::move(refused);
  return answer_in_turn(compute, valves.limits, request, TurnCost::Long,
                        [&](RequestClosures& closures) {
                          Json list = Json::array();
                          Eigen::Index left = kMostNumbers;
                          for (const NamedFile& file : files) {
                            if (closures.cancelled()) throw RequestClosures::Unfinished{};
                            list.push_back(preview_json(file, left));
                          }
                          return json_answer(200, {{"files", std::move(list)}});
                        });
}

}  // namespace coapt
