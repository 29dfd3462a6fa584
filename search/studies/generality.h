// How general the thesis's findings are: the same studies on many valves.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "search/studies/anatomy.h"
#include "search/studies/anchor_question.h"
#include "search/studies/findings.h"

namespace coapt {

struct StudiedValve {
  std::string kind;  ///< what it is counted with, such as "random anatomies"
  Valve valve;
};

/// `count` anatomies from the box of anatomy_parameters(), uniformly, of which each makes a
/// competent valve: it closes uncrossed with at most 5 mm2. Others are drawn again, and counted.
struct RandomAnatomies {
  std::vector<Valve> valves;
  std::vector<ParametricValve> dimensions;  ///< of each valve
  int drawn = 0;
};
RandomAnatomies random_anatomies(int count, std::uint64_t seed, int threads);

struct ValveFindings {
  std::string kind, name;
  std::vector<Finding> findings;
  int configurations = 0, untrusted = 0;
  int closures = 0;  ///< made for it now
};

struct GeneralityOptions {
  ThesisStudyOptions
      studies;  ///< its stage is told from several threads, if several valves are studied at once
  /// Valves studied at once. Worth it where tables close elsewhere; changes no answer.
  int at_once = 1;
  std::function<void(int, int)> progress;  ///< valves done, planned; from one thread at a time
};

/// `open_table` is called from several threads, if several valves are studied at once.
std::vector<ValveFindings> study_generality(const std::vector<StudiedValve>& valves,
                                            const OpenTable& open_table,
                                            const GeneralityOptions& options = {});

/// On which share of the valves of a kind a finding holds; "" is all kinds.
struct FindingShare {
  std::string finding, kind;
  int valves = 0, agree = 0;  ///< valves where it could be asked
};
std::vector<FindingShare> finding_shares(const std::vector<ValveFindings>& studied);

}  // namespace coapt
