// Surfaces and arrows in a box seen from above its corner (0, 0, 0), without perspective: low values
// stand in front of high ones when z grows with x and y. Painter's algorithm.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "io/picture/chart_frame.h"

namespace coapt {

struct ObliqueBox {
  std::array<Axis, 3> axes;
  double height = 1.0;  ///< of the z axis, in lengths of the other two
  PlotBox area{};       ///< px; the box fits into it, words stand up to 40 px outside
};

/// Pixels.
Eigen::Vector2d project(const ObliqueBox& box, const Eigen::Vector3d& point);

/// Floor and the two walls behind; x_label on the right in front, y_label on the left, z_label at the
/// left edge.
std::string draw_box(const ObliqueBox& box, const std::array<std::string, 3>& labels);

struct Surface {
  std::string colour;  ///< class
  std::vector<double> x, y;
  std::vector<std::vector<double>>
      z;  ///< [x][y]; faces with a value that is not finite are left out
};
/// From the lowest: each is drawn over the one before.
std::string draw_surfaces(const ObliqueBox& box, const std::vector<Surface>& surfaces);

struct Arrow {
  Eigen::Vector3d from, along;
  double share = 0.0;  ///< of the colour scale
};
std::string draw_arrows(const ObliqueBox& box, std::vector<Arrow> arrows);

}  // namespace coapt
