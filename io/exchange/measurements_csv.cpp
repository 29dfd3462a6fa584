#include "io/exchange/measurements_csv.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/closure/standing.h"
#include "core/metrics/annulus.h"
#include "core/metrics/quantile.h"
#include "core/valve/number_text.h"
#include "io/exchange/valve_markups.h"

namespace coapt {
namespace {

class Table {
 public:
  /// @param error NaN: not known
  void add(const std::string& metric, double value, const char* unit,
           const std::string& definition = "",
           double error = std::numeric_limits<double>::quiet_NaN()) {
    if (!std::isfinite(value)) return;
    const int decimals = std::string(unit) == "mm/mm" ? 2 : 1;
    text_ += quoted(metric) + ',' + with_decimals(std::abs(value) < 0.05 ? 0.0 : value, decimals) +
             ',' + unit + ',' + quoted(definition) + ',' +
             (std::isfinite(error) ? with_decimals(error, decimals) : "") + '\n';
  }
  void remark(const std::string& metric, const std::string& definition) {
    text_ += quoted(metric) + ",,," + quoted(definition) + ",\n";
  }
  std::string take() && { return std::move(text_); }

 private:
  static std::string quoted(const std::string& field) {
    return field.find(',') == std::string::npos ? field : '"' + field + '"';
  }
  std::string text_ = "Metric,Value,Unit,Definition,Error\n";
};

void add_annulus(const Valve& valve, const AnnulusMeasure& annulus, Table& table) {
  const auto vertices = landmark_vertices(valve);
  const auto distance = [&](int from, int to) {
    return (annulus_position_mm(valve, vertices[static_cast<std::size_t>(from)]) -
            annulus_position_mm(valve, vertices[static_cast<std::size_t>(to)]))
        .norm();
  };
  table.add("Annulus circumference (3D)", annulus.circumference_mm, "mm");
  table.add("A-P distance", distance(0, 1), "mm");
  table.add("AL-PM distance", distance(2, 3), "mm");
  table.add("ALC-PMC distance", distance(4, 5), "mm");
  table.add("Sphericity index (A-P / AL-PM)", distance(0, 1) / distance(2, 3), "mm/mm");

  const AnnulusFrame plane = annulus_frame(valve, AnnulusAxis::Commissures);
  const Eigen::VectorXd height =
      (valve.annulus_mm.rowwise() - plane.origin_mm.transpose()) * plane.normal;
  table.add("Annulus height", height.maxCoeff() - height.minCoeff(), "mm");
  table.add("Annulus height above", height.maxCoeff(), "mm", "above: towards the atrium");
  table.add("Annulus height below", -height.minCoeff(), "mm");
  table.add("Annulus area (2D)", annulus.area_mm2, "mm*mm");
}

void add_coaptation(const Coaptation& coaptation, Table& table) {
  const std::string name = "Coaptation anterior - posterior height ";
  const std::string definition = "contact height in nine sections across the coaptation line";
  std::vector<double> heights;
  for (const CoaptationSection& section : coaptation.sections) heights.push_back(section.height_mm);
  table.add(name + "(min)", coaptation.height_min_mm, "mm", definition);
  table.add(name + "(mean)", coaptation.height_mean_mm, "mm", definition);
  table.add(name + "(max)", *std::max_element(heights.begin(), heights.end()), "mm", definition);
  for (const int percent : {10, 25, 50, 75, 90})
    table.add(name + '(' + std::to_string(percent) + "th percentile)",
              quantile(heights, 0.01 * percent), "mm", definition);
}

}  // namespace

std::string write_measurements_csv(const ClosedValve& exported) {
  const ValveMeasure& measure = exported.measure;
  Table table;
  if (const std::string doubt = doubt_about(exported.closure); !doubt.empty())
    table.remark("Closure", doubt);
  add_annulus(exported.valve, measure.annulus, table);
  table.add("Tenting height", measure.tenting_height_mm, "mm",
            "in the mid-valve section, from the annular line to the coaptation point; SlicerHeart "
            "uses the leaflet point furthest from a surface through the annulus");
  add_coaptation(measure.coaptation, table);
  table.add("Regurgitant orifice area", measure.leak.area_mm2, "mm*mm",
            "anatomic: the smallest area through which blood can flow back; not an EROA",
            measure.leak_error_mm2);
  return std::move(table).take();
}

}  // namespace coapt
