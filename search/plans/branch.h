// A branch of the plan space: discrete decisions, and the lattice of sizes, lengths and places that
// they leave open.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/repair/plan.h"
#include "core/valve/problem_list.h"

namespace coapt {

enum class ChordalChoice { None, CutStruts, Shorten, Transfer };

/// At a lesion. Triangular, Quadrangular (sliding): resections of the posterior leaflet. Clip: edge to edge. CommissuralClosure: a
/// stitch at each commissure of which both scallops prolapse.
enum class LeafletChoice { None, Triangular, Quadrangular, Clip, CommissuralClosure };

/// The discrete decisions of a plan; what is fixed is not among them.
struct Choice {
  std::string ring;                                    ///< shape; empty: none
  std::optional<Anchor> anterolateral, posteromedial;  ///< sutures
  int neochordae = 0;
  ChordalChoice chordal = ChordalChoice::None;
  LeafletChoice leaflet = LeafletChoice::None;
  bool clefts = false;  ///< sutured
};

enum class ParameterOf {
  RingSize,        ///< mm, or sizes below for an own ring
  Movement,        ///< mm, of papillary muscle `index` (0 anterolateral, 1 posteromedial)
  AnchorPlace,     ///< share of the annulus from the saddle peak towards the side of muscle `index`
  NeochordaPlace,  ///< of `along`, from the usual place of neochorda `index`
  NeochordaLength,  ///< mm, of neochorda `index`
  Shortening,       ///< mm
  LeafletWidth,     ///< mm, of a resection, a clip or a stitch
  CleftWidth,       ///< mm, from the root of each cleft, that its sutures reach
};

/// Values lower + k x step for k in [0, count).
struct Parameter {
  ParameterOf of = ParameterOf::RingSize;
  int index = 0;
  double lower = 0.0, step = 1.0;
  int count = 1;
  int start = 0;  ///< what practice would try first
};

/// From the lower end to at most the upper; it starts at the value nearest to `start`.
Parameter make_parameter(ParameterOf of, int index, Range range, double step, double start);

struct Branch {
  Choice choice;
  std::vector<Parameter> parameters;
};

/// One value per parameter of a branch.
using LatticePoint = std::vector<int>;

LatticePoint start_of(const Branch& branch);
/// Lattice points of a branch.
std::int64_t point_count(const Branch& branch);
/// The point of that number, in [0, point_count()).
LatticePoint point_at(const Branch& branch, std::int64_t number);

/// The cheapest operation of a branch: largest ring, least movement.
LatticePoint mildest_of(const Branch& branch);

/// The same values in another branch, where it has such parameters; else its start.
LatticePoint nearest_point(const Branch& from, const LatticePoint& at, const Branch& to);

/// Decisions that are not the same.
int differences(const Choice& a, const Choice& b);

}  // namespace coapt
