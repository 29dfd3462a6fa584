#include <algorithm>

#include "core/valve/mean_point.h"
#include "core/valve/validate_parts.h"

namespace coapt {
namespace {

constexpr std::size_t kMinAnnulus = 6;  // room for six landmarks
// Dilation and rings move the centroid by millimetres and the frame stays; scanner coordinates are
// off by hundreds.
constexpr double kMaxCentroidMm = 15.0;

double circumference(const Points& loop) {
  double sum = 0.0;
  for (int i = 0; i < loop.rows(); ++i)
    sum += (loop.row((i + 1) % loop.rows()) - loop.row(i)).norm();
  return sum;
}

// Positive if counter-clockwise seen from +z.
double area_from_atrium(const Points& loop) {
  double sum = 0.0;
  for (int i = 0; i < loop.rows(); ++i) {
    const auto a = loop.row(i);
    const auto b = loop.row((i + 1) % loop.rows());
    sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  return sum;
}

void check_size(const Points& loop, const std::string& path, ProblemList& problems) {
  const double length = circumference(loop);
  if (length >= kCircumferenceMm.min && length <= kCircumferenceMm.max) return;
  problems.add(ErrorCode::BadGeometry, path,
               "gives the annulus a circumference of " + shown(length) + " mm" +
                   (length == 0.0  ? ": all points are the same;"
                    : length < 1.0 ? ", which looks like metres;"
                                   : ",") +
                   " must be from 30 to 400 mm");
}

bool check_annulus_indices(const Valve& valve, ProblemList& problems) {
  const std::string path = "/annulus/vertices";
  bool usable = true;
  std::vector<bool> seen(valve.rest_mm.rows(), false);
  for (std::size_t i = 0; i < valve.annulus.size(); ++i) {
    const int vertex = valve.annulus[i];
    const std::string here = at(path, i);
    if (vertex < 0 || vertex >= valve.rest_mm.rows()) {
      usable = false;
      problems.add(ErrorCode::BadReference, here,
                   "is " + std::to_string(vertex) + ", must be the index of a vertex, 0 to " +
                       std::to_string(valve.rest_mm.rows() - 1));
    } else if (seen[vertex]) {
      usable = false;
      problems.add(ErrorCode::BadTopology, here,
                   "repeats vertex " + std::to_string(vertex) + "; the annulus passes each once");
    } else {
      seen[vertex] = true;
    }
  }
  return usable;
}

// Each annulus edge is a boundary edge, walked in the direction of its face.
void check_boundary(const Valve& valve, const MeshCheck& mesh, bool clockwise,
                    ProblemList& problems) {
  const std::size_t size = valve.annulus.size();
  const auto next = [&](int vertex) { return mesh.next_on_boundary[vertex]; };
  std::size_t reversed = 0;
  bool loop = true;
  for (std::size_t i = 0; i < size; ++i) {
    const int from = valve.annulus[i];
    const int to = valve.annulus[(i + 1) % size];
    if (next(to) == from) {
      ++reversed;
    } else if (next(from) != to) {
      loop = false;
      problems.add(ErrorCode::BadTopology, at("/annulus/vertices", i),
                   "is " + std::to_string(from) +
                       ", and no boundary edge leads from there to the "
                       "next, " +
                       std::to_string(to) + "; the annulus must be a boundary loop");
    }
  }
  if (!loop) return;
  if (reversed > 0 && !clockwise) {
    problems.add(ErrorCode::BadGeometry, "/faces",
                 "is flipped as a whole: face normals must point to the atrial surface, with each "
                 "annulus edge in its face in the direction of the annulus");
  } else if (reversed == 0 && clockwise) {
    problems.add(ErrorCode::BadGeometry, "/faces",
                 "is wound along an annulus that runs clockwise: reverse both");
  }
  std::size_t boundary = 0;
  for (const int vertex : mesh.next_on_boundary) boundary += vertex >= 0 ? 1 : 0;
  if (boundary == size) {
    problems.add(ErrorCode::BadTopology, "/faces",
                 "has no boundary but the annulus; the leaflets need a free edge");
  }
}

// Counter-clockwise from the posteromedial commissure. A trigone may coincide with its commissure.
void check_landmarks(const Valve& valve, ProblemList& problems) {
  struct Named {
    const char* name;
    int vertex;
    bool may_coincide;  // with the one before
  };
  const Landmarks& marks = valve.landmarks;
  const std::array<Named, 6> order = {{
      {"posteromedial_commissure", marks.posteromedial_commissure, false},
      {"posteromedial_trigone", marks.posteromedial_trigone, true},
      {"saddle_peak", marks.saddle_peak, false},
      {"anterolateral_trigone", marks.anterolateral_trigone, false},
      {"anterolateral_commissure", marks.anterolateral_commissure, true},
      {"mid_posterior", marks.mid_posterior, false},
  }};
  const auto size = std::ssize(valve.annulus);
  std::array<std::ptrdiff_t, 6> place{};
  bool on_annulus = true;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto found = std::find(valve.annulus.begin(), valve.annulus.end(), order[i].vertex);
    place[i] = found - valve.annulus.begin();
    if (found != valve.annulus.end()) continue;
    on_annulus = false;
    problems.add(ErrorCode::BadReference, std::string("/landmarks/") + order[i].name,
                 "is " + std::to_string(order[i].vertex) + ", must be a vertex of the annulus");
  }
  if (!on_annulus) return;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const auto before = (place[i - 1] - place[0] + size) % size;
    const auto here = (place[i] - place[0] + size) % size;
    if (here > before || (order[i].may_coincide && here == before)) continue;
    problems.add(
        ErrorCode::BadGeometry, std::string("/landmarks/") + order[i].name,
        std::string("must follow ") + order[i - 1].name +
            " along the annulus; the order is "
            "posteromedial commissure, posteromedial trigone, saddle peak, anterolateral trigone, "
            "anterolateral commissure, mid-posterior");
    return;
  }
  const auto under_pressure = [&](std::size_t i) { return valve.annulus_mm.row(place[i]); };
  if (!(under_pressure(0).x() > under_pressure(4).x())) {
    problems.add(ErrorCode::BadGeometry, "/landmarks/posteromedial_commissure",
                 "must lie at larger x than the anterolateral commissure: x is posteromedial");
  }
  if (!(under_pressure(2).y() > under_pressure(5).y())) {
    problems.add(ErrorCode::BadGeometry, "/landmarks/saddle_peak",
                 "must lie at larger y than mid-posterior: y is anterior");
  }
}

}  // namespace

