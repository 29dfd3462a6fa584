// Closes a valve, repaired if there is a plan, and measures what leaks: on its own mesh, on finer and finer ones until the leak
// settles, or as finely as an error needs. Answers coapt.closure/2.
#include <limits>
#include <optional>
#include <utility>

#include "core/closed/accurate_closure.h"
#include "core/closed/mesh_convergence.h"
#include "core/valve/leaflets.h"
#include "io/json/diagnosis_json.h"
#include "io/json/model_study_json.h"
#include "io/json/opening_json.h"
#include "io/json/result_json.h"
#include "io/json/valve_json.h"
#include "operations/certainty.h"
#include "operations/model_draws.h"
#include "operations/stopwatch.h"
#include "operations/table.h"
#include "search/plans/gates.h"

namespace coapt {
namespace {

// Meshes of four and sixteen times the triangles take some ten and a hundred times as long.
constexpr std::ptrdiff_t kClosuresOfFinerMeshes = 100;
constexpr int kMostTissueDraws = 1000;
constexpr int kFewestVertices = 6, kMostVertices = 100'000;  // of a mesh that refining makes

struct CloseRequest {
  RepairRequest repair{};
  ClosureOptions closure{};
  std::optional<double> accuracy_mm2{};
  std::optional<MeshConvergenceOptions> converge{};
  Certainty certainty = Certainty::Quick;
  bool open = false;
  int draws = 0;
};

constexpr Range kAnyError{0.0, std::numeric_limits<double>::max()};

MeshConvergenceOptions read_converge(const JsonPlace& place) {
  MeshConvergenceOptions options;
  const auto within = [&options](const JsonPlace& at) {
    options.within_mm2 = read_number_in(at, kAnyError, " mm2");
    options.within_share = 0.0;
  };
  const auto vertices = [](const JsonPlace& at) {
    return read_integer_in(at, kFewestVertices, kMostVertices);
  };
  read_fields(place, {{"within_mm2", within, false},
                      {"most_vertices", into(options.most_vertices, vertices), false}});
  return options;
}

std::vector<JsonField> fields_of(CloseRequest& asked) {
  return {{"method",
           into(asked.closure.method,
                [](const JsonPlace& place) {
                  return read_name<Method>(place, {Method::Fast, Method::Thesis});
                }),
           false},
          {"membrane",
           into(asked.closure.membrane,
                [](const JsonPlace& place) {
                  return read_name<Membrane>(place, {Membrane::Continuum, Membrane::Springs});
                }),
           false},
          {"accuracy_mm2",
           into(asked.accuracy_mm2,
                [](const JsonPlace& place) { return read_number_in(place, kAnyError, " mm2"); }),
           false},
          {"converge", into(asked.converge, read_converge), false},
          {"certainty",
           into(asked.certainty,
                [](const JsonPlace& place) {
                  return read_name<Certainty>(
                      place, {Certainty::Quick, Certainty::Sure, Certainty::Proof});
                }),
           false},
          {"open", into(asked.open, read_boolean), false},
          {"draws", into(asked.draws, integer_in(0, kMostTissueDraws)), false}};
}

/// What cannot be asked for together.
Errors contradictions(const CloseRequest& asked) {
  ProblemList problems;
  if (asked.accuracy_mm2 && asked.converge)
    problems.add(ErrorCode::Unsupported, "/converge",
                 "refines the mesh, as does accuracy_mm2; leave one of them out");
  if (asked.certainty != Certainty::Quick && (asked.accuracy_mm2 || asked.converge))
    problems.add(ErrorCode::Unsupported, "/certainty",
                 "refines the mesh, as do accuracy_mm2 and converge; leave the others out");
  if (asked.accuracy_mm2 && asked.closure.method != Method::Fast)
    problems.add(ErrorCode::Unsupported, "/accuracy_mm2",
                 "is available only for method fast; leave out method thesis");
  if (is_mitral(asked.repair.valve)) return std::move(problems).take();
  for (const auto& [given, name] : {std::pair(asked.accuracy_mm2.has_value(), "/accuracy_mm2"),
                                    {asked.open, "/open"},
                                    {asked.draws > 0, "/draws"}})
    if (given)
      problems.add(ErrorCode::Unsupported, name,
                   "requires a mitral valve (coapt.valve/1); this is coapt.valve/2");
  return std::move(problems).take();
}

/// The closed valve; what there is to say of how it was refined goes into `more`.
Expected<ClosedValve> closed_valve(const CloseRequest& asked, Context& context, Json& more) {
  const Valve& valve = asked.repair.repaired;
  ClosureOptions options = asked.closure;
  options.budget = context.budget();
  if (asked.converge) {
    MeshConvergenceOptions until = *asked.converge;
    until.closure = options;
    std::vector<double> seconds;
    Stopwatch level;
    MeshConvergence finer = close_until_settled(valve, until, [&](const MeshLevel&) {
      seconds.push_back(std::exchange(level, {}).seconds());
    });
    if (finer.finest.closure.unfinished) return context.refusal();
    more["convergence"] = to_json(finer, until);
    for (std::size_t i = 0; i < seconds.size(); ++i)
      more["convergence"]["levels"][i]["seconds"] = seconds[i];
    return std::move(finer.finest);
  }
  if (!asked.accuracy_mm2) return context.close(valve, options);
  Expected<AccurateClosure> within = close_within(valve, *asked.accuracy_mm2, options);
  if (!within) {
    Errors errors = within.errors();
    for (Error& error : errors) error.path = "/accuracy_mm2";
    return errors;
  }
  if (within->closed.closure.unfinished) return context.refusal();
  more["accuracy"] = to_json(*within, *asked.accuracy_mm2);
  return std::move(within->closed);
}

/// Adds the tissue's part of the leak's error, by as many draws as asked for.
Errors add_tissue(const CloseRequest& asked, const ClosedValve& closed, Context& context,
                  Json& answer) {
  ModelStudyOptions study;
  study.draws = asked.draws;
  const Expected<ModelStudy> drawn = study_within(asked.repair, study, asked.closure, context);
  if (!drawn) return drawn.errors();
  const std::optional<Interval> tissue = tissue_interval(*drawn);
  answer["leak"]["tissue"] = tissue ? Json{tissue->low, tissue->high} : Json();
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
  Expected<ClosedValve> closed = closed_valve(asked, context, finer);
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
  // The thesis takes the mean of several end states of a mitral valve.
  if (asked->closure.method == Method::Thesis && is_mitral(asked->repair.valve))
    asked->closure.samples = kThesisSamples;
  if (asked->certainty != Certainty::Quick) asked->converge.emplace();
  if (asked->certainty == Certainty::Sure) asked->converge->most_meshes = 2;
  const bool once = !asked->converge && !asked->accuracy_mm2;
  return task_of(asked,
                 (once ? 1 : kClosuresOfFinerMeshes) + draw_closures(asked->repair, asked->draws),
                 close);
}

}  // namespace coapt
