// Closed shapes compared, and valves fitted to them, as `coapt compare` and `coapt fit` do.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "clients/python/engine/local_valve.h"
#include "core/metrics/shape_comparison.h"
#include "io/mesh/mesh_file.h"
#include "search/fit/fit.h"

namespace coapt {

/// Within so many thicknesses leaflets touch, as those that coapt (core/metrics/coaptation.h).
inline constexpr double kContactThicknesses = 1.25;

/// A shape with what it is called and how thick it is.
struct LocalShape {
  std::string source;
  LeafletMesh mesh;
  std::optional<double> thickness_mm;
};

/// Throw Problems: it diverged; it is no mesh.
LocalShape shape_of(const LocalClosure& closed);
LocalShape shape_of(std::string source, const Points& vertices_mm, const Faces& faces);
LocalShape shape_of_file(std::string source, std::string_view bytes, const std::string& format);

/// The closed valve as a file, by the end of its path. Throws Problems.
std::string file_of(const LocalClosure& closed, const std::string& path, bool open);

/// A mesh's file. Throws Problems.
TriangleMesh mesh_of_file(std::string_view bytes, const std::string& format);
std::string file_of(const TriangleMesh& mesh, const std::string& format);

struct LocalComparison {
  std::string document;  ///< coapt.comparison/1
  Points moved_mm;       ///< the closed shape's nodes, as aligned
  std::vector<double> signed_mm;
};
/// @param align "auto", "none" or "rigid"; any other throws Problems
LocalComparison compare_locally(const LocalShape& closed, const LocalShape& reference,
                                const std::string& align);

/// What a fit is asked for.
struct LocalFit {
  Points points_mm;  ///< of the closed surface, in the valve's frame
  std::string side;  ///< "atrial" or "middle"
  std::optional<double> leak_mm2, leak_sd_mm2;
  std::vector<std::string> known;  ///< of "slack", "tips", "prestretch", "hidden"
  std::optional<int> points, rounds;
  bool ruptures = false;
  int threads = 0;
};

struct LocalFitted {
  LocalValve valve;
  std::string document;  ///< coapt.fit/1
};
/// @param progress, cancelled as in FitOptions. Throws Problems.
LocalFitted fit_locally(const LocalValve& valve, const LocalFit& asked,
                        std::function<bool(int, double)> progress, std::function<bool()> cancelled);

}  // namespace coapt
