#include "core/valve/subdivide.h"

#include <algorithm>
#include <map>

namespace coapt {

Subdivision subdivide(const Faces& faces, int vertices) {
  Subdivision fine;
  fine.vertices = vertices;
  fine.faces.resize(4 * faces.rows(), 3);
  std::map<std::array<int, 2>, int> known;
  const auto midpoint = [&](int i, int j) {
    const std::array<int, 2> edge = {std::min(i, j), std::max(i, j)};
    const int next = vertices + static_cast<int>(fine.edges.size());
    const auto [entry, is_new] = known.try_emplace(edge, next);
    if (is_new) fine.edges.push_back(edge);
    return entry->second;
  };
  for (Index f = 0; f < faces.rows(); ++f) {
    const int a = faces(f, 0), b = faces(f, 1), c = faces(f, 2);
    const int ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
    fine.faces.row(4 * f) << a, ab, ca;
    fine.faces.row(4 * f + 1) << ab, b, bc;
    fine.faces.row(4 * f + 2) << ca, bc, c;
    fine.faces.row(4 * f + 3) << bc, ca, ab;
  }
  return fine;
}

Points with_midpoints(const Points& points, const Subdivision& subdivision) {
  Points fine(points.rows() + std::ssize(subdivision.edges), 3);
  fine.topRows(points.rows()) = points;
  Index next = points.rows();
  for (const auto& [i, j] : subdivision.edges)
    fine.row(next++) = 0.5 * (points.row(i) + points.row(j));
  return fine;
}

Insertion subdivided(Insertion insertion) {
  const double sum = insertion.weights[0] + insertion.weights[1] + insertion.weights[2];
  for (double& weight : insertion.weights) weight /= sum;
  const auto heaviest = std::max_element(insertion.weights.begin(), insertion.weights.end());
  const int corner = static_cast<int>(heaviest - insertion.weights.begin());
  insertion.face *= 4;
  if (*heaviest >= 0.5) {
    insertion.face += corner;
    for (int k = 0; k < 3; ++k)
      insertion.weights[k] = k == corner ? std::max(0.0, 2.0 * insertion.weights[k] - 1.0)
                                         : 2.0 * insertion.weights[k];
  } else {
    insertion.face += 3;
    for (double& weight : insertion.weights) weight = 1.0 - 2.0 * weight;
  }
  return insertion;
}

}  // namespace coapt
