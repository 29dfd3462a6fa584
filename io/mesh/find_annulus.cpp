#include "io/mesh/find_annulus.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/valve/contour.h"
#include "core/valve/number_text.h"
#include "core/valve/principal_axes.h"
#include "io/mesh/sheet_repair.h"

namespace coapt {
namespace {

constexpr int kSteps = 120;    // of an outline
constexpr int kAngles = 96;    // of the annulus
constexpr double kEnds = 2.0;  // weight of the distance at the ends of a stretch
constexpr double kJoin =
    1.5;  // weight of the gap to the other sheet's stretch, less than that of an end's distance
constexpr int kRounds = 3;
constexpr double kApart_mm = 3.0;  // loops further apart than this, in the mean, are different ones
constexpr double kBeyond_mm = 1.5;    // outside the loop, of billowing leaflets and noise
constexpr double kStraddled = 1.5;    // weight of the sheets' distance on either side
constexpr double kOutside = 2.0;      // weight of the share outside
constexpr double kSaddle = 0.1;       // of the loop's mean radius: off its plane for nothing, rms
constexpr double kLeastMargin = 0.1;  // of the score
constexpr double kWidestGap = 0.2;    // of the loop's length

/// Equal steps along a closed line of the mesh.
Points outline(const TriangleMesh& sheet, const std::vector<int>& loop) {
  const ArcLength arc(sheet.vertices_mm(loop, Eigen::all));
  Points points(kSteps, 3);
  for (int i = 0; i < kSteps; ++i) points.row(i) = arc.at(arc.total_mm() * i / kSteps);
  return points;
}

Eigen::Matrix3d axes_with(const Vec3& z) {
  Eigen::Matrix3d axes;
  axes.col(2) = z;
  axes.col(0) = z.unitOrthogonal();
  axes.col(1) = z.cross(axes.col(0));
  return axes;
}

/// Distances of each point from the two ends of the other sheet's stretch, n x 2; zero without another.
Eigen::MatrixX2d from_ends(const Points& line, const Points& other) {
  Eigen::MatrixX2d distances_mm = Eigen::MatrixX2d::Zero(line.rows(), 2);
  for (Eigen::Index end = 0; end < other.rows(); ++end)
    distances_mm.col(end) = (line.rowwise() - other.row(end)).rowwise().norm();
  return distances_mm;
}

/// Between the ends of two stretches, the sum over both, of points `i` and `j` of from_ends().
double gap_mm(const Eigen::MatrixX2d& from_ends_mm, Eigen::Index i, Eigen::Index j) {
  return std::min(from_ends_mm(i, 0) + from_ends_mm(j, 1), from_ends_mm(i, 1) + from_ends_mm(j, 0));
}

Points ends_of(const Points& line) {
  Points ends(2, 3);
  ends << line.row(0), line.row(line.rows() - 1);
  return ends;
}

/// The annular stretch of an outline: columns of the frame about the axis.
/// @param other ends of the other sheet's stretch, 2 x 3, or none
Points annular_stretch(const Points& framed, double depth_mm, const Points& other) {
  const auto n = framed.rows();
  Eigen::VectorXd g(n), advance(n);  // of i to i + 1
  const Vec3 q(0.0, 0.0, -depth_mm);
  for (Eigen::Index i = 0; i < n; ++i) g[i] = (Vec3(framed.row(i)) - q).norm();
  const double mean = g.mean();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Vec3 a = framed.row(i), b = framed.row((i + 1) % n);
    const double r = 0.5 * (a.head<2>().norm() + b.head<2>().norm());
    const double turn = std::atan2(a.x() * b.y() - a.y() * b.x(), a.head<2>().dot(b.head<2>()));
    advance[i] = 0.5 * (g[i] + g[(i + 1) % n]) / mean * r * turn;
  }
  const Eigen::MatrixX2d apart_mm = from_ends(framed, other);
  Eigen::Index from = 0, length = 0;
  double best = -1e300;
  for (const double sense : {1.0, -1.0}) {
    for (Eigen::Index i = 0; i < n; ++i) {
      double sum = 0.0;
      Eigen::Index before = i, end = i;
      for (Eigen::Index k = 1; k < n; ++k, before = end) {
        end = end + 1 < n ? end + 1 : 0;
        sum += sense * advance[before];
        const double without_gap = sum + kEnds * (g[i] + g[end]);
        if (without_gap <= best) continue;
        const double score = without_gap - kJoin * gap_mm(apart_mm, i, end);
        if (score <= best) continue;
        best = score;
        from = i;
        length = k;
      }
    }
  }
  Points stretch(length + 1, 3);
  for (Eigen::Index k = 0; k <= length; ++k) stretch.row(k) = framed.row((from + k) % n);
  return stretch;
}

Vec3 least_square_normal(const Points& points) {
  return principal_axes(points.rowwise() - points.colwise().mean()).col(0);
}

/// How far the smaller of both sheets' sides goes where they lie on either side of the loop's plane: about 0 of an annulus.
double straddled_mm(const std::vector<TriangleMesh>& sheets, const Points& loop_mm) {
  const Vec3 normal = least_square_normal(loop_mm);
  const double level = normal.dot(Vec3(loop_mm.colwise().mean()));
  double height_mm[2];
  for (std::size_t i = 0; i < 2; ++i)
    height_mm[i] = normal.dot(Vec3(sheets[i].vertices_mm.colwise().mean())) - level;
  if ((height_mm[0] > 0.0) == (height_mm[1] > 0.0)) return 0.0;
  return std::min(std::abs(height_mm[0]), std::abs(height_mm[1]));
}

/// Share of the outlines' points that lie outside the loop, seen along the normal of its plane.
double outside_share(const std::vector<Points>& outlines, const Points& loop_mm) {
  const Eigen::Matrix3d axes = axes_with(least_square_normal(loop_mm));
  const Eigen::RowVector3d centre = loop_mm.colwise().mean();
  std::array<double, kAngles> radius{};
  const auto sector = [](const Eigen::RowVector3d& p) {
    const double turn = std::atan2(p.y(), p.x()) / (2.0 * std::numbers::pi);
    return static_cast<std::size_t>(
        std::clamp(static_cast<int>((turn + 0.5) * kAngles), 0, kAngles - 1));
  };
  const Points loop = (loop_mm.rowwise() - centre) * axes;
  for (const auto& p : loop.rowwise()) {
    double& r = radius[sector(p)];
    r = std::max(r, p.head<2>().norm());
  }
  double outside = 0.0, total = 0.0;
  for (const Points& line : outlines) {
    const Points framed = (line.rowwise() - centre) * axes;
    for (const auto& p : framed.rowwise()) {
      const double r = radius[sector(p)];
      outside += r > 0.0 && p.head<2>().norm() > r + kBeyond_mm ? 1.0 : 0.0;
      total += 1.0;
    }
  }
  return outside / total;
}

struct Candidate {
  Points loop_mm;  ///< in the source's coordinates
  Vec3 axis = Vec3::UnitZ();
  double score = -1e300, off_plane_mm = 0.0, gap_mm = 0.0;
};

struct Loop {
  Points points_mm;      ///< of the sectors, in the frame; none of stretches that lead nowhere
  double open_mm = 0.0;  ///< length of what is between the sectors that stretches lead through
};

/// Mean distance from the axis and height in each sector; empty sectors between their neighbours.
Loop by_angle(const std::vector<Points>& stretches) {
  Eigen::MatrixX3d sums = Eigen::MatrixX3d::Zero(kAngles, 3);  // r, z, count
  for (const Points& stretch : stretches) {
    for (Eigen::Index i = 0; i + 1 < stretch.rows(); ++i) {
      for (int part = 0; part < 4; ++part) {
        const Vec3 p = stretch.row(i) + 0.25 * part * (stretch.row(i + 1) - stretch.row(i));
        const double turn = std::atan2(p.y(), p.x()) / (2.0 * std::numbers::pi);
        const int sector = std::clamp(static_cast<int>((turn + 0.5) * kAngles), 0, kAngles - 1);
        sums.row(sector) += Eigen::RowVector3d(p.head<2>().norm(), p.z(), 1.0);
      }
    }
  }
  Points loop(kAngles, 3);
  const auto filled = [&](int sector) { return sums((sector + kAngles) % kAngles, 2) > 0.0; };
  const auto mean = [&](int sector) {
    const int s = (sector + kAngles) % kAngles;
    return Eigen::Vector2d(sums(s, 0) / sums(s, 2), sums(s, 1) / sums(s, 2));
  };
  for (int s = 0; s < kAngles; ++s) {
    int back = 0, ahead = 0;
    while (back < kAngles && !filled(s - back)) ++back;
    while (ahead < kAngles && !filled(s + ahead)) ++ahead;
    if (back == kAngles) return {};
    const double share = back + ahead > 0 ? static_cast<double>(back) / (back + ahead) : 0.0;
    const Eigen::Vector2d rz = (1.0 - share) * mean(s - back) + share * mean(s + ahead);
    const double angle = 2.0 * std::numbers::pi * ((s + 0.5) / kAngles - 0.5);
    loop.row(s) << rz[0] * std::cos(angle), rz[0] * std::sin(angle), rz[1];
  }
  double open_mm = 0.0;
  for (int s = 0; s < kAngles; ++s)
    if (!filled(s)) open_mm += (loop.row((s + 1) % kAngles) - loop.row(s)).norm();
  return {loop, open_mm};
}

Candidate candidate(const std::vector<Points>& outlines, const Vec3& axis, const Vec3& centre,
                    double depth_mm) {
  const Eigen::Matrix3d axes = axes_with(axis);
  std::vector<Points> framed, stretches;
  for (const Points& points : outlines) {
    framed.emplace_back((points.rowwise() - centre.transpose()) * axes);
    stretches.push_back(annular_stretch(framed.back(), depth_mm, {}));
  }
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t i = 0; i < 2; ++i)
      stretches[i] = annular_stretch(framed[i], depth_mm, ends_of(stretches[1 - i]));
  Candidate found;
  found.axis = axis;
  const auto [loop, open_mm] = by_angle(stretches);
  if (loop.rows() == 0) return found;
  found.gap_mm =
      0.5 *
      std::max(open_mm, gap_mm(from_ends(ends_of(stretches[0]), ends_of(stretches[1])), 0, 1));
  double area = 0.0;
  for (int i = 0; i < kAngles; ++i) {
    const Eigen::RowVector3d a = loop.row(i), b = loop.row((i + 1) % kAngles);
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  const double perimeter = ArcLength(loop).total_mm();
  const Points centred = loop.rowwise() - loop.colwise().mean();
  found.off_plane_mm = (centred * least_square_normal(loop)).norm() / std::sqrt(kAngles);
  const double bent_mm =
      std::max(0.0, found.off_plane_mm - kSaddle * perimeter / (2.0 * std::numbers::pi));
  found.score = area - perimeter * (bent_mm + 0.5 * found.gap_mm);
  found.loop_mm = (loop * axes.transpose()).rowwise() + centre.transpose();
  return found;
}

/// To the faces, edges and corners of a cube: 26.
std::vector<Vec3> directions() {
  std::vector<Vec3> all;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k)
        if (i != 0 || j != 0 || k != 0) all.push_back(Vec3(i, j, k).normalized());
  return all;
}

