#include "clients/cli/print.h"

#include <algorithm>
#include <iomanip>
#include <ostream>

#include "io/picture/text.h"
#include "search/plans/objective.h"

namespace coapt {
namespace {

constexpr double kSmallestListed_mm2 = 0.05;  // less is shown as 0.0

std::ostream& row(std::ostream& out, const char* label) {
  return out << "  " << std::left << std::setw(16) << label << std::right;
}

const char* crossing_words(bool crossing) { return crossing ? "leaflets cross" : "no crossing"; }

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

}  // namespace coapt
