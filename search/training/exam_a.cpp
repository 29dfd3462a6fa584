#include "search/training/exam_a.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "search/random_share.h"
#include "search/training/flaccid.h"

namespace coapt {
namespace {

ClosedDifference difference(const FreeEdge& edge, const ClosedValve& one,
                            const ClosedValve& other) {
  return {edge_difference_mm(edge, one.closure.closed_mm, other.closure.closed_mm),
          std::abs(one.measure.leak.area_mm2 - other.measure.leak.area_mm2)};
}

/// What choices are compared with.
struct Unchanged {
  const Valve& valve;
  FreeEdge edge;
  Points flaccid_mm;
};

/// Nothing if it looks otherwise than the unlesioned valve without pressure, does not close to one shape that can be trusted, or
/// closes as one of those before it.
std::optional<CaseChoice> choice_of(const Unchanged& from, CaseLesions lesions,
                                    const std::vector<CaseChoice>& before,
                                    const ExamARules& rules) {
  const Expected<Valve> changed = with_lesions(from.valve, lesions);
  if (!changed) return std::nullopt;
  const FreeEdge& edge = from.edge;
  CaseChoice choice{std::move(lesions), {}, flaccid_mm(*changed), {}};
  if (flaccid_difference_mm(edge, choice.flaccid_mm, from.flaccid_mm) >= 0.5 * rules.flaccid_mm)
    return std::nullopt;
  choice.closed = close_and_measure(*changed);
  if (!trusted(choice.closed.closure)) return std::nullopt;
  for (const CaseChoice& other : before)
    if (scaled(difference(edge, choice.closed, other.closed), rules) < 1.0) return std::nullopt;
  const ClosedValve slower = close_and_measure(*changed, {.speed = 0.5});
  if (!trusted(slower.closure)) return std::nullopt;
  choice.half_speed = difference(edge, choice.closed, slower);
  if (scaled(choice.half_speed, rules) > rules.half_speed_share) return std::nullopt;
  return choice;
}

void compare_choices(const FreeEdge& edge, const ExamARules& rules, ExamACase& made) {
  made.smallest_difference = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kChoices; ++i)
    for (std::size_t j = 0; j < kChoices; ++j) {
      if (i == j) continue;
      made.differences[i][j] = difference(edge, made.choices[i].closed, made.choices[j].closed);
      made.smallest_difference =
          std::min(made.smallest_difference, scaled(made.differences[i][j], rules));
      made.largest_flaccid_mm = std::max(
          made.largest_flaccid_mm,
          flaccid_difference_mm(edge, made.choices[i].flaccid_mm, made.choices[j].flaccid_mm));
    }
  made.difficulty = -std::log(made.smallest_difference);
}

}  // namespace

double scaled(const ClosedDifference& difference, const ExamARules& rules) {
  return std::max(difference.edge_mm / rules.edge_mm, difference.leak_mm2 / rules.leak_mm2);
}

double edge_difference_mm(const FreeEdge& edge, const Points& closed_mm, const Points& other_mm) {
  double sum = 0.0;
  for (const int vertex : edge.vertices)
    sum += (closed_mm.row(vertex) - other_mm.row(vertex)).squaredNorm();
  return std::sqrt(sum / static_cast<double>(edge.vertices.size()));
}

Expected<ExamACase> make_exam_a(const Valve& valve, std::uint64_t seed, const ExamARules& rules) {
  Expected<FreeEdge> edge = free_edge(valve);
  if (!edge) return edge.errors();
  const std::vector<Segment> segments = segments_with_chordae(valve);
  if (segments.empty())
    return Error{ErrorCode::Unsupported, "/chordae", "has no intact native chorda to change"};
  const Unchanged from{valve, *std::move(edge), flaccid_mm(valve)};
  std::mt19937_64 engine(seed);
  std::vector<CaseChoice> found;
  ExamACase made;
  made.seed = seed;
  for (; found.size() < kChoices && made.draws < rules.most_draws; ++made.draws)
    if (std::optional<CaseChoice> choice =
            choice_of(from, draw_lesions(valve, segments, rules.lesions, engine), found, rules))
      found.push_back(*std::move(choice));
  if (found.size() < kChoices)
    return Error{ErrorCode::Unsupported, "",
                 "only " + std::to_string(found.size()) + " of " + std::to_string(made.draws) +
                     " valves with lesions could be used: a case needs 4 that look alike without "
                     "pressure and differ when closed; try another seed or valve"};
  // Fisher and Yates.
  for (std::size_t i = kChoices - 1; i > 0; --i)
    std::swap(found[i], found[std::min(i, static_cast<std::size_t>(random_share(engine) *
                                                                   static_cast<double>(i + 1)))]);
  for (std::size_t i = 0; i < kChoices; ++i) made.choices[i] = std::move(found[i]);
  made.answer = std::min(kChoices - 1, static_cast<std::size_t>(random_share(engine) * kChoices));
  compare_choices(from.edge, rules, made);
  return made;
}

}  // namespace coapt
