#include "io/json/score_json.h"

#include <map>
#include <utility>

#include "io/json/result_json.h"
#include "io/json/version.h"
#include "search/training/exam_a.h"
#include "search/training/score.h"

namespace coapt {
namespace {

constexpr double kNextSuccess = 0.6;  // in the middle of 1/4 or 1/3 by chance and 1

Json one_score(const Score& score) {
  return {{"learner", score.learner},
          {"exam", score.segments ? "B" : "A"},
          {"block", score.block ? Json(*score.block) : nullptr},
          {"trials", score.trials},
          {"answers", score.answers},
          {"right", score.right},
          {"share", static_cast<double>(score.right) / score.answers},
          {"interval95", score.interval95},
          {"chance", score.chance},
          {"by_chance", score.by_chance},
          {"brier", score.brier},
          {"seconds", score.seconds},
          {"path_mm", score.path_mm},
          {"largest_n", score.largest_n},
          {"visited_segments", score.visited_segments},
          {"order_distance", score.order_distance},
          {"begins_at_p1", score.begins_at_p1},
          {"returns_to_p1", score.returns_to_p1},
          {"ability", score.ability.value},
          {"ability_se", score.ability.standard_error}};
}

/// @param own the trials of the score's learner and exam.
Json next_of(const Score& score, const std::vector<TrainingTrial>& own) {
  Json repeat = Json::array();
  for (const RepeatedCase& repeated : cases_to_repeat(own))
    repeat.push_back(
        {{"valve", repeated.valve}, {"seed", repeated.seed}, {"due_in", repeated.due_in}});
  return {{"learner", score.learner},
          {"exam", score.segments ? "B" : "A"},
          {"success", kNextSuccess},
          {"difficulty", difficulty_for(score.ability.value, score.chance, kNextSuccess)},
          {"repeat", std::move(repeat)}};
}

/// Of exam A; a learner's first answer to a case counts, before anything was learned of it.
Json calibrated(const std::vector<TrainingTrial>& trials) {
  std::map<int, int> raters;
  std::map<std::pair<std::string, std::uint64_t>, int> items;
  std::map<std::pair<int, int>, bool> first;
  std::vector<const TrainingTrial*> of_item;
  for (const TrainingTrial& trial : trials) {
    const auto* chosen = std::get_if<ChosenValve>(&trial.judged);
    if (!chosen) continue;
    if (first.size() == kMostCalibrationAnswers) break;
    const int rater = raters.emplace(trial.learner, raters.size()).first->second;
    const auto [item, is_new] = items.emplace(std::pair(trial.valve, trial.seed), items.size());
    if (is_new) of_item.push_back(&trial);
    first.emplace(std::pair(rater, item->second), chosen->choice == chosen->answer);
  }
  Json list = Json::array();
  if (raters.size() < kCalibrationLearners) return list;
  std::vector<RatedItem> rated;
  for (const auto& [key, right] : first) rated.push_back({key.first, key.second, right});
  const std::vector<ItemFit> fits = calibrate(rated, static_cast<int>(raters.size()),
                                              static_cast<int>(items.size()), {.chance = kChanceA});
  for (std::size_t i = 0; i < fits.size(); ++i)
    list.push_back({{"valve", of_item[i]->valve},
                    {"exam", "A"},
                    {"seed", of_item[i]->seed},
                    {"answers", fits[i].answers},
                    {"difficulty_as_made", of_item[i]->difficulty},
                    {"difficulty", fits[i].difficulty},
                    {"difficulty_se", fits[i].difficulty_se}});
  return list;
}

}  // namespace

Json score_to_json(const std::vector<TrainingTrial>& trials) {
  std::map<std::pair<int, bool>, std::vector<TrainingTrial>> own;  // of a learner and exam
  for (const TrainingTrial& trial : trials)
    own[{trial.learner, std::holds_alternative<JudgedSegments>(trial.judged)}].push_back(trial);
  Json scores = Json::array(), next = Json::array();
  for (const Score& score : scores_of(trials)) {
    scores.push_back(one_score(score));
    if (!score.block) next.push_back(next_of(score, own.at({score.learner, score.segments})));
  }
  return result_document("coapt.training_score/1", {{"trials", trials.size()},
                                                    {"scores", std::move(scores)},
                                                    {"next", std::move(next)},
                                                    {"cases", calibrated(trials)}});
}

}  // namespace coapt