void check_annulus(const Valve& valve, const MeshCheck& mesh, ProblemList& problems) {
  const std::size_t size = valve.annulus.size();
  if (size < kMinAnnulus) {
    problems.add(ErrorCode::OutOfRange, "/annulus/vertices",
                 "has " + std::to_string(size) + " entries, must have at least 6");
    return;
  }
  if (valve.annulus_mm.rows() != std::ssize(valve.annulus)) {
    problems.add(ErrorCode::OutOfRange, "/annulus/positions_mm",
                 "has " + std::to_string(valve.annulus_mm.rows()) +
                     " rows, must have one for each of the " + std::to_string(size) +
                     " annulus vertices");
    return;
  }
  const bool usable = mesh.vertices_usable && check_annulus_indices(valve, problems);
  if (!check_points(valve.annulus_mm, "/annulus/positions_mm", problems)) return;
  const std::string positions = "/annulus/positions_mm";
  check_size(valve.annulus_mm, positions, problems);
  const Vec3 centroid = mean_point(valve.annulus_mm);
  if (centroid.norm() > kMaxCentroidMm) {
    problems.add(
        ErrorCode::BadGeometry, positions,
        "has its centroid " + shown(centroid.norm()) + " mm from the origin, must be within 15 mm");
  }
  const bool clockwise = !(area_from_atrium(valve.annulus_mm) > 0.0);
  if (clockwise) {
    problems.add(ErrorCode::BadGeometry, "/annulus/vertices",
                 "runs clockwise seen from the atrium (z up), must run counter-clockwise");
  }
  if (!usable) return;
  Points rest(size, 3);
  for (std::size_t i = 0; i < size; ++i) {
    rest.row(i) = valve.rest_mm.row(valve.annulus[i]);
  }
  check_size(rest, "/vertices_mm", problems);
  if (mesh.surface) check_boundary(valve, mesh, clockwise, problems);
  if (!clockwise && is_mitral(valve)) check_landmarks(valve, problems);
}

}  // namespace coapt
