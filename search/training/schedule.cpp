#include "search/training/schedule.h"

#include <algorithm>
#include <random>
#include <utility>

#include "search/random_share.h"

namespace coapt {
namespace {

template <class T>
void shuffle(std::vector<T>& list, std::mt19937_64& engine) {
  for (std::size_t i = list.size(); i > 1; --i) {
    const auto other = static_cast<std::size_t>(random_share(engine) * static_cast<double>(i));
    std::swap(list[i - 1], list[std::min(other, i - 1)]);
  }
}

/// Puts those of each group `same` tells in a random order, in the places that they had.
template <class T, class Same>
void shuffle_alike(std::vector<T>& list, std::mt19937_64& engine, Same same) {
  std::vector<bool> done(list.size(), false);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (done[i]) continue;
    std::vector<std::size_t> places;
    for (std::size_t j = i; j < list.size(); ++j)
      if (j == i || same(list[i], list[j])) places.push_back(j);
    std::vector<T> alike;
    for (const std::size_t place : places) {
      alike.push_back(list[place]);
      done[place] = true;
    }
    shuffle(alike, engine);
    for (std::size_t k = 0; k < places.size(); ++k) list[places[k]] = std::move(alike[k]);
  }
}

/// No repeat directly after its case, where there are others to come between.
void shuffle_apart(std::vector<ScheduledTrial>& trials, std::mt19937_64& engine) {
  constexpr int kTries = 100;
  for (int i = 0; i < kTries; ++i) {
    shuffle(trials, engine);
    const auto twice = std::adjacent_find(
        trials.begin(), trials.end(),
        [](const ScheduledTrial& a, const ScheduledTrial& b) { return a.seed == b.seed; });
    if (twice == trials.end()) break;
  }
  std::vector<std::uint64_t> before;
  for (ScheduledTrial& trial : trials) {
    trial.repeated = std::find(before.begin(), before.end(), trial.seed) != before.end();
    before.push_back(trial.seed);
  }
}

}  // namespace

std::vector<ScheduledBlock> lay_out(const Schedule& schedule, std::uint64_t learner_seed,
                                    std::uint64_t first_seed) {
  std::mt19937_64 engine(learner_seed);
  std::vector<ScheduleBlock> blocks = schedule.blocks;
  shuffle_alike(blocks, engine, [](const ScheduleBlock& a, const ScheduleBlock& b) {
    return !a.swap.empty() && a.swap == b.swap;
  });
  struct Hand {
    bool segments;
    std::vector<std::uint64_t> seeds;
  };
  std::vector<Hand> hands;
  std::uint64_t next = first_seed;
  for (const ScheduleBlock& block : blocks) {
    if (!block.instruction.empty()) continue;
    Hand hand{block.segments, {}};
    for (int i = 0; i < block.cases; ++i) hand.seeds.push_back(next++);
    hands.push_back(std::move(hand));
  }
  // Cases of all blocks of an exam in one random order, dealt again.
  for (const bool segments : {false, true}) {
    std::vector<std::uint64_t> all;
    for (const Hand& hand : hands)
      if (hand.segments == segments) all.insert(all.end(), hand.seeds.begin(), hand.seeds.end());
    shuffle(all, engine);
    std::size_t dealt = 0;
    for (Hand& hand : hands)
      if (hand.segments == segments)
        for (std::uint64_t& seed : hand.seeds) seed = all[dealt++];
  }
  std::vector<ScheduledBlock> laid;
  auto hand = hands.begin();
  for (ScheduleBlock& block : blocks) {
    ScheduledBlock& out = laid.emplace_back();
    if (block.instruction.empty()) {
      for (const std::uint64_t seed : hand->seeds) out.trials.push_back({seed});
      const auto repeats =
          std::min<std::size_t>(static_cast<std::size_t>(block.repeats), hand->seeds.size());
      for (std::size_t i = 0; i < repeats; ++i) out.trials.push_back({hand->seeds[i]});
      shuffle_apart(out.trials, engine);
      ++hand;
    }
    out.block = std::move(block);
  }
  return laid;
}

}  // namespace coapt
