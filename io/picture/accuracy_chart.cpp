#include "io/picture/accuracy_chart.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "io/picture/picture.h"

namespace coapt {
namespace {

bool usable(const AccuracyPoint& point) {
  return point.status == ClosureStatus::Converged && !point.crossing;
}

using Error = double (*)(const AccuracyPoint&);

/// Points of a scene that no other of it beats in both time and error, in order of time.
Series front(const std::vector<AccuracyPoint>& points, const std::string& scene, Error error) {
  std::vector<std::pair<double, double>> sorted;
  for (const AccuracyPoint& point : points)
    if (point.scene == scene && usable(point))
      sorted.emplace_back(1e3 * point.seconds, error(point));
  std::sort(sorted.begin(), sorted.end());
  Series best{"Pareto front, " + scene, {}, {}};
  for (const auto& [x, y] : sorted)
    if (best.y.empty() || y < best.y.back()) {
      best.x.push_back(x);
      best.y.push_back(y);
    }
  return best;
}

Chart chart_of(const std::vector<AccuracyPoint>& points, Error error) {
  Chart chart;
  chart.log_x = true;
  chart.x_label = "time of a closure, ms";
  const auto add = [&](const char* label, Method method, Membrane membrane) {
    Series series{label, {}, {}, false};
    for (const AccuracyPoint& point : points) {
      if (point.of.method != method || point.of.membrane != membrane || !usable(point)) continue;
      series.x.push_back(1e3 * point.seconds);
      series.y.push_back(error(point));
    }
    chart.series.push_back(series);
  };
  add("fast springs", Method::Fast, Membrane::Springs);
  add("fast continuum", Method::Fast, Membrane::Continuum);
  add("thesis", Method::Thesis, Membrane::Springs);
  std::set<std::string> scenes;
  for (const AccuracyPoint& point : points)
    if (scenes.insert(point.scene).second)
      chart.series.push_back(front(points, point.scene, error));
  return chart;
}

}  // namespace

std::string accuracy_csv(const std::vector<AccuracyPoint>& points) {
  std::ostringstream csv;
  csv << "scene,method,membrane,triangles,tolerance,status,crossing,seconds,rms_mm,max_mm,"
         "orifice_error_mm2,own_rms_mm,own_orifice_error_mm2\n";
  for (const AccuracyPoint& p : points)
    csv << p.scene << ',' << to_string(p.of.method) << ',' << to_string(p.of.membrane) << ','
        << p.triangles << ',' << p.of.tolerance << ',' << to_string(p.status) << ','
        << (p.crossing ? "true" : "false") << ',' << p.seconds << ',' << p.rms_mm << ',' << p.max_mm
        << ',' << p.orifice_error_mm2 << ',' << p.own_rms_mm << ',' << p.own_orifice_error_mm2
        << '\n';
  return csv.str();
}

std::string accuracy_svg(const std::vector<AccuracyPoint>& points) {
  Chart chart = chart_of(points, [](const AccuracyPoint& p) { return p.rms_mm; });
  chart.title = "Accuracy against time";
  chart.y_label = "rms distance from the reference, mm";
  // Table 2.2: 0.56 to 0.82 mm rms from imaging; chapter 4: less than ten seconds a configuration.
  chart.series.push_back({"thesis's figures", {1e4, 1e4, 1e4}, {0.56, 0.68, 0.82}, false});
  return chart_svg(chart);
}

std::string orifice_error_svg(const std::vector<AccuracyPoint>& points) {
  Chart chart =
      chart_of(points, [](const AccuracyPoint& p) { return std::abs(p.orifice_error_mm2); });
  chart.title = "Error of the orifice against time";
  chart.y_label = "orifice, difference from the reference, mm2";
  return chart_svg(chart);
}

}  // namespace coapt
