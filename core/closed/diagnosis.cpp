#include "core/closed/diagnosis.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/repair/approximation.h"
#include "core/valve/annulus_frame.h"
#include "core/valve/leaflet_of.h"
#include "core/valve/ruptures.h"

namespace coapt {
namespace {

constexpr std::size_t kA2 = 1;  // in kScallops
constexpr int kLateral =
    3;  // of kScallops, an anterior segment and the opposite one are so far apart

/// Heights over the annulus, anywhere between its sides.
class HingeLine {
 public:
  explicit HingeLine(const Valve& valve) : frame_(annulus_frame(valve, AnnulusAxis::Commissures)) {
    for (Index i = 0; i < valve.annulus_mm.rows(); ++i)
      loop_.push_back(into_frame(frame_, valve.annulus_mm.row(i).transpose()));
    const auto [least, most] = std::minmax_element(
        loop_.begin(), loop_.end(), [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); });
    least_ = least->x();
    most_ = most->x();
  }

  /// Towards the atrium, across the line at its place along the commissures; beyond them, as at them.
  double height_mm(const Vec3& point_mm) const {
    const Vec3 point = into_frame(frame_, point_mm);
    constexpr double kInside = 1e-6;  // so that the plane there meets both sides
    const double x = std::clamp(point.x(), least_ + kInside, most_ - kInside);
    Vec2 posterior(std::numeric_limits<double>::infinity(), 0.0), anterior = -posterior;
    for (std::size_t i = 0; i < loop_.size(); ++i) {
      const Vec3 &from = loop_[i], &to = loop_[(i + 1) % loop_.size()];
      if ((from.x() < x) == (to.x() < x)) continue;
      const Vec3 met = from + (x - from.x()) / (to.x() - from.x()) * (to - from);
      if (met.y() > anterior.x()) anterior = met.tail<2>();
      if (met.y() < posterior.x()) posterior = met.tail<2>();
    }
    const Vec2 line = anterior - posterior;
    if (!(line.x() > 0.0)) return point.z() - anterior.y();
    const Vec2 up = Vec2(-line.y(), line.x()) / line.norm();
    return up.dot(point.tail<2>() - posterior);
  }

