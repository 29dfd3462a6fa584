#include "core/valve/measured_skeleton.h"

#include "core/valve/problem_list.h"
#include "core/valve/validate_parts.h"

namespace coapt {
namespace {

constexpr Range kAcrossMm = {8.0, 100.0};
constexpr Range kTipDepthMm = {8.0, 60.0};  // as ParametricValve::tip_depth_mm
constexpr double kTipAsideMm = 60.0;        // from the axis: beyond it there is no ventricle
constexpr Index kMaxTips = 100;             // as many heads as a valve may have

Errors check_annulus(const Points& annulus_mm) {
  const double length = ArcLength(annulus_mm).total_mm();
  if (length == 0.0)
    return {{ErrorCode::BadGeometry, "/annulus_mm",
             "is the same point " + std::to_string(annulus_mm.rows()) +
                 " times, must be a closed loop"}};
  if (length >= kCircumferenceMm.min && length <= kCircumferenceMm.max) return {};
  const char* unit = length < 1.0    ? ", looks like metres;"
                     : length < 20.0 ? ", looks like centimetres;"
                                     : ",";
  return {
      {ErrorCode::BadGeometry, "/annulus_mm",
       "has a circumference of " + shown(length) + " mm" + unit + " must be from 30 to 400 mm"}};
}

Errors check_width(const Points& annulus_mm) {
  Errors errors;
  for (const int axis : {0, 1}) {
    const double width = annulus_mm.col(axis).maxCoeff() - annulus_mm.col(axis).minCoeff();
    if (width >= kAcrossMm.min && width <= kAcrossMm.max) continue;
    errors.push_back({ErrorCode::BadGeometry, "/annulus_mm",
                      std::string("measures ") + shown(width) + " mm " +
                          (axis == 0 ? "along" : "across") +
                          " the line between the papillary muscles, must be from 8 to 100 mm"});
  }
  return errors;
}

/// Tips in the valve's frame.
Errors check_tips(const Points& tips_mm) {
  Index shallow = 0, deep = 0, aside = 0;
  for (Index i = 0; i < tips_mm.rows(); ++i) {
    const double depth = -tips_mm(i, 2);
    shallow += depth < kTipDepthMm.min;
    deep += depth > kTipDepthMm.max;
    aside += tips_mm.row(i).head<2>().norm() > kTipAsideMm;
  }
  const std::string of = " of " + std::to_string(tips_mm.rows()) + " tips lie ";
  Errors errors;
  const auto refuse = [&](Index count, const std::string& where) {
    if (count > 0)
      errors.push_back({ErrorCode::BadGeometry, "/tips_mm", std::to_string(count) + of + where});
  };
  refuse(shallow, "in, near or above the annulus plane (the highest " +
                      shown(-tips_mm.col(2).maxCoeff()) +
                      " mm below it), must be from 8 to 60 mm "
                      "below it");
  refuse(deep, "up to " + shown(-tips_mm.col(2).minCoeff()) +
                   " mm below the annulus plane, must be from 8 to 60 mm below it");
  refuse(aside, "more than 60 mm from the axis of the annulus");
  if (tips_mm.col(0).minCoeff() >= 0.0 || tips_mm.col(0).maxCoeff() <= 0.0)
    errors.push_back({ErrorCode::BadGeometry, "/tips_mm",
                      "all tips lie on one side of the annulus; accepted: both"});
  return errors;
}

}  // namespace

Expected<MeasuredSkeleton> measured_skeleton(const Points& annulus_mm, const Points& tips_mm) {
  Errors errors = check_annulus(annulus_mm);
  if (tips_mm.rows() > kMaxTips)
    errors.push_back({ErrorCode::OutOfRange, "/tips_mm",
                      "has " + std::to_string(tips_mm.rows()) +
                          " points, accepted: 2 to 100, one for each head of a muscle"});
  if (!errors.empty()) return errors;
  const MeasuredSkeleton skeleton = into_valve_frame(annulus_mm, tips_mm);
  errors = check_width(skeleton.annulus_mm);
  const Errors of_tips = check_tips(skeleton.tips_mm);
  errors.insert(errors.end(), of_tips.begin(), of_tips.end());
  if (!errors.empty()) return errors;
  return skeleton;
}

}  // namespace coapt
