#include "io/picture/oblique_plot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/picture/svg.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;

// A quarter to the left of the diagonal, so that no two edges of the box coincide.
constexpr double kAzimuth = 38.0 * std::numbers::pi / 180.0;
constexpr double kElevation = 18.0 * std::numbers::pi / 180.0;

/// Directions in the box, x and y of which are 1 long: to the right, upwards, away.
struct Sight {
  Vector3d right{std::cos(kAzimuth), -std::sin(kAzimuth), 0.0};
  Vector3d up{std::sin(kElevation) * std::sin(kAzimuth), std::sin(kElevation) * std::cos(kAzimuth),
              std::cos(kElevation)};
  Vector3d away{std::cos(kElevation) * std::sin(kAzimuth),
                std::cos(kElevation) * std::cos(kAzimuth), -std::sin(kElevation)};
};

/// x and y 0 to 1, z 0 to the box's height.
Vector3d shares(const ObliqueBox& box, const Vector3d& point) {
  Vector3d in;
  for (int i = 0; i < 3; ++i) {
    const Axis& axis = box.axes[static_cast<std::size_t>(i)];
    in[i] = (point[i] - axis.low) / (axis.high - axis.low);
  }
  in.z() *= box.height;
  return in;
}

std::string at(const Vector2d& p) { return fixed(p.x(), 1) + " " + fixed(p.y(), 1); }

std::string polygon(const std::string& style, const std::vector<Vector2d>& corners) {
  std::string path;
  for (const Vector2d& corner : corners) path += (path.empty() ? "M" : "L") + at(corner);
  return "<path class=\"" + style + "\" d=\"" + path + "Z\"/>\n";
}

std::string segment(const char* style, const Vector2d& a, const Vector2d& b) {
  return line_at(style, a.x(), a.y(), b.x(), b.y());
}

struct Face {
  double away;
  std::vector<Vector2d> corners;
};

std::vector<Face> faces_of(const ObliqueBox& box, const Surface& surface) {
  std::vector<Face> faces;
  for (std::size_t i = 0; i + 1 < surface.x.size(); ++i)
    for (std::size_t j = 0; j + 1 < surface.y.size(); ++j) {
      Face face{0.0, {}};
      for (const auto& [a, b] : {std::pair(i, j), {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}) {
        if (!std::isfinite(surface.z[a][b])) break;
        const Vector3d corner(surface.x[a], surface.y[b], surface.z[a][b]);
        face.corners.push_back(project(box, corner));
        face.away += Sight().away.dot(shares(box, corner));
      }
      if (face.corners.size() == 4) faces.push_back(face);
    }
  std::stable_sort(faces.begin(), faces.end(),
                   [](const Face& a, const Face& b) { return a.away > b.away; });
  return faces;
}

}  // namespace

Vector2d project(const ObliqueBox& box, const Vector3d& point) {
  const Sight sight;
  // The box's extent on the screen: rightwards from its corner y, upwards from its corner 0.
  const double left = sight.right.y(), width = sight.right.x() - left;
  const double height = sight.up.dot(Vector3d(1.0, 1.0, box.height));
  const double scale =
      std::min((box.area.right - box.area.left) / width, (box.area.bottom - box.area.top) / height);
  const double middle = 0.5 * (box.area.left + box.area.right);
  const double centre = 0.5 * (box.area.top + box.area.bottom);
  const Vector3d in = shares(box, point);
  return {middle + scale * (sight.right.dot(in) - left - 0.5 * width),
          centre - scale * (sight.up.dot(in) - 0.5 * height)};
}

std::string draw_box(const ObliqueBox& box, const std::array<std::string, 3>& labels) {
  const auto& [x, y, z] = box.axes;
  const auto point = [&](double px, double py, double pz) {
    return project(box, Vector3d(px, py, pz));
  };
  std::string svg;
  const auto rule = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    svg += segment("grid", project(box, a), project(box, b));
    svg += segment("grid", project(box, b), project(box, c));
  };
  const auto tick = [&](const Vector2d& p, double dx, double dy, const char* anchor, double value,
                        int decimals) {
    svg += text_at(p.x() + dx, p.y() + dy,
                   "class=\"tick\" text-anchor=\"" + std::string(anchor) + "\"",
                   fixed(value, decimals));
  };
  for (const double v : ticks_of(x)) {
    rule({v, y.low, z.low}, {v, y.high, z.low}, {v, y.high, z.high});
    tick(point(v, y.low, z.low), 4.0, 15.0, "start", v, x.decimals);
  }
  for (const double v : ticks_of(y)) {
    rule({x.low, v, z.low}, {x.high, v, z.low}, {x.high, v, z.high});
    if (v > y.low)  // the corner has one number
      tick(point(x.low, v, z.low), -4.0, 15.0, "end", v, y.decimals);
  }
  for (const double v : ticks_of(z)) {
    rule({x.low, y.high, v}, {x.high, y.high, v}, {x.high, y.low, v});
    tick(point(x.low, y.high, v), -7.0, 4.0, "end", v, z.decimals);
  }
  svg += segment("axis", point(x.low, y.low, z.low), point(x.high, y.low, z.low));
  svg += segment("axis", point(x.low, y.low, z.low), point(x.low, y.high, z.low));
  svg += segment("axis", point(x.low, y.high, z.low), point(x.low, y.high, z.high));
  const Vector2d x_middle = point(0.5 * (x.low + x.high), y.low, z.low);
  const Vector2d y_middle = point(x.low, 0.5 * (y.low + y.high), z.low);
  const Vector2d z_top = point(x.low, y.high, z.high);
  svg += text_at(x_middle.x() + 16.0, x_middle.y() + 32.0, "text-anchor=\"start\"", labels[0]);
  svg += text_at(y_middle.x() - 16.0, y_middle.y() + 32.0, "text-anchor=\"end\"", labels[1]);
  return svg + text_at(z_top.x() - 24.0, z_top.y() - 12.0, "text-anchor=\"start\"", labels[2]);
}

std::string draw_surfaces(const ObliqueBox& box, const std::vector<Surface>& surfaces) {
  std::string svg;
  for (const Surface& surface : surfaces)
    for (const Face& face : faces_of(box, surface))
      svg += polygon("face " + surface.colour, face.corners);
  return svg;
}

std::string draw_arrows(const ObliqueBox& box, std::vector<Arrow> arrows) {
  constexpr double kDot = 2.5;  // px; shorter arrows are dots
  std::stable_sort(arrows.begin(), arrows.end(), [&](const Arrow& a, const Arrow& b) {
    return Sight().away.dot(shares(box, a.from)) > Sight().away.dot(shares(box, b.from));
  });
  std::string svg;
  for (const Arrow& arrow : arrows) {
    if (!arrow.from.allFinite() || !arrow.along.allFinite()) continue;
    const Vector2d from = project(box, arrow.from), to = project(box, arrow.from + arrow.along);
    const double length = (to - from).norm();
    const std::string shade = shade_class(arrow.share);
    svg += "<g class=\"arrow " + shade + "\"><circle class=\"solid\" cx=\"" + fixed(from.x(), 1) +
           "\" cy=\"" + fixed(from.y(), 1) + "\" r=\"1.4\"/>\n";
    if (length > kDot) {
      const Vector2d along = (to - from) / length, across(-along.y(), along.x());
      const double head = std::min(8.0, 0.55 * length);
      svg += segment("line", from, to - 0.8 * head * along);
      svg += polygon("solid", {to, to - head * along + 0.42 * head * across,
                               to - head * along - 0.42 * head * across});
    }
    svg += "</g>\n";
  }
  return svg;
}

}  // namespace coapt
