#include "io/mesh/imaged_state.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace coapt {
namespace {

constexpr int kLattice = 160;  // points across the annulus
constexpr double kMostClosed = 0.12, kLeastOpen = 0.25;

using Vec2 = Eigen::Vector2d;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

struct Lattice {
  Vec2 low;
  double step_mm = 0.0;
  std::vector<bool> covered = std::vector<bool>(kLattice * kLattice, false);
  Vec2 at(int i, int j) const { return low + step_mm * Vec2(i + 0.5, j + 0.5); }
  static std::size_t index(int i, int j) { return static_cast<std::size_t>(j * kLattice + i); }
  int cell(double coordinate, int axis) const {
    return static_cast<int>(
        std::floor(std::clamp((coordinate - low[axis]) / step_mm, -1.0, kLattice + 1.0)));
  }
};

void cover(const Vec2& a, const Vec2& b, const Vec2& c, Lattice& lattice) {
  const Vec2 least = a.cwiseMin(b).cwiseMin(c), most = a.cwiseMax(b).cwiseMax(c);
  const double turn = cross(b - a, c - a) < 0.0 ? -1.0 : 1.0;
  for (int j = std::max(0, lattice.cell(least.y(), 1));
       j <= std::min(kLattice - 1, lattice.cell(most.y(), 1)); ++j)
    for (int i = std::max(0, lattice.cell(least.x(), 0));
         i <= std::min(kLattice - 1, lattice.cell(most.x(), 0)); ++i) {
      const Vec2 p = lattice.at(i, j);
      if (turn * cross(b - a, p - a) >= 0.0 && turn * cross(c - b, p - b) >= 0.0 &&
          turn * cross(a - c, p - c) >= 0.0)
        lattice.covered[Lattice::index(i, j)] = true;
    }
}

bool is_inside(const Eigen::MatrixX2d& loop, const Vec2& p) {
  bool inside = false;
  for (Eigen::Index i = 0, j = loop.rows() - 1; i < loop.rows(); j = i++)
    if ((loop(i, 1) > p.y()) != (loop(j, 1) > p.y()) &&
        p.x() < loop(i, 0) +
                    (loop(j, 0) - loop(i, 0)) * (p.y() - loop(i, 1)) / (loop(j, 1) - loop(i, 1)))
      inside = !inside;
  return inside;
}

}  // namespace

StateSigns imaged_state(const std::vector<TriangleMesh>& leaflets, const Points& annulus_mm,
                        double thickness_mm) {
  const Eigen::RowVector3d centre = annulus_mm.colwise().mean();
  const Points centred = annulus_mm.rowwise() - centre;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(centred.transpose() * centred);
  const Eigen::Matrix<double, 3, 2> plane = solver.eigenvectors().rightCols(2);
  const Eigen::MatrixX2d loop = centred * plane;
  Lattice lattice;
  lattice.low = loop.colwise().minCoeff().transpose();
  lattice.step_mm = (loop.colwise().maxCoeff() - loop.colwise().minCoeff()).maxCoeff() / kLattice;
  StateSigns signs;
  if (!(lattice.step_mm > 0.0)) return signs;
  for (const TriangleMesh& sheet : leaflets) {
    const Eigen::MatrixX2d flat = (sheet.vertices_mm.rowwise() - centre) * plane;
    for (const auto& face : sheet.faces.rowwise())
      cover(flat.row(face[0]), flat.row(face[1]), flat.row(face[2]), lattice);
  }
  const int reach = static_cast<int>(0.5 * thickness_mm / lattice.step_mm);
  int inside = 0, bare = 0;
  for (int j = 0; j < kLattice; ++j)
    for (int i = 0; i < kLattice; ++i) {
      if (!is_inside(loop, lattice.at(i, j))) continue;
      ++inside;
      bool covered = false;
      for (int dj = -reach; dj <= reach && !covered; ++dj)
        for (int di = -reach; di <= reach && !covered; ++di)
          covered = di * di + dj * dj <= reach * reach && i + di >= 0 && i + di < kLattice &&
                    j + dj >= 0 && j + dj < kLattice &&
                    lattice.covered[Lattice::index(i + di, j + dj)];
      bare += covered ? 0 : 1;
    }
  signs.uncovered_share = inside > 0 ? static_cast<double>(bare) / inside : 0.0;
  signs.state = signs.uncovered_share <= kMostClosed ? ImagedState::Closed
                : signs.uncovered_share < kLeastOpen ? ImagedState::HalfClosed
                                                     : ImagedState::Open;
  return signs;
}

}  // namespace coapt
