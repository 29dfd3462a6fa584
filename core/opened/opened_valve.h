// Opening a valve: the same model as for closing, under the load of filling instead of that of systole, with annulus and tips in
// diastole.
//
// Load: at the peak of filling blood passes at kPeakOverMean times the mean flow; what it needs drives the leaflets apart, and less
// of it acts where the funnel narrows (flow_load.h). Load and shape are found in turns, each shape from the one before, until the
// jet changes by less than kSettled. At half the flow seven presets open 8 to 13 % less, at double the flow 4 to 14 % more; where
// marginal chordae are ruptured, 17 % less (human-p2-prolapse).
// Flow: a human's 155 ml/s in the mean; less in proportion to the annulus where that is smaller (filling_flow_ml_s()).
// Opening: the least surface between atrium and ventricle (core/metrics/leak.h). The mean gradient is Bernoulli's over the pulse of
// filling, through a jet that contracts as in Gorlin's constant (1951, Am Heart J 41:1; 37.7 = 0.85 x 44.3): of the areas before and
// after a clip, 6.0 and 3.6 cm2, it makes 1.1 and 3.0 mmHg, measured 1.7 and 4.1 +- 2.2 (Herrmann 2009). Behind rings of 24 to 27 mm
// 3.4 +- 1.6 mmHg were measured at rest (catheter, Circ J 2017;81:1832), 3.2 +- 1.2 (Grimaldi 2012).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/closure/closure.h"
#include "core/metrics/leak.h"
#include "core/opened/diastole.h"
#include "core/valve/problem_list.h"

namespace coapt {

inline constexpr Range kFillingPressures_mmhg{1.0, 30.0}, kFillingFlows_ml_s{10.0, 1000.0},
    kExercises{1.0, 5.0};
/// Of the flow of filling: 450 ml/s at its peak (assumed) over 155 in the mean (a stroke of 70 ml in 0.45 s).
inline constexpr double kPeakOverMean = 450.0 / 155.0;

struct OpeningOptions {
  /// Atrium over ventricle at the peak of filling; none: what the flow needs.
  std::optional<double> pressure_mmhg = {};
  std::optional<double> flow_ml_s = {};  ///< mean over filling; none: filling_flow_ml_s()
  /// At exercise over rest: mean gradients 6.3 against 3.2 mmHg behind rings of 27 mm (Grimaldi 2012), which go as flow squared.
  double exercise = 1.4;
  bool motion = false;  ///< keep the states on the way (ClosureResult::motion_mm)
  ClosureBudget budget{};
};

struct OpeningMeasure {
  double opening_area_mm2 = 0.0;    ///< the least surface (core/metrics/leak.h)
  double projected_area_mm2 = 0.0;  ///< open in the atrial view, leaflets with their half thickness
  double annulus_area_mm2 = 0.0;    ///< in diastole, projected on its plane
  double gradient_mmhg = 0.0, gradient_exercise_mmhg = 0.0;  ///< mean
  double flow_ml_s = 0.0, flow_exercise_ml_s = 0.0;          ///< mean over filling
  double pressure_mmhg = 0.0;  ///< atrium over ventricle, at the peak of filling
  double tied_n = 0.0;         ///< sum of what ties bear
};

/// Areas are NaN where `closure` did not converge uncrossed.
struct OpenedValve {
  Valve valve;  ///< in diastole; its pressure is negative: from the atrium
  ClosureResult
      closure;  ///< its end is the open state; steps and motion are of all on the way to it
  OpeningMeasure measure;
  Leak leak;  ///< that of opening_area_mm2, with its openings: two behind a clip
};

/// Errors: ranges of the options by pointer, or what in_diastole() says. @pre the valve is valid and mitral.
Expected<OpenedValve> open_valve(const Valve& valve, const OpeningOptions& options = {});

/// What its figures should be read with, in sentences: ties that bear more than kMostTied_n; an annulus in diastole that is not
/// kHealthyAnnulus_mm2, times the size of the heart, where nothing but healthy systole was asked for.
std::vector<std::string> opening_warnings(const OpenedValve& opened);

/// Of all ties; all that filling does to the annulus's area is hardly more (8.6 cm2 at 10 mmHg: 1.1 N).
inline constexpr double kMostTied_n = 1.0;
/// Controls 8.7 cm2 (Aquila 2016, Medicine 95:e5387), a tenth about it.
inline constexpr Range kHealthyAnnulus_mm2{800.0, 950.0};

/// Mean flow of filling at rest through a heart of the valve's size. Valve areas and cardiac output grow with body surface, speeds
/// do not (496 children; Sluysmans and Colan 2005, J Appl Physiol 99:445): 155 ml/s, or less in proportion to the area of the
/// unstressed annulus, which no ring changes, where that is below kHumanAnnulus_mm2.
double filling_flow_ml_s(const Valve& valve);

/// Mean gradient across an opening through which so much flows in the mean, in a pulse (half a sine) with kPeakOverMean: the mean of
/// its square is pi / 4 x kPeakOverMean times the square of its mean. @return infinite for no opening.
double mean_gradient_mmhg(double area_mm2, double flow_ml_s);

}  // namespace coapt
