#include "operations/fit_request.h"

#include <algorithm>

namespace coapt {
namespace {

MeasuredSide read_measured_side(const JsonPlace& place) {
  return read_choice(place, {"atrial", "middle"}).value_or(0) == 0 ? MeasuredSide::Atrial
                                                                   : MeasuredSide::Middle;
}

void read_known(const JsonPlace& place, FitUnknowns& unknowns) {
  read_array(place, [&](const JsonPlace& entry) {
    bool* const kept[] = {&unknowns.slack, &unknowns.tips, &unknowns.prestretch,
                          &unknowns.stiffness, &unknowns.hidden};
    if (const auto known =
            read_choice(entry, {"slack", "tips", "prestretch", "stiffness", "hidden"}))
      *kept[*known] = false;
  });
}

}  // namespace

std::vector<JsonField> fit_fields(FitTarget& target) {
  FitUnknowns& unknowns = target.options.unknowns;
  return {{"side", into(target.side, read_measured_side), false},
          {"leak_mm2", into(target.leak_mm2, number_in(0.0, 2000.0)), false},
          {"leak_sd_mm2", into(target.leak_sd_mm2, number_in(0.01, 1000.0)), false},
          {"known", [&unknowns](const JsonPlace& known) { read_known(known, unknowns); }, false},
          {"slack_sd", into(unknowns.slack_sd, number_in(0.001, 0.2)), false},
          {"tip_sd_mm", into(unknowns.tip_sd_mm, number_in(0.01, 10.0)), false},
          {"hidden_sd_mm", into(unknowns.hidden_sd_mm, number_in(0.01, 5.0)), false},
          {"points", into(target.options.most_points, integer_in(100, 10'000)), false},
          {"rounds", into(target.options.most_rounds, integer_in(1, 1000)), false}};
}

Errors as_fit_fields(Errors errors, const std::string& path, const std::string& valve) {
  for (Error& error : errors)
    error.path = error.path == "/points_mm"  ? path + "/surface"
                 : error.path == "/leak_mm2" ? path + "/leak_mm2"
                 : error.path == "/unknowns" ? path + "/known"
                                             : valve;
  return errors;
}

FitOptions within(FitOptions options, Context& context) {
  options.threads = context.limits.threads;
  options.most_seconds = std::min(options.most_seconds, context.limits.seconds);
  options.cancelled = [&context] {
    return context.cancelled() || (context.interrupted != nullptr && *context.interrupted);
  };
  const int rounds = (options.ruptures ? 6 : 2) * options.most_rounds;
  options.progress = [&context, rounds](int round, double rms_mm) {
    if (context.distance) context.distance(rms_mm);
    if (context.progress) context.progress(round, rounds);
    return true;
  };
  return options;
}

}  // namespace coapt
