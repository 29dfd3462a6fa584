#include "io/mesh/given_landmarks.h"

#include <array>

#include "core/valve/number_text.h"

namespace coapt {
namespace {

constexpr int kArcs = 1440;  // looked at along the annulus, a tenth of a millimetre apart

struct NamedLandmark {
  const char *key, *words;
  const std::optional<Vec3>& place_mm;
};

std::array<NamedLandmark, 4> named(const GivenLandmarks& given) {
  return {{{"anterolateral_commissure_mm", "anterolateral commissure",
            given.anterolateral_commissure_mm},
           {"posteromedial_commissure_mm", "posteromedial commissure",
            given.posteromedial_commissure_mm},
           {"saddle_peak_mm", "saddle peak", given.saddle_peak_mm},
           {"mid_posterior_mm", "mid-posterior", given.mid_posterior_mm}}};
}

}  // namespace

double nearest_arc_mm(const ArcLength& contour, const Vec3& point_mm) {
  double best = 1e300, at = 0.0;
  for (int i = 0; i < kArcs; ++i) {
    const double arc = contour.total_mm() * i / kArcs;
    const double distance = (contour.at(arc) - point_mm).norm();
    if (distance >= best) continue;
    best = distance;
    at = arc;
  }
  return at;
}

int nearest_station(const Skirt& skirt, const Vec3& point_mm, int first, int last) {
  int nearest = first;
  for (int i = first; i <= last; ++i) {
    const auto away = [&](int station) {
      return (Vec3(skirt.vertices_mm.row(station)) - point_mm).norm();
    };
    if (away(i) < away(nearest)) nearest = i;
  }
  return nearest;
}

void check_given(const FramedSource& source, ProblemList& problems) {
  const ArcLength contour(source.annulus_mm);
  for (const NamedLandmark& landmark : named(source.landmarks)) {
    if (!landmark.place_mm) continue;
    const double away =
        landmark.place_mm->allFinite()
            ? (contour.at(nearest_arc_mm(contour, *landmark.place_mm)) - *landmark.place_mm).norm()
            : 1e300;
    if (away > kLandmarkReach_mm)
      problems.add(ErrorCode::OutOfRange, std::string("/landmarks/") + landmark.key,
                   (away < 1e299 ? "lies " + significant(away, 3) + " mm from the annulus"
                                 : std::string("is no place")) +
                       "; must lie within 10 mm of the annulus, in the coordinates and units of "
                       "the files");
  }
}

std::string given_names(const GivenLandmarks& given) {
  std::string names;
  for (const NamedLandmark& landmark : named(given))
    if (landmark.place_mm) names += (names.empty() ? "" : ", ") + std::string(landmark.words);
  return names;
}

}  // namespace coapt
