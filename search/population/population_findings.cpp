#include "search/population/population_findings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "search/plans/objective.h"
#include "search/population/population_factors.h"
#include "search/population/truncated_normal.h"

namespace coapt {
namespace {

using Records = std::vector<const PopulationRecord*>;

const CandidateRecord& of(const PopulationRecord& record, int candidate) {
  return record.candidates[static_cast<std::size_t>(candidate)];
}

double cheapest_cost(const PopulationRecord& record) {
  double cheapest = kWorstRepair;
  for (const CandidateRecord& candidate : record.candidates)
    cheapest = std::min(cheapest, capped_cost(candidate));
  return cheapest;
}

std::vector<FamilyWins> family_wins(const Records& records) {
  std::vector<FamilyWins> all(kRepairFamilies);
  for (int f = 0; f < kRepairFamilies; ++f) all[f].family = static_cast<RepairFamily>(f);
  for (const PopulationRecord* record : records) {
    const double best = cheapest_cost(*record);
    std::vector<double> of_family(kRepairFamilies, std::numeric_limits<double>::infinity());
    for (int c = 0; c < kCandidates; ++c) {
      double& cost = of_family[static_cast<std::size_t>(candidate_repairs()[c].family)];
      if (is_closed(of(*record, c))) cost = std::min(cost, capped_cost(of(*record, c)));
    }
    bool won = false;
    for (int f = 0; f < kRepairFamilies; ++f) {
      all[f].offered += std::isfinite(of_family[f]);
      all[f].as_good += of_family[f] < best + kRepairTie_mm2;
      const bool wins = !won && of_family[f] <= best;
      all[f].wins += wins;
      won = won || wins;
    }
  }
  return all;
}

std::vector<CandidateMeans> candidate_means(const Records& records) {
  std::vector<CandidateMeans> all;
  for (int c = 0; c < kCandidates; ++c) {
    CandidateMeans means{c};
    std::vector<double> leaks;
    double cost = 0.0;
    int offered = 0;
    for (const PopulationRecord* record : records) {
      const CandidateRecord& candidate = of(*record, c);
      if (candidate.state == static_cast<int>(CandidateState::NotOffered)) continue;
      ++offered;
      cost += capped_cost(candidate);
      if (!is_closed(candidate)) {
        ++means.refused;
        continue;
      }
      ++means.closed;
      means.wins += capped_cost(candidate) <= cheapest_cost(*record);
      if (!std::isfinite(candidate.mean_mm2)) continue;
      leaks.push_back(candidate.mean_mm2);
      means.competent += candidate.mean_mm2 <= kMildLeak_mm2;
    }
    if (offered == 0) continue;
    means.cost = cost / offered;
    means.leak_mm2 = mean_interval(leaks);
    all.push_back(means);
  }
  return all;
}

/// The candidate that differs in its anchor alone; -1 if there is none.
int with_anchor(const CandidateRepair& candidate, Anchor anchor) {
  for (int c = 0; c < kCandidates; ++c) {
    const CandidateRepair& other = candidate_repairs()[c];
    if (other.family == candidate.family && other.anchor == anchor &&
        other.both_muscles == candidate.both_muscles && other.movement_mm == candidate.movement_mm)
      return c;
  }
  return -1;
}

std::vector<AnchorComparison> compare_anchors(const Records& records) {
  std::vector<AnchorComparison> all;
  for (int c = 0; c < kCandidates; ++c) {
    const CandidateRepair& candidate = candidate_repairs()[c];
    if (candidate.movement_mm == 0.0 || candidate.anchor != Anchor::IpsilateralTrigone) continue;
    const int peak = with_anchor(candidate, Anchor::SaddlePeak);
    AnchorComparison comparison{candidate.both_muscles,
                                candidate.family == RepairFamily::PapillaryAndRing,
                                candidate.movement_mm};
    std::vector<double> differences;
    for (const PopulationRecord* record : records) {
      const double difference =
          static_cast<double>(of(*record, c).mean_mm2) - of(*record, peak).mean_mm2;
      if (!is_closed(of(*record, c)) || !is_closed(of(*record, peak)) || !std::isfinite(difference))
        continue;
      differences.push_back(difference);
      comparison.trigone_better += difference < -kLeakTie_mm2;
      comparison.same += std::abs(difference) <= kLeakTie_mm2;
    }
    comparison.members = static_cast<int>(differences.size());
    comparison.difference_mm2 = mean_interval(differences);
    if (comparison.members > 0) all.push_back(comparison);
  }
  return all;
}

std::vector<Undersizing> undersizing_of(const Records& records) {
  std::vector<Undersizing> all;
  for (int c = 0; candidate_repairs()[c].family == RepairFamily::OwnRing; ++c) {
    Undersizing sizes{candidate_repairs()[c].sizes_below};
    std::vector<double> leaks;
    for (const PopulationRecord* record : records) {
      const CandidateRecord& candidate = of(*record, c);
      if (!is_closed(candidate) || !std::isfinite(candidate.mean_mm2)) continue;
      leaks.push_back(candidate.mean_mm2);
      sizes.competent += candidate.mean_mm2 <= kMildLeak_mm2;
    }
    sizes.closed = static_cast<int>(leaks.size());
    sizes.leak_mm2 = mean_interval(leaks);
    all.push_back(sizes);
  }
  return all;
}

/// A quantity of a record; not finite: the member does not count.
struct Quantity {
  const char* name;
  double (*of)(const PopulationRecord&);
};

double best_undersized_leak(const PopulationRecord& record) {
  double best = std::numeric_limits<double>::infinity();
  for (int c = 0; candidate_repairs()[c].family == RepairFamily::OwnRing; ++c)
    if (is_closed(of(record, c)) && std::isfinite(of(record, c).mean_mm2))
      best = std::min(best, static_cast<double>(of(record, c).mean_mm2));
  return best;
}

/// Mean over movements, muscles, with and without ring.
double trigone_advantage(const PopulationRecord& record) {
  double sum = 0.0;
  int count = 0;
  for (int c = 0; c < kCandidates; ++c) {
    const CandidateRepair& candidate = candidate_repairs()[c];
    if (candidate.movement_mm == 0.0 || candidate.anchor != Anchor::IpsilateralTrigone) continue;
    const CandidateRecord& peak = of(record, with_anchor(candidate, Anchor::SaddlePeak));
    const double advantage = static_cast<double>(peak.mean_mm2) - of(record, c).mean_mm2;
    if (!is_closed(peak) || !is_closed(of(record, c)) || !std::isfinite(advantage)) continue;
    sum += advantage;
    ++count;
  }
  return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

constexpr Quantity kQuantities[] = {
    {"leak before repair",
     [](const PopulationRecord& r) { return static_cast<double>(r.leak_mm2); }},
    {"leak with the best own ring", best_undersized_leak},
    {"advantage of the trigone over the saddle peak", trigone_advantage}};

DecidedBy decided_by(const Quantity& quantity, const Population& population,
                     const AetiologyPrior& prior, const Records& records) {
  DecidedBy found;
  found.quantity = quantity.name;
  std::vector<const PriorFactor*> anatomy, lesions;
  for (const PriorFactor& factor : population.prior.anatomy)
    if (factor.distribution.sd > 0.0) anatomy.push_back(&factor);
  for (const PriorFactor& factor : prior.lesions)
    if (factor.distribution.sd > 0.0) lesions.push_back(&factor);
  for (const PriorFactor* f : anatomy)
    found.factors.emplace_back(anatomy_factors()[static_cast<std::size_t>(f->factor)].words);
  for (const PriorFactor* f : lesions)
    found.factors.emplace_back(lesion_factors()[static_cast<std::size_t>(f->factor)].words);
  std::vector<std::vector<double>> shares;
  std::vector<double> values;
  for (const PopulationRecord* record : records) {
    const double value = quantity.of(*record);
    if (!std::isfinite(value)) continue;
    const PopulationMember& member = population.members[static_cast<std::size_t>(record->index)];
    std::vector<double> row;
    for (const PriorFactor* f : anatomy)
      row.push_back(
          share_below(f->distribution, member.anatomy[static_cast<std::size_t>(f->factor)]));
    for (const PriorFactor* f : lesions)
      row.push_back(
          share_below(f->distribution, member.lesions[static_cast<std::size_t>(f->factor)]));
    shares.push_back(std::move(row));
    values.push_back(value);
  }
  found.members = static_cast<int>(values.size());
  if (!values.empty()) found.indices = sobol_indices(shares, values);
  return found;
}

GroupFindings findings_of(const Records& records) {
  GroupFindings group;
  group.members = static_cast<int>(records.size());
  group.families = family_wins(records);
  group.candidates = candidate_means(records);
  group.anchors = compare_anchors(records);
  group.undersizing = undersizing_of(records);
  return group;
}

}  // namespace

bool is_closed(const CandidateRecord& record) {
  return record.state == static_cast<int>(CandidateState::Closed);
}

double capped_cost(const CandidateRecord& record) {
  return is_closed(record) ? std::min(kWorstRepair, static_cast<double>(record.cost))
                           : kWorstRepair;
}

std::vector<GroupFindings> population_findings(const Population& population,
                                               const std::vector<PopulationRecord>& records) {
  Records all;
  for (const PopulationRecord& record : records)
    if (record.made != 0) all.push_back(&record);
  std::vector<GroupFindings> groups{findings_of(all)};
  for (const AetiologyPrior& prior : population.prior.aetiologies) {
    Records some;
    for (const PopulationRecord* record : all)
      if (record->aetiology == static_cast<int>(prior.aetiology)) some.push_back(record);
    if (some.empty()) continue;
    groups.push_back(findings_of(some));
    groups.back().aetiology = prior.aetiology;
    for (const Quantity& quantity : kQuantities)
      if (DecidedBy decided = decided_by(quantity, population, prior, some); decided.members > 0)
        groups.back().decided_by.push_back(std::move(decided));
  }
  return groups;
}

}  // namespace coapt