 private:
  AnnulusFrame frame_;
  std::vector<Vec3> loop_;
  double least_ = 0.0, most_ = 0.0;
};

/// A piece of the free edge of one segment.
struct EdgePiece {
  double length_mm = 0.0;
  double lower_mm = 0.0, higher_mm = 0.0;  ///< of its ends
  double middle_mm() const { return 0.5 * (lower_mm + higher_mm); }
};

using FreeEdge = std::map<Segment, std::vector<EdgePiece>>;

FreeEdge free_edge(const Valve& valve, const Points& closed_mm) {
  std::vector<bool> on_annulus(static_cast<std::size_t>(valve.rest_mm.rows()), false);
  for (const int vertex : valve.annulus) on_annulus[static_cast<std::size_t>(vertex)] = true;
  std::map<std::pair<int, int>, std::pair<int, Index>> edges;  // faces at it, the last of them
  for (Index face = 0; face < valve.faces.rows(); ++face)
    for (int k = 0; k < 3; ++k) {
      auto& [count, last] =
          edges[std::minmax(valve.faces(face, k), valve.faces(face, (k + 1) % 3))];
      ++count;
      last = face;
    }
  const HingeLine hinge(valve);
  const auto at = [&](int vertex) { return Vec3(closed_mm.row(vertex).transpose()); };
  FreeEdge pieces;
  for (const auto& [ends, faces] : edges) {
    const auto [from, to] = ends;
    if (faces.first != 1 ||
        (on_annulus[static_cast<std::size_t>(from)] && on_annulus[static_cast<std::size_t>(to)]))
      continue;
    const auto [lower, higher] = std::minmax({hinge.height_mm(at(from)), hinge.height_mm(at(to))});
    pieces[valve.segments[static_cast<std::size_t>(faces.second)]].push_back(
        {(at(from) - at(to)).norm(), lower, higher});
  }
  return pieces;
}

/// Sum of the lengths of those above a height.
double length_above(const std::vector<EdgePiece>& pieces, double height_mm) {
  double length = 0.0;
  for (const EdgePiece& piece : pieces)
    if (piece.middle_mm() > height_mm) length += piece.length_mm;
  return length;
}

double mean_height(const std::vector<EdgePiece>& pieces) {
  double sum = 0.0;
  for (const EdgePiece& piece : pieces) sum += piece.length_mm * piece.middle_mm();
  return sum / length_above(pieces, -std::numeric_limits<double>::infinity());
}

int ruptured_of(const Valve& valve, Segment segment) {
  return static_cast<int>(
      std::count_if(valve.chordae.begin(), valve.chordae.end(), [&](const Chorda& chorda) {
        return chorda.kind == ChordaKind::Marginal && chorda.ruptured &&
               held_by(valve, chorda) == segment;
      }));
}

/// Through an opening of its own: one that most segments border says nothing of any of them.
bool leaks_beside(const ValveMeasure& measure, Segment segment) {
  constexpr std::size_t kFewSegments = 4;
  return std::any_of(
      measure.leak.openings.begin(), measure.leak.openings.end(), [&](const LeakOpening& opening) {
        return opening.area_mm2 > kTraceLeak_mm2 && opening.segments.size() <= kFewSegments &&
               std::find(opening.segments.begin(), opening.segments.end(), segment) !=
                   opening.segments.end();
      });
}

/// How much higher than the opposite segment a free edge lies in closed valves.
double usual_override_mm(Segment segment) {
  if (segment == Segment::P2) return kUsualOverride_mm;
  return segment == Segment::A2 ? -kUsualOverride_mm : 0.0;
}

std::array<SegmentDiagnosis, 6> diagnose_segments(const Valve& valve, const Points& closed_mm,
                                                  const ValveMeasure& measure) {
  FreeEdge edge = free_edge(valve, closed_mm);
  std::array<SegmentDiagnosis, 6> found;
  for (std::size_t s = 0; s < found.size(); ++s) {
    const Segment segment = kScallops[s], opposite = kScallops[(s + kLateral) % 6];
    SegmentDiagnosis& of = found[s];
    of.segment = segment;
    of.ruptured = ruptured_of(valve, segment);
    const std::vector<EdgePiece>&pieces = edge[segment], &others = edge[opposite];
    if (pieces.empty() || others.empty()) continue;  // resected whole
    of.edge_mm = mean_height(pieces);
    of.highest_mm =
        std::max_element(pieces.begin(), pieces.end(), [](const EdgePiece& a, const EdgePiece& b) {
          return a.higher_mm < b.higher_mm;
        })->higher_mm;
    const double level = mean_height(others) + usual_override_mm(segment);
    of.override_mm = of.edge_mm - level;
    const double whole = length_above(pieces, -std::numeric_limits<double>::infinity());
    const bool above_annulus = length_above(pieces, 0.0) > 0.5 * whole;
    const bool overrides = of.override_mm >= kProlapse_mm && of.edge_mm > kDeepEdge_mm;
    const bool leaks = leaks_beside(measure, segment);
    const bool rides = of.override_mm >= kFlail_mm && of.edge_mm > kDeepEdge_mm;
    const bool flail = of.ruptured > 0 && (rides || above_annulus || leaks);
    if (flail || overrides || above_annulus)
      of.finding = flail ? SegmentFinding::Flail : SegmentFinding::Prolapse;
    of.sure = (flail && (overrides || leaks)) || above_annulus ||
              std::abs(of.override_mm - kProlapse_mm) > kOverrideMargin_mm ||
              of.edge_mm <= kDeepEdge_mm;
    if (of.finding != SegmentFinding::Normal)
      of.width_mm = length_above(pieces, std::min(0.0, level + kProlapse_mm));
  }
  return found;
}

/// Logistic regression on 93 valves, of which 37 tethered; 86 others were judged by it.
double tethering(const Diagnosis& of) {
  const double furthest = std::max(of.tip_to_trigone_mm[0], of.tip_to_trigone_mm[1]);
  const double score = 0.375 * furthest - 18.0 * of.ap_mm / of.transverse_mm -
                       1.13 * of.segments[kA2].edge_mm - 10.6;
  return 1.0 / (1.0 + std::exp(-score));
}

/// The muscle that is so much further from its trigone that the hand could tell (plans/disturbance.h: 3 mm of the tip); none where the
/// other one is beyond doubt displaced, too.
std::optional<Side> further_side(const Diagnosis& of) {
  constexpr double kApart_mm = 3.0;
  const double more = of.tip_to_trigone_mm[1] - of.tip_to_trigone_mm[0];
  const double nearer_mm = std::min(of.tip_to_trigone_mm[0], of.tip_to_trigone_mm[1]);
  if (std::abs(more) < kApart_mm || nearer_mm > kFarTip_mm) return std::nullopt;
  return more > 0.0 ? Side::Posteromedial : Side::Anterolateral;
}

/// Those that the tethered side's muscle holds; the middle is held by both.
bool is_held_by(Segment segment, std::optional<Side> side) {
  if (segment == Segment::A1 || segment == Segment::P1) return side != Side::Posteromedial;
  if (segment == Segment::A3 || segment == Segment::P3) return side != Side::Anterolateral;
  return true;
}

bool prolapses(const SegmentDiagnosis& segment) {
  return segment.finding == SegmentFinding::Prolapse || segment.finding == SegmentFinding::Flail;
}

/// Another type than I that is not sure yields to clefts that explain the leak, and is ruled out where they explain nearly all of it.
void name_clefts(Diagnosis& of) {
  constexpr double kNearlyAll = 0.8;
  if (of.clefts.empty()) return;
  if (!of.type_sure && clefts_explain(of)) {
    if (of.types.front() != CarpentierType::I) of.not_ruled_out = of.types.front();
    of.types = {CarpentierType::I};
    if (leak_through(of.clefts) < kNearlyAll * of.leak_mm2) return;
    of.not_ruled_out.reset();
    of.type_sure = true;
  } else if (std::find(of.types.begin(), of.types.end(), CarpentierType::I) == of.types.end()) {
    of.types.push_back(CarpentierType::I);
  }
}

void name_types(Diagnosis& of) {
  if (of.competent) return;
  const bool excessive = std::any_of(of.segments.begin(), of.segments.end(), prolapses);
  const double furthest_mm = std::max(of.tip_to_trigone_mm[0], of.tip_to_trigone_mm[1]);
  const bool tethered = excessive ? of.tethering >= kTetheredBesides && furthest_mm > kFarTip_mm
                                  : of.tethering >= kTethered;
  if (excessive) of.types.push_back(CarpentierType::II);
  if (tethered) of.types.push_back(CarpentierType::IIIb);
  if (of.types.empty()) of.types.push_back(CarpentierType::I);
  if (excessive) {
    of.type_sure = std::any_of(of.segments.begin(), of.segments.end(), [](const auto& segment) {
      return prolapses(segment) && segment.sure;
    });
    if (!of.type_sure)
      of.not_ruled_out =
          tethered || of.tethering >= kTethered ? CarpentierType::IIIb : CarpentierType::I;
  } else if (const double sure = std::max(of.tethering, 1.0 - of.tethering);
             sure < kSureOfTethering) {
    of.type_sure = false;
    of.not_ruled_out = tethered ? CarpentierType::I : CarpentierType::IIIb;
  }
  name_clefts(of);
  if (!tethered || of.types.front() == CarpentierType::I) return;
  of.tethered_side = further_side(of);
  for (SegmentDiagnosis& segment : of.segments)
    if (!prolapses(segment) && is_held_by(segment.segment, of.tethered_side))
      segment.finding = SegmentFinding::Tethered;
}

}  // namespace