double apart_mm(const Points& a, const Points& b) {
  double sum = 0.0;
  for (const auto& point : a.rowwise()) sum += (b.rowwise() - point).rowwise().norm().minCoeff();
  return sum / static_cast<double>(a.rows());
}

const Error kUnknown{ErrorCode::MissingField, "/annulus_mm", ""};

Error unknown(const std::string& why) {
  Error error = kUnknown;
  error.message = "is missing and cannot be detected from the leaflet outlines: " + why +
                  "; provide the annulus (--annulus)";
  return error;
}

}  // namespace

Expected<FoundAnnulus> find_annulus(const ImportSource& source) {
  std::vector<Points> outlines;
  std::vector<std::vector<int>> loops;
  for (const TriangleMesh& sheet : source.leaflets) {
    loops = boundary_loops(sheet);
    if (loops.empty()) return unknown("a leaflet is a closed surface");
    outlines.push_back(outline(sheet, loops[0]));
  }
  std::vector<Vec3> tips;
  for (const ImportedTip& tip : source.tips) tips.push_back(tip.position_mm);
  for (const ImportedChorda& chorda : source.chordae) tips.push_back(chorda.tip_mm);
  Vec3 tip = Vec3::Zero();
  for (const Vec3& one : tips) tip += one / static_cast<double>(tips.size());
  if (source.leaflets.size() == 1) {
    if (tips.empty() || loops.size() < 2)
      return unknown(tips.empty()
                         ? "papillary tips are needed to tell the two edges of a single skirt apart"
                         : "a single sheet must be a skirt with two edges");
    const Points other = outline(source.leaflets[0], loops[1]);
    const auto away = [&](const Points& line) {
      return (line.rowwise() - tip.transpose()).rowwise().norm().mean();
    };
    const double first = away(outlines[0]), second = away(other);
    return FoundAnnulus{first > second ? outlines[0] : other,
                        std::abs(first - second) / std::max(first, second), 0.0, 0.0};
  }
  Points all(kSteps * std::ssize(outlines), 3);
  for (std::size_t i = 0; i < outlines.size(); ++i)
    all.middleRows(kSteps * static_cast<Eigen::Index>(i), kSteps) = outlines[i];
  const Vec3 centre = all.colwise().mean();
  const Points centred = all.rowwise() - centre.transpose();
  const double depth_mm = centred.rowwise().norm().mean();
  if (!(depth_mm > 0.0)) return unknown("all their points are the same");
  const Eigen::Matrix3d principal = principal_axes(centred);
  std::vector<Candidate> found;
  for (const Vec3& direction : directions()) {
    const Vec3 axis = principal * direction;
    if (!tips.empty() && axis.dot(tip - centre) > 0.0) continue;
    Candidate best = candidate(outlines, axis, centre, depth_mm);
    for (int round = 0; round < kRounds && best.loop_mm.rows() > 0; ++round) {
      Vec3 normal = least_square_normal(best.loop_mm);
      if (normal.dot(axis) < 0.0) normal = -normal;
      Candidate next = candidate(outlines, normal, best.loop_mm.colwise().mean(), depth_mm);
      if (next.score <= best.score) break;
      best = std::move(next);
    }
    if (best.loop_mm.rows() == 0) continue;
    best.score -= kStraddled * ArcLength(best.loop_mm).total_mm() *
                  straddled_mm(source.leaflets, best.loop_mm);
    best.score -= kOutside * std::abs(best.score) * outside_share(outlines, best.loop_mm);
    found.push_back(std::move(best));
  }
  if (found.empty()) return unknown("none of their edges encircles an opening");
  std::stable_sort(found.begin(), found.end(),
                   [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  const Candidate& best = found.front();
  if (best.gap_mm > kWidestGap * ArcLength(best.loop_mm).total_mm() || !(best.score > 0.0))
    return unknown("their edges do not form a loop (gap " + significant(best.gap_mm, 2) + " mm)");
  FoundAnnulus annulus{best.loop_mm, 1.0, best.off_plane_mm, best.gap_mm};
  for (const Candidate& other : found) {
    if (apart_mm(best.loop_mm, other.loop_mm) < kApart_mm) continue;
    annulus.margin = std::min(1.0, (best.score - other.score) / best.score);
    break;
  }
  if (annulus.margin < kLeastMargin)
    return unknown("two loops are equally likely (their scores differ by " +
                   significant(100.0 * annulus.margin, 2) + " %)");
  return annulus;
}

}  // namespace coapt
