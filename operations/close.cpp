// Closes a valve, repaired if there is a plan, and measures what leaks: on its own mesh, on finer and finer ones until the leak
// settles, or as finely as an error needs. Answers coapt.closure/2.
#include <optional>
#include <utility>

#include "core/metrics/closed_figures.h"
#include "core/valve/leaflets.h"
#include "io/json/diagnosis_json.h"
#include "io/json/model_study_json.h"
#include "io/json/opening_json.h"
#include "io/json/result_json.h"
#include "io/json/valve_json.h"
#include "operations/closing.h"
#include "operations/model_draws.h"
#include "operations/stopwatch.h"
#include "operations/table.h"
#include "search/plans/gates.h"

namespace coapt {
namespace {

constexpr int kMostTissueDraws = 1000;

struct CloseRequest {
  RepairRequest repair{};
  Closing closing{};
  bool open = false;
  int draws = 0;
};

std::vector<JsonField> fields_of(CloseRequest& asked) {
  std::vector<JsonField> fields = closing_fields(asked.closing);
  fields.push_back({"open", into(asked.open, read_boolean), false});
  fields.push_back({"draws", into(asked.draws, integer_in(0, kMostTissueDraws)), false});
  return fields;
}

/// What cannot be asked for together.
Errors contradictions(const CloseRequest& asked) {
  ProblemList problems;
  add_contradictions(asked.closing, problems);
  if (is_mitral(asked.repair.valve)) return std::move(problems).take();
  for (const auto& [given, name] :
       {std::pair(asked.closing.accuracy_mm2.has_value(), "/accuracy_mm2"),
        {asked.open, "/open"},
        {asked.draws > 0, "/draws"}})
    if (given)
      problems.add(ErrorCode::Unsupported, name,
                   "requires a mitral valve (coapt.valve/1); this is coapt.valve/2");
  return std::move(problems).take();
}

/// Adds the tissue's part of errors, by as many draws as asked for.
Errors add_tissue(const CloseRequest& asked, const ClosedValve& closed, Context& context,
                  Json& answer) {
  ModelStudyOptions study;
  study.draws = asked.draws;
  const Expected<ModelStudy> drawn =
      study_within(asked.repair, study, asked.closing.closure, context);
  if (!drawn) return drawn.errors();
  const std::optional<Interval> tissue = tissue_interval(*drawn);
  answer["leak"]["tissue"] = interval_json(tissue);
  for (std::size_t i = 0; i < closed_figures().size(); ++i)
    answer["estimates"][closed_figures()[i].name]["tissue"] =
        interval_json(tissue_interval(*drawn, i));
  const ValveMeasure& measure = closed.measure;
  const double area_mm2 = measure.leak.area_mm2;
  answer["diagnosis"] =
      to_json(diagnose(closed.valve, closed.closure, measure),
              {area_mm2, area_interval(area_mm2, measure.leak_error_mm2), tissue, {}});
  answer["tissue_draws"] = tissue_draws_json(*drawn);
  return {};
}

Expected<OperationAnswer> close(const CloseRequest& asked, Context& context) {
  const auto& [before, plan, repaired, material] = asked.repair;
  Json finer = Json::object();
  const Stopwatch closing;
  Expected<ClosedValve> closed = close_as(repaired, asked.closing, context, finer);
  const double seconds = closing.seconds();
  if (!closed) return closed.errors();
  const bool mitral = is_mitral(before);
  if (mitral) closed = with_repair(*std::move(closed), before, plan);
  Json answer = closure_to_json(closed->valve, closed->closure, closed->measure, seconds);
  answer.update(finer);
  if (!before.observed.empty()) answer["observed"] = to_json(before.observed);
  if (asked.draws > 0)
    if (Errors errors = add_tissue(asked, *closed, context, answer); !errors.empty()) return errors;
  std::vector<std::string> warnings;
  if (mitral) warnings = warnings_of(operation_gates({plan, before, repaired}));
  if (asked.open) {
    const Stopwatch opening;
    const Expected<OpenedValve> opened = context.open(repaired);
    if (!opened) return opened.errors();
    answer["opening"] = opening_figures_json(*opened, opening.seconds());
    for (std::string& warning : opening_warnings(*opened)) warnings.push_back(std::move(warning));
    if (context.opened) context.opened(*opened);
  }
  answer["warnings"] = warnings;
  if (context.closed) context.closed(*closed);
  return OperationAnswer(std::move(answer));
}

}  // namespace

Expected<OperationTask> read_close(const Json& request, const Context& context) {
  const auto asked = std::make_shared<CloseRequest>();
  if (Errors errors =
          read_repair(request, context, fields_of(*asked), asked->repair, AcceptedValve::Any);
      !errors.empty())
    return errors;
  if (Errors errors = contradictions(*asked); !errors.empty()) return errors;
  if (Errors errors = check_draws(asked->repair, asked->draws, context); !errors.empty())
    return errors;
  asked->closing = settled(asked->closing, is_mitral(asked->repair.valve));
  return task_of(asked, closures_of(asked->closing) + draw_closures(asked->repair, asked->draws),
                 close);
}

}  // namespace coapt
