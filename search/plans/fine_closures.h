// The mesh that a verdict needs: reported plans closed once more, as planned, on the refined valve.
//
// A search climbs on the valve's own mesh, whose order of plans is good and whose areas near 1 mm2
// are not. A refined closure starts from the plan's own (refined_start.h). Once refined it costs
// about what eight closures of the search do, against the thousand of a reported plan's region.
#pragma once

#include <map>
#include <optional>

#include "search/plans/plan_evaluations.h"

namespace coapt {

/// Which mesh the verdicts are of.
struct FineMesh {
  int levels = 0;     ///< times that each triangle was cut into four; 0: the valve's own mesh
  int triangles = 0;  ///< of the refined valve; 0 without levels
  /// The valve as it is, closed there; none without levels or if the search was cancelled before.
  std::optional<PlanClosure> before;
  int closures = 0;  ///< made on refined meshes; SearchResult::closures does not count them
};

struct FineClosures {
  FineMesh mesh;
  /// As planned, on that mesh, measured by the least surface. Missing: cancelled before, or no levels.
  std::map<const PlanRecord*, PlanClosure> plans;
};

/// Most triangles of a mesh for verdicts: a closure on so many takes a second or two.
inline constexpr int kMostFineTriangles = 12000;

/// At most `levels` refinements, fewer where the mesh would have more than kMostFineTriangles. On
/// all threads; a search that is cancelled makes no more, one out of time makes all.
/// @param known of the same valve and levels: what is missing is added
FineClosures close_fine(PlanEvaluations& evaluations, const std::vector<PlanRecord*>& plans,
                        int levels, FineClosures known = {});

/// What the terms of a plan's cost change by when its closure as planned is the fine one, whose leak is measured where the search
/// estimates.
CostTerms fine_change(const PlanEvaluations& evaluations, const PlanRecord& plan,
                      const FineClosures& fine);

}  // namespace coapt
