// The parts of validate(), each in a file of its own, and what they share. Each lists its own problems and says what the
// later ones may rely on.
#pragma once

#include <string>
#include <vector>

#include "core/valve/problem_list.h"
#include "core/valve/valve.h"

namespace coapt {

/// Wide enough for any valve, narrow enough to catch a wrong unit.
inline constexpr Range kCoordinateMm = {-500.0, 500.0};
inline constexpr Range kCircumferenceMm = {30.0, 400.0};  // of an annulus

struct MeshCheck {
  bool vertices_usable = false;  ///< a sensible number of them, all of them finite
  bool faces_usable = false;     ///< their indices are those of vertices
  bool surface = false;          ///< one orientable sheet, all faces wound alike
  /// |V|, -1 off the boundary; the direction of the faces. If surface.
  std::vector<int> next_on_boundary;
};

MeshCheck check_mesh(const Valve& valve, ProblemList& problems);
void check_annulus(const Valve& valve, const MeshCheck& mesh, ProblemList& problems);
void check_chordae(const Valve& valve, ProblemList& problems);
void check_ties(const Valve& valve, ProblemList& problems);
void check_fitted(const Valve& valve, ProblemList& problems);

/// Whether all coordinates are inside the accepted range; lists each row and column that is not.
bool check_points(const Points& points, const std::string& path, ProblemList& problems);

/// A face, and weights on it that are none below 0 and add up to 1.
void check_insertion(const Insertion& insertion, int faces, const std::string& path,
                     ProblemList& problems);

inline std::string at(const std::string& path, Index index) {
  return path + '/' + std::to_string(index);
}

}  // namespace coapt
