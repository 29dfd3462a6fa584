#include "core/closure/crossing.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

namespace coapt {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

TEST(Crossing, IsFoundWhenAnEdgePiercesATriangle) {
  Faces faces(2, 3);
  faces << 0, 1, 2, 3, 4, 5;
  Points x(6, 3);
  x << 0, 0, 0, 10, 0, 0, 0, 10, 0, 2, 2, -1, 2, 3, 1, 9, 9, 5;
  EXPECT_EQ(crossing_pairs(faces, x), (Pairs{{0, 1}}));
  x.bottomRows(3).col(2).array() += 1.5;  // lifted clear
  EXPECT_TRUE(crossing_pairs(faces, x).empty());
}

TEST(Crossing, IsFoundBetweenTrianglesThatShareAVertex) {
  Faces faces(2, 3);
  faces << 0, 1, 2, 0, 3, 4;
  Points x(5, 3);
  x << 0, 0, 0, 10, 0, 0, 0, 10, 0, 4, 4, -1, 4, 4, 1;  // the edge 3-4 pierces the first triangle
  EXPECT_EQ(crossing_pairs(faces, x), (Pairs{{0, 1}}));
  x.row(3) << 4, 4, 3;
  EXPECT_TRUE(crossing_pairs(faces, x).empty());
}

TEST(Crossing, IsNotSeenInNeighboursThatShareAnEdge) {
  Faces faces(2, 3);
  faces << 0, 1, 2, 1, 0, 3;
  Points x(4, 3);
  x << 0, 0, 0, 10, 0, 0, 5, 8, 0, 5, 8, 0.2;  // folded almost flat
  EXPECT_TRUE(crossing_pairs(faces, x).empty());
}

TEST(Crossing, OfARandomSoupMatchesPlaneSideCountsOfAllPairs) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(0.0, 10.0);
  Faces faces(60, 3);
  Points x(180, 3);
  for (int v = 0; v < 180; ++v) {
    faces(v / 3, v % 3) = v;
    const int first = v - v % 3;
    for (int k = 0; k < 3; ++k)
      x(v, k) =
          v == first ? 0.6 * uniform(generator) : x(first, k) + 0.4 * uniform(generator) - 2.0;
  }
  // Reference: solve p + t (q - p) = a + u (b - a) + v (c - a) for every edge and triangle.
  Pairs brute;
  for (int f = 0; f < 60; ++f)
    for (int g = f + 1; g < 60; ++g) {
      bool crosses = false;
      for (const auto& [e, t] : {std::pair{f, g}, {g, f}})
        for (int k = 0; k < 3; ++k) {
          const Vec3 p = x.row(faces(e, k)), q = x.row(faces(e, (k + 1) % 3));
          const Vec3 a = x.row(faces(t, 0)), b = x.row(faces(t, 1)), c = x.row(faces(t, 2));
          Eigen::Matrix3d m;
          m << p - q, b - a, c - a;
          const Vec3 s = m.inverse() * (p - a);
          crosses |= s[0] > 0 && s[0] < 1 && s[1] > 0 && s[2] > 0 && s[1] + s[2] < 1;
        }
      if (crosses) brute.emplace_back(f, g);
    }
  EXPECT_GT(brute.size(), 5u);
  EXPECT_EQ(crossing_pairs(faces, x), brute);
}

}  // namespace
}  // namespace coapt
