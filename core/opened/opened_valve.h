// Opening a valve: the same model as for closing, under the pressure of filling instead of that of systole, with annulus and
// tips in diastole.
//
// Assumed: the whole difference of pressure acts on every leaflet, as if no blood flowed; opening areas at 2 and 5 mmHg differ by
// less than 5 %. The mean gradient is Gorlin's (1951, Am Heart J 41:1; constant 37.7), of the smaller of two areas: that of the
// narrowest passage, and what is open along the annulus's normal, by which blood comes. Measured at rest behind rings of 24 to
// 27 mm: 3.4 +- 1.6 mmHg (catheter, Circ J 2017;81:1832), 3.2 +- 1.2 (Grimaldi 2012).
#pragma once

#include "core/closure/closure.h"
#include "core/opened/diastole.h"
#include "core/valve/problem_list.h"

namespace coapt {

inline constexpr Range kFillingPressures_mmhg{1.0, 30.0}, kFillingFlows_ml_s{10.0, 1000.0},
    kExercises{1.0, 5.0};

struct OpeningOptions {
  double pressure_mmhg =
      5.0;  ///< atrium over ventricle; below 3 slack leaflets take ten times as long to settle
  double flow_ml_s = 155.0;  ///< mean over filling
  /// At exercise over rest: mean gradients 6.3 against 3.2 mmHg behind rings of 27 mm (Grimaldi 2012), which go as flow squared.
  double exercise = 1.4;
  bool motion = false;  ///< keep the states on the way (ClosureResult::motion_mm)
  ClosureBudget budget{};
};

struct OpeningMeasure {
  double opening_area_mm2 = 0.0;  ///< of the narrowest passage (funnel.h)
  double passage_depth_mm =
      0.0;                ///< where that is, below the annulus's centroid along the funnel's axis
  double tilt_deg = 0.0;  ///< of that axis from the annular plane's normal
  double projected_area_mm2 = 0.0;  ///< open in the atrial view, leaflets with their half thickness
  double annulus_area_mm2 = 0.0;    ///< in diastole, projected on its plane
  double gradient_mmhg = 0.0, gradient_exercise_mmhg = 0.0;  ///< mean, of the smaller area
};

/// The smaller of both areas, by which blood is held up; NaN if neither is known.
double opening_mm2(const OpeningMeasure& measure);

/// Areas are NaN, and there is no passage, where `closure` did not converge uncrossed.
struct OpenedValve {
  Valve valve;            ///< in diastole; its pressure is negative: from the atrium
  ClosureResult closure;  ///< its end is the open state
  OpeningMeasure measure;
  std::vector<Vec3> passage_mm;  ///< outline of the narrowest passage (FunnelPassage::outline_mm)
};

/// Errors: ranges of the options by pointer, or what in_diastole() says. @pre the valve is valid and mitral.
Expected<OpenedValve> open_valve(const Valve& valve, const OpeningOptions& options = {});

/// Mean gradient across an opening. @return infinite for none.
double gorlin_mmhg(double area_mm2, double flow_ml_s);

}  // namespace coapt
