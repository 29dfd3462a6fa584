#include "core/valve/remodel.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <string>

#include "core/valve/annulus_frame.h"
#include "core/valve/leaflet_coordinates.h"
#include "core/valve/problem_list.h"
#include "core/valve/ruptures.h"
#include "core/valve/turns.h"
#include "core/valve/validate.h"

namespace coapt {
namespace {

constexpr Range kDilationPercent = {-50.0, 100.0};
constexpr Range kHeightPercent = {0.0, 200.0};
constexpr Range kDisplacementMm = {-30.0, 30.0};
constexpr Range kGrowthPercent = {-50.0, 100.0};
constexpr Range kElongationPercent = {-50.0, 200.0};
constexpr Range kTissuePercent = {1.0, 1000.0};

void check_displacement(const Vec3& displacement_mm, const std::string& path,
                        ProblemList& problems) {
  for (int k = 0; k < 3; ++k)
    check_range(problems, path + '/' + std::to_string(k), displacement_mm(k), kDisplacementMm,
                " mm");
}

void grow(const Vec3& centre_mm, double factor, Valve& valve) {
  const auto away = [&](const Vec3& point) -> Vec3 {
    return centre_mm + factor * (point - centre_mm);
  };
  for (Points* points : {&valve.rest_mm, &valve.annulus_mm})
    for (Index i = 0; i < points->rows(); ++i) points->row(i) = away(points->row(i));
  for (PapillaryHead& head : valve.heads)
    for (Vec3* point : {&head.rest_mm, &head.tip_mm}) *point = away(*point);
  for (Chorda& chorda : valve.chordae)
    for (ChordaSegment& segment : chorda.segments) {
      segment.rest_length_mm *= factor;
      segment.branch_point_mm = away(segment.branch_point_mm);
    }
}

void scale_height(const AnnulusFrame& frame, double factor, Valve& valve) {
  for (Index i = 0; i < valve.annulus_mm.rows(); ++i) {
    const Vec3 point = valve.annulus_mm.row(i);
    const double height = frame.normal.dot(point - frame.origin_mm);
    valve.annulus_mm.row(i) += (factor - 1.0) * height * frame.normal.transpose();
  }
}

/// The line through both trigones, in coordinates of the frame.
struct TrigoneLine {
  Vec3 from, to;
  double behind_mm(const Vec3& point) const {
    const double slope = (to.y() - from.y()) / (to.x() - from.x());
    return from.y() + slope * (point.x() - from.x()) - point.y();
  }
};

TrigoneLine trigone_line(const Valve& valve, const AnnulusFrame& frame) {
  const Landmarks& marks = valve.landmarks;
  return {into_frame(frame, annulus_position_mm(valve, marks.anterolateral_trigone)),
          into_frame(frame, annulus_position_mm(valve, marks.posteromedial_trigone))};
}

/// Share of its distance behind the trigone line by which each point moves backwards.
double backward_share(const Valve& valve, const AnnulusFrame& frame, const TrigoneLine& line,
                      double ap_growth_mm) {
  const Vec3 back = into_frame(frame, annulus_position_mm(valve, valve.landmarks.mid_posterior));
  return ap_growth_mm / line.behind_mm(back);
}

void dilate(const AnnulusFrame& frame, const TrigoneLine& line, double share, Valve& valve) {
  for (Index i = 0; i < valve.annulus_mm.rows(); ++i) {
    const double behind = line.behind_mm(into_frame(frame, valve.annulus_mm.row(i)));
    if (behind > 0.0) valve.annulus_mm.row(i) -= share * behind * frame.y.transpose();
  }
}

void displace(const Remodelling& change, Valve& valve) {
  for (PapillaryHead& head : valve.heads) {
    const bool anterolateral = head.side == Side::Anterolateral;
    const Vec3& move = anterolateral ? change.anterolateral_mm : change.posteromedial_mm;
    head.tip_mm += Vec3(anterolateral ? -move.x() : move.x(), -move.y(), -move.z());
  }
}

/// Per vertex: the place of the unstressed annulus from which its column of the leaflet hangs.
Points feet_mm(const Valve& valve) {
  const std::vector<double> around = leaflet_coordinates(valve).around;
  const std::vector<double> arc = annulus_around(valve);
  Points feet(valve.rest_mm.rows(), 3);
  for (Index v = 0; v < feet.rows(); ++v) {
    std::size_t before = 0;
    double past = 1.0;
    for (std::size_t a = 0; a < arc.size(); ++a)
      if (const double here = turn_fraction(around[static_cast<std::size_t>(v)] - arc[a]);
          here < past) {
        past = here;
        before = a;
      }
    const std::size_t after = (before + 1) % arc.size();
    const double t = std::min(1.0, past / turn_fraction(arc[after] - arc[before]));
    feet.row(v) = (1.0 - t) * valve.rest_mm.row(valve.annulus[before]) +
                  t * valve.rest_mm.row(valve.annulus[after]);
  }
  return feet;
}

void grow_leaflets(double percent, Valve& valve) {
  const Points before = valve.rest_mm, feet = feet_mm(valve);
  valve.rest_mm = feet + (1.0 + percent / 100.0) * (before - feet);
  for (const int vertex : valve.annulus) valve.rest_mm.row(vertex) = before.row(vertex);
  for (Index f = 0; f < valve.faces.rows(); ++f) {  // fibres go with their face
    const auto edges = [&](const Points& at) {
      const Vec3 corner = at.row(valve.faces(f, 0));
      Eigen::Matrix<double, 3, 2> sides;
      sides << Vec3(at.row(valve.faces(f, 1))) - corner, Vec3(at.row(valve.faces(f, 2))) - corner;
      return sides;
    };
    const Eigen::Matrix<double, 3, 2> old = edges(before);
    const Vec3 fibre = valve.fibre.row(f);
    const Vec2 shares = (old.transpose() * old).inverse() * (old.transpose() * fibre);
    valve.fibre.row(f) = (edges(valve.rest_mm) * shares).normalized();
  }
}

void elongate(double percent, Chorda& chorda) {
  for (ChordaSegment& segment : chorda.segments) segment.rest_length_mm *= 1.0 + percent / 100.0;
}

void elongate(const Remodelling& change, Valve& valve) {
  for (Chorda& chorda : valve.chordae) {
    elongate(change.chordal_elongation_percent, chorda);
    for (const ChordalElongation& further : change.elongated)
      if (chorda.kind == ChordaKind::Marginal && held_by(valve, chorda) == further.segment)
        elongate(further.percent, chorda);
  }
}

/// A scallop whose marginal chordae are meant, and the field that names it.
struct NamedScallop {
  std::string at;
  Segment segment;
};

std::vector<NamedScallop> named_scallops(const Remodelling& change) {
  std::vector<NamedScallop> named;
  for (std::size_t i = 0; i < change.elongated.size(); ++i)
    named.push_back({"/elongated/" + std::to_string(i) + "/segment", change.elongated[i].segment});
  for (std::size_t i = 0; i < change.ruptured.size(); ++i)
    named.push_back({"/ruptured/" + std::to_string(i), change.ruptured[i]});
  return named;
}

void check_scallops(const Valve& valve, const Remodelling& change, ProblemList& problems) {
  const std::vector<NamedScallop> scallops = named_scallops(change);
  if (scallops.empty()) return;
  const std::vector<Segment> held = held_segments(valve);
  std::string accepted;
  for (const Segment segment : held)
    accepted += (accepted.empty() ? "" : ", ") + std::string(to_string(segment));
  for (const NamedScallop& named : scallops)
    if (std::find(held.begin(), held.end(), named.segment) == held.end())
      problems.add(ErrorCode::BadReference, named.at,
                   std::string("no marginal chorda holds ") + to_string(named.segment) +
                       "; accepted: " + accepted);
}

/// The field of Remodelling that changes what lies at `path` in the valve, "" if none does.
std::string field_behind(const std::string& path, const Remodelling& change, const Valve& valve) {
  for (std::size_t h = 0; h < valve.heads.size(); ++h) {
    const std::string tip = "/papillary_heads/" + std::to_string(h) + "/tip_mm";
    if (!path.starts_with(tip + '/')) continue;
    const bool anterolateral = valve.heads[h].side == Side::Anterolateral;
    return (anterolateral ? "/anterolateral_mm" : "/posteromedial_mm") + path.substr(tip.size());
  }
  if (path.starts_with("/systole")) return path;
  if (path.starts_with("/material")) return "/tissue";
  if (!path.starts_with("/annulus") && !path.starts_with("/landmarks"))
    return change.leaflet_growth_percent != 0.0 ? "/leaflet_growth_percent" : "";
  return change.ap_dilation_percent != 0.0 ? "/ap_dilation_percent" : "/annular_height_percent";
}

/// Names of TissueChange's numbers.
std::vector<std::pair<const char*, double>> percentages(const TissueChange& tissue) {
  return {{"thickness", tissue.thickness_percent},
          {"extension", tissue.extension_percent},
          {"circumferential_stiffness", tissue.circumferential_stiffness_percent},
          {"radial_stiffness", tissue.radial_stiffness_percent}};
}

std::string tissue_in_words(const TissueChange& tissue) {
  std::string words;
  for (const auto& [name, percent] : percentages(tissue)) {
    std::string what = name;
    std::replace(what.begin(), what.end(), '_', ' ');
    if (percent != 100.0) words += "; " + what + " of the tissue " + shown(percent) + " %";
  }
  return words;
}

std::string in_words(const Remodelling& change) {
  const auto tips = [](const Vec3& d) {
    return shown(d.x()) + " outwards, " + shown(d.y()) + " posterior, " + shown(d.z()) + " apical";
  };
  std::string words = "remodelled: anteroposterior dilation " + shown(change.ap_dilation_percent) +
                      " %, annular height " + shown(change.annular_height_percent) +
                      " %, tips in mm: anterolateral " + tips(change.anterolateral_mm) +
                      "; posteromedial " + tips(change.posteromedial_mm);
  if (change.growth_percent != 0.0)
    words += "; the whole valve grown by " + shown(change.growth_percent) + " % of its lengths";
  if (change.leaflet_growth_percent != 0.0)
    words += "; leaflets grown by " + shown(change.leaflet_growth_percent) + " % of their heights";
  if (change.chordal_elongation_percent != 0.0)
    words += "; chordae elongated by " + shown(change.chordal_elongation_percent) + " %";
  for (const ChordalElongation& further : change.elongated)
    words += std::string("; marginal chordae of ") + to_string(further.segment) + " elongated by " +
             shown(further.percent) + " %";
  words += tissue_in_words(change.tissue);
  for (const Segment segment : change.ruptured)
    words += std::string("; marginal chordae of ") + to_string(segment) + " ruptured";
  return words;
}

}  // namespace

void change_tissue(const TissueChange& change, Tissue& tissue) {
  tissue.thickness_mm *= change.thickness_percent / 100.0;
  for (double* modulus : {&tissue.circumferential_pre_kpa, &tissue.circumferential_post_kpa})
    *modulus *= change.circumferential_stiffness_percent / 100.0;
  for (double* modulus : {&tissue.radial_pre_kpa, &tissue.radial_post_kpa})
    *modulus *= change.radial_stiffness_percent / 100.0;
  const double extension = change.extension_percent / 100.0;
  if (extension == 1.0) return;  // a prestretch that is worked out anew is off in its last digit
  if (tissue.reference == TissueReference::Excised) {
    tissue.circumferential_transition *= extension;
    tissue.radial_transition *= extension;
    return;
  }
  const auto extended = [&](double transition, double prestretch) {
    const double left = (1.0 + transition) / prestretch - 1.0;
    return (1.0 + transition) / (1.0 + extension * left);
  };
  tissue.circumferential_prestretch =
      extended(tissue.circumferential_transition, tissue.circumferential_prestretch);
  tissue.radial_prestretch = extended(tissue.radial_transition, tissue.radial_prestretch);
}

Errors check_remodelling(const Remodelling& change) {
  ProblemList problems;
  check_range(problems, "/ap_dilation_percent", change.ap_dilation_percent, kDilationPercent);
  check_range(problems, "/annular_height_percent", change.annular_height_percent, kHeightPercent);
  check_displacement(change.anterolateral_mm, "/anterolateral_mm", problems);
  check_displacement(change.posteromedial_mm, "/posteromedial_mm", problems);
  check_range(problems, "/growth_percent", change.growth_percent, kGrowthPercent);
  check_range(problems, "/leaflet_growth_percent", change.leaflet_growth_percent, kGrowthPercent);
  check_range(problems, "/chordal_elongation_percent", change.chordal_elongation_percent,
              kElongationPercent);
  for (std::size_t i = 0; i < change.elongated.size(); ++i)
    check_range(problems, "/elongated/" + std::to_string(i) + "/percent",
                change.elongated[i].percent, kElongationPercent);
  for (const auto& [name, percent] : percentages(change.tissue))
    check_range(problems, std::string("/tissue/") + name + "_percent", percent, kTissuePercent);
  return std::move(problems).take();
}

Expected<Valve> remodel(const Valve& valve, const Remodelling& change) {
  if (Errors errors = check_remodelling(change); !errors.empty()) return errors;
  ProblemList problems;
  check_scallops(valve, change, problems);
  if (!problems.empty()) return std::move(problems).take();

  Valve remodelled = valve;
  remodelled.observed.clear();  // of another state of the valve
  if (change.growth_percent != 0.0)
    grow(annulus_frame(valve, AnnulusAxis::SaddlePeak).origin_mm,
         1.0 + change.growth_percent / 100.0, remodelled);
  const AnnulusFrame frame = annulus_frame(remodelled, AnnulusAxis::SaddlePeak);
  const TrigoneLine line = trigone_line(remodelled, frame);
  const double share = backward_share(
      remodelled, frame, line, change.ap_dilation_percent / 100.0 * ap_diameter_mm(remodelled));
  if (!(share > -1.0 && std::isfinite(share)))
    return Error{ErrorCode::OutOfRange, "/ap_dilation_percent",
                 "is " + shown(change.ap_dilation_percent) +
                     ": mid-posterior would reach the line between the trigones of this valve"};
  scale_height(frame, change.annular_height_percent / 100.0, remodelled);
  dilate(frame, line, share, remodelled);
  displace(change, remodelled);
  if (change.leaflet_growth_percent != 0.0)
    grow_leaflets(change.leaflet_growth_percent, remodelled);
  elongate(change, remodelled);
  change_tissue(change.tissue, remodelled.tissue);
  for (const Segment segment : change.ruptured)
    remodelled = with_ruptured(std::move(remodelled), segment);
  if (change.systole) remodelled.systole = *change.systole;
  for (const Error& error : validate(remodelled))
    problems.add(error.code, field_behind(error.path, change, valve),
                 "leaves no valid valve: " + error.path + ' ' + error.message);
  if (!problems.empty()) return std::move(problems).take();
  remodelled.provenance.push_back(in_words(change));
  return remodelled;
}

void grow_annulus(double ap_growth_mm, Valve& valve) {
  const AnnulusFrame frame = annulus_frame(valve, AnnulusAxis::SaddlePeak);
  const TrigoneLine line = trigone_line(valve, frame);
  dilate(frame, line, backward_share(valve, frame, line, ap_growth_mm), valve);
}

}  // namespace coapt
