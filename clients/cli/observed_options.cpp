#include "clients/cli/observed_options.h"

namespace coapt {
namespace {

/// How a figure is called on the command line.
struct FigureOption {
  const char *value, *sd, *help;
};

/// In the order of ObservedFigure.
constexpr std::array<FigureOption, kObservedFigures> kFigures = {
    {{"--leak", "--leak-sd",
      "Anatomic regurgitant orifice area (planimetry, 3D vena contracta), mm2; divide an effective "
      "area by its discharge coefficient"},
     {"--tenting-area", "--tenting-area-sd",
      "Tenting area between the annular line and the leaflets in the mid-valve section, mm2"},
     {"--widest-gap", "--widest-gap-sd",
      "Widest gap: diameter of the largest ball that passes between the leaflets, mm"}}};

}  // namespace

void add_observed_options(Command command, ObservedOptions& options,
                          const std::string& source_option) {
  for (std::size_t i = 0; i < kFigures.size(); ++i) {
    const ObservedRow& row = kObservedRows[i];
    command.add_option(kFigures[i].value, options.values[i], kFigures[i].help)
        .check(number_from(row.least, row.most));
    command
        .add_option(kFigures[i].sd, options.sds[i],
                    "Standard deviation of " + std::string(kFigures[i].value) + ", " + row.unit)
        .check(number_from(row.least_sd, row.most_sd));
  }
  command.add_option(source_option, options.source, "Source of the observation, as free text");
}

std::string observed_option_names() {
  return "--leak and --leak-sd, --tenting-area and --tenting-area-sd, or --widest-gap and "
         "--widest-gap-sd";
}

bool any_observed(const ObservedOptions& options) {
  for (std::size_t i = 0; i < kFigures.size(); ++i)
    if (options.values[i] || options.sds[i]) return true;
  return false;
}

Errors check_observed(const ObservedOptions& options) {
  Errors errors;
  for (std::size_t i = 0; i < kFigures.size(); ++i) {
    const bool has_value = options.values[i].has_value();
    if (has_value == options.sds[i].has_value()) continue;
    const auto [value, sd, help] = kFigures[i];
    errors.push_back(
        {ErrorCode::MissingField, "",
         std::string(has_value ? sd : value) + " is required with " + (has_value ? value : sd)});
  }
  return errors;
}

Json observed_json(const ObservedOptions& options) {
  Json json = Json::object();
  for (std::size_t i = 0; i < kFigures.size(); ++i) {
    if (!options.values[i]) continue;
    Json& one = json[kObservedRows[i].name];
    one = {{"value", *options.values[i]}, {"sd", *options.sds[i]}};
    if (!options.source.empty()) one["source"] = options.source;
  }
  return json;
}

void take_observed(const ObservedOptions& options, Valve& valve) {
  for (std::size_t i = 0; i < kFigures.size(); ++i) {
    if (!options.values[i]) continue;
    observe(valve.observed,
            {static_cast<ObservedFigure>(i), *options.values[i], *options.sds[i], options.source});
  }
}

}  // namespace coapt
