// Closing a valve on finer and finer meshes until its leak stands.
//
// Each mesh halves the edges of the one before (core/valve/refine.h) and starts from its closed
// state: the first two refinements of a preset take a half and a third of the time that they take
// from the open state, and end within 0.5 mm2 of leak (springs or continuum without bending). What
// is said of the limit is Richardson's extrapolation with Roache's precautions (1998): the observed
// order of three meshes where their changes shrink with one sign, 2 at most, a factor of 1.25 on
// the remaining error; below order 0.5 that of 0.5 for the error, and nothing extrapolated; order 1 of two meshes, which makes the error their change; and
// no order, the larger of the last two changes, where the sequence swings or grows.
//
// Leaflets with surplus tissue may come to rest in more than one shape (docs/researcher/accuracy.md): the first mesh is closed a second
// time, at half the speed, and the error of the leak takes in what that changes.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "core/closed/closed_valve.h"

namespace coapt {

struct MeshConvergenceOptions {
  ClosureOptions closure{};
  /// The leak stands when it changes by no more than the larger of these.
  double within_mm2 = 0.5;     ///< [0, inf)
  double within_share = 0.05;  ///< of the leak, [0, 1]
  int most_vertices = 10000;   ///< of a refined mesh; the given one is closed in any case
  int most_meshes = std::numeric_limits<int>::max();  ///< at least 1
};

/// Of one mesh.
struct MeshLevel {
  int triangles = 0, vertices = 0;
  ClosureStatus status = ClosureStatus::Converged;
  bool crossing = false;
  double leak_mm2 = 0.0;  ///< NaN if it flew apart
  /// Of the leak since the mesh before; NaN for the first.
  double change_mm2 = std::numeric_limits<double>::quiet_NaN();
};

enum class MeshStop {
  Settled,      ///< the leak stands
  MostMeshes,   ///< no more meshes were asked for
  VertexLimit,  ///< the next mesh would have more vertices than allowed, or validate() refuses it
  NotClosed,    ///< a closure did not converge uncrossed, or was ended by its budget
};

const char* to_string(MeshStop stop);

/// What a sequence of leaks says of its limit.
struct MeshLimit {
  /// The leak changes like the edge's length to this power; NaN where three meshes do not show one.
  double order = std::numeric_limits<double>::quiet_NaN();
  bool monotonous = true;  ///< changes of one sign, none larger than the one before
  double leak_mm2 = 0.0;  ///< expected of ever finer meshes; the last one's without an order of 0.5
  double error_mm2 = 0.0;  ///< of the last mesh's leak; NaN of a single mesh
};

/// @param leaks_mm2 of meshes each with half the edges of the one before; at least one.
MeshLimit mesh_limit(const std::vector<double>& leaks_mm2);

struct MeshConvergence {
  std::vector<MeshLevel> levels;  ///< coarsest first; at least one
  MeshStop stop = MeshStop::VertexLimit;
  MeshLimit limit;
  /// Of the first mesh's leak, closed at half the speed; NaN where either closure did not come to rest.
  double other_end_mm2 = std::numeric_limits<double>::quiet_NaN();
  ClosedValve finest;  ///< on the last mesh; its leak_error_mm2 has the other end in it
};

/// @param told of each level as it ends; may be empty. @pre the valve is valid.
MeshConvergence close_until_settled(const Valve& valve, const MeshConvergenceOptions& options,
                                    const std::function<void(const MeshLevel&)>& told = {});

}  // namespace coapt
