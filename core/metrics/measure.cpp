#include "core/metrics/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/metrics/area_error.h"
#include "core/metrics/leak_estimate.h"
#include "core/metrics/loads.h"
#include "core/metrics/quantile.h"

namespace coapt {
namespace {

constexpr double kStrainQuantile = 0.99;  // leaves out the few faces that a coarse mesh distorts

/// Of a closure that flew apart only the annulus can be measured.
void set_unknown(ValveMeasure& measure) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  Coaptation& coaptation = measure.coaptation;
  for (std::size_t i = 0; i < coaptation.sections.size(); ++i) {
    CoaptationSection& section = coaptation.sections[i];
    section = {};
    section.along = 0.1 * static_cast<double>(i + 1);
    section.height_mm = section.distance_mm = kUnknown;
  }
  coaptation.height_min_mm = coaptation.height_mean_mm = coaptation.height_p10_mm = kUnknown;
  coaptation.distance_max_mm = kUnknown;
  measure.tenting_height_mm = measure.tenting_area_mm2 = kUnknown;
  measure.tension_max_n = measure.tension_sum_n = kUnknown;
  measure.strain_circumferential_max = measure.strain_radial_max = kUnknown;
}

bool is_finite(const ClosureResult& closure) {
  bool finite = closure.closed_mm.allFinite();
  for (const Points& sample_mm : closure.samples_mm) finite = finite && sample_mm.allFinite();
  return finite;
}

Leak leak_of(const Valve& valve, const Points& closed_mm, LeakBy leak_by) {
  if (leak_by == LeakBy::Surface) return measure_leak(valve, closed_mm);
  Leak leak;
  leak.area_mm2 = estimate_leak_mm2(valve, closed_mm);
  return leak;
}

}  // namespace

ValveMeasure measure(const Valve& valve, const ClosureResult& closure, LeakBy leak_by) {
  ValveMeasure measure;
  measure.annulus = measure_annulus(valve);
  if (!is_finite(closure)) {
    set_unknown(measure);
    return measure;
  }
  measure.leak = leak_of(valve, closure.closed_mm, leak_by);
  if (is_mitral(valve)) {
    measure.coaptation = measure_coaptation(valve, closure.closed_mm);
    const Tenting tenting = measure_tenting(valve, closure.closed_mm);
    measure.tenting_height_mm = tenting.height_mm;
    measure.tenting_area_mm2 = tenting.area_mm2;
    if (tenting.contact) {
      measure.anterior_length_mm = tenting.anterior_mm;
      measure.posterior_length_mm = tenting.posterior_mm;
    }
  } else {
    set_unknown(measure);
    measure.leaflets = measure_leaflets(valve, closure.closed_mm);
  }

  const ChordaeTension tension = chordae_tension(valve, closure.tension_n);
  measure.tension_max_n = tension.max_n;
  measure.tension_sum_n = tension.sum_n;

  std::vector<double> circumferential, radial;
  for (const FaceStrain& strain : face_strains(valve, closure.closed_mm)) {
    circumferential.push_back(strain.circumferential);
    radial.push_back(strain.radial);
  }
  measure.strain_circumferential_max = quantile(std::move(circumferential), kStrainQuantile);
  measure.strain_radial_max = quantile(std::move(radial), kStrainQuantile);
  if (is_mitral(valve) && trusted(closure))
    measure.leak_error_mm2 = area_error_mm2(measure.leak.area_mm2, precision_of(valve, closure));
  return measure;
}

double coaptation_a2_p2_mm(const ValveMeasure& measure) {
  const auto& sections = measure.coaptation.sections;
  return (sections[3].height_mm + sections[4].height_mm + sections[5].height_mm) / 3.0;
}

double leaflet_ratio(const ValveMeasure& measure) {
  return measure.anterior_length_mm / measure.posterior_length_mm;
}

}  // namespace coapt
