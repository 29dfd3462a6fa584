// Harmonic functions on the unstressed skirt: the discrete Laplacian with cotangent weights
// (Pinkall and Polthier 1993), Dirichlet values on the annulus (and, for the height, on the free
// edge), nothing prescribed elsewhere, so that lines of constant `around` meet the free edge at a
// right angle.
//
// `around` is an angle and jumps by one turn somewhere. Its cosine and sine do not: extending them
// gives an angle that is right up to a single-valued correction; one more solve makes it harmonic.
//
// Weights of obtuse triangles may be negative; clamped to kSmallestWeight they keep the maximum
// principle (height within 0 and 1, no fold-over) at the cost of a little smoothness there.

#include "core/valve/leaflet_coordinates.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/valve/turns.h"

namespace coapt {
namespace {

constexpr double kSmallestWeight = 0.05;  // an equilateral mesh has 0.577
constexpr double kTurn = 2.0 * std::numbers::pi;

using Weights = std::map<std::pair<int, int>, double>;  // of each edge, smaller vertex first

Weights cotangent_weights(const Valve& valve) {
  Weights weights;
  for (Index f = 0; f < valve.faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int i = valve.faces(f, k), j = valve.faces(f, (k + 1) % 3);
      const Vec3 apex = valve.rest_mm.row(valve.faces(f, (k + 2) % 3));
      const Vec3 a = Vec3(valve.rest_mm.row(i)) - apex, b = Vec3(valve.rest_mm.row(j)) - apex;
      weights[std::minmax(i, j)] += 0.5 * a.dot(b) / a.cross(b).norm();
    }
  }
  for (auto& [edge, weight] : weights) weight = std::max(weight, kSmallestWeight);
  return weights;
}

std::vector<bool> on_annulus(const Valve& valve) {
  std::vector<bool> mask(valve.rest_mm.rows(), false);
  for (const int vertex : valve.annulus) mask[vertex] = true;
  return mask;
}

std::vector<bool> on_boundary(const Valve& valve) {
  std::map<std::pair<int, int>, int> faces_of;
  for (Index f = 0; f < valve.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k)
      ++faces_of[std::minmax(valve.faces(f, k), valve.faces(f, (k + 1) % 3))];
  std::vector<bool> mask(valve.rest_mm.rows(), false);
  for (const auto& [edge, count] : faces_of) {
    if (count != 1) continue;
    mask[edge.first] = true;
    mask[edge.second] = true;
  }
  return mask;
}

/// The Laplacian restricted to the vertices that are not fixed.
class Laplacian {
 public:
  Laplacian(const Weights& weights, std::vector<bool> fixed)
      : weights_(weights), fixed_(std::move(fixed)), row_(fixed_.size(), -1) {
    int rows = 0;
    for (std::size_t i = 0; i < fixed_.size(); ++i)
      if (!fixed_[i]) row_[i] = rows++;
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& [edge, weight] : weights_) {
      const int a = row(edge.first), b = row(edge.second);
      if (a >= 0) entries.emplace_back(a, a, weight);
      if (b >= 0) entries.emplace_back(b, b, weight);
      if (a < 0 || b < 0) continue;
      entries.emplace_back(a, b, -weight);
      entries.emplace_back(b, a, -weight);
    }
    Eigen::SparseMatrix<double> matrix(rows, rows);
    matrix.setFromTriplets(entries.begin(), entries.end());
    factors_.compute(matrix);
  }

  /// Values at all vertices. @param values right at the fixed vertices. @param source |V|, the
  /// Laplacian's right-hand side at the others.
  Eigen::VectorXd solve(Eigen::VectorXd values, const Eigen::VectorXd& source) const {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(factors_.rows());
    for (std::size_t i = 0; i < row_.size(); ++i)
      if (row_[i] >= 0) right(row_[i]) = source(i);
    for (const auto& [edge, weight] : weights_) {
      const int a = row(edge.first), b = row(edge.second);
      if (a >= 0 && b < 0) right(a) += weight * values(edge.second);
      if (b >= 0 && a < 0) right(b) += weight * values(edge.first);
    }
    const Eigen::VectorXd free = factors_.solve(right);
    for (std::size_t i = 0; i < row_.size(); ++i)
      if (row_[i] >= 0) values(i) = free(row_[i]);
    return values;
  }

