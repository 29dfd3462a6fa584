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
      "Anatomic regurgitant orifice area (planimetry, 3D vena contracta), mm2"},
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
  const auto in = [](Range range) { return number_from(range.min, range.max); };
  command
      .add_option("--effective-leak", options.effective_mm2,
                  "Effective regurgitant orifice area (flow convergence, Doppler), mm2, instead of "
                  "--leak; divided by the discharge coefficient")
      .check(in(kEffectiveLeaks_mm2));
  command
      .add_option("--effective-leak-sd", options.effective_sd_mm2,
                  "Standard deviation of --effective-leak, mm2")
      .check(in(kEffectiveLeakSds_mm2));
  command
      .add_option("--discharge", options.discharge.discharge,
                  "Discharge coefficient: effective over anatomic area (assumed)")
      .check(in(kDischarges))
      .show_default();
  command
      .add_option("--discharge-sd", options.discharge.discharge_sd,
                  "Standard deviation of --discharge (assumed)")
      .check(in(kDischargeSds))
      .show_default();
  command.add_option(source_option, options.source, "Source of the observation, as free text");
}

std::string observed_option_names() {
  return "--leak and --leak-sd, --effective-leak and --effective-leak-sd, --tenting-area and "
         "--tenting-area-sd, or --widest-gap and --widest-gap-sd";
}

bool any_observed(const ObservedOptions& options) {
  for (std::size_t i = 0; i < kFigures.size(); ++i)
    if (options.values[i] || options.sds[i]) return true;
  return options.effective_mm2 || options.effective_sd_mm2;
}

Errors check_observed(const ObservedOptions& options) {
  Errors errors;
  const auto check_both = [&errors](bool has_value, bool has_sd, const char* value,
                                    const char* sd) {
    if (has_value == has_sd) return;
    errors.push_back(
        {ErrorCode::MissingField, "",
         std::string(has_value ? sd : value) + " is required with " + (has_value ? value : sd)});
  };
  for (std::size_t i = 0; i < kFigures.size(); ++i)
    check_both(options.values[i].has_value(), options.sds[i].has_value(), kFigures[i].value,
               kFigures[i].sd);
  check_both(options.effective_mm2.has_value(), options.effective_sd_mm2.has_value(),
             "--effective-leak", "--effective-leak-sd");
  if (options.effective_mm2 && options.values[static_cast<std::size_t>(ObservedFigure::Leak)])
    errors.push_back({ErrorCode::Unsupported, "",
                      "--effective-leak and --leak are of one figure; leave one of them out"});
  return errors;
}

std::optional<EffectiveLeak> effective_leak(const ObservedOptions& options) {
  if (!options.effective_mm2) return std::nullopt;
  EffectiveLeak seen = options.discharge;
  seen.value_mm2 = *options.effective_mm2;
  seen.sd_mm2 = *options.effective_sd_mm2;
  seen.source = options.source;
  return seen;
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
  if (const auto seen = effective_leak(options)) observe(valve.observed, anatomic_leak(*seen));
}

}  // namespace coapt
