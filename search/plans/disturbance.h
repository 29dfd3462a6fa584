// What may come between a plan and the valve that it leaves: sutures tied a little long or short,
// tips that come to lie elsewhere, a ventricle that goes on remodelling. Every plan is closed under
// the same disturbances, each known by its index, so that costs are compared over equal ones.
#pragma once

#include <vector>

#include "core/repair/plan.h"
#include "search/perturbation.h"

namespace coapt {

inline constexpr int kRingSutureCount = 12;

/// Of sewing a ring and tying neochordae. Assumed, for want of measurements of surgeons.
struct SewingError {
  double shift_transverse_mm = 0.0, shift_anterior_mm = 0.0;  ///< of the ring in its plane
  double turn_deg = 0.0;                                      ///< of the ring about its normal
  /// Where around the annulus, from the saddle peak as Valve::annulus goes, one of the ring's kRingSutureCount sutures has torn out: the annulus
  /// between its neighbours goes back to where it was. [0, 1), negative: all hold.
  double torn_out = -1.0;
  double neochorda_mm = 0.0;  ///< by which all of them are too long

  bool operator==(const SewingError&) const = default;
};

struct Disturbance {
  Perturbation anterolateral, posteromedial;
  /// How far tips go outwards, backwards and apically. A taut suture holds: a tip goes no
  /// further from its anchor than it was.
  Vec3 remodelling_mm = Vec3::Zero();
  double anterolateral_share = 1.0;  ///< of it, by which that muscle goes
  double annular_growth_mm = 0.0;    ///< of the anteroposterior diameter; a ring holds it
  SewingError sewing{};
};

/// Indices [first, first + count) into disturbances().
struct DisturbanceSet {
  int first = 0, count = 0;
};

/// The whole region of interest (perturbation.h): both muscles take the same node, mirrored, for
/// remodelling is global. Index 0 is the plan as planned; the first n stand for all.
inline constexpr DisturbanceSet kRegion = {0, 1089};
/// One muscle alone, 9 suture lengths x 11 angles outwards, see slice_node(): the other stays.
inline constexpr DisturbanceSet kAnterolateralAlone = {1089, 98};
inline constexpr DisturbanceSet kPosteromedialAlone = {1187, 98};
/// All that is done, each with an error of its own: two muscles at nodes of their own, each at the
/// region's nodes 1 to 64 once, uncorrelated; a ring up to 1.5 mm off and turned by up to 5 degrees, a suture of it torn out in a quarter;
/// neochordae up to 1 mm wrong.
inline constexpr DisturbanceSet kIndependent = {1285, 64};
/// Rays of further remodelling, see remodelling_rays().
inline constexpr DisturbanceSet kRemodelling = {1349, 24};
/// How disease goes on, see disease_courses().
inline constexpr DisturbanceSet kDisease = {1373, 24};
inline constexpr int kDisturbances = 1397;

const std::vector<Disturbance>& disturbances();

/// Axes of the region: -1 to 1 mm, -5 to 5 degrees twice.
inline constexpr int kRegionLengths = 9, kRegionAngles = 11;
inline constexpr double kRegionLength_mm = 1.0, kRegionAngle_deg = 5.0;
/// How far errors of the sutures go, of the worse muscle: 0 none, 1 at the border of the region.
/// Remodelling does not count.
double region_share(const Disturbance& disturbance);
/// Index of a region's node by its place on the grid: length, outwards, posterior.
int region_node(int length, int outwards, int posterior);
/// Index of a node of the slice of one muscle alone by its place there; the middle is index 0.
int slice_node(Side side, int length, int outwards);

struct RemodellingRay {
  const char* direction;     ///< "apical", "outwards", "posterior", "all three"
  std::vector<int> indices;  ///< 7, at 0, 1, ... 6 mm
};
const std::vector<RemodellingRay>& remodelling_rays();

/// Disease that goes on, tips and annulus together, as it may do: eight courses, a fractional factorial design (2^(5-2))
/// of what differs between patients, each factor one sd below or above its mean.
/// Sources: the posteromedial tip 6.8 +- 3.4 mm outwards, 6.5 +- 3.2 mm in all, and the anteroposterior diameter by 4.9 +- 2.7 mm,
/// in sheep whose inferior infarction led to regurgitation within seven weeks (2.3 mm for 3.1 mm without regurgitation: the same
/// ratio; Tibayan 2003, Circulation 108:II116). Outwards, posterior and apical as 8 to 8 to 5, the usual model of ischaemic
/// displacement. Assumed: the same relative spread of all three, and that the anterolateral muscle goes 0 to 1 times as far.
struct DiseaseCourse {
  std::vector<int>
      indices;  ///< 4, at 0, 4, 8, 12 mm of the posteromedial tip: as far as mean and 1.7 sd
};
inline constexpr int kCourseSteps = 3;
inline constexpr double kCourseStep_mm = 4.0;
const std::vector<DiseaseCourse>& disease_courses();

/// @param plan the repair that led from `before` to `repaired`, each of its sutures taut. A muscle without a
/// suture swings about its trigone.
Valve disturb(const Valve& before, const Valve& repaired, const RepairPlan& plan,
              const Disturbance& disturbance);

}  // namespace coapt
