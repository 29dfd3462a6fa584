// One trial of a learner, as it is kept: a row of the table of trials (io/json/trials_csv.h). No names.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "search/training/exam_b.h"

namespace coapt {

/// Of exam A: choices from 1 to kChoices.
struct ChosenValve {
  int choice = 1, answer = 1;
};

/// Of exam B, by Segment.
struct JudgedSegments {
  std::array<Mobility, kSegments> choice{}, answer{};
};

struct TrainingTrial {
  int learner = 1;          ///< a number, not a name
  std::string block;        ///< of the schedule: "baseline", ...
  int trial = 1;            ///< from 1, in the order that a learner did them
  std::string valve;        ///< name of the valve that cases are made of
  std::uint64_t seed = 1;   ///< of the case
  double difficulty = 0.0;  ///< of the case, as it was made
  std::variant<ChosenValve, JudgedSegments> judged;
  double confidence = 0.5;       ///< 0 to 1: the learner's probability of being right
  double seconds = 0.0;          ///< of analysis
  double path_mm = 0.0;          ///< that hooks travelled
  double largest_n = 0.0;        ///< force of a hook
  std::vector<Segment> visited;  ///< by a hook, in order, no segment twice in succession
};

/// Exam A: of one answer; exam B: of eight.
int answers_of(const TrainingTrial& trial);
int right_of(const TrainingTrial& trial);
double chance_of(const TrainingTrial& trial);

/// One answer, as a model of ability sees it.
struct Response {
  bool right = false;
  double difficulty = 0.0;
  double chance = 0.25;
  double slope = 1.0;
};
/// One of exam A, eight of exam B.
std::vector<Response> responses_of(const TrainingTrial& trial);

}  // namespace coapt
