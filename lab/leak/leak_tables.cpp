#include "lab/leak/leak_tables.h"

#include <cmath>
#include <sstream>

#include "core/valve/number_text.h"
#include "io/json/json.h"

namespace coapt {
namespace {

std::string cell(double value, int decimals) {
  return std::isfinite(value) ? "," + with_decimals(value, decimals) : ",";
}

template <class Rows>
Json rows_json(const Rows& rows) {
  Json json = Json::array();
  for (Index i = 0; i < rows.rows(); ++i)
    json.push_back(Json::array({rows(i, 0), rows(i, 1), rows(i, 2)}));
  return json;
}

}  // namespace

std::string leaks_csv(const std::vector<LeakCase>& cases) {
  std::ostringstream csv;
  csv << "number,valve,repair,held_out,triangles,trusted,reference_mm2,surface_mm2,primal_mm2,dual_"
         "mm2,"
         "coarser_mm2,openings,cells,widened,seconds";
  for (const LeakCase& one : cases) {
    if (one.areas.empty()) continue;
    for (const MeasuredArea& area : one.areas)
      csv << ',' << area.measure << "_mm2," << area.measure << "_error_mm2";
    break;
  }
  csv << '\n';
  for (const LeakCase& one : cases) {
    csv << one.number << ",\"" << one.valve << "\"," << one.repair << ','
        << (one.number % 2 ? "true" : "false") << ',' << one.surface.faces.rows() << ','
        << (one.is_trusted ? "true" : "false");
    if (one.is_trusted) {
      const std::vector<ReferenceLevel>& levels = one.reference.levels;
      csv << cell(one.reference.area_mm2, 3) << cell(one.reference.surface_mm2, 3)
          << cell(one.reference.primal_mm2, 3) << cell(one.reference.dual_mm2, 3)
          << (levels.size() > 1 ? cell(levels[levels.size() - 2].primal_mm2, 3) : ",") << ','
          << one.reference.openings.size() << ',' << levels.back().cells << ','
          << levels.back().widened << cell(one.reference_seconds, 1);
      for (const MeasuredArea& area : one.areas)
        csv << cell(area.area_mm2, 3) << cell(area.error_mm2, 3);
    }
    csv << '\n';
  }
  return csv.str();
}

std::string openings_csv(const std::vector<LeakCase>& cases) {
  std::ostringstream csv;
  csv << "number,area_mm2,x_mm,y_mm,z_mm,normal_x,normal_y,normal_z\n";
  for (const LeakCase& one : cases)
    for (const ReferenceOpening& opening : one.reference.openings) {
      csv << one.number << cell(opening.area_mm2, 3);
      for (int k = 0; k < 3; ++k) csv << cell(opening.centroid_mm[k], 2);
      for (int k = 0; k < 3; ++k) csv << cell(opening.normal[k], 3);
      csv << '\n';
    }
  return csv.str();
}

std::string agreements_table(const std::vector<LeakAgreement>& agreements) {
  std::ostringstream table;
  table << "| measure | valves | above 5 mm2 | bias % | sd | median | p90 | worst | below | mean "
           "mm2 | worst | flips at 1 mm2 | unsafe | outside +- |\n"
           "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const LeakAgreement& a : agreements) {
    table << "| " << a.measure << " | " << a.valves << " | " << a.large;
    for (const double percent :
         {a.bias_percent, a.sd_percent, a.median_percent, a.p90_percent, a.worst_percent})
      table << " | " << with_decimals(percent, 1);
    table << " | " << a.small << " | " << with_decimals(a.small_mean_mm2, 2) << " | "
          << with_decimals(a.small_worst_mm2, 2) << " | " << a.flips << " | " << a.unsafe << " | ";
    if (a.with_error > 0) table << a.outside << " of " << a.with_error;
    table << " |\n";
  }
  return table.str();
}

std::string surface_json(const LeakCase& one) {
  Json edges = Json::array();
  for (const auto& [from, to] : free_edges(one.surface)) edges.push_back(Json::array({from, to}));
  const Json json = {{"number", one.number},
                     {"valve", one.valve},
                     {"half_thickness_mm", one.surface.half_thickness_mm},
                     {"points_mm", rows_json(one.surface.points_mm)},
                     {"faces", rows_json(one.surface.faces)},
                     {"annulus", one.surface.annulus},
                     {"free_edge", edges}};
  return json.dump() + '\n';
}

}  // namespace coapt
