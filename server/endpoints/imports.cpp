#include "server/endpoints/imports.h"

#include "io/exchange/decisions_json.h"
#include "io/exchange/file_preview.h"
#include "server/answers.h"
#include "server/content_id.h"
#include "server/endpoints/valves.h"
#include "server/jobs/import_request.h"

namespace coapt {
namespace {

/// What has come of the files, or why nothing.
struct Made {
  std::optional<ImportedValve> imported = {};
  std::optional<Answer> refusal = {};
};

Made make_checked(const ImportRequest& asked, const ValveSource& valves) {
  Expected<ImportedValve> done = make_import(asked);
  if (!done) return {{}, problem(422, done.errors())};
  if (const Errors errors = check_size(done->valve, valves.limits); !errors.empty())
    return {{}, problem(422, errors)};
  return {*std::move(done)};
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

Json preview_json(const NamedFile& file) {
  const FilePreview preview = preview_file(file);
  return {{"name", file.name},
          {"content", to_string(preview.content)},
          {"points", flat(preview.points)},
          {"faces", flat(preview.faces)},
          {"labels", preview.labels},
          {"problems", to_json(preview.problems)}};
}

}  // namespace

Answer ImportValve::operator()(const Request& request) const {
  ImportRequest asked;
  if (auto refused = read_body(valves, request.body, import_fields(asked)))
    return *std::move(refused);
  if (const Errors errors = check_import(asked); !errors.empty()) return problem(422, errors);
  const Compute::Turn turn(compute);
  if (!turn) return too_busy();
  const Made made = make_checked(asked, valves);
  if (made.refusal) return *made.refusal;
  return store_valve(store, valves.limits, made.imported->valve,
                     {{"decisions", to_json(made.imported->decisions)}});
}

Answer PostImports::operator()(const Request& request) const {
  ImportRequest asked;
  std::vector<JsonField> fields = import_fields(asked);
  fields.push_back(fit_field(asked));
  if (auto refused = read_body(submitting.valves, request.body, fields)) return *std::move(refused);
  if (const Errors errors = check_import(asked); !errors.empty()) return problem(422, errors);
  Made made;
  {
    const Compute::Turn turn(compute);
    if (!turn) return too_busy();
    made = make_checked(asked, submitting.valves);
    if (made.refusal) return *made.refusal;
    if (asked.fit)
      if (const auto surface = fit_surface(asked, *made.imported); !surface)
        return problem(422, surface.errors());
  }
  return submit(submitting, request,
                {"import",
                 made.imported->valve,
                 {{"files", content_id(request.body)}, {"fit", asked.fit.has_value()}},
                 request.body});
}

Answer PreviewImport::operator()(const Request& request) const {
  std::vector<NamedFile> files;
  const auto read = [](const JsonPlace& place) { return read_list(place, read_file); };
  if (auto refused = read_body(valves, request.body, {{"files", into(files, read)}}))
    return *std::move(refused);
  const Compute::Turn turn(compute);
  if (!turn) return too_busy();
  Json list = Json::array();
  for (const NamedFile& file : files) list.push_back(preview_json(file));
  return json_answer(200, {{"files", std::move(list)}});
}

}  // namespace coapt
