// How long a repair lasts while the disease goes on (thesis 5.1.3): how far tips and annulus may go before the valve leaks again.
#pragma once

#include <optional>
#include <span>

#include "core/metrics/estimate.h"
#include "search/plans/plan_evaluations.h"

namespace coapt {

struct Durability {
  /// Way of the posteromedial tip until the leak passes kMildLeak_mm2, mean over disease_courses(); a course that
  /// does not come to that counts with kFurthestCourse_mm. Between closures the leak is taken as linear.
  double expected_mm = 0.0;
  double outlasting = 0.0;  ///< share of the courses that do not come to that
};

/// As far as courses go.
inline constexpr double kFurthestCourse_mm = kCourseSteps * kCourseStep_mm;

/// None unless all courses are closed up to where the plan leaks. Where a closure failed the valve counts as leaking.
std::optional<Durability> durability(const PlanRecord& plan);

/// What the numerical error of leaks (core/metrics/area_error.h) makes of Durability::expected_mm: leaks pass kMildLeak_mm2 so much
/// earlier or later. Beyond the last closure of a course its leak goes on rising as it did. None as durability().
std::optional<Interval> durability_interval(const PlanRecord& plan, int triangles);

/// Durability::expected_mm if what is not closed yet does not leak.
double most_durable_mm(const PlanRecord& plan);

/// Closes the next step of each course that has not leaked. False if it was stopped.
bool close_disease_step(PlanEvaluations& evaluations, std::span<PlanRecord* const> plans,
                        PlanEvaluations::Phase phase);

/// Closes the courses step by step, each up to where its plan leaks. False if it was stopped.
bool close_disease(PlanEvaluations& evaluations, std::span<PlanRecord* const> plans,
                   PlanEvaluations::Phase phase);

/// What of kFurthestCourse_mm a plan does not last.
CostTerms durability_terms(const Durability& durability);

}  // namespace coapt
