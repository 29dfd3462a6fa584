#include "lab/twins/rupture_table.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <sstream>

#include "core/metrics/quantile.h"
#include "lab/twins/twin_table.h"

namespace coapt {
namespace {

/// Medians over some twins.
struct RuptureErrors {
  std::vector<double> rms_intact_mm, rms_mm, leak_intact_mm2, leak_mm2, surface_mm;
};

void print_errors(std::ostream& out, const char* of, const RuptureErrors& errors) {
  if (errors.rms_mm.empty()) return;
  const auto median = [](const std::vector<double>& values) { return quantile(values, 0.5); };
  out << "  " << of << ": rms of points " << median(errors.rms_intact_mm) << " mm intact, "
      << median(errors.rms_mm) << " mm taken (largest "
      << *std::max_element(errors.rms_mm.begin(), errors.rms_mm.end()) << "); error of the leak "
      << median(errors.leak_intact_mm2) << " mm2 intact, " << median(errors.leak_mm2)
      << " mm2 taken; from the twin's surface " << median(errors.surface_mm) << " mm\n";
}

void print_rupture_half(std::ostream& out, const std::vector<const Twin*>& twins) {
  int ruptured = 0, found = 0, elsewhere = 0, missed = 0, intact = 0, invented = 0,
      right_refitted = 0;
  RuptureErrors of_ruptured, of_intact;
  for (const Twin* twin : twins) {
    const bool right = twin->taken == twin->lesion;
    if (twin->lesion == "intact") {
      ++intact;
      invented += right ? 0 : 1;
    } else {
      ++ruptured;
      found += right ? 1 : 0;
      missed += twin->taken == "intact" ? 1 : 0;
      elsewhere += !right && twin->taken != "intact" ? 1 : 0;
      right_refitted += std::any_of(twin->hypotheses.begin(), twin->hypotheses.end(),
                                    [&](const FitHypothesis& hypothesis) {
                                      return hypothesis.refitted && hypothesis.name == twin->lesion;
                                    })
                            ? 1
                            : 0;
    }
    RuptureErrors& errors = twin->lesion == "intact" ? of_intact : of_ruptured;
    const FitHypothesis& whole = twin->hypotheses.front();
    errors.rms_intact_mm.push_back(whole.rms_mm);
    errors.rms_mm.push_back(twin->rms_mm);
    errors.leak_intact_mm2.push_back(std::abs(whole.leak_mm2 - twin->leak_mm2));
    errors.leak_mm2.push_back(std::abs(twin->fitted_leak.mm2 - twin->leak_mm2));
    errors.surface_mm.push_back(twin->surface_rms_mm);
  }
  out << ruptured << " ruptured: " << found << " found, " << elsewhere << " taken for another one, "
      << missed << " for intact; the right one was refitted in " << right_refitted << ". " << intact
      << " intact: " << invented << " taken for ruptured\n";
  print_errors(out, "ruptured", of_ruptured);
  print_errors(out, "intact", of_intact);
}

}  // namespace

std::string ruptures_csv(const std::vector<Twin>& twins) {
  std::ostringstream csv;
  csv << "twin,lesion,hypothesis,taken,refitted,probability,objective,rms_mm,leak_mm2,twin_leak_"
         "mm2,"
         "surface_rms_mm\n";
  const auto yes = [](bool is) { return is ? "true" : "false"; };
  for (const Twin& twin : twins)
    for (const FitHypothesis& of : twin.hypotheses) {
      const bool taken = of.name == twin.taken;
      csv << twin.number << ',' << twin.lesion << ',' << of.name << ',' << yes(taken) << ','
          << yes(of.refitted) << ',' << of.probability << ',' << of.objective << ',' << of.rms_mm
          << ',' << of.leak_mm2 << ',' << twin.leak_mm2 << ',';
      if (taken) csv << twin.surface_rms_mm;
      csv << '\n';
    }
  return csv.str();
}

void print_ruptures(std::ostream& out, const std::vector<Twin>& twins) {
  print_halves(out, twins, print_rupture_half);
}

}  // namespace coapt
