#include "io/mesh/imaged_state.h"

#include <algorithm>
#include <cstdint>

#include "core/metrics/raster.h"
#include "core/valve/principal_axes.h"

namespace coapt {
namespace {

constexpr int kLattice = 160;          // pixels across the annulus
constexpr std::size_t kAtOnce = 4096;  // triangles between two looks at the budget
constexpr double kMostClosed = 0.12, kLeastOpen = 0.25;

}  // namespace

StateSigns imaged_state(const std::vector<TriangleMesh>& leaflets, const Points& annulus_mm,
                        double thickness_mm, const ClosureBudget& budget) {
  const Eigen::RowVector3d centre = annulus_mm.colwise().mean();
  const Points centred = annulus_mm.rowwise() - centre;
  const Eigen::Matrix<double, 3, 2> plane = principal_axes(centred).rightCols(2);
  const Eigen::MatrixX2d loop = centred * plane;
  const Eigen::RowVector2d low_mm = loop.colwise().minCoeff();
  const double pixel_mm = (loop.colwise().maxCoeff() - low_mm).maxCoeff() / kLattice;
  StateSigns signs;
  if (!(pixel_mm > 0.0)) return signs;
  Mask bare{kLattice, kLattice, std::vector<std::uint8_t>(kLattice * kLattice, 0)};
  std::vector<Eigen::Vector2d> outline;
  for (const auto& point : loop.rowwise()) outline.push_back((point - low_mm) / pixel_mm);
  const int inside = mark_polygon(bare, outline);
  for (const TriangleMesh& sheet : leaflets) {
    const Eigen::MatrixX2d flat =
        (((sheet.vertices_mm.rowwise() - centre) * plane).rowwise() - low_mm) / pixel_mm;
    std::vector<Triangle> triangles;
    const auto cover = [&] {
      cover_triangles(bare, triangles, 0.5 * thickness_mm / pixel_mm);
      triangles.clear();
    };
    for (const auto& face : sheet.faces.rowwise()) {
      triangles.push_back({flat.row(face[0]), flat.row(face[1]), flat.row(face[2])});
      if (triangles.size() < kAtOnce) continue;
      cover();
      if (budget.is_cancelled()) return signs;
    }
    cover();
  }
  const auto left = std::count(bare.pixels.begin(), bare.pixels.end(), 1);
  signs.uncovered_share = inside > 0 ? static_cast<double>(left) / inside : 0.0;
  signs.state = signs.uncovered_share <= kMostClosed ? ImagedState::Closed
                : signs.uncovered_share < kLeastOpen ? ImagedState::HalfClosed
                                                     : ImagedState::Open;
  return signs;
}

}  // namespace coapt
