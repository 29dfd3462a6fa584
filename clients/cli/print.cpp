#include "clients/cli/print.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>

#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr double kSmallestListed_mm2 = 0.05;  // less is shown as 0.0

std::ostream& row(std::ostream& out, const char* label) {
  return out << "  " << std::left << std::setw(16) << label << std::right;
}

const char* crossing_words(bool crossing) { return crossing ? "leaflets cross" : "no crossing"; }

std::string known(double value) { return std::isnan(value) ? "-" : fixed(value, 1); }

void print_plan(std::ostream& out, const RankedPlan& plan) {
  const OrificeStatistics& leak = plan.leak_mm2;
  out << std::setw(4) << plan.rank << std::setw(9) << fixed(plan.orifice_area_mm2.nominal, 1)
      << std::setw(6) << fixed(plan.measure.coaptation.gap_area_mm2, 1) << std::setw(9)
      << known(leak.mean) << std::setw(6) << known(leak.sd) << std::setw(7) << known(leak.worst)
      << std::setw(15) << fixed(plan.measure.coaptation.height_mean_mm, 1) << std::setw(11)
      << fixed(plan.measure.tension_max_n, 2) << '\n';
  for (const std::string& step : plan.description) out << "      " << printable(step) << '\n';
  if (plan.plan.steps.empty()) out << "      no repair\n";
  if (plan.status != ClosureStatus::Converged || plan.crossing) {
    out << "      ! " << to_string(plan.status) << ", " << crossing_words(plan.crossing) << '\n';
  }
  for (const std::string& warning : plan.warnings) out << "      ! " << warning << '\n';
}

}  // namespace

void print_closure(std::ostream& out, const std::string& name, const ClosureResult& closure) {
  out << printable(name) << ": " << to_string(closure.status) << " after " << closure.steps
      << " steps, residual " << fixed(closure.residual, 4) << ", "
      << crossing_words(closure.crossing) << '\n';
  if (closure.attempts.size() < 2) return;
  for (const ClosureAttempt& attempt : closure.attempts)
    out << "  tried " << attempt.how << ": " << to_string(attempt.status) << " after "
        << attempt.steps << " steps, " << attempt.crossing_pairs << " crossings\n";
}

void print_measure(std::ostream& out, const ValveMeasure& measure) {
  const OrificeMeasure& orifice = measure.orifice;
  const Coaptation& coaptation = measure.coaptation;
  const double hidden = coaptation.gap_area_mm2 - orifice.area_mm2;
  row(out, "leak") << fixed(leak_mm2(measure), 1) << " mm2, the larger of orifice and gap";
  if (hidden > kCompetentLeak_mm2) {
    out << "; the view from the atrium hides " << fixed(hidden, 1) << " mm2 of it";
  }
  out << '\n';
  row(out, "orifice") << fixed(orifice.area_mm2, 1) << " mm2 (raw "
                      << fixed(orifice.area_raw_mm2, 1) << ", mean of end states "
                      << fixed(orifice.area_mean_mm2, 1) << ")\n";
  for (const Orifice& opening : orifice.orifices) {
    if (opening.area_mm2 < kSmallestListed_mm2) continue;
    row(out, "") << fixed(opening.area_mm2, 1) << " mm2 at " << to_string(opening.segment) << '\n';
  }
  row(out, "gap") << fixed(coaptation.gap_area_mm2, 1) << " mm2 between the leaflets, up to "
                  << fixed(coaptation.distance_max_mm, 2)
                  << " mm from mid-surface to mid-surface\n";
  const auto touching = std::count_if(coaptation.sections.begin(), coaptation.sections.end(),
                                      [](const CoaptationSection& s) { return s.contact; });
  row(out, "coaptation") << "height min " << fixed(coaptation.height_min_mm, 1) << ", mean "
                         << fixed(coaptation.height_mean_mm, 1) << " mm; contact at " << touching
                         << " of " << coaptation.sections.size() << " sections\n";
  const AnnulusMeasure& annulus = measure.annulus;
  row(out, "annulus") << "AP " << fixed(annulus.ap_mm, 1) << ", AL-PM "
                      << fixed(annulus.al_pm_mm, 1) << ", circumference "
                      << fixed(annulus.circumference_mm, 1) << ", saddle "
                      << fixed(annulus.saddle_height_mm, 1) << " mm; area "
                      << fixed(annulus.area_mm2, 0) << " mm2\n";
  row(out, "tenting") << "height " << fixed(measure.tenting_height_mm, 1) << " mm, area "
                      << fixed(measure.tenting_area_mm2, 0) << " mm2\n";
  row(out, "chordae") << "peak tension " << fixed(measure.tension_max_n, 2) << " N, sum "
                      << fixed(measure.tension_sum_n, 1) << " N\n";
  row(out, "leaflet strain") << "circumferential "
                             << fixed(100.0 * measure.strain_circumferential_max, 1)
                             << " %, radial " << fixed(100.0 * measure.strain_radial_max, 1)
                             << " %\n";
}

void print_oblique(std::ostream& out, const ObliqueOrifice& widest) {
  row(out, "widest passage") << fixed(widest.area_mm2, 1) << " mm2, " << fixed(widest.tilt_deg, 0)
                             << " degrees from the annulus's normal, azimuth "
                             << fixed(widest.azimuth_deg, 0) << " (0 posteromedial, 90 anterior)\n";
}

void print_ranked(std::ostream& out, const SearchResult& result) {
  out << "Before: orifice " << fixed(result.before.orifice.area_mm2, 1)
      << " mm2, gap between the leaflets " << fixed(result.before.coaptation.gap_area_mm2, 1)
      << " mm2, coaptation " << fixed(result.before.coaptation.height_mean_mm, 1) << " mm, "
      << to_string(result.before_status) << ", " << crossing_words(result.before_crossing)
      << "\n\n";
  if (result.plans.empty()) {
    out << "no plan yet\n";
  } else {
    out << "      orifice   gap   leak over the region    coaptation    tension\n"
        << "rank      mm2   mm2     mean    sd  worst             mm          N\n";
  }
  for (const RankedPlan& plan : result.plans) print_plan(out, plan);
  out << '\n'
      << result.closures << " closures (" << result.closures_not_converged << " not converged, "
      << result.closures_crossed << " crossed) in " << fixed(result.seconds, 1) << " s\n";
}

}  // namespace coapt
