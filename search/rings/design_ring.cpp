#include "search/rings/design_ring.h"

#include <utility>

#include "search/plans/disturbance.h"

namespace coapt {
namespace {

struct Disturbances {
  std::vector<int> searched, held_out;
};

/// As planned, nodes of the region in opposite pairs, and errors of sewing, of which a quarter has a torn suture: none twice.
Disturbances disturbances_for(bool is_one_patient) {
  const int region = is_one_patient ? 4 : 2, sewing = region;
  constexpr int kMore = 2;  // times as many are held out
  Disturbances chosen{{0}, {0}};
  for (int k = 0; k < region; ++k) chosen.searched.push_back(kRegion.first + 1 + k);
  for (int k = 0; k < sewing; ++k) chosen.searched.push_back(kIndependent.first + k);
  for (int k = 0; k < kMore * region; ++k)
    chosen.held_out.push_back(kRegion.first + 1 + region + k);
  for (int k = 0; k < kMore * sewing; ++k)
    chosen.held_out.push_back(kIndependent.first + sewing + k);
  return chosen;
}

}  // namespace

Expected<std::optional<RingDesignResult>> design_ring_by(const RingTrial& trial,
                                                         const std::vector<RingMember>& members,
                                                         const std::string& name,
                                                         const RingDesignOptions& options) {
  const bool is_one_patient = members.size() == 1;
  std::vector<RingMember> searched, judged;
  for (std::size_t i = 0; i < members.size(); ++i)
    (i % 2 == 0 ? searched : judged).push_back(members[i]);
  if (is_one_patient) judged = searched;
  if (members.empty())
    return Error{
        ErrorCode::OutOfRange, "",
        "has no member whose valve closes without crossing leaflets, so no ring can be designed"};
  const Disturbances disturbances = disturbances_for(is_one_patient);
  RingSearchOptions search{.evaluations = options.evaluations,
                           .seed = options.seed,
                           .threads = options.threads,
                           .disturbances = disturbances.searched,
                           .weights = options.weights,
                           .progress = options.progress,
                           .cancelled = options.cancelled};
  std::optional<RingSearchResult> found = search_ring(trial, searched, name, search);
  if (!found) return std::optional<RingDesignResult>();
  const RingQuestion everything{disturbances.held_out, true, true};
  const RingDesign& design = found->design;
  const auto outcomes = [&](const RingCandidate& candidate) {
    return try_ring(trial, judged, candidate, everything, options.threads);
  };
  RingDesignResult result{
      .search = *found,
      .searched_members = static_cast<int>(searched.size()),
      .held_out_members = static_cast<int>(judged.size()),
      .searched_disturbances = static_cast<int>(disturbances.searched.size()),
      .held_out_disturbances = static_cast<int>(disturbances.held_out.size()),
      .verdicts = verdicts_of(judged, outcomes({design.shape, design.width_over_transverse}),
                              outcomes(found->generic.candidate)),
      .claims = ask_claims(trial, judged, options.threads)};
  if (options.cancelled != nullptr && *options.cancelled) return std::optional<RingDesignResult>();
  return std::optional<RingDesignResult>(std::move(result));
}

Expected<std::optional<RingDesignResult>> design_ring(std::vector<RingMember> members,
                                                      const std::string& name,
                                                      const RingDesignOptions& options) {
  const ClosureOptions closure;
  const auto given = members.size();
  members = prepare_members(std::move(members), closure, options.threads);
  auto result = design_ring_by(closing_trial(closure), members, name, options);
  if (result && *result) (*result)->untrusted_members = static_cast<int>(given - members.size());
  return result;
}

}  // namespace coapt
