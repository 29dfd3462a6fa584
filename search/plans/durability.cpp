#include "search/plans/durability.h"

#include <algorithm>

namespace coapt {
namespace {

/// Along one course; none if a closure is missing.
std::optional<double> lasts_mm(const PlanRecord& plan, const DiseaseCourse& course) {
  double before_mm2 = 0.0;
  std::optional<double> lasts;
  for (std::size_t step = 0; step < course.indices.size(); ++step) {
    const auto found = plan.closures.find(course.indices[step]);
    if (found == plan.closures.end()) return std::nullopt;
    if (lasts) continue;
    const bool closed = trusted(found->second);
    const double leak = closed ? leak_mm2(found->second) : 0.0;
    if (closed && leak <= kGoodRepair_mm2) {
      before_mm2 = leak;
      continue;
    }
    const double share =
        closed && step > 0 ? (kGoodRepair_mm2 - before_mm2) / (leak - before_mm2) : 0.0;
    lasts = kCourseStep_mm * std::max(0.0, static_cast<double>(step) - 1.0 + share);
  }
  return lasts.value_or(kFurthestCourse_mm);
}

}  // namespace

std::optional<Durability> durability(const PlanRecord& plan) {
  Durability all;
  const double share = 1.0 / static_cast<double>(disease_courses().size());
  for (const DiseaseCourse& course : disease_courses()) {
    const std::optional<double> lasts = lasts_mm(plan, course);
    if (!lasts) return std::nullopt;
    all.expected_mm += share * *lasts;
    all.outlasting += *lasts >= kFurthestCourse_mm ? share : 0.0;
  }
  return all;
}

CostTerms durability_terms(const Durability& durability) {
  CostTerms terms;
  terms[CostTerm::Durability] = kFurthestCourse_mm - durability.expected_mm;
  return terms;
}

}  // namespace coapt
