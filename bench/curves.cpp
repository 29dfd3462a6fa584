// Orifice against annular dilation and against papillary displacement, as CSV and SVG.
// Usage: curves DIRECTORY [PRESET...]   (default presets: porcine-1 human-normal)

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/closure/closure.h"
#include "core/metrics/measure.h"
#include "core/presets/presets.h"
#include "core/valve/remodel.h"
#include "io/picture/picture.h"
#include "search/parallel.h"

namespace {

using namespace coapt;

struct Curve {
  std::string label;
  Valve valve;
  std::vector<Remodelling> changes;
  std::vector<double> at;
};

struct Point {
  double orifice_mm2 = 0.0;
  ClosureStatus status = ClosureStatus::Converged;
  bool crossing = false;
};

Point close_at(const Valve& valve, const Remodelling& change) {
  const Expected<Valve> changed = remodel(valve, change);
  if (!changed) return {0.0, ClosureStatus::Diverged, false};
  const ClosureResult closed = close_valve(*changed);
  return {measure(*changed, closed).orifice.area_mm2, closed.status, closed.crossing};
}

bool draw(const std::filesystem::path& directory, const std::string& file, Chart chart,
          const std::vector<Curve>& curves) {
  std::ofstream csv(directory / (file + ".csv"));
  csv << "curve,x,orifice_area_mm2,status,crossing\n";
  bool trusted = true;
  for (const Curve& curve : curves) {
    std::vector<Point> points(curve.at.size());
    for_each_index(static_cast<int>(points.size()), 0, [&](int i) {
      const auto k = static_cast<std::size_t>(i);
      points[k] = close_at(curve.valve, curve.changes[k]);
    });
    Series series{curve.label, curve.at, {}};
    for (std::size_t i = 0; i < points.size(); ++i) {
      series.y.push_back(points[i].orifice_mm2);
      csv << curve.label << ',' << curve.at[i] << ',' << points[i].orifice_mm2 << ','
          << to_string(points[i].status) << ',' << (points[i].crossing ? "true" : "false") << '\n';
      trusted = trusted && points[i].status == ClosureStatus::Converged && !points[i].crossing;
    }
    chart.series.push_back(series);
    std::fprintf(stderr, "%s: %s\n", file.c_str(), curve.label.c_str());
  }
  std::ofstream(directory / (file + ".svg")) << chart_svg(chart);
  return trusted;
}

std::vector<Curve> dilation(const std::string& name, const Valve& valve) {
  Curve curve{name, valve, {}, {}};
  for (int percent = 0; percent <= 30; percent += 2) {
    Remodelling change;
    change.ap_dilation_percent = percent;
    curve.changes.push_back(change);
    curve.at.push_back(percent);
  }
  return {curve};
}

std::vector<Curve> displacement(const Valve& valve) {
  const Vec3 none = Vec3::Zero(), lateral(1, 0, 0), apical(0, 0, 1);
  struct Kind {
    const char* label;
    Vec3 anterolateral, posteromedial;
  };
  const std::array<Kind, 4> kinds = {
      {{"AL apical", apical, none},
       {"PM apical", none, apical},
       {"both apical", apical, apical},
       {"both lateral + apical", lateral + apical, lateral + apical}}};
  std::vector<Curve> curves;
  for (const Kind& kind : kinds) {
    Curve curve{kind.label, valve, {}, {}};
    for (double mm = 0.0; mm <= 6.0; mm += 0.5) {
      Remodelling change;
      change.anterolateral_mm = mm * kind.anterolateral;
      change.posteromedial_mm = mm * kind.posteromedial;
      curve.changes.push_back(change);
      curve.at.push_back(mm);
    }
    curves.push_back(curve);
  }
  return curves;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: %s DIRECTORY [PRESET...]\n", argv[0]);
    return 2;
  }
  const std::filesystem::path directory = argv[1];
  std::filesystem::create_directories(directory);
  std::vector<std::string> names(argv + 2, argv + argc);
  if (names.empty()) names = {"porcine-1", "human-normal"};
  bool trusted = true;
  std::vector<Curve> dilations;
  for (const std::string& name : names) {
    const Expected<Valve> valve = make_preset(name);
    if (!valve) {
      std::fprintf(stderr, "%s\n", valve.errors().front().message.c_str());
      return 2;
    }
    for (const Curve& curve : dilation(name, *valve)) dilations.push_back(curve);
    trusted &= draw(directory, "papillary-" + name,
                    {"Papillary displacement, " + name, "displacement, mm", "orifice, mm²", {}},
                    displacement(*valve));
  }
  trusted &=
      draw(directory, "ap-dilation",
           {"Annular dilation", "anteroposterior dilation, %", "orifice, mm²", {}}, dilations);
  if (!trusted) std::fprintf(stderr, "some closures did not converge or crossed: see the CSV\n");
  return trusted ? 0 : 3;
}
