// Openings without a library for polygons, by scan lines x = const: the slits of a closed valve run
// along x more than across it.
//
// Grown tissue is what its outlines wind round and the grown edges of those outlines; the faces
// between them are no work. A line is open where the sums along it say inside the outline and
// outside of all tissue. Its open length is integrated over x by Simpson's rule, and lines are set
// closer where that differs from the trapezium rule: where edges end or cross or run along y.
// Regions and their contours come from open intervals of neighbouring lines (open_intervals.h).
#include "core/metrics/openings_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/metrics/open_intervals.h"
#include "core/metrics/openings.h"
#include "core/metrics/plane_grid.h"
#include "core/metrics/scan_bounds.h"

namespace coapt {
namespace {

constexpr double kSlab_mm = 0.1;       // three lines each, the outer ones shared
constexpr double kSettled_mm2 = 1e-5;  // of a slab: the most that the two rules may differ by
constexpr double kThinnest_mm = 2e-5;  // of slabs: a side of 10 mm along y is worth 2e-4 mm2 then
constexpr double kSliver_mm = 1e-6;    // open intervals up to this are rounding

/// Of windings along a line.
struct Change {
  double at_mm = 0.0;  ///< y
  int bound = 0;
  int winding = 0;
};

struct ScanLine {
  double at_mm = 0.0;  ///< x
  double weight_mm = 0.0;
  double length_mm = 0.0;          ///< of it that is open
  std::size_t first = 0, end = 0;  ///< its intervals
};

class Sweep {
 public:
  void add_loop(const std::vector<Vec2>& loop_mm, Cover cover) {
    for (std::size_t i = 0; i < loop_mm.size(); ++i) {
      ScanBound bound = edge_bound(loop_mm[i], loop_mm[(i + 1) % loop_mm.size()]);
      bound.cover = cover;
      bound.number = next_number_++;
      add(bound);
    }
    next_number_ += 2;
  }

  void add_grown(const std::vector<Vec2>& line_mm, double radius_mm) {
    for (std::size_t i = 0; i + 1 < line_mm.size(); ++i) {
      ScanBound bound = grown_bound(line_mm[i], line_mm[i + 1], radius_mm);
      bound.number = next_number_;
      next_number_ += 2;
      add(bound);
    }
  }

  /// Draws lines from one x to the other. Once.
  void run(double first_mm, double last_mm) {
    std::stable_sort(bounds_.begin(), bounds_.end(), [](const ScanBound& a, const ScanBound& b) {
      return a.first_mm < b.first_mm;
    });
    const int slabs = static_cast<int>(std::ceil((last_mm - first_mm) / kSlab_mm));
    lines_.reserve(4 * static_cast<std::size_t>(std::max(0, slabs)));
    intervals_.reserve(2 * lines_.capacity());
    for (int i = 0; i < slabs; ++i) {
      const double from_mm = first_mm + (last_mm - first_mm) * i / slabs;
      const double to_mm = first_mm + (last_mm - first_mm) * (i + 1) / slabs;
      reach(from_mm, to_mm);
      if (i == 0) draw_line(from_mm);
      const std::size_t from = lines_.size() - 1;
      draw_line(to_mm);
      integrate(from, from + 1);
      std::sort(lines_.begin() + static_cast<std::ptrdiff_t>(from), lines_.end(),
                [](const ScanLine& a, const ScanLine& b) { return a.at_mm < b.at_mm; });
    }
  }

  /// Of all lines drawn, in the direction of x.
  std::vector<OpenInterval> intervals() const {
    std::vector<OpenInterval> ordered;
    ordered.reserve(intervals_.size());
    for (std::size_t i = 0; i < lines_.size(); ++i)
      for (std::size_t k = lines_[i].first; k < lines_[i].end; ++k) {
        OpenInterval& interval = ordered.emplace_back(intervals_[k]);
        interval.line = static_cast<int>(i);
        interval.at_mm = lines_[i].at_mm;
        interval.weight_mm = lines_[i].weight_mm;
      }
    return ordered;
  }

 private:
  void add(const ScanBound& bound) {
    if (bound.first_mm < bound.last_mm) bounds_.push_back(bound);
  }

  /// Finds the bounds that lines of a slab can meet. Slabs come in the direction of x.
  void reach(double from_mm, double to_mm) {
    for (; reached_ < bounds_.size() && bounds_[reached_].first_mm <= to_mm; ++reached_)
      near_.push_back(static_cast<int>(reached_));
    std::erase_if(near_, [&](int bound) { return bounds_[bound].last_mm < from_mm; });
  }

