#include "io/picture/fit_picture.h"

#include "core/closure/standing.h"
#include "io/picture/distance_map.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

std::string words(const FittedParameter& fitted) {
  const int digits = fitted.parameter.unit == "mm" ? 2 : 3;
  return fitted.parameter.name + ' ' + fixed(fitted.value, digits) + " ± " +
         fixed(fitted.sd, digits) + (fitted.parameter.unit == "mm" ? " mm" : "");
}

/// What a fit with ruptures decided: "; marginal chordae of P2 assumed ruptured (probability 0.99)".
std::string lesion_words(const ValveFit& fit) {
  for (const FitHypothesis& of : fit.hypotheses)
    if (of.name == fit.taken) {
      const std::string lesion =
          of.name == "intact" ? "chordae as in the valve file"
                              : "marginal chordae of " + of.name.substr(9) + " assumed ruptured";
      return "; " + lesion + " (probability " + fixed(of.probability, 2) + ')';
    }
  return "";
}

}  // namespace

std::string fit_map_png(const LeafletMesh& surface, const ValveFit& fit, MeasuredSide side,
                        const std::string& name) {
  const std::vector<double> distances =
      signed_distances_mm(surface.vertices_mm, surface_of(fit.closed), side);
  return distance_map_png(
      {surface.vertices_mm, surface.faces, distances, round_range_mm(2.0 * fit.rms_mm),
       name + " compared with the fitted valve",
       "rms " + fixed(fit.rms_mm, 3) + " mm; research software, not a medical device",
       doubt_about(fit.closed.closure)});
}

std::string fit_sentence(const ValveFit& fit, const std::string& name) {
  std::string text = "fitted to " + name + ": distances " + fixed(fit.rms_before_mm, 2) +
                     " mm rms before, " + fixed(fit.rms_mm, 2) + " mm after" + lesion_words(fit);
  for (const FittedParameter& fitted : fit.parameters) text += "; " + words(fitted);
  return text;
}

}  // namespace coapt
