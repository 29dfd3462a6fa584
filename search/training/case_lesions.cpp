#include "search/training/case_lesions.h"

#include <algorithm>
#include <limits>

#include "core/valve/validate.h"
#include "search/random_share.h"
#include "search/training/free_edge.h"

namespace coapt {
namespace {

constexpr double kOneSide = 2.0 / 3.0;  // of lesions of a segment that both muscles hold

bool may_change(const Chorda& chorda) {
  return chorda.kind != ChordaKind::Neochorda && !chorda.ruptured;
}

bool holds(const Valve& valve, Segment segment, Side side) {
  return std::any_of(valve.chordae.begin(), valve.chordae.end(), [&](const Chorda& chorda) {
    return may_change(chorda) && segment_of(valve, chorda) == segment &&
           valve.heads[static_cast<std::size_t>(chorda.head)].side == side;
  });
}

double drawn_in(Range range, std::mt19937_64& engine) {
  return range.min + (range.max - range.min) * random_share(engine);
}

std::size_t drawn_index(std::size_t count, std::mt19937_64& engine) {
  return std::min(count - 1,
                  static_cast<std::size_t>(random_share(engine) * static_cast<double>(count)));
}

}  // namespace

Segment segment_of(const Valve& valve, const Chorda& chorda) {
  Vec3 mean = Vec3::Zero();
  int count = 0;
  for (const ChordaSegment& segment : chorda.segments) {
    if (!segment.inserts) continue;
    mean += position(segment.insertion, valve.faces, valve.rest_mm);
    ++count;
  }
  mean /= count;
  double nearest = std::numeric_limits<double>::infinity();
  Segment found = Segment::A1;
  for (const ChordaSegment& segment : chorda.segments) {
    if (!segment.inserts) continue;
    const double from_mean =
        (position(segment.insertion, valve.faces, valve.rest_mm) - mean).norm();
    if (from_mean >= nearest) continue;
    nearest = from_mean;
    found = valve.segments[static_cast<std::size_t>(segment.insertion.face)];
  }
  return found;
}

std::vector<Segment> segments_with_chordae(const Valve& valve) {
  std::vector<Segment> found;
  for (const Segment segment : kAllSegments)
    if (holds(valve, segment, Side::Anterolateral) || holds(valve, segment, Side::Posteromedial))
      found.push_back(segment);
  return found;
}

CaseLesions draw_lesions(const Valve& valve, const std::vector<Segment>& segments,
                         const LesionRanges& ranges, std::mt19937_64& engine) {
  CaseLesions lesions;
  std::vector<Segment> left = segments;
  const auto most =
      std::min<std::size_t>(static_cast<std::size_t>(ranges.most_segments), left.size());
  const auto fewest = std::min<std::size_t>(static_cast<std::size_t>(ranges.fewest_segments), most);
  const std::size_t count = fewest + drawn_index(most - fewest + 1, engine);
  while (lesions.chordae.size() < count) {
    const std::size_t at = drawn_index(left.size(), engine);
    ChordaeLesion lesion{left[at]};
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
    lesion.factor = drawn_in(random_share(engine) < 0.5 ? ranges.shorter : ranges.longer, engine);
    const double which =
        random_share(engine);  // drawn always, so that later draws stay as they are
    if (ranges.by_side && which < kOneSide && holds(valve, lesion.segment, Side::Anterolateral) &&
        holds(valve, lesion.segment, Side::Posteromedial))
      lesion.side = which < 0.5 * kOneSide ? Side::Anterolateral : Side::Posteromedial;
    lesions.chordae.push_back(lesion);
  }
  if (random_share(engine) >= ranges.tip_share) return lesions;
  TipLesion tip{random_share(engine) < 0.5 ? Side::Anterolateral : Side::Posteromedial};
  for (double& along : tip.moved_mm) along = drawn_in({-ranges.tip_mm, ranges.tip_mm}, engine);
  lesions.tips.push_back(tip);
  return lesions;
}

Expected<Valve> with_lesions(const Valve& valve, const CaseLesions& lesions) {
  Valve changed = valve;
  for (Chorda& chorda : changed.chordae) {
    if (!may_change(chorda)) continue;
    const Segment segment = segment_of(valve, chorda);
    const Side side = valve.heads[static_cast<std::size_t>(chorda.head)].side;
    for (const ChordaeLesion& lesion : lesions.chordae)
      if (lesion.segment == segment && lesion.side.value_or(side) == side)
        for (ChordaSegment& piece : chorda.segments) piece.rest_length_mm *= lesion.factor;
  }
  for (PapillaryHead& head : changed.heads)
    for (const TipLesion& lesion : lesions.tips)
      if (lesion.side == head.side) head.tip_mm += lesion.moved_mm;
  if (Errors errors = validate(changed); !errors.empty()) return errors;
  return changed;
}

}  // namespace coapt
