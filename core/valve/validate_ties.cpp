#include <set>

#include "core/valve/validate_parts.h"

namespace coapt {
namespace {

constexpr Index kMostTies = 100;
constexpr Range kTieLengthMm = {0.05, 20.0};
constexpr Range kTieZoneMm = {0.0, 10.0};
constexpr Range kTieNPerMm = {0.01, 100.0};

}  // namespace

void check_ties(const Valve& valve, ProblemList& problems) {
  if (valve.ties.empty()) return;
  if (!is_mitral(valve))
    problems.add(ErrorCode::Unsupported, "/ties", "must be those of a mitral valve");
  if (std::ssize(valve.ties) > kMostTies)
    problems.add(ErrorCode::OutOfRange, "/ties", "must be at most 100");
  std::set<std::string> ids;
  for (std::size_t i = 0; i < valve.ties.size(); ++i) {
    const Tie& tie = valve.ties[i];
    const std::string path = at("/ties", static_cast<Index>(i));
    if (!ids.insert(tie.id).second)
      problems.add(ErrorCode::OutOfRange, path + "/id", "is that of an earlier tie");
    check_insertion(tie.anterior, static_cast<int>(valve.faces.rows()), path + "/anterior",
                    problems);
    check_insertion(tie.posterior, static_cast<int>(valve.faces.rows()), path + "/posterior",
                    problems);
    check_range(problems, path + "/rest_length_mm", tie.rest_length_mm, kTieLengthMm, " mm");
    check_range(problems, path + "/zone_mm", tie.zone_mm, kTieZoneMm, " mm");
    check_range(problems, path + "/stiffness_n_per_mm", tie.stiffness_n_per_mm, kTieNPerMm,
                " N/mm");
  }
}

}  // namespace coapt
