// The value of information: which measurement of a valve would say most of a leak, as it is or repaired.
//
// Of draws of the model (model_draw.h) each has a leak, and figures that a measurement would show of it, the unrepaired valve. What a
// measurement removes of the leak's variance is 1 - E[Var(leak | measured)] / Var(leak). Each draw is measured four times, with errors by
// seed, and its leak is predicted from the others in two ways: by their mean as they would weigh then, which knows every shape of the
// relation but needs draws that agree, and by a polynomial of second degree in the figures, fitted by weighted least squares, which
// needs few. The squares of what is left over are at least the conditional variance in the mean, so the way that leaves less counts.
// Draws count as they weigh by what was observed already: a second look at the same figure says little more.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/metrics/measure.h"
#include "search/conditioning.h"

namespace coapt {

/// Tenting height and area, mean height of coaptation: what a surface would show.
using ShapeFigures = std::array<double, 3>;
ShapeFigures shape_figures(const ValveMeasure& measure);

/// One that is to be trusted, repaired and not.
struct InformedDraw {
  double leak_mm2 = 0.0;       ///< of the valve that is asked for
  double weight = 0.0;         ///< > 0, in any unit
  std::vector<double> shares;  ///< order of model_parameters()
  ModelFigures figures{};      ///< of the unrepaired valve, as closed_shape
  ShapeFigures closed_shape{};
};

struct InformationRow {
  std::string measurement;
  double share_removed = 0.0;  ///< of the leak's variance, [0, 1]; NaN of too few draws
  double remaining_mm2 = 0.0;  ///< standard deviation of the leak that would be left
};

/// Most telling first. @param effective draws that would say as much if they weighed alike (Conditioning)
std::vector<InformationRow> information_rows(const std::vector<InformedDraw>& draws,
                                             double effective);

}  // namespace coapt
