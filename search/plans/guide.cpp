#include "search/plans/guide.h"

#include <algorithm>

#include "search/plans/durability.h"
#include "search/plans/objective.h"
#include "search/plans/plan_order.h"

namespace coapt {
namespace {

constexpr double kMuscle = 0.3, kFreeAnchor = 0.2, kResection = 0.15, kWarning = 5.0,
                 kUnlikely = 40.0;  // steps

double beside_effort(const OperationMerits& operation) {
  return kMuscle * operation.muscles + kFreeAnchor * operation.free_anchors +
         kResection * operation.resections + kWarning * operation.avoidable_warnings;
}

}  // namespace

double least_guide(const OperationMerits& operation) {
  return effort_price(operation.effort, kGuideWeights) + beside_effort(operation);
}

double guide(const CostTerms& terms, double mild, const OperationMerits& operation) {
  CostTerms counted = terms;  // what is enough by the rule is enough here
  double& short_mm = counted[CostTerm::Durability];
  short_mm =
      std::max(0.0, short_mm - (kFurthestCourse_mm - OrderThresholds{}.enough_durability_mm));
  return price(counted, kGuideWeights) + beside_effort(operation) +
         kUnlikely * std::max(0.0, kAcceptable - mild);
}

}  // namespace coapt
