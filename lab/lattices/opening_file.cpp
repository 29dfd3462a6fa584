#include "lab/lattices/opening_file.h"

#include <limits>
#include <map>

#include "io/json/json_reader.h"
#include "io/json/parse_json.h"

namespace coapt {

std::string write_openings(const std::string& subject, const KnownOpenings& openings) {
  std::map<std::string, Json> rows;
  for (const auto& [key, opening] : openings)
    rows[key] = {static_cast<int>(opening.status), opening.crossing,
                 opening.measure.opening_area_mm2, opening.measure.projected_area_mm2,
                 opening.measure.gradient_mmhg};
  return Json{{"openings", rows}, {"subject", subject}}.dump();
}

KnownOpenings read_openings(const std::string& subject, const std::string& text) {
  const auto number = [](const Json& value) {  // null: NaN
    return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
  };
  KnownOpenings openings;
  const Expected<Json> json = parse_json(text);
  if (!json || !json->is_object() || json->value("subject", Json()) != subject ||
      !json->contains("openings") || !(*json)["openings"].is_object())
    return {};
  for (const auto& [key, row] : (*json)["openings"].items()) {
    if (!row.is_array() || row.size() != 5 || !row[0].is_number_integer() || !row[1].is_boolean())
      return {};
    PlanOpening opening{static_cast<ClosureStatus>(row[0].get<int>()), row[1].get<bool>(), {}};
    opening.measure.opening_area_mm2 = number(row[2]);
    opening.measure.projected_area_mm2 = number(row[3]);
    opening.measure.gradient_mmhg = number(row[4]);
    openings[key] = opening;
  }
  return openings;
}

}  // namespace coapt
