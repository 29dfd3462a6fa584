// What every plan of a lattice trades (search/plans/trade_off.h), and how much of it a search has found after so many closures.
#pragma once

#include "lab/lattices/lattice_benchmark.h"
#include "search/plans/durability.h"
#include "search/plans/trade_off.h"

namespace coapt {

struct PlanOutcome {
  std::optional<TradeOff> trade_off;  ///< none: practice does not accept it
  double leak_mm2 = 0.0;              ///< mean + sd over the nodes closed
  int closures = 0;  ///< that measure_trade_offs() takes of it, its opening among them
};

struct SolvedFront {
  LatticeCase of;
  std::shared_ptr<const PlanSpace> space;
  std::shared_ptr<const FlatSpace> flat{};
  KnownPlans closures{};
  KnownOpenings openings{};
  Evaluation before{};
  std::vector<int> numbers{};           ///< of each combination's plan, see LatticePlans
  std::vector<PlanOutcome> outcomes{};  ///< by number
  double volume = 0.0;                  ///< dominated_volume() of all
};

/// @param context its `known` are taken, its `keep` is told of every closure. @param openings known ones, by plan_key(). Nothing if cancelled.
std::optional<SolvedFront> solve_front(const LatticeCase& lattice, int threads,
                                       const SearchContext& context, KnownOpenings openings,
                                       const std::function<void(const KnownOpenings&)>& keep);

/// Closures after which a run had found a share of the front's volume, as it rises.
using VolumeRise = std::vector<std::pair<int, double>>;

/// Of plans measured one after the other; each is paid for once.
VolumeRise volume_rise(const SolvedFront& front, const std::vector<int>& numbers);

}  // namespace coapt
