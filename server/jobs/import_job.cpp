#include "server/jobs/import_job.h"

#include <algorithm>

#include "io/json/base64.h"
#include "io/json/fit_json.h"
#include "io/json/parse_json.h"
#include "io/json/result_json.h"
#include "io/json/valve_json.h"
#include "io/picture/fit_picture.h"
#include "io/store/stored_valves.h"
#include "server/content_id.h"
#include "server/jobs/closure_keeping.h"

namespace coapt {
namespace {

/// What is left of it in the document that a reader made: without files. None: none was asked for.
Expected<std::optional<FitRequest>> fit_asked(const Json& document) {
  if (!document.contains("fit")) return std::optional<FitRequest>();
  ImportRequest request;
  ProblemList problems;
  const Json fit = {{"fit", document["fit"]}};
  read_fields({fit, problems}, {fit_field(request)});
  if (!problems.empty()) return std::move(problems).take();
  return std::move(request.fit);
}

std::optional<FitState> kept_state(const std::optional<std::string>& text) {
  if (!text) return std::nullopt;
  const Expected<Json> json = parse_json(*text);
  return json ? fit_state_from_json(*json) : std::nullopt;
}

struct Fitted {
  FittedImport made;
  std::optional<JobFile> map;  ///< of a surface with faces
};

/// Kept round by round. Errors: those of the surface and of the fit; throws if the server stops.
Expected<Fitted> fit_import(const ImportJob& work, RunningJob& job, const FitTarget& asked,
                            const Valve& imported, const LeafletMesh& surface,
                            std::optional<FitState> from) {
  const MeasuredClosure measured{surface.vertices_mm, asked.side, asked.leak_mm2,
                                 asked.leak_sd_mm2};
  FitOptions options = asked.options;
  options.threads = work.reader.limits.threads;
  options.cancelled = [&] { return work.board.stopping() || job.cancelled; };
  options.most_seconds = std::max(0.0, work.reader.limits.seconds - job.seconds());
  JobProgress progress{.stage = "fitting", .closures = from ? from->closures : 0};
  job.note(progress);
  options.from = std::move(from);
  options.keep = [&](const FitState& state) {
    if (work.board.stopping()) throw std::runtime_error(kJobStops);  // closures may be unfinished
    keep_closure(work.board, job,
                 [&] { return work.store.keep_state(job.job.id, to_json(state).dump()); });
    progress.closures = state.closures;
  };
  options.progress = [&](int, double rms_mm) {
    progress.rms_mm = rms_mm;
    job.note(progress);
    return true;
  };
  const Expected<ValveFit> fit = fit_valve(imported, measured, options);
  if (work.board.stopping()) throw std::runtime_error(kJobStops);
  if (!fit) return as_fit_fields(fit.errors(), "/fit", "/fit");
  Fitted fitted{fitted_import(*fit, measured, job.job.valve), std::nullopt};
  if (surface.faces.rows() > 0)
    fitted.map = {"fit.png", "image/png", fit_map_png(surface, *fit, asked.side, kFittedSurface)};
  return fitted;
}

}  // namespace

std::optional<JobEnd> ImportJob::operator()(RunningJob& job) const {
  using Text = std::optional<std::string>;
  const Text body = retried<Text>(board, job, [&] { return store.input(job.job.id); });
  if (!body) return failed(job, {Error{ErrorCode::BadReference, "", "its files no longer exist"}});
  std::optional<FitState> from =
      kept_state(retried<Text>(board, job, [&] { return store.state(job.job.id); }));
  if (const std::optional<JobEnd> end = begin(board, job, from ? from->closures : 0)) return end;

  job.note({.stage = "importing"});
  const ClosureBudget budget{.cancelled = [&] { return board.stopping() || job.cancelled; }};
  const std::optional<Answer> answer =
      reader(ImportStep::Job, *body, budget, reader.limits.seconds - job.seconds(),
             JobRunner::kBelowRequests);
  if (!answer) throw std::runtime_error(kJobStops);
  const Expected<Json> answered = answer_document(*answer);
  if (!answered) return failed(job, answered.errors());
  const Json& read = *answered;
  if (answer->status != 200)
    return failed(job, errors_from_json(read.value("problems", Json::array())));
  Expected<ImportedValve> imported = import_from(read);
  if (!imported) return failed(job, imported.errors());
  Valve made = imported->valve;
  std::vector<JobFile> files = {
      {kImportPicture, "image/png", decoded_base64(read.value("picture", "")).value_or("")}};
  Json fit = nullptr;
  const Expected<std::optional<FitRequest>> asked = fit_asked(read);
  if (!asked) return failed(job, asked.errors());
  if (*asked) {
    const Expected<LeafletMesh> surface = surface_from(read.value("surface", Json()));
    if (!surface) return failed(job, surface.errors());
    Expected<Fitted> fitted =
        fit_import(*this, job, (*asked)->target, made, *surface, std::move(from));
    if (!fitted) return failed(job, fitted.errors());
    made = std::move(fitted->made.valve);
    fit = std::move(fitted->made.json);
    imported->decisions.push_back(std::move(fitted->made.decision));
    if (fitted->map) files.push_back(*std::move(fitted->map));
  }
  const std::string document = write_valve(made);
  const std::string id = content_id(document);
  retried<bool>(board, job, [&] { return add_valve(store, id, document); });
  files.push_back({"valve.json", "application/json", document});

  const Json result = import_answer(*imported, made, std::move(fit));
  const bool cancelled = job.cancel_asked || job.job.cancel_requested;
  JobEnd end = ended(job, cancelled ? JobState::Cancelled : JobState::Succeeded);
  end.summary = Json{{"made", id}}.dump();
  end.result = result.dump();
  end.files = std::move(files);
  return end;
}

}  // namespace coapt
