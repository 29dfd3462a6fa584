// Why a closed mitral valve leaks, in the words of surgeons: Carpentier's types of dysfunction, segment by segment.
//
// Heights are measured from the hinge line, which joins both sides of the annulus straight across the line between the commissures:
// the annular line of an echocardiographic long-axis view, anywhere along the valve. A segment prolapses (type II) where its free
// edge rides over the opposite one by more than in closed valves, or stands above that line; it is flail where its marginal
// chordae are ruptured and it rides over half as much, or leaks through an opening of its own. Leaflets are tethered (type IIIb) by the probability that a logistic regression gives to three figures
// that surgeons know: how far the tips are from their trigones, how round the annulus is, how deep A2's edge lies. What leaks and
// is neither has an annulus too wide for its leaflets or leaks through deep clefts (type I); where most of the leak passes through
// clefts and another type is not sure, they are what explains it. Leaflets that cannot open are type IIIa.
//
// Thresholds were chosen on one half of 120 made valves and their diseases and judged on the other (docs/researcher/diagnosis.md).
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "core/closed/clefts.h"
#include "core/metrics/measure.h"
#include "core/repair/limits.h"

namespace coapt {

/// Up to this leak a valve counts as competent, and a repair as good (thesis 4.2.3).
inline constexpr double kMildLeak_mm2 = 5.0;
/// Below it a leak is called none or trace; the error of an area is about as large.
inline constexpr double kTraceLeak_mm2 = 1.0;

enum class CarpentierType {
  I,     ///< normal leaflet motion: the annulus is dilated, or clefts leak
  II,    ///< excessive motion: prolapse, flail
  IIIa,  ///< restricted in diastole and systole
  IIIb   ///< restricted in systole: tethered by displaced papillary muscles
};

enum class SegmentFinding { Normal, Prolapse, Flail, Tethered };

struct SegmentDiagnosis {
  Segment segment = Segment::A1;
  SegmentFinding finding = SegmentFinding::Normal;
  bool sure = true;         ///< not within kOverrideMargin_mm of the threshold
  double edge_mm = 0.0;     ///< mean height of its free edge over the hinge line; below it negative
  double highest_mm = 0.0;  ///< of its free edge
  double override_mm =
      0.0;                ///< by which the edge lies higher over the opposite segment's than usual
  double width_mm = 0.0;  ///< of the free edge that prolapses, along it
  int ruptured = 0;       ///< marginal chordae that held it
};

struct Diagnosis {
  bool competent = false;      ///< leak <= kMildLeak_mm2
  bool competent_sure = true;  ///< further from that than the leak's error
  double leak_mm2 = 0.0, leak_error_mm2 = 0.0;

  /// What explains the leak most first; empty if the valve is competent and opens. Several: mixed disease.
  std::vector<CarpentierType> types;
  bool type_sure = true;
  std::optional<CarpentierType> not_ruled_out;  ///< where the first type is not sure

  std::array<SegmentDiagnosis, 6> segments;  ///< in the order of kScallops (core/valve/ruptures.h)

  std::vector<Cleft> clefts;  ///< that leak

  std::array<double, 2> tip_to_trigone_mm{};  ///< anterolateral, posteromedial
  double tenting_height_mm = 0.0;
  double tethering = 0.0;  ///< probability of type IIIb against I, [0, 1]
  std::optional<Side>
      tethered_side;  ///< type IIIb: of the muscle that is further away; none: both alike

  double ap_mm = 0.0, transverse_mm = 0.0;
  bool annulus_dilated = false;  ///< rounder than in health, or more than 35 mm anteroposterior
};

// By which edges lie higher than in closed valves: in the middle P2's edge lies 2 mm above A2's, at the sides as high.
inline constexpr double kUsualOverride_mm = 2.0;
inline constexpr double kProlapse_mm = 4.0;  ///< of SegmentDiagnosis::override_mm
inline constexpr double kFlail_mm = 2.0;     ///< the same where its chordae are ruptured (assumed)
inline constexpr double kOverrideMargin_mm =
    1.0;                                      ///< within this of kProlapse_mm a finding is not sure
inline constexpr double kDeepEdge_mm = -9.0;  ///< an edge below that does not prolapse
inline constexpr double kTethered = 0.5,
                        kSureOfTethering = 0.85;  ///< Diagnosis::tethering; of either
// A prolapse moves A2's edge, too: beside it tethering must be beyond doubt, with a tip beyond mean + 2 sd of health.
inline constexpr double kTetheredBesides = 0.98;
inline constexpr double kFarTip_mm = kTipToTrigone_mm + 2.0 * kTipToTrigoneSd_mm;
/// Anteroposterior over transverse diameter: health 0.75 +- 0.07 (PMC7368231, table 3), mean + 2 sd.
inline constexpr double kRoundAnnulus = 0.89;
inline constexpr double kDilatedAp_mm =
    35.0;  ///< ESC/EACTS guidelines on valvular heart disease 2012
inline constexpr double kCannotOpen_mm2 = 150.0;  ///< severe stenosis (ASE/EACVI 2009)
/// And of the annulus: healthy valves open to half of it (4.7 of 8.5 cm2), small ones, too.
inline constexpr double kCannotOpenShare = 0.3;

const char* to_string(CarpentierType type);     ///< "I", "II", "IIIa", "IIIb"
const char* to_string(SegmentFinding finding);  ///< "normal", "prolapse", "flail", "tethered"

/// None of a closure that is not to be trusted, and of a valve that is not mitral.
/// @param opening_mm2 of the valve in diastole; NaN: not known, and type IIIa is not looked for
std::optional<Diagnosis> diagnose(const Valve& valve, const ClosureResult& closure,
                                  const ValveMeasure& measure,
                                  double opening_mm2 = std::numeric_limits<double>::quiet_NaN());

/// Whether a type is among those of the valve, or not ruled out.
bool may_be(const Diagnosis& diagnosis, CarpentierType type);
/// Whether some segment surely prolapses: the types are sure, and II is one of them.
bool surely_prolapses(const Diagnosis& diagnosis);
/// Half of it or more passes through clefts. @pre there are clefts
bool clefts_explain(const Diagnosis& diagnosis);
/// Segments that prolapse or are flail, sure or not.
std::vector<SegmentDiagnosis> prolapsing(const Diagnosis& diagnosis);

}  // namespace coapt
