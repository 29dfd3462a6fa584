#include "search/plans/guide.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

OperationMerits operation(int steps, int muscles = 0) {
  OperationMerits merits;
  merits.effort.steps = steps;
  merits.muscles = muscles;
  return merits;
}

/// Of effort alone.
CostTerms terms_of(const OperationMerits& merits) {
  CostTerms terms;
  terms[CostTerm::Step] = merits.effort.steps;
  terms[CostTerm::Undersizing] = merits.effort.sizes_below;
  return terms;
}

double of(const OperationMerits& merits, double mild = 1.0, double not_borne_mm = 0.0) {
  CostTerms terms = terms_of(merits);
  terms[CostTerm::Durability] = not_borne_mm;
  return guide(terms, mild, merits);
}

TEST(Guide, NoPlanIsBelowItsOperation) {
  OperationMerits merits = operation(3, 2);
  merits.effort.sizes_below = 2.0;
  merits.avoidable_warnings = 1;
  EXPECT_EQ(of(merits), least_guide(merits));
  EXPECT_GT(of(merits, 0.5), least_guide(merits));
}

TEST(Guide, RanksAsTheRuleDoes) {
  OperationMerits warned = operation(1);
  warned.avoidable_warnings = 1;
  OperationMerits free = operation(2, 1);
  free.free_anchors = 1;
  EXPECT_LT(of(warned, 0.95), of(operation(1), 0.80)) << "acceptable before unwarned";
  EXPECT_LT(of(operation(4, 2)), of(warned)) << "unwarned before simple";
  EXPECT_LT(of(operation(3, 2)), of(operation(2, 1), 1.0, 8.5)) << "lasting before simple";
  EXPECT_LT(of(operation(2, 1), 1.0, 5.5), of(operation(3, 2)))
      << "simple among those that last enough";
  EXPECT_LT(of(operation(2)), of(operation(2, 1))) << "fewer muscles";
  EXPECT_LT(of(operation(2, 1)), of(free)) << "landmarks";
}

TEST(Guide, WhatIsAcceptableIsAlike) {
  EXPECT_EQ(of(operation(1), 0.95), of(operation(1), 1.0));
  EXPECT_GT(of(operation(1), 0.90), of(operation(2)));
}

}  // namespace
}  // namespace coapt
