#include "lab/charts/tables.h"

#include <cmath>
#include <sstream>

namespace coapt {

std::string ablation_csv(const std::vector<AblationOutcome>& outcomes) {
  std::ostringstream csv;
  csv << "group,change,scene,status,crossing,attempts,compared,full_leak_mm2,leak_change_mm2,"
         "rms_mm,seconds,time_ratio\n";
  for (const AblationOutcome& o : outcomes)
    csv << o.group << ',' << o.change << ',' << o.scene << ',' << to_string(o.status) << ','
        << (o.crossing ? "true" : "false") << ',' << o.attempts << ','
        << (o.compared ? "true" : "false") << ',' << o.full_leak_mm2 << ',' << o.leak_change_mm2
        << ',' << o.rms_mm << ',' << o.seconds << ',' << o.time_ratio << '\n';
  return csv.str();
}

std::string accuracy_csv(const std::vector<AccuracyPoint>& points) {
  std::ostringstream csv;
  csv << "scene,method,membrane,triangles,tolerance,status,crossing,seconds,rms_mm,max_mm,"
         "leak_error_mm2,own_rms_mm,own_leak_error_mm2\n";
  for (const AccuracyPoint& p : points)
    csv << p.scene << ',' << to_string(p.of.method) << ',' << to_string(p.of.membrane) << ','
        << p.triangles << ',' << p.of.tolerance << ',' << to_string(p.status) << ','
        << (p.crossing ? "true" : "false") << ',' << p.seconds << ',' << p.rms_mm << ',' << p.max_mm
        << ',' << p.leak_error_mm2 << ',' << p.own_rms_mm << ',' << p.own_leak_error_mm2 << '\n';
  return csv.str();
}

std::string stability_csv(const std::vector<StabilityCell>& cells) {
  std::ostringstream csv;
  const auto add = [&](double value) {
    csv << ',';
    if (std::isfinite(value)) csv << value;
  };
  csv << "scene,axis,level,nominal,method,outcome,steps,seconds,residual,crossing_pairs,attempts,"
         "from_reference_mm,end_from_reference_mm,leak_difference_mm2\n";
  for (const StabilityCell& c : cells) {
    csv << c.scene << ',' << to_string(c.axis) << ',' << c.level << ','
        << (c.nominal ? "true" : "false") << ',' << c.method << ',' << to_string(c.outcome) << ','
        << c.steps << ',' << c.seconds;
    add(c.residual);
    csv << ',' << c.crossing_pairs << ',' << c.attempts;
    add(c.from_reference_mm);
    add(c.end_from_reference_mm);
    add(c.leak_difference_mm2);
    csv << '\n';
  }
  return csv.str();
}

}  // namespace coapt
