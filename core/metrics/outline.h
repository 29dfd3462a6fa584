// Outline of a set of faces: the edges that remain when those that two faces share, one running
// each way, are struck out. What remains is closed walks, whose winding number about a point of a
// projection in which all faces run counter-clockwise is the number of faces over it.
#pragma once

#include <array>
#include <vector>

namespace coapt {

/// Each walk is a list of vertices, first and last joined; a vertex can be met more than once.
std::vector<std::vector<int>> outline(const std::vector<std::array<int, 3>>& faces);

}  // namespace coapt