const char* to_string(CarpentierType type) {
  switch (type) {
    case CarpentierType::I:
      return "I";
    case CarpentierType::II:
      return "II";
    case CarpentierType::IIIa:
      return "IIIa";
    case CarpentierType::IIIb:
      return "IIIb";
  }
  return "";
}

const char* to_string(SegmentFinding finding) {
  switch (finding) {
    case SegmentFinding::Normal:
      return "normal";
    case SegmentFinding::Prolapse:
      return "prolapse";
    case SegmentFinding::Flail:
      return "flail";
    case SegmentFinding::Tethered:
      return "tethered";
  }
  return "";
}

std::optional<Diagnosis> diagnose(const Valve& valve, const ClosureResult& closure,
                                  const ValveMeasure& measure, double opening_mm2) {
  if (!is_mitral(valve) || !trusted(closure) || !std::isfinite(measure.leak.area_mm2))
    return std::nullopt;
  Diagnosis of;
  of.leak_mm2 = measure.leak.area_mm2;
  of.leak_error_mm2 = measure.leak_error_mm2;
  of.competent = of.leak_mm2 <= kMildLeak_mm2;
  of.competent_sure = std::abs(of.leak_mm2 - kMildLeak_mm2) > of.leak_error_mm2;
  of.segments = diagnose_segments(valve, closure.closed_mm, measure);
  of.tip_to_trigone_mm = {anchor_distance_mm(valve, {.side = Side::Anterolateral}),
                          anchor_distance_mm(valve, {.side = Side::Posteromedial})};
  of.tenting_height_mm = measure.tenting_height_mm;
  of.ap_mm = ap_diameter_mm(valve);
  of.transverse_mm = transverse_diameter_mm(valve);
  of.annulus_dilated = of.ap_mm > kDilatedAp_mm || of.ap_mm > kRoundAnnulus * of.transverse_mm;
  of.tethering = tethering(of);
  of.clefts = leaking_clefts(valve, closure.closed_mm, measure, kTraceLeak_mm2);
  name_types(of);
  const double annulus_mm2 = 0.25 * std::numbers::pi * of.ap_mm * of.transverse_mm;
  if (opening_mm2 <= kCannotOpen_mm2 && opening_mm2 <= kCannotOpenShare * annulus_mm2)
    of.types.push_back(CarpentierType::IIIa);
  return of;
}

bool may_be(const Diagnosis& diagnosis, CarpentierType type) {
  return diagnosis.not_ruled_out == type ||
         std::find(diagnosis.types.begin(), diagnosis.types.end(), type) != diagnosis.types.end();
}

bool surely_prolapses(const Diagnosis& diagnosis) {
  return diagnosis.type_sure && may_be(diagnosis, CarpentierType::II);
}

bool clefts_explain(const Diagnosis& diagnosis) {
  return leak_through(diagnosis.clefts) >= 0.5 * diagnosis.leak_mm2;
}

std::vector<SegmentDiagnosis> prolapsing(const Diagnosis& diagnosis) {
  std::vector<SegmentDiagnosis> found;
  for (const SegmentDiagnosis& segment : diagnosis.segments)
    if (prolapses(segment)) found.push_back(segment);
  return found;
}

}  // namespace coapt
