// When is the trigone the better anchor? A designed scan over anatomies: trigone less saddle peak,
// by protocol, class and objective, and which factor of the anatomy decides.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/valve/parametric.h"
#include "search/studies/anchor_summary.h"
#include "search/studies/sobol_indices.h"

namespace coapt {

/// What an anchor is to have less of.
enum class AnchorObjective { Mean, Sd, LengthSensitivity, Movement, LeakingShare };
inline constexpr std::array<AnchorObjective, 5> kAnchorObjectives = {
    AnchorObjective::Mean, AnchorObjective::Sd, AnchorObjective::LengthSensitivity,
    AnchorObjective::Movement, AnchorObjective::LeakingShare};
const char* to_string(AnchorObjective objective);
double value_of(const AnchorSummary& summary, AnchorObjective objective);

/// The factors that the scan varies around one anatomy, each over a range.
struct ScanFactor {
  const char* name;
  double lower, upper;
};
inline constexpr int kScanFactors = 6;
const std::array<ScanFactor, kScanFactors>& scan_factors();

/// `centre` with tips, trigones, saddle and reserve at these shares of their ranges.
ParametricValve scanned_anatomy(const ParametricValve& centre, const std::vector<double>& shares);

struct AnchorQuestionOptions {
  int anatomies = 64;
  std::uint64_t seed = 1;
  std::vector<Protocol> protocols = {Protocol::LookupClamped, Protocol::Closed, Protocol::Optimum};
  ApproximationOptions approximation = {6.0, 17, 20.0};
  int at_once = 1;  ///< anatomies: worth it where tables close elsewhere; changes no answer
  /// Anatomies done, planned; from one thread at a time.
  std::function<void(int, int)> progress;
};

/// A valve's table of orifices, perhaps with what an earlier run knew.
using OpenTable = std::function<OrificeTable(const Valve&)>;

struct ScannedAnatomy {
  std::vector<double> shares;
  /// Closes uncrossed with at most 5 mm2 when undisturbed; others are left out.
  bool competent = false;
  std::vector<AnchorSummary> summaries;  ///< by protocol, class, anchor
  int closures = 0;                      ///< made for it now
};

/// `open_table` is called from several threads, if several anatomies are asked at once.
std::vector<ScannedAnatomy> scan_anchors(const ParametricValve& centre, const OpenTable& open_table,
                                         const AnchorQuestionOptions& options = {});

/// One cell of the answer: over the anatomies where the class leaks.
struct AnchorAnswer {
  Protocol protocol = Protocol::Closed;
  Displaced displaced = Displaced::Anterolateral;
  AnchorObjective objective = AnchorObjective::Mean;
  int anatomies = 0, trigone_wins = 0;  ///< smaller by more than a hundredth of the saddle peak's
  int ties = 0;
  double mean_difference = 0.0;  ///< trigone less saddle peak
  SobolIndices decided_by = {};  ///< of that difference; order of scan_factors()
};

std::vector<AnchorAnswer> answer_anchor_question(const std::vector<ScannedAnatomy>& scan);

}  // namespace coapt
