#include "io/json/physiology_json.h"

#include <cmath>

#include "io/json/version.h"

namespace coapt {

Json to_json(const PhysiologyRow& row) {
  const bool known = row.range != nullptr;
  return {{"quantity", row.quantity->name},
          {"what", row.quantity->what},
          {"value", std::isfinite(row.value) ? Json(row.value) : Json()},
          {"unit", row.quantity->unit},
          {"low", known ? Json(row.range->low) : Json()},
          {"high", known ? Json(row.range->high) : Json()},
          {"source", known ? Json(row.range->source) : Json()},
          {"verdict", to_string(row.verdict)}};
}

Json to_json(const Physiology& physiology, const Valve& valve) {
  Json rows = Json::array();
  for (const PhysiologyRow& row : physiology.rows) rows.push_back(to_json(row));
  return result_document("coapt.physiology/1", {{"valve", valve.name},
                                                {"triangles", valve.faces.rows()},
                                                {"kind", to_string(physiology.kind)},
                                                {"kind_judged", physiology.kind_judged},
                                                {"species", to_string(physiology.species)},
                                                {"species_judged", physiology.species_judged},
                                                {"rows", std::move(rows)}});
}

}  // namespace coapt