 private:
  int row(int vertex) const { return row_[vertex]; }

  const Weights& weights_;
  std::vector<bool> fixed_;
  std::vector<int> row_;  // -1 if fixed
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
};

Eigen::VectorXd harmonic_height(const Valve& valve, const Weights& weights) {
  const std::vector<bool> annulus = on_annulus(valve);
  Eigen::VectorXd height = Eigen::VectorXd::Ones(valve.rest_mm.rows());
  for (const int vertex : valve.annulus) height(vertex) = 0.0;
  return Laplacian(weights, on_boundary(valve))
      .solve(height, Eigen::VectorXd::Zero(valve.rest_mm.rows()));
}

Eigen::VectorXd harmonic_around(const Valve& valve, const Weights& weights) {
  const Index n = valve.rest_mm.rows();
  const Laplacian laplacian(weights, on_annulus(valve));
  const std::vector<double> arc = annulus_around(valve);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd cosine = zero, sine = zero;
  for (std::size_t i = 0; i < arc.size(); ++i) {
    cosine(valve.annulus[i]) = std::cos(kTurn * arc[i]);
    sine(valve.annulus[i]) = std::sin(kTurn * arc[i]);
  }
  cosine = laplacian.solve(cosine, zero);
  sine = laplacian.solve(sine, zero);
  Eigen::VectorXd angle(n);
  for (Index i = 0; i < n; ++i) angle(i) = std::atan2(sine(i), cosine(i)) / kTurn;
  for (std::size_t i = 0; i < arc.size(); ++i) angle(valve.annulus[i]) = arc[i];
  Eigen::VectorXd source = zero;
  for (const auto& [edge, weight] : weights) {
    const double flow = weight * wrapped(angle(edge.second) - angle(edge.first));
    source(edge.first) += flow;
    source(edge.second) -= flow;
  }
  return angle + laplacian.solve(zero, source);
}

}  // namespace

std::vector<double> annulus_around(const Valve& valve) {
  const Landmarks& marks = valve.landmarks;
  const std::array<int, 4> quarter = {marks.posteromedial_commissure, marks.saddle_peak,
                                      marks.anterolateral_commissure, marks.mid_posterior};
  const Index size = std::ssize(valve.annulus);
  const auto index_of = [&](int vertex) -> Index {
    const auto found = std::find(valve.annulus.begin(), valve.annulus.end(), vertex);
    assert(found != valve.annulus.end());
    return found - valve.annulus.begin();
  };
  std::vector<double> around(size, 0.0);
  for (std::size_t q = 0; q < 4; ++q) {
    const Index first = index_of(quarter[q]), last = index_of(quarter[(q + 1) % 4]);
    std::vector<double> arc;
    double length = 0.0;
    for (Index i = first; i != last; i = (i + 1) % size) {
      arc.push_back(length);
      length += (valve.annulus_mm.row((i + 1) % size) - valve.annulus_mm.row(i)).norm();
    }
    for (std::size_t k = 0; k < arc.size(); ++k)
      around[(first + k) % size] = 0.25 * (static_cast<double>(q) + arc[k] / length);
  }
  return around;
}

LeafletCoordinates leaflet_coordinates(const Valve& valve) {
  const Weights weights = cotangent_weights(valve);
  const Eigen::VectorXd around = harmonic_around(valve, weights);
  const Eigen::VectorXd height = harmonic_height(valve, weights);
  LeafletCoordinates coordinates;
  for (Index i = 0; i < around.size(); ++i) {
    coordinates.around.push_back(turn_fraction(around(i)));
    coordinates.height.push_back(std::clamp(height(i), 0.0, 1.0));
  }
  return coordinates;
}

Vec3 annulus_point_mm(const Valve& valve, double around) {
  const std::vector<double> arc = annulus_around(valve);
  std::size_t before = 0;
  double past = 1.0;
  for (std::size_t i = 0; i < arc.size(); ++i) {
    const double here = turn_fraction(around - arc[i]);
    if (here < past) {
      past = here;
      before = i;
    }
  }
  const std::size_t after = (before + 1) % arc.size();
  const double t = std::min(1.0, past / turn_fraction(arc[after] - arc[before]));
  return (1.0 - t) * valve.annulus_mm.row(before) + t * valve.annulus_mm.row(after);
}

}  // namespace coapt
