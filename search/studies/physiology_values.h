// What a valve does in trials that bear on its physiology, in figures.
//
// A quantity comes from a trial: the valve as it is, or cut, loaded, ringed, opened, clipped. Trials are independent closures;
// whoever needs few quantities (calibrate_valve()) pays for their trials alone.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "core/closure/closure.h"
#include "search/studies/physiology_ranges.h"

namespace coapt {

/// Each is one to six closures or openings; that of Rest is always made.
enum class PhysiologyTrial { Rest, StrutsCut, Pressures, Rings, Opening, RingOpenings, Clips };
inline constexpr std::array kPhysiologyTrials = {
    PhysiologyTrial::Rest,  PhysiologyTrial::StrutsCut, PhysiologyTrial::Pressures,
    PhysiologyTrial::Rings, PhysiologyTrial::Opening,   PhysiologyTrial::RingOpenings,
    PhysiologyTrial::Clips};

/// NaN: not asked for, or a closure did not converge uncrossed, or the valve has no such part.
struct PhysiologyValues {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  // Rest
  double leak_mm2 = kUnknown;
  double coaptation_length_mm = kUnknown;  ///< of contact in the mid-valve section, A2 on P2
  double coaptation_height_mm = kUnknown;  ///< mean of nine sections
  double depth_hinge_mm =
      kUnknown;  ///< coaptation point below the line from saddle peak to mid-posterior
  double depth_plane_mm = kUnknown;  ///< the same point below the annulus's best-fit plane
  double tenting_area_mm2 = kUnknown;
  double strut_n = kUnknown;              ///< mean of the trunks
  double anterior_marginal_n = kUnknown;  ///< largest of the trunks
  double strut_over_marginal = kUnknown;
  double a2_marginal_n = kUnknown;  ///< mean of the trunks that hold A2
  double muscle_anterolateral_n = kUnknown, muscle_posteromedial_n = kUnknown;
  double muscle_share = kUnknown;  ///< their sum over pressure times the annulus's area
  /// Septal-lateral: what the tissue pulls the septal half and the lateral half of the annulus together with.
  double annular_force_n = kUnknown;
  double a2_radial_percent = kUnknown, a2_circumferential_percent = kUnknown,
         a2_areal_percent = kUnknown;
  double posterior_squeezed_share =
      kUnknown;  ///< of its area, squeezed by more than a tenth along its fibres
  double papillary_systole_mm = kUnknown;  ///< between the tips
  double papillary_diastole_mm = kUnknown;
  // StrutsCut
  double a2_marginal_cut_n = kUnknown;
  double struts_cut_ratio = kUnknown;  ///< of a2_marginal_n, after over before
  // Pressures
  double leak_60_mm2 = kUnknown, leak_90_mm2 = kUnknown, leak_200_mm2 = kUnknown;
  double leak_200_over_60 = kUnknown;
  // Rings, generic-classic
  double ring_40_mm2 = kUnknown, ring_38_mm2 = kUnknown, ring_36_mm2 = kUnknown,
         ring_34_mm2 = kUnknown, ring_32_mm2 = kUnknown, ring_30_mm2 = kUnknown;
  // Opening
  double opening_mm2 = kUnknown;
  double gradient_mmhg = kUnknown;
  // RingOpenings: rings of the valve's own shape, 0, 2 and 4 sizes below
  double opening_own_0_mm2 = kUnknown, opening_own_2_mm2 = kUnknown, opening_own_4_mm2 = kUnknown;
  double gradient_own_0_mmhg = kUnknown, gradient_own_2_mmhg = kUnknown,
         gradient_own_4_mmhg = kUnknown;
  double ring_opening_share = kUnknown;      ///< the widest behind a ring over that without
  double gradient_slope_mmhg_mm = kUnknown;  ///< a mm of size, from 0 to 4 sizes below
  // Clips
  double opening_clip_mm2 = kUnknown, opening_two_clips_mm2 = kUnknown;
  double clip_share = kUnknown;       ///< of the opening that one clip leaves
  double two_clips_share = kUnknown;  ///< of the opening behind one that two leave
  double clip_gradient_mmhg = kUnknown;

  bool unfinished = false;  ///< a closure or opening ended by its budget; its figures are unknown
};

struct PhysiologyOptions {
  std::vector<PhysiologyTrial> trials{kPhysiologyTrials.begin(), kPhysiologyTrials.end()};
  /// Left out: judged from the closed valve, see kind_of().
  std::optional<ValveKind> kind{};
  std::optional<Species> species{};  ///< left out: porcine if the valve's name says so, else human
  ClosureBudget budget{};            ///< of each closure
  int threads = 0;                   ///< 0: all cores; does not change the answer
  std::function<void(int, int)> progress{};  ///< trials made, planned; from one thread at a time
};

/// What a valve does, without judging it. @pre the valve is valid and mitral.
PhysiologyValues physiology_values(const Valve& valve, const PhysiologyOptions& options = {});

}  // namespace coapt
