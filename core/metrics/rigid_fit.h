// Laying one shape over another by a rigid motion.
//
// With known partners: least squares (Kabsch 1976; Umeyama 1991 without scale). Onto a surface: iterative closest point.
// Each round moves the points towards the planes of their nearest faces (Chen and Medioni 1992), which converges
// quadratically where the shapes agree; a round that would take them further away is replaced by one towards the nearest
// points themselves (Besl and McKay 1992), which cannot. Points whose nearest one lies on the edge of the surface do not
// pull (Turk and Levoy 1994): they may lie beyond it.
#pragma once

#include <functional>

#include "core/metrics/surface_tree.h"

namespace coapt {

/// x -> rotation x + shift.
struct RigidMotion {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 shift_mm = Vec3::Zero();
};

Points moved(const Points& points_mm, const RigidMotion& motion);

/// First `first`, then `second`.
RigidMotion composed(const RigidMotion& first, const RigidMotion& second);

/// 0 to 180.
double rotation_deg(const RigidMotion& motion);

/// Of row i to row i, in the least-squares sense. At least one row.
RigidMotion fit_to_points(const Points& from_mm, const Points& to_mm);

struct SurfaceFit {
  RigidMotion motion;
  /// Of the moved points from the surface, all of them; infinite if cancelled before it was known.
  double rms_mm = 0.0;
  int rounds = 0;
  bool settled = false;  ///< the last rounds moved hardly anything; else they ran out
};

inline constexpr int kMostRounds = 200;

/// From `start` on. At least one point.
SurfaceFit fit_to_surface(const Points& points_mm, const SurfaceTree& surface,
                          const RigidMotion& start = {}, int max_rounds = kMostRounds);

/// From where the mesh lies and, because it may come from another frame of reference, also from principal axes laid over
/// principal axes, in eight ways; those count only if their fit is better by a third.
/// @param cancelled asked as nearest_to_each() does; true, from then on, ends it, not settled
SurfaceFit fit_mesh_to_surface(const Points& vertices_mm, const Faces& faces,
                               const SurfaceTree& surface,
                               const std::function<bool()>& cancelled = {});

}  // namespace coapt