  void list_changes(double x_mm) {
    changes_.clear();
    for (const int i : near_) {
      const ScanBound& bound = bounds_[i];
      if (!(bound.first_mm <= x_mm && x_mm < bound.last_mm)) continue;
      if (bound.cover == Cover::Grown) {
        changes_.push_back({side_at(bound, x_mm, -1.0), i, 1});
        changes_.push_back({side_at(bound, x_mm, 1.0), i, -1});
      } else {
        changes_.push_back({edge_at(bound, x_mm), i, bound.winding});
      }
    }
    std::sort(changes_.begin(), changes_.end(), [](const Change& a, const Change& b) {
      return a.at_mm != b.at_mm ? a.at_mm < b.at_mm : a.bound < b.bound;
    });
  }

  /// Appends the line at x and its intervals.
  void draw_line(double x_mm) {
    list_changes(x_mm);
    ScanLine line{x_mm, 0.0, 0.0, intervals_.size(), 0};
    std::array<int, 3> windings = {0, 0, 0};  // by Cover
    OpenInterval interval;
    bool was_open = false;
    for (std::size_t i = 0; i < changes_.size(); ++i) {
      const Change& change = changes_[i];
      windings[static_cast<std::size_t>(bounds_[change.bound].cover)] += change.winding;
      if (i + 1 < changes_.size() && changes_[i + 1].at_mm == change.at_mm) continue;
      const bool is_open = windings[0] != 0 && windings[1] == 0 && windings[2] == 0;
      if (is_open == was_open) continue;
      was_open = is_open;
      (is_open ? interval.from_mm : interval.to_mm) = change.at_mm;
      (is_open ? interval.below : interval.above) = bounds_[change.bound].number;
      if (is_open || interval.to_mm - interval.from_mm <= kSliver_mm) continue;
      line.length_mm += interval.to_mm - interval.from_mm;
      intervals_.push_back(interval);
    }
    line.end = intervals_.size();
    lines_.push_back(line);
  }

  /// Weighs two lines, given by their indices, and those that it draws between them.
  void integrate(std::size_t from, std::size_t to) {
    const double breadth_mm = lines_[to].at_mm - lines_[from].at_mm;
    const std::size_t middle = lines_.size();
    draw_line(0.5 * (lines_[from].at_mm + lines_[to].at_mm));
    const double bend_mm =
        lines_[from].length_mm - 2.0 * lines_[middle].length_mm + lines_[to].length_mm;
    if (breadth_mm > kThinnest_mm && std::abs(bend_mm) * breadth_mm / 3.0 > kSettled_mm2) {
      integrate(from, middle);
      integrate(middle, to);
      return;
    }
    lines_[from].weight_mm += breadth_mm / 6.0;
    lines_[middle].weight_mm += breadth_mm * 4.0 / 6.0;
    lines_[to].weight_mm += breadth_mm / 6.0;
  }

  int next_number_ = 0;
  std::vector<ScanBound> bounds_;
  std::size_t reached_ = 0;  // bounds before it begin before the slab's end
  std::vector<int> near_;
  std::vector<Change> changes_;
  std::vector<ScanLine> lines_;
  std::vector<OpenInterval> intervals_;  // of lines as they were drawn
};

std::vector<Opening> swept(const std::vector<Vec2>& outline_mm, const FlatTissue& tissue,
                           double radius_mm) {
  Sweep sweep;
  sweep.add_loop(outline_mm, Cover::Outline);
  for (const std::vector<Vec2>& loop_mm : tissue.outlines_mm)
    sweep.add_loop(loop_mm, Cover::Tissue);
  if (radius_mm > 0.0) {
    for (std::vector<Vec2> loop_mm : tissue.outlines_mm) {
      if (!loop_mm.empty()) loop_mm.push_back(loop_mm.front());
      sweep.add_grown(loop_mm, radius_mm);
    }
    for (const std::vector<Vec2>& line_mm : tissue.lines_mm) sweep.add_grown(line_mm, radius_mm);
  }
  double first_mm = kFarthest_mm, last_mm = -kFarthest_mm;
  for (const Vec2& corner_mm : outline_mm) {
    const double x_mm = from_grid(to_grid(corner_mm)).x();
    first_mm = std::min(first_mm, x_mm);
    last_mm = std::max(last_mm, x_mm);
  }
  sweep.run(first_mm, last_mm);
  return joined_intervals(sweep.intervals());
}

}  // namespace

Openings swept_openings(const std::vector<Vec2>& outline_mm, const FlatTissue& tissue,
                        double radius_mm) {
  Openings found;
  found.bare = swept(outline_mm, tissue, 0.0);
  found.grown = radius_mm > 0.0 ? swept(outline_mm, tissue, radius_mm) : found.bare;
  return found;
}

}  // namespace coapt
