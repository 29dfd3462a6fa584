#include "lab/twins/twin_table.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <sstream>

#include "core/metrics/quantile.h"

namespace coapt {
namespace {

constexpr double kNinety = 1.6449;  // standard deviations to either side that hold 90 %

/// Fits of one kind of quantity: errors in its unit, how many lie within the interval.
struct Judged {
  std::vector<double> errors;
  int within = 0, identifiable = 0;
  void add(double error, double sd, bool is_identifiable) {
    errors.push_back(std::abs(error));
    within += std::abs(error) <= kNinety * sd ? 1 : 0;
    identifiable += is_identifiable ? 1 : 0;
  }
};

/// "slack", "tip", "prestretch", "stiffness", "hidden".
std::string kind_of(const std::string& name) { return name.substr(0, name.find('_')); }

std::string share(int part, std::size_t whole) {
  return std::to_string(std::lround(100.0 * part / static_cast<double>(whole))) + " %";
}

void print_half(std::ostream& out, const std::vector<const Twin*>& twins) {
  std::map<std::string, Judged> kinds;
  std::vector<double> nodes, surface, points;
  Judged all;
  for (const Twin* twin : twins) {
    nodes.push_back(twin->node_rms_mm);
    surface.push_back(twin->surface_rms_mm);
    points.push_back(twin->rms_mm);
    for (const TwinParameter& p : twin->parameters) {
      const double error = p.fitted.value - p.truth;
      kinds[kind_of(p.fitted.parameter.name)].add(error, p.fitted.sd, p.fitted.identifiable);
      all.add(error, p.fitted.sd, p.fitted.identifiable);
    }
    kinds["leak"].add(twin->fitted_leak.mm2 - twin->leak_mm2, twin->fitted_leak.sd_mm2, true);
  }
  const auto spread = [](const std::vector<double>& values) {
    std::ostringstream text;
    text << "median " << quantile(values, 0.5) << ", p90 " << quantile(values, 0.9) << ", max "
         << *std::max_element(values.begin(), values.end());
    return text.str();
  };
  out << twins.size() << " twins\n  nodes, mm: " << spread(nodes)
      << "\n  surface, mm: " << spread(surface) << "\n  points, mm: " << spread(points) << '\n';
  for (const auto& [name, judged] : kinds)
    out << "  " << name << ": error " << spread(judged.errors) << "; "
        << share(judged.within, judged.errors.size()) << " within the 90 % interval; "
        << share(judged.identifiable, judged.errors.size()) << " identifiable\n";
  out << "  all parameters: " << share(all.within, all.errors.size())
      << " within the 90 % interval\n";
}

}  // namespace

std::string twins_csv(const std::vector<Twin>& twins) {
  std::ostringstream csv;
  csv << "twin,quantity,unit,prior,prior_sd,truth,value,sd,identifiable\n";
  for (const Twin& twin : twins) {
    for (const TwinParameter& p : twin.parameters) {
      const FitParameter& of = p.fitted.parameter;
      csv << twin.number << ',' << of.name << ',' << of.unit << ',' << of.prior << ','
          << of.prior_sd << ',' << p.truth << ',' << p.fitted.value << ',' << p.fitted.sd << ','
          << (p.fitted.identifiable ? "true" : "false") << '\n';
    }
    csv << twin.number << ",leak,mm2," << twin.leak_before_mm2 << ",," << twin.leak_mm2 << ','
        << twin.fitted_leak.mm2 << ',' << twin.fitted_leak.sd_mm2 << ",\n";
    csv << twin.number << ",nodes,mm," << twin.node_rms_before_mm << ",,0," << twin.node_rms_mm
        << ",,\n";
    csv << twin.number << ",surface,mm,,,0," << twin.surface_rms_mm << ",,\n";
    csv << twin.number << ",rounds,1,,,," << twin.rounds << ",,\n";
    csv << twin.number << ",independent_points,1,,," << twin.points << ','
        << twin.independent_points << ",,\n";
    csv << twin.number << ",points,mm," << twin.rms_before_mm << ",,," << twin.rms_mm << ",,\n";
  }
  return csv.str();
}

void print_halves(
    std::ostream& out, const std::vector<Twin>& twins,
    const std::function<void(std::ostream&, const std::vector<const Twin*>&)>& print_half) {
  for (const int odd : {0, 1}) {
    std::vector<const Twin*> half;
    for (const Twin& twin : twins)
      if (twin.number % 2 == odd) half.push_back(&twin);
    if (half.empty()) continue;
    out << (odd == 1 ? "odd: " : "even: ");
    print_half(out, half);
  }
}

void print_twins(std::ostream& out, const std::vector<Twin>& twins) {
  print_halves(out, twins, print_half);
}

}  // namespace coapt
