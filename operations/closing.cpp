#include "operations/closing.h"

#include <limits>
#include <utility>

#include "core/closed/accurate_closure.h"
#include "io/json/result_json.h"
#include "operations/stopwatch.h"

namespace coapt {
namespace {

// Meshes of four and sixteen times the triangles take some ten and a hundred times as long.
constexpr std::ptrdiff_t kClosuresOfFinerMeshes = 100;
constexpr int kFewestVertices = 6, kMostVertices = 100'000;  // of a mesh that refining makes
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

}  // namespace

std::vector<JsonField> closing_fields(Closing& asked) {
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
           false}};
}

void add_contradictions(const Closing& asked, ProblemList& problems) {
  if (asked.accuracy_mm2 && asked.converge)
    problems.add(ErrorCode::Unsupported, "/converge",
                 "refines the mesh, as does accuracy_mm2; leave one of them out");
  if (asked.certainty != Certainty::Quick && (asked.accuracy_mm2 || asked.converge))
    problems.add(ErrorCode::Unsupported, "/certainty",
                 "refines the mesh, as do accuracy_mm2 and converge; leave the others out");
  if (asked.accuracy_mm2 && asked.closure.method != Method::Fast)
    problems.add(ErrorCode::Unsupported, "/accuracy_mm2",
                 "is available only for method fast; leave out method thesis");
}

Closing settled(Closing asked, bool mitral) {
  // The thesis takes the mean of several end states of a mitral valve.
  if (asked.closure.method == Method::Thesis && mitral) asked.closure.samples = kThesisSamples;
  if (asked.certainty != Certainty::Quick) asked.converge.emplace();
  if (asked.certainty == Certainty::Sure) asked.converge->most_meshes = 2;
  return asked;
}

std::ptrdiff_t closures_of(const Closing& asked) {
  return asked.converge || asked.accuracy_mm2 ? kClosuresOfFinerMeshes : 1;
}

Expected<ClosedValve> close_as(const Valve& valve, const Closing& asked, Context& context,
                               Json& more) {
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

}  // namespace coapt
