// What a search loses where chordae were never seen: plans judged on anatomies with their own chordae, and with draws
// (core/presets/synthetic_chordae.h) in their place.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace coapt {

struct ChordaeStudyOptions {
  int anatomies = 20;  ///< random ones, dilated and displaced (varied_scenes.h)
  int draws = 10;      ///< for each of them, tips seen and tips drawn
  int plans = 12;      ///< random ones, besides no repair
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: all cores
};

enum class ChordaeKnown { Own, TipsSeen, Nothing };
const char* to_string(ChordaeKnown known);

/// One anatomy under one set of chordae.
struct DrawnAnatomy {
  int anatomy = 0;
  ChordaeKnown known = ChordaeKnown::Own;
  int draw = 0;  ///< 0 of its own chordae, else the seed
  /// Of no repair, then the plans; none where the plan is refused or the closure is not trusted.
  std::vector<std::optional<double>> leak_mm2;
};

/// Annulus and leaflets are those of the anatomy, and so is by how much disease has moved the tips: the draws take
/// their lengths before it. @param progress anatomies done, planned.
std::vector<DrawnAnatomy> study_chordae(const ChordaeStudyOptions& options,
                                        const std::function<void(int, int)>& progress = {});

/// What the median leak over the draws of an anatomy says of its plans, against its own chordae.
struct ChordaeAgreement {
  ChordaeKnown known = ChordaeKnown::TipsSeen;
  int anatomies = 0;
  double tau = 0.0;  ///< median of Kendall's tau-b over the anatomies
  double regret_mm2 = 0.0,
         most_regret_mm2 = 0.0;  ///< median, largest: leak of the plan chosen less that of the best
  double error_mm2 = 0.0;        ///< median over all plans
  double sd_mm2 = 0.0;           ///< median over all plans, of the draws
  int refused = 0;               ///< plans on draws without a leak
};
std::vector<ChordaeAgreement> chordae_agreements(const std::vector<DrawnAnatomy>& all);

/// Columns: anatomy, known, draw, plan, leak_mm2; empty where there is none.
std::string chordae_csv(const std::vector<DrawnAnatomy>& all);

}  // namespace coapt
