// A start between known closures: closed shapes of one mesh change nearly linearly with a small
// movement of tips and annulus as long as no fold changes, so a few closures around a valve say
// where its leaflets come to rest before it is closed.
//
// Shares are those of the linear fit through the nominal valve whose squares are smallest, far
// closures counted less: exact for every family that is linear in its parameters, and where the
// closures do not span all of these, for what they span. Limits: a fold that changes between the
// closures, chordae that go slack. Hence the start is relaxed like any other, and one whose leaflets
// cross is none.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/closure/closure_result.h"

namespace coapt {

/// A closure and how much of it a prediction takes; shares may be negative, and their sum is 1.
struct ClosureShare {
  const ClosureResult* closure = nullptr;
  double share = 0.0;
};

/// A neighbour for close_valve(), marked as predicted: the shares' mean of closed shapes and branch
/// points, with the guards of all. None if a closure is missing, did not converge uncrossed or is of
/// another mesh, or if the leaflets of the mean cross. Cost: 0.3 ms at 650 triangles, a test for crossings.
std::optional<ClosureResult> predicted_start(const Faces& faces,
                                             std::span<const ClosureShare> shares);

/// Shares, one for each of `parameters`, whose mean of the parameters is `wanted`, or as near as
/// they come. The first is the nominal one: what lies far from it in a direction that no other one
/// has is taken from there.
/// @param parameters each of the size of `wanted`, in units that move the leaflets alike; at least
/// one.
std::vector<double> linear_shares(std::span<const Eigen::VectorXd> parameters,
                                  const Eigen::VectorXd& wanted);

}  // namespace coapt
