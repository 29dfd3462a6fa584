// The plans that a search may try on a valve (search/plans/plan_space.h), for optimisers of Python's own.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "clients/python/engine/local_valve.h"
#include "search/plans/plan_space.h"

namespace coapt {

/// Immutable, and used from many threads at once.
struct LocalSpace {
  std::shared_ptr<const Valve> valve;
  std::shared_ptr<const PlanSpace> space;  ///< not null
};

/// @param search a request's "search" object, of which the rules count
/// @param indicated what the closed valve's diagnosis indicates; else all that the rules offer
/// Throws Problems, whose paths begin with "/rules".
LocalSpace space_of(const LocalValve& valve, std::string_view search, bool indicated);

/// {"branches": [{"ring", "anterolateral", "posteromedial", "neochordae", "chordal", "leaflet", "parameters": [{"name", "lower", "step",
/// "count", "start"}]}], "cut": [{"what", "why"}]}
std::string space_document(const LocalSpace& space);

/// The coapt.plan/1 at a point of a branch's lattice. Throws std::out_of_range: there is no such point.
std::string plan_at(const LocalSpace& space, int branch, const LatticePoint& at);

/// place_of() the plan, one length for all plans of a valve; empty: the valve does not allow it.
std::vector<double> place_at(const LocalSpace& space, int branch, const LatticePoint& at);

/// What PlaceModel makes of values at places, at other places: means and standard deviations.
struct Guesses {
  std::vector<double> mean, sd;
};
/// @pre as many places as values, at least one; places of one length.
Guesses guess(const std::vector<std::vector<double>>& places, const std::vector<double>& values,
              double usual_sd, const std::vector<std::vector<double>>& at);

}  // namespace coapt
