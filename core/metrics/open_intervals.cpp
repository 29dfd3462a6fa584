#include "core/metrics/open_intervals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace coapt {
namespace {

constexpr double kStraight_mm = 1e-3;
constexpr double kTouching_mm = 1e-6;  // overlaps up to this are rounding: corners that meet

/// An interval and one of the next line that it leads into, as indices.
struct Passage {
  std::size_t here = 0, next = 0;
};

bool leads_into(const OpenInterval& here, const OpenInterval& next) {
  if (std::abs(here.below - next.below) <= 1 || std::abs(here.above - next.above) <= 1) return true;
  if (here.below == next.above || here.above == next.below) return false;  // beyond a wall
  return std::min(here.to_mm, next.to_mm) - std::max(here.from_mm, next.from_mm) > kTouching_mm;
}

/// Sorted by both ends at once, for no two passages cross.
std::vector<Passage> passages_between(const std::vector<OpenInterval>& intervals) {
  std::vector<Passage> passages;
  passages.reserve(intervals.size());
  const auto end_of_line = [&](std::size_t first) {
    std::size_t end = first;
    while (end < intervals.size() && intervals[end].line == intervals[first].line) ++end;
    return end;
  };
  for (std::size_t first = 0, end = end_of_line(0); end < intervals.size();) {
    const std::size_t next_end = end_of_line(end);
    if (intervals[end].line == intervals[first].line + 1)
      for (std::size_t here = first, lowest = end; here < end; ++here)
        for (std::size_t next = lowest; next < next_end; ++next)
          if (leads_into(intervals[here], intervals[next])) {
            passages.push_back({here, next});
            lowest = next;
          }
    first = std::exchange(end, next_end);
  }
  return passages;
}

/// The region of each interval, numbered in the order of their first intervals.
std::vector<std::size_t> regions_of(std::size_t count, const std::vector<Passage>& passages) {
  std::vector<std::size_t> region(count);
  for (std::size_t i = 0; i < count; ++i) region[i] = i;
  const auto root = [&](std::size_t i) {
    while (region[i] != i) i = region[i] = region[region[i]];
    return i;
  };
  for (const Passage& passage : passages) {
    const std::size_t a = root(passage.here), b = root(passage.next);
    region[std::max(a, b)] = std::min(a, b);
  }
  std::size_t regions = 0;
  for (std::size_t i = 0; i < count; ++i)
    region[i] = region[i] == i ? regions++ : region[region[i]];
  return region;
}

/// Walks round regions with the open side at the left: along the lower ends of intervals in the
/// direction of x, back along the upper ones.
class Walker {
 public:
  struct End {
    std::size_t interval = 0;
    bool is_upper = false;
  };

  Walker(std::size_t intervals, const std::vector<Passage>& passages)
      : passages_(passages), first_out_(intervals, kNone), last_in_(intervals, kNone) {
    for (std::size_t p = 0; p < passages.size(); ++p) {
      if (first_out_[passages[p].here] == kNone) first_out_[passages[p].here] = p;
      last_in_[passages[p].next] = p;
    }
  }

  End after(const End& end) const {
    if (!end.is_upper) {
      const std::size_t p = first_out_[end.interval];
      if (p == kNone) return {end.interval, true};  // the region's tip
      if (p > 0 && passages_[p - 1].next == passages_[p].next) return {passages_[p - 1].here, true};
      return {passages_[p].next, false};
    }
    const std::size_t p = last_in_[end.interval];
    if (p == kNone) return {end.interval, false};
    if (p + 1 < passages_.size() && passages_[p + 1].here == passages_[p].here)
      return {passages_[p + 1].next, false};
    return {passages_[p].here, true};
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  const std::vector<Passage>& passages_;
  std::vector<std::size_t> first_out_, last_in_;  // passage of each interval
};

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Without the points within kStraight_mm of the straight line between those that are kept.
std::vector<Vec2> without_straight(const std::vector<Vec2>& contour_mm) {
  std::vector<Vec2> kept = {contour_mm.front()};
  Vec2 right, left;  // the directions from the last one kept that pass all since
  bool is_bounded = false;
  for (std::size_t i = 1; i < contour_mm.size(); ++i) {
    Vec2 way = contour_mm[i] - kept.back();
    if (is_bounded && (cross(right, way) < 0.0 || cross(way, left) < 0.0)) {
      kept.push_back(contour_mm[i - 1]);
      way = contour_mm[i] - kept.back();
      is_bounded = false;
    }
    const double length = way.norm();
    if (length <= kStraight_mm) continue;
    const double sine = kStraight_mm / length, cosine = std::sqrt(1.0 - sine * sine);
    const Vec2 ahead = cosine * way, aside = sine * Vec2(-way.y(), way.x());
    if (!is_bounded || cross(right, ahead - aside) > 0.0) right = ahead - aside;
    if (!is_bounded || cross(ahead + aside, left) > 0.0) left = ahead + aside;
    is_bounded = true;
  }
  if (contour_mm.size() > 1) kept.push_back(contour_mm.back());
  return kept;
}

}  // namespace

std::vector<Opening> joined_intervals(const std::vector<OpenInterval>& intervals) {
  const std::vector<Passage> passages = passages_between(intervals);
  const std::vector<std::size_t> region = regions_of(intervals.size(), passages);
  std::vector<Opening> openings;
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    if (region[i] == openings.size()) openings.emplace_back();
    const OpenInterval& interval = intervals[i];
    const double area = interval.weight_mm * (interval.to_mm - interval.from_mm);
    openings[region[i]].area_mm2 += area;
    openings[region[i]].moment_mm3 +=
        area * Vec2(interval.at_mm, 0.5 * (interval.from_mm + interval.to_mm));
  }
  const Walker walker(intervals.size(), passages);
  std::vector<bool> is_walked(intervals.size(), false);  // its lower end; every contour has some
  std::vector<Vec2> contour_mm;
  for (std::size_t i = 0; i < intervals.size(); ++i) {  // a region's first one lies on its outside
    if (is_walked[i]) continue;
    contour_mm.clear();
    for (Walker::End end{i, false}; end.is_upper || !is_walked[end.interval];
         end = walker.after(end)) {
      const OpenInterval& interval = intervals[end.interval];
      contour_mm.emplace_back(interval.at_mm, end.is_upper ? interval.to_mm : interval.from_mm);
      if (!end.is_upper) is_walked[end.interval] = true;
    }
    openings[region[i]].contours_mm.push_back(without_straight(contour_mm));
  }
  std::stable_sort(openings.begin(), openings.end(),
                   [](const Opening& a, const Opening& b) { return a.area_mm2 > b.area_mm2; });
  return openings;
}

}  // namespace coapt
