#include "core/metrics/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/metrics/area_error.h"
#include "core/metrics/loads.h"
#include "core/metrics/quantile.h"

namespace coapt {
namespace {

constexpr double kStrainQuantile = 0.99;  // leaves out the few faces that a coarse mesh distorts

/// Of a closure that flew apart only the annulus can be measured.
void set_unknown(ValveMeasure& measure) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  measure.orifice.area_mm2 = measure.orifice.area_raw_mm2 = measure.orifice.area_mean_mm2 =
      kUnknown;
  Coaptation& coaptation = measure.coaptation;
  for (std::size_t i = 0; i < coaptation.sections.size(); ++i) {
    CoaptationSection& section = coaptation.sections[i];
    section = {};
    section.along = 0.1 * static_cast<double>(i + 1);
    section.height_mm = section.distance_mm = kUnknown;
  }
  coaptation.height_min_mm = coaptation.height_mean_mm = coaptation.height_p10_mm = kUnknown;
  coaptation.distance_max_mm = coaptation.gap_area_mm2 = kUnknown;
  measure.tenting_height_mm = measure.tenting_area_mm2 = kUnknown;
  measure.tension_max_n = measure.tension_sum_n = kUnknown;
  measure.strain_circumferential_max = measure.strain_radial_max = kUnknown;
}

bool is_finite(const ClosureResult& closure) {
  bool finite = closure.closed_mm.allFinite();
  for (const Points& sample_mm : closure.samples_mm) finite = finite && sample_mm.allFinite();
  return finite;
}

AreaErrors errors_of(const Valve& valve, const ClosureResult& closure,
                     const ValveMeasure& measure) {
  AreaErrors errors;
  if (!is_mitral(valve) || !trusted(closure)) return errors;
  const AreaPrecision precision = precision_of(valve, closure);
  errors.orifice_mm2 = area_error_mm2(measure.orifice.area_mm2, precision);
  errors.gap_mm2 = area_error_mm2(measure.coaptation.gap_area_mm2, precision);
  errors.leak_mm2 = area_error_mm2(leak_mm2(measure), precision);
  return errors;
}

}  // namespace

ValveMeasure measure(const Valve& valve, const ClosureResult& closure) {
  ValveMeasure measure;
  measure.annulus = measure_annulus(valve);
  if (!is_finite(closure)) {
    set_unknown(measure);
    return measure;
  }
  if (is_mitral(valve)) {
    measure.orifice = measure_orifice(valve, closure);
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
    measure.orifice = measure_orifice(valve, closure);
    measure.orifice.orifices.clear();  // they are named by mitral segments
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
  measure.error = errors_of(valve, closure, measure);
  return measure;
}

double leak_mm2(const ValveMeasure& measure) {
  if (!measure.leaflets.empty()) return measure.orifice.area_mm2;
  return leak_mm2(measure.orifice.area_mm2, measure.coaptation.gap_area_mm2);
}

double leak_mm2(double orifice_mm2, double gap_mm2) {
  if (std::isnan(orifice_mm2) || std::isnan(gap_mm2))
    return std::numeric_limits<double>::quiet_NaN();
  return std::max(orifice_mm2, gap_mm2);
}

}  // namespace coapt
