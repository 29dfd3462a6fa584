#include "search/plans/durability.h"

#include <algorithm>
#include <vector>

#include "core/metrics/area_error.h"

namespace coapt {
namespace {

constexpr double kOneCourse = 1.0 / 8.0;  // of a course

bool leaks(const PlanClosure& closure, double most_mm2 = kMildLeak_mm2) {
  return !trusted(closure) || closure.leak_mm2 > most_mm2;
}

/// Along one course until it leaks more than `most_mm2`; what is not closed does not leak, but goes on rising behind a leak.
double lasts_mm(const PlanRecord& plan, const DiseaseCourse& course,
                double most_mm2 = kMildLeak_mm2) {
  double before_mm2 = 0.0, rise_mm2 = 0.0;
  for (std::size_t step = 0; step < course.indices.size(); ++step) {
    const auto found = plan.closures.find(course.indices[step]);
    const double last = static_cast<double>(step) - 1.0;  // that leaks less
    if (found == plan.closures.end()) {
      if (before_mm2 <= kMildLeak_mm2) break;
      return std::min(kFurthestCourse_mm,
                      kCourseStep_mm * (last + (most_mm2 - before_mm2) / rise_mm2));
    }
    const PlanClosure& closure = found->second;
    rise_mm2 = closure.leak_mm2 - before_mm2;
    if (leaks(closure, most_mm2)) {
      const double share = trusted(closure) && step > 0 ? (most_mm2 - before_mm2) / rise_mm2 : 0.0;
      return kCourseStep_mm * std::max(0.0, last + share);
    }
    before_mm2 = closure.leak_mm2;
  }
  return kFurthestCourse_mm;
}

double expected_mm(const PlanRecord& plan, double most_mm2) {
  double expected = 0.0;
  for (const DiseaseCourse& course : disease_courses())
    expected += kOneCourse * lasts_mm(plan, course, most_mm2);
  return expected;
}

/// The next closure of a course; none if it is at its end or at a leak.
std::optional<int> next_of(const PlanRecord& plan, const DiseaseCourse& course) {
  for (const int index : course.indices) {
    const auto found = plan.closures.find(index);
    if (found == plan.closures.end()) return index;
    if (leaks(found->second)) break;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Durability> durability(const PlanRecord& plan) {
  Durability all;
  all.expected_mm = most_durable_mm(plan);
  for (const DiseaseCourse& course : disease_courses()) {
    if (next_of(plan, course)) return std::nullopt;
    all.outlasting += lasts_mm(plan, course) >= kFurthestCourse_mm ? kOneCourse : 0.0;
  }
  return all;
}

std::optional<Interval> durability_interval(const PlanRecord& plan, int triangles) {
  if (!durability(plan)) return std::nullopt;
  const double error_mm2 = area_error_mm2(kMildLeak_mm2, {.triangles = triangles});
  return Interval{expected_mm(plan, kMildLeak_mm2 - error_mm2),
                  expected_mm(plan, kMildLeak_mm2 + error_mm2)};
}

double most_durable_mm(const PlanRecord& plan) { return expected_mm(plan, kMildLeak_mm2); }

bool close_disease_step(PlanEvaluations& evaluations, std::span<PlanRecord* const> plans,
                        PlanEvaluations::Phase phase) {
  std::vector<PlanEvaluations::Wanted> wanted;
  for (PlanRecord* plan : plans)
    for (const DiseaseCourse& course : disease_courses())
      if (const std::optional<int> next = next_of(*plan, course)) wanted.push_back({plan, *next});
  return evaluations.close(wanted, phase);
}

bool close_disease(PlanEvaluations& evaluations, std::span<PlanRecord* const> plans,
                   PlanEvaluations::Phase phase) {
  for (int step = 0; step <= kCourseSteps; ++step)
    if (!close_disease_step(evaluations, plans, phase)) return false;
  return true;
}

CostTerms durability_terms(const Durability& durability) {
  CostTerms terms;
  terms[CostTerm::Durability] = kFurthestCourse_mm - durability.expected_mm;
  return terms;
}

}  // namespace coapt
