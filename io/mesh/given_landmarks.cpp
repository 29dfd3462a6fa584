#include "io/mesh/given_landmarks.h"

#include <array>

#include "core/valve/number_text.h"

namespace coapt {
namespace {

constexpr double kUsualMove_mm = 4.0;  // more is looked at
constexpr int kArcs = 1440;            // looked at along the annulus, a tenth of a millimetre apart

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
                                 : std::string("is not a finite position")) +
                       "; must lie within 10 mm of the annulus, in the coordinates and units of "
                       "the files");
  }
  const auto& [lateral, medial, peak, posterior] = source.landmarks;
  if (lateral && medial && lateral->x() > medial->x())
    problems.add(ErrorCode::BadGeometry, "/landmarks/anterolateral_commissure_mm",
                 "lies on the posteromedial side, and the posteromedial commissure on the "
                 "anterolateral one; exchange the two, or check the axes of the files");
}

Expected<std::vector<ImportDecision>> given_decisions(const GivenLandmarks& given,
                                                      const Skirt& skirt, const Landmarks& taken) {
  const std::array stations = {taken.anterolateral_commissure, taken.posteromedial_commissure,
                               taken.saddle_peak, taken.mid_posterior};
  const auto landmarks = named(given);
  ProblemList problems;
  std::string names, alone, furthest;
  double moved_mm = 0.0;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    const NamedLandmark& landmark = landmarks[i];
    if (!landmark.place_mm) continue;
    if (i < 2 && !skirt.commissures_given) {
      alone = landmark.words;
      continue;
    }
    names += (names.empty() ? "" : ", ") + std::string(landmark.words);
    const double away = (Vec3(skirt.vertices_mm.row(stations[i])) - *landmark.place_mm).norm();
    if (away > kLandmarkReach_mm + skirt.spacing_mm)
      problems.add(ErrorCode::OutOfRange, std::string("/landmarks/") + landmark.key,
                   "lies " + significant(away, 3) + " mm from the " +
                       (i == 2 ? "anterior" : "posterior") +
                       " annulus between the commissures; must lie within 10 mm of it");
    if (away <= moved_mm) continue;
    moved_mm = away;
    furthest = landmark.words;
  }
  if (!problems.empty()) return std::move(problems).take();
  std::vector<ImportDecision> decisions;
  const bool look = moved_mm > kUsualMove_mm;
  if (!names.empty())
    decisions.push_back({"landmarks", names + " as given",
                         look ? "the " + furthest + " was moved by " + significant(moved_mm, 2) +
                                    " mm to the annulus; up to " + shown(kUsualMove_mm) +
                                    " mm is usual"
                              : "moved to the annulus",
                         look, look ? 0.5 : 1.0});
  if (!alone.empty())
    decisions.push_back(
        {"landmarks", alone + " not used", "the other commissure is not given", true, 0.5});
  return decisions;
}

}  // namespace coapt
