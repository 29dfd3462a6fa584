#include "core/valve/remodel.h"

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "core/valve/annulus_frame.h"
#include "core/valve/problem_list.h"
#include "core/valve/validate.h"

namespace coapt {
namespace {

constexpr Range kDilationPercent = {-50.0, 100.0};
constexpr Range kHeightPercent = {0.0, 200.0};
constexpr Range kDisplacementMm = {-30.0, 30.0};

void check_displacement(const Vec3& displacement_mm, const std::string& path,
                        ProblemList& problems) {
  for (int k = 0; k < 3; ++k)
    check_range(problems, path + '/' + std::to_string(k), displacement_mm(k), kDisplacementMm,
                " mm");
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

/// The field of Remodelling that changes what lies at `path` in the valve, "" if none does.
std::string field_behind(const std::string& path, const Remodelling& change, const Valve& valve) {
  for (std::size_t h = 0; h < valve.heads.size(); ++h) {
    const std::string tip = "/papillary_heads/" + std::to_string(h) + "/tip_mm";
    if (!path.starts_with(tip + '/')) continue;
    const bool anterolateral = valve.heads[h].side == Side::Anterolateral;
    return (anterolateral ? "/anterolateral_mm" : "/posteromedial_mm") + path.substr(tip.size());
  }
  if (!path.starts_with("/annulus") && !path.starts_with("/landmarks")) return "";
  return change.ap_dilation_percent != 0.0 ? "/ap_dilation_percent" : "/annular_height_percent";
}

std::string in_words(const Remodelling& change) {
  const auto tips = [](const Vec3& d) {
    return shown(d.x()) + " outwards, " + shown(d.y()) + " posterior, " + shown(d.z()) + " apical";
  };
  return "remodelled: anteroposterior dilation " + shown(change.ap_dilation_percent) +
         " %, annular height " + shown(change.annular_height_percent) +
         " %, tips in mm: anterolateral " + tips(change.anterolateral_mm) + "; posteromedial " +
         tips(change.posteromedial_mm);
}

}  // namespace

Expected<Valve> remodel(const Valve& valve, const Remodelling& change) {
  ProblemList problems;
  check_range(problems, "/ap_dilation_percent", change.ap_dilation_percent, kDilationPercent);
  check_range(problems, "/annular_height_percent", change.annular_height_percent, kHeightPercent);
  check_displacement(change.anterolateral_mm, "/anterolateral_mm", problems);
  check_displacement(change.posteromedial_mm, "/posteromedial_mm", problems);
  if (!problems.empty()) return std::move(problems).take();

  Valve remodelled = valve;
  const AnnulusFrame frame = annulus_frame(valve, AnnulusAxis::SaddlePeak);
  const TrigoneLine line = trigone_line(valve, frame);
  const double share = backward_share(valve, frame, line,
                                      change.ap_dilation_percent / 100.0 * ap_diameter_mm(valve));
  if (!(share > -1.0 && std::isfinite(share)))
    return Error{ErrorCode::OutOfRange, "/ap_dilation_percent",
                 "is " + shown(change.ap_dilation_percent) +
                     ": mid-posterior would reach the line between the trigones of this valve"};
  scale_height(frame, change.annular_height_percent / 100.0, remodelled);
  dilate(frame, line, share, remodelled);
  displace(change, remodelled);
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
