#include "io/mesh/handedness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numbers>
#include <optional>

#include "core/valve/number_text.h"

namespace coapt {
namespace {

constexpr const char *kSubject = "frame", *kUnseen = "a mirror image cannot be detected";
constexpr double kLeastApart_mm = 3.0;  // of named sides, along the line of the commissures
// Turned by up to this from where hearts usually lie. Of axes that mean nothing 1 % are within 35 degrees of any one orientation.
constexpr double kUsual_deg = 50.0, kMirrored_deg = 35.0;

/// Columns x, y, z of a valve in LPS as textbooks draw the heart: the apex is to the left, in front and below, the aortic root to the
/// right of the mitral valve and in front. Assumed; hearts differ by some 30 degrees.
Eigen::Matrix3d usual_axes() {
  const Vec3 to_the_atrium = Vec3(-0.65, 0.5, 0.55).normalized(), to_the_aorta(-0.6, -0.7, 0.0);
  const Vec3 x = to_the_aorta.cross(to_the_atrium).normalized();
  Eigen::Matrix3d axes;
  axes << x, to_the_atrium.cross(x), to_the_atrium;
  return axes;
}

double degrees_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return Eigen::AngleAxisd(Eigen::Matrix3d(a.transpose() * b)).angle() * 180.0 / std::numbers::pi;
}

/// As an import makes them of files that were mirrored along one axis: front and atrium are found in the mirror image, so x is turned.
Eigen::Matrix3d of_mirror_image(const Eigen::Matrix3d& axes, Index along) {
  Eigen::Matrix3d mirrored = axes;
  mirrored.row(along) *= -1.0;
  mirrored.col(0) *= -1.0;
  return mirrored;
}

/// How far the posteromedial places lie to the posteromedial side of the anterolateral ones; none: not both are named.
std::optional<double> sides_apart_mm(const std::vector<ImportedTip>& sided, const Vec3& x) {
  std::array<double, 2> sum = {0.0, 0.0}, count = {0.0, 0.0};
  for (const ImportedTip& place : sided) {
    const std::size_t side = place.side == Side::Anterolateral ? 0 : 1;
    sum[side] += x.dot(place.position_mm);
    count[side] += 1.0;
  }
  if (count[0] == 0.0 || count[1] == 0.0) return {};
  return sum[1] / count[1] - sum[0] / count[0];
}

}  // namespace

Expected<ImportDecision> judged_handedness(const ImportSource& source, const PatientFrame& frame) {
  if (const auto apart = sides_apart_mm(source.sided, frame.axes.col(0));
      apart && std::abs(*apart) >= kLeastApart_mm) {
    if (*apart > 0.0)
      return ImportDecision{kSubject, "no mirror image",
                            "parts named after a side lie on that side"};
    return Error{ErrorCode::BadGeometry, "/mirrored",
                 "must be set if the files show a mirror image, because parts named after the "
                 "anterolateral side (A1, P1) lie on the posteromedial side; otherwise the names "
                 "of the sides are interchanged"};
  }
  constexpr const char* kNoSign =
      "there are no papillary tips or parts named after a side (A1, P3); --mirrored mirrors all "
      "files";
  if (source.axes == SourceAxes::Stated) {
    const Eigen::Matrix3d usual = usual_axes();
    const double off = degrees_between(frame.axes, usual);
    double mirrored = 180.0;
    for (Index along = 0; along < 3; ++along)
      mirrored = std::min(mirrored, degrees_between(frame.axes, of_mirror_image(usual, along)));
    if (off <= kUsual_deg)
      return ImportDecision{
          kSubject, "no mirror image",
          "its orientation in the stated patient axes is that of a heart, within " +
              significant(off, 2) + " degrees",
          false, 0.95};
    if (mirrored <= kMirrored_deg)
      return ImportDecision{
          kSubject, "possibly a mirror image",
          "its orientation in the stated patient axes is that of a mirrored heart, within " +
              significant(mirrored, 2) + " degrees; --mirrored mirrors all files",
          true, 0.3};
    return ImportDecision{kSubject, kUnseen,
                          "it lies " + significant(off, 3) +
                              " degrees from how a heart usually lies in the stated axes, and " +
                              kNoSign,
                          true, 0.5};
  }
  if (source.axes == SourceAxes::Unknown)
    return ImportDecision{kSubject, kUnseen,
                          std::string("the label map does not state its axes, and ") + kNoSign,
                          true, 0.5};
  return ImportDecision{kSubject, kUnseen, kNoSign, false, 0.5};
}

}  // namespace coapt
