// A face deforms uniformly. With its unstressed edges written in the basis (fibre, cross-fibre) as
// a 2 x 2 matrix D and its closed edges as a 3 x 2 matrix d, the columns of d D^-1 are the images
// of the two unit directions, and the strain along each is half its squared length less a half.
#include "core/metrics/loads.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

namespace coapt {

std::vector<FaceStrain> face_strains(const Valve& valve, const Points& closed_mm) {
  std::vector<FaceStrain> strains;
  strains.reserve(valve.faces.rows());
  for (Index f = 0; f < valve.faces.rows(); ++f) {
    const auto edges = [&](const Points& points) {
      const Vec3 corner = points.row(valve.faces(f, 0)).transpose();
      Eigen::Matrix<double, 3, 2> columns;
      columns.col(0) = points.row(valve.faces(f, 1)).transpose() - corner;
      columns.col(1) = points.row(valve.faces(f, 2)).transpose() - corner;
      return columns;
    };
    const Eigen::Matrix<double, 3, 2> rest = edges(valve.rest_mm);
    const Vec3 fibre = valve.fibre.row(f).transpose();
    const Vec3 cross_fibre = rest.col(0).cross(rest.col(1)).normalized().cross(fibre);
    Eigen::Matrix<double, 3, 2> basis;
    basis << fibre, cross_fibre;
    const Eigen::Matrix2d rest_in_basis = basis.transpose() * rest;
    const Eigen::Matrix<double, 3, 2> images = edges(closed_mm) * rest_in_basis.inverse();
    strains.push_back(
        {0.5 * (images.col(0).squaredNorm() - 1.0), 0.5 * (images.col(1).squaredNorm() - 1.0)});
  }
  return strains;
}

ChordaeTension chordae_tension(const Valve& valve,
                               const std::vector<std::vector<double>>& tension_n) {
  ChordaeTension tension;
  for (std::size_t c = 0; c < tension_n.size(); ++c)
    for (std::size_t s = 0; s < tension_n[c].size(); ++s) {
      tension.max_n = std::max(tension.max_n, tension_n[c][s]);
      if (valve.chordae[c].segments[s].parent < 0) tension.sum_n += tension_n[c][s];
    }
  return tension;
}

}  // namespace coapt
