#include "search/training/exam_b.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace coapt {
namespace {

/// What a case is compared with.
struct Unlesioned {
  const Valve& valve;
  FreeEdge edge;
  Points flaccid_mm;
  SegmentHeights heights_mm;
};

bool has_all_kinds(const std::array<SegmentTruth, kSegments>& truths, int fewest) {
  const auto has = [&](Mobility mobility) {
    return std::count_if(truths.begin(), truths.end(), [&](const SegmentTruth& truth) {
             return truth.mobility == mobility;
           }) >= fewest;
  };
  return has(Mobility::Tethered) && has(Mobility::Normal) && has(Mobility::Prolapsing);
}

/// Nothing if a segment is too near to the limit, or a kind is missing.
std::optional<std::array<SegmentTruth, kSegments>> truths_of(const SegmentHeights& heights_mm,
                                                             const SegmentHeights& normal_mm,
                                                             const ExamBRules& rules) {
  std::array<SegmentTruth, kSegments> truths;
  for (std::size_t s = 0; s < kSegments; ++s) {
    const double change_mm = heights_mm[s] - normal_mm[s];
    if (std::abs(std::abs(change_mm) - rules.limit_mm) < rules.margin_mm) return std::nullopt;
    truths[s] = {mobility_of(change_mm, rules.limit_mm), heights_mm[s], normal_mm[s]};
  }
  if (!has_all_kinds(truths, rules.fewest_of_kind)) return std::nullopt;
  return truths;
}

std::optional<ExamBCase> case_of(const Unlesioned& before, CaseLesions lesions,
                                 const ExamBRules& rules) {
  const auto shorter = std::count_if(lesions.chordae.begin(), lesions.chordae.end(),
                                     [](const ChordaeLesion& l) { return l.factor < 1.0; });
  if (shorter == 0 || shorter == std::ssize(lesions.chordae)) return std::nullopt;
  Expected<Valve> changed = with_lesions(before.valve, lesions);
  if (!changed) return std::nullopt;
  ExamBCase made;
  made.flaccid_mm = flaccid_mm(*changed);
  made.flaccid_difference_mm =
      flaccid_difference_mm(before.edge, made.flaccid_mm, before.flaccid_mm);
  if (made.flaccid_difference_mm >= rules.flaccid_mm) return std::nullopt;
  made.closed = close_and_measure(*changed);
  if (!trusted(made.closed.closure)) return std::nullopt;
  const auto truths =
      truths_of(pulled_heights_mm(*changed, before.edge, rules.pull_n), before.heights_mm, rules);
  if (!truths) return std::nullopt;
  made.truths = *truths;
  made.lesions = std::move(lesions);
  made.smallest_difference = std::numeric_limits<double>::infinity();
  for (const SegmentTruth& truth : made.truths)
    if (truth.mobility != Mobility::Normal)
      made.smallest_difference = std::min(
          made.smallest_difference, std::abs(truth.height_mm - truth.normal_mm) / rules.limit_mm);
  made.difficulty = -std::log(made.smallest_difference);
  return made;
}

}  // namespace

const char* to_string(Mobility mobility) {
  switch (mobility) {
    case Mobility::Tethered:
      return "tethered";
    case Mobility::Normal:
      return "normal";
    case Mobility::Prolapsing:
      return "prolapsing";
  }
  return "";
}

Mobility mobility_of(double change_mm, double limit_mm) {
  if (change_mm < -limit_mm) return Mobility::Tethered;
  return change_mm > limit_mm ? Mobility::Prolapsing : Mobility::Normal;
}

Expected<ExamBCase> make_exam_b(const Valve& valve, std::uint64_t seed, const ExamBRules& rules) {
  Expected<FreeEdge> edge = free_edge(valve);
  if (!edge) return edge.errors();
  const std::vector<Segment> segments = segments_with_chordae(valve);
  if (segments.empty())
    return Error{ErrorCode::Unsupported, "/chordae", "has no intact native chorda to change"};
  const SegmentHeights normal_mm = pulled_heights_mm(valve, *edge, rules.pull_n);
  const Unlesioned before{valve, *std::move(edge), flaccid_mm(valve), normal_mm};
  std::mt19937_64 engine(seed);
  for (int draws = 1; draws <= rules.most_draws; ++draws)
    if (std::optional<ExamBCase> made =
            case_of(before, draw_lesions(valve, segments, rules.lesions, engine), rules)) {
      made->seed = seed;
      made->draws = draws;
      return *std::move(made);
    }
  return Error{ErrorCode::Unsupported, "",
               "none of " + std::to_string(rules.most_draws) +
                   " valves with lesions looks unchanged without pressure and has tethered, normal "
                   "and prolapsing segments; try another seed or valve"};
}

}  // namespace coapt
