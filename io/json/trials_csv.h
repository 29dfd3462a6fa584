// The table of trials: one row a trial, no names. Columns, in any order, all of them:
//
//   learner     1 to 1,000,000, a number that stands for a person
//   block       of the schedule, at most 64 bytes of UTF-8 without control characters but tabs and ends of lines
//   trial       1 to 100,000, ascending for each learner
//   valve       name of the valve that the case was made of, at most 200 such bytes
//   exam        A or B
//   seed        of the case, 0 to 2^53 - 1
//   difficulty  of the case, -10 to 10
//   choice      A: 1 to 4; B: eight letters T (tethered), N (normal), P (prolapsing) for A1 A2 A3 P1 P2 P3 AC PC
//   answer      the true one, alike
//   right       number of right ones: A 0 or 1, B 0 to 8; what choice and answer say
//   confidence  0 to 1
//   seconds     of analysis, 0 to 86,400
//   path_mm     that the hook travelled, 0 to 1,000,000
//   largest_n   force of the hook, 0 to 100
//   visited     segments in the order of their visits, separated by spaces; may be empty
#pragma once

#include <string_view>
#include <vector>

#include "search/training/training_trial.h"

namespace coapt {

/// Every problem is listed; "/3/confidence" is line 3 of the text. Quoted cells as RFC 4180 has them; the apostrophe before text
/// that a spreadsheet would compute (io/picture/csv_lines.h) is taken off. At most 100,000 rows.
Expected<std::vector<TrainingTrial>> read_trials_csv(std::string_view text);

}  // namespace coapt
