#include "farm/work/closure_options_json.h"

#include <cmath>

namespace coapt {
namespace {

constexpr Range kPositive = {1e-9, 1e9};
constexpr int kMostSteps = 1'000'000'000, kMostSamples = 10'000;

const char* name_of(SelfContact self) {
  switch (self) {
    case SelfContact::All:
      return "all";
    case SelfContact::NotAnterior:
      return "not_anterior";
    case SelfContact::None:
      return "none";
  }
  return "";
}

SelfContact read_self_contact(const JsonPlace& place) {
  const std::vector choices = {SelfContact::All, SelfContact::NotAnterior, SelfContact::None};
  std::vector<std::string> names;
  for (const SelfContact choice : choices) names.emplace_back(name_of(choice));
  return choices[read_choice(place, names).value_or(0)];
}

Method read_closing_method(const JsonPlace& place) {
  return read_name(place, std::vector{Method::Fast, Method::Thesis});
}

Membrane read_closing_membrane(const JsonPlace& place) {
  return read_name(place, std::vector{Membrane::Continuum, Membrane::Springs});
}

}  // namespace

Expected<Json> closure_options_json(const ClosureOptions& options) {
  // Names all fields, so that this does not compile when there is one more.
  const auto& [method, membrane, residual_tolerance, way_tolerance_mm, max_steps,
               contact_pressure_mpa, speed, damping_per_ms, samples, edge_contact, self_contact,
               motion, budget] = options;
  ProblemList problems;
  if (motion)
    problems.add(ErrorCode::Unsupported, "/motion", "states on the way are not kept elsewhere");
  if (std::isfinite(budget.vertex_steps))
    problems.add(ErrorCode::Unsupported, "/budget", "a budget of steps holds here alone");
  const Json json = {{"method", to_string(method)},
                     {"membrane", to_string(membrane)},
                     {"residual_tolerance", residual_tolerance},
                     {"way_tolerance_mm", way_tolerance_mm},
                     {"max_steps", max_steps},
                     {"contact_pressure_mpa", contact_pressure_mpa},
                     {"speed", speed},
                     {"damping_per_ms", damping_per_ms},
                     {"samples", samples},
                     {"edge_contact", edge_contact},
                     {"self_contact", name_of(self_contact)}};
  read_closure_options({json, problems});
  if (!problems.empty()) return std::move(problems).take();
  return json;
}

ClosureOptions read_closure_options(const JsonPlace& place) {
  const auto positive = [](const JsonPlace& at) { return read_number_in(at, kPositive); };
  const auto not_negative = [](const JsonPlace& at) {
    return read_number_in(at, {0.0, kPositive.max});
  };
  ClosureOptions options;
  read_fields(
      place,
      {{"method", into(options.method, read_closing_method)},
       {"membrane", into(options.membrane, read_closing_membrane)},
       {"residual_tolerance", into(options.residual_tolerance, positive)},
       {"way_tolerance_mm", into(options.way_tolerance_mm, positive)},
       {"max_steps", into(options.max_steps,
                          [](const JsonPlace& at) { return read_integer_in(at, 0, kMostSteps); })},
       {"contact_pressure_mpa", into(options.contact_pressure_mpa, not_negative)},
       {"speed", into(options.speed,
                      [](const JsonPlace& at) {
                        return read_number_in(at, {kPositive.min, 1.0});
                      })},
       {"damping_per_ms", into(options.damping_per_ms, not_negative)},
       {"samples", into(options.samples,
                        [](const JsonPlace& at) { return read_integer_in(at, 1, kMostSamples); })},
       {"edge_contact", into(options.edge_contact, read_boolean)},
       {"self_contact", into(options.self_contact, read_self_contact)}});
  return options;
}

}  // namespace coapt
