#include "io/json/calibration_json.h"

#include <algorithm>
#include <cmath>

#include "io/json/dimensions_json.h"
#include "io/json/parse_json.h"

namespace coapt {
namespace {

/// It names a file beside calibration.json and result.json.
bool is_file_name(std::string_view name) {
  const auto usual = [](unsigned char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
           c == '_';
  };
  return !name.empty() && std::all_of(name.begin(), name.end(), usual) && name != "calibration" &&
         name != "result";
}

CalibratedValve read_calibrated_valve(const JsonPlace& place) {
  CalibratedValve valve;
  valve.name = std::string(place.name);
  if (!is_file_name(place.name))
    add_problem(place, ErrorCode::OutOfRange,
                "a valve's name has letters, digits, - and _, and is not calibration or result");
  read_fields(place,
              {{"kind",
                [&](const JsonPlace& at) {
                  valve.kind = read_name(at, std::vector(kValveKinds.begin(), kValveKinds.end()));
                }},
               {"species",
                [&](const JsonPlace& at) {
                  valve.species = read_name(at, std::vector(kSpecies.begin(), kSpecies.end()));
                },
                false},
               {"remodelling", into(valve.change, read_remodelling), false},
               {"disease", into(valve.disease, read_string), false}});
  return valve;
}

std::vector<CalibratedValve> read_calibrated_valves(const JsonPlace& place) {
  std::vector<CalibratedValve> valves;
  std::vector<JsonField> fields;
  if (place.value.is_object())
    for (const auto& [name, value] : place.value.items())
      fields.push_back(
          {name, [&](const JsonPlace& at) { valves.push_back(read_calibrated_valve(at)); }});
  read_fields(place, fields);
  if (place.value.is_object() && place.value.empty())
    add_problem(place, ErrorCode::MissingField, "names no valve");
  return valves;
}

/// Null unless a number is there.
const Json* number_at(const Json& document, const std::string& path) {
  if (!path.starts_with("/dimensions/") && !path.starts_with("/valves/")) return nullptr;
  try {
    const Json& value = document.at(Json::json_pointer(path));
    return value.is_number() ? &value : nullptr;
  } catch (const Json::exception&) {  // no pointer, or to nothing
    return nullptr;
  }
}

/// Of the unknown at `place`, whose numbers stand in `document`.
CalibrationUnknown read_unknown(const JsonPlace& place, const Json& document) {
  CalibrationUnknown unknown;
  std::vector<double> starts;
  const auto read_at = [&](const JsonPlace& at) {
    const std::string path = read_string(at);
    if (const Json* number = number_at(document, path))
      starts.push_back(number->get<double>());
    else
      add_problem(at, ErrorCode::BadReference,
                  "must point to a number of this document, below /dimensions or /valves");
    return path;
  };
  read_fields(place, {{"at", [&](const JsonPlace& at) { read_list(at, read_at); }},
                      {"low", into(unknown.low, read_number)},
                      {"high", into(unknown.high, read_number)}});
  if (starts.empty()) return unknown;
  unknown.start = starts.front();
  if (!(unknown.low < unknown.high && unknown.start >= unknown.low &&
        unknown.start <= unknown.high))
    add_problem(place, ErrorCode::OutOfRange,
                "starts at " + shown(unknown.start) + ", must be from low to high, low below high");
  return unknown;
}

CalibrationBand read_band(const JsonPlace& place, const std::vector<CalibratedValve>& valves) {
  CalibrationBand band;
  std::optional<double> low, high, scale;
  std::vector<std::string> names, quantities;
  for (const CalibratedValve& valve : valves) names.push_back(valve.name);
  for (const PhysiologyQuantity& quantity : physiology_quantities())
    quantities.emplace_back(quantity.name);
  bool found = true;
  const auto choose = [&found](const JsonPlace& at, const std::vector<std::string>& of) {
    const std::optional<std::size_t> chosen = read_choice(at, of);
    found = found && chosen;
    return chosen.value_or(0);
  };
  read_fields(
      place,
      {{"valve", [&](const JsonPlace& at) { band.valve = static_cast<int>(choose(at, names)); }},
       {"quantity",
        [&](const JsonPlace& at) {
          band.quantity = &physiology_quantities()[choose(at, quantities)];
        }},
       {"low", into(low, read_number), false},
       {"high", into(high, read_number), false},
       {"scale", into(scale, read_number), false},
       {"weight", into(band.weight, read_number), false}});
  if (!found || band.quantity == nullptr || valves.empty()) return band;
  const CalibratedValve& valve = valves[static_cast<std::size_t>(band.valve)];
  const PhysiologyRange* range = find_range(band.quantity->name, valve.kind, valve.species);
  if (range == nullptr && !(low && high)) {
    add_problem(place, ErrorCode::MissingField,
                std::string("no range of ") + band.quantity->name + " is published for a " +
                    to_string(valve.kind) + " " + to_string(valve.species) +
                    " valve: low and high are required");
    return band;
  }
  band.low = low ? *low : range->low;
  band.high = high ? *high : range->high;
  band.scale = scale.value_or(0.25 * (band.high - band.low));
  if (!(band.low <= band.high))
    add_problem(place, ErrorCode::OutOfRange,
                "low is " + shown(band.low) + ", must not be above high, " + shown(band.high));
  if (!(band.scale > 0.0)) add_problem(place, ErrorCode::OutOfRange, "scale must be above 0");
  if (!(band.weight >= 0.0))
    add_problem(place, ErrorCode::OutOfRange, "weight must not be below 0");
  return band;
}

/// The healthy valve's dimensions and the valves; the rest is left alone.
CalibrationValves read_valves(const Json& document, ProblemList& problems) {
  CalibrationValves valves;
  const JsonPlace root{document, problems};
  const auto leave = [](const JsonPlace&) {};
  read_fields(
      root,
      {{"schema", leave},
       {"dimensions", [&](const JsonPlace& at) { read_dimension_fields(at, valves.dimensions); }},
       {"valves", [&](const JsonPlace& at) { valves.valves = read_calibrated_valves(at); }},
       {"unknowns", leave},
       {"targets", leave}});
  return valves;
}

/// A bound that the valves cannot take is a problem of the bound.
void check_bounds(const Json& document, const std::vector<CalibrationUnknown>& unknowns,
                  ProblemList& problems) {
  std::vector<double> values;
  for (const CalibrationUnknown& unknown : unknowns) values.push_back(unknown.start);
  for (std::size_t i = 0; i < unknowns.size(); ++i)
    for (const auto& [name, value] :
         {std::pair{"low", unknowns[i].low}, {"high", unknowns[i].high}}) {
      std::vector<double> at_bound = values;
      at_bound[i] = value;
      ProblemList found;
      read_valves(with_values(document, at_bound), found);
      if (found.empty()) continue;
      const Error& first = found.listed().front();
      problems.add(first.code, "/unknowns/" + std::to_string(i) + "/" + name,
                   first.path + " " + first.message);
    }
}

}  // namespace

Json with_values(Json document, const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    for (const Json& pointer : document.at("unknowns").at(i).at("at"))
      document[Json::json_pointer(pointer.get<std::string>())] = six_digits(values[i]);
  return document;
}

Expected<CalibrationFile> read_calibration(std::string_view text) {
  Expected<Json> json = parse_json(text);
  if (!json) return json.errors();
  CalibrationFile file{*std::move(json), {}};
  const Json& document = file.document;
  ProblemList problems;
  CalibrationValves valves;
  read_fields(
      {document, problems},
      {{"schema", [](const JsonPlace& at) { read_schema(at, "coapt.calibration/1"); }},
       {"dimensions", [&](const JsonPlace& at) { read_dimension_fields(at, valves.dimensions); }},
       {"valves", [&](const JsonPlace& at) { valves.valves = read_calibrated_valves(at); }},
       {"unknowns",
        [&](const JsonPlace& at) {
          file.problem.unknowns =
              read_list(at, [&](const JsonPlace& entry) { return read_unknown(entry, document); });
          if (file.problem.unknowns.empty())
            add_problem(at, ErrorCode::MissingField, "names no unknown");
        }},
       {"targets", [&](const JsonPlace& at) {
          file.problem.bands = read_list(
              at, [&](const JsonPlace& entry) { return read_band(entry, valves.valves); });
          if (file.problem.bands.empty())
            add_problem(at, ErrorCode::MissingField, "names no target");
        }}});
  if (problems.empty()) check_bounds(document, file.problem.unknowns, problems);
  if (!problems.empty()) return std::move(problems).take();
  file.problem.valves_at =
      [document](const std::vector<double>& values) -> Expected<CalibrationValves> {
    ProblemList found;
    CalibrationValves at = read_valves(with_values(document, values), found);
    if (!found.empty()) return std::move(found).take();
    return at;
  };
  return file;
}

std::string calibrated_dimensions(const CalibrationValves& valves, int valve) {
  const CalibratedValve& one = valves.valves[static_cast<std::size_t>(valve)];
  HumanValve written{valves.dimensions, one.change, one.disease};
  written.dimensions.name = one.name;
  return write_dimensions(written);
}

}  // namespace coapt
