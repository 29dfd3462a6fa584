#include "search/training/score.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "search/training/binomial.h"

namespace coapt {
namespace {

constexpr std::array<int, 3> kPauses = {2, 4, 8};  // trials between two of a case

int edit_distance(const std::vector<Segment>& one, const std::vector<Segment>& other) {
  std::vector<int> row(other.size() + 1);
  for (std::size_t j = 0; j <= other.size(); ++j) row[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= one.size(); ++i) {
    int diagonal = row[0];
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= other.size(); ++j) {
      const int exchanged = diagonal + (one[i - 1] == other[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, exchanged});
    }
  }
  return row.back();
}

struct ScoreKey {
  int learner;
  bool segments;
  bool operator<(const ScoreKey& other) const {
    return std::tie(learner, segments) < std::tie(other.learner, other.segments);
  }
};

bool judges_segments(const TrainingTrial& trial) {
  return std::holds_alternative<JudgedSegments>(trial.judged);
}

Score score_of(const std::vector<const TrainingTrial*>& trials) {
  Score score;
  score.learner = trials.front()->learner;
  score.segments = judges_segments(*trials.front());
  score.chance = chance_of(*trials.front());
  std::vector<Response> responses;
  for (const TrainingTrial* trial : trials) {
    ++score.trials;
    const int answers = answers_of(*trial), right = right_of(*trial);
    score.answers += answers;
    score.right += right;
    score.brier += right * std::pow(trial->confidence - 1.0, 2) +
                   (answers - right) * std::pow(trial->confidence, 2);
    score.seconds += trial->seconds;
    score.path_mm += trial->path_mm;
    score.largest_n = std::max(score.largest_n, trial->largest_n);
    const VisitingOrder order = visiting_order(trial->visited);
    score.visited_segments += order.segments;
    score.order_distance += order.distance;
    score.returns_to_p1 += order.returns_to_p1;
    score.begins_at_p1 += order.begins_at_p1 ? 1.0 : 0.0;
    for (const Response& response : responses_of(*trial)) responses.push_back(response);
  }
  for (double* sum : {&score.seconds, &score.path_mm, &score.visited_segments,
                      &score.order_distance, &score.returns_to_p1, &score.begins_at_p1})
    *sum /= score.trials;
  score.brier /= score.answers;
  score.interval95 = share_interval(score.right, score.answers);
  score.by_chance = chance_of_at_least(score.right, score.answers, score.chance);
  score.ability = ability_of(responses);
  return score;
}

}  // namespace

VisitingOrder visiting_order(const std::vector<Segment>& visited) {
  VisitingOrder order;
  order.segments = static_cast<int>(std::set<Segment>(visited.begin(), visited.end()).size());
  if (visited.empty()) {
    order.distance = static_cast<int>(kSegments);
    return order;
  }
  order.begins_at_p1 = visited.front() == Segment::P1;
  std::vector<Segment> round = {visited.front()};
  for (std::size_t i = 1; i < visited.size(); ++i) {
    if (visited[i] == Segment::P1 && order.begins_at_p1)
      ++order.returns_to_p1;
    else if (visited[i] != round.back())
      round.push_back(visited[i]);
  }
  std::vector<Segment> expected(kVisitingOrder.begin(), kVisitingOrder.end());
  std::rotate(expected.begin(), std::find(expected.begin(), expected.end(), visited.front()),
              expected.end());
  order.distance = edit_distance(round, expected);
  return order;
}

std::vector<Score> scores_of(const std::vector<TrainingTrial>& trials) {
  std::map<ScoreKey, std::vector<const TrainingTrial*>> groups;
  for (const TrainingTrial& trial : trials)
    groups[{trial.learner, judges_segments(trial)}].push_back(&trial);
  std::vector<Score> scores;
  for (const auto& [key, all] : groups) {
    scores.push_back(score_of(all));
    std::map<std::string, std::size_t> index;  // of a block in `blocks`
    std::vector<std::vector<const TrainingTrial*>> blocks;
    for (const TrainingTrial* trial : all) {
      const auto [known, is_new] = index.emplace(trial->block, blocks.size());
      if (is_new) blocks.emplace_back();
      blocks[known->second].push_back(trial);
    }
    for (const std::vector<const TrainingTrial*>& of_block : blocks) {
      scores.push_back(score_of(of_block));
      scores.back().block = of_block.front()->block;
    }
  }
  return scores;
}

std::vector<RepeatedCase> cases_to_repeat(const std::vector<TrainingTrial>& trials) {
  struct Known {
    std::size_t pause = 0;
    int last = 0;  // trial
    bool failed = false;
  };
  std::map<std::tuple<std::string, bool, std::uint64_t>, Known> cases;
  int at = 0;
  for (const TrainingTrial& trial : trials) {
    ++at;
    Known& known = cases[{trial.valve, judges_segments(trial), trial.seed}];
    known.last = at;
    if (right_of(trial) < answers_of(trial)) {
      known.failed = true;
      known.pause = 0;
    } else if (known.failed && ++known.pause == kPauses.size()) {
      known = {0, at, false};
    }
  }
  std::vector<RepeatedCase> repeated;
  for (const auto& [name, known] : cases)
    if (known.failed)
      repeated.push_back({std::get<0>(name), std::get<1>(name), std::get<2>(name),
                          std::max(0, kPauses[known.pause] - (at - known.last))});
  std::stable_sort(
      repeated.begin(), repeated.end(),
      [](const RepeatedCase& a, const RepeatedCase& b) { return a.due_in < b.due_in; });
  return repeated;
}

}  // namespace coapt
