#include "lab/leak/minimal_cut.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coapt {
namespace {

constexpr int kLook = 50;  // iterations from one look at the bounds to the next

/// Cells that follow each other in a run and whose neighbours follow each other, too.
struct Stretch {
  int begin = 0, count = 0;
  std::array<int, 2> above = {0, 0}, below = {0, 0};  ///< neighbours of `begin` along y and z
};

class PrimalDual {
 public:
  PrimalDual(const VoxelBand& band, const AxisFields& shares, CutState start)
      : band_(band), shares_(shares), state_(std::move(start)) {
    make_stretches();
    const std::size_t size = static_cast<std::size_t>(nothing_ + longest_ + 1);
    state_.side.resize(size, 0.0F);
    ahead_ = state_.side;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      shares_[axis].resize(size, 0.0F);
      state_.flow[axis].resize(size, 0.0F);
    }
    step_.assign(size, 0.0F);
    divergence_.assign(static_cast<std::size_t>(longest_), 0.0F);
    for (int i = 1; i <= band.cells; ++i)
      if (!band.is_fixed[static_cast<std::size_t>(i)]) step_[static_cast<std::size_t>(i)] = kStep;
  }

  MinimalCut run(const CutStop& stop) {
    MinimalCut cut;
    while (cut.iterations < stop.iterations) {
      for (const Stretch& stretch : stretches_) move_flow(stretch);
      for (const Stretch& stretch : stretches_) move_side(stretch);
      if (++cut.iterations % kLook && cut.iterations < stop.iterations) continue;
      set_bounds(cut);
      if (cut.primal_mm2 - cut.dual_mm2 <= std::max(stop.gap_mm2, stop.gap_share * cut.primal_mm2))
        break;
    }
    cut.state = std::move(state_);
    return cut;
  }

 private:
  static constexpr float kStep = 0.28867513F;  // 1 / sqrt(12): 12 bounds the square of |C grad|

  void make_stretches() {
    for (const VoxelRun& run : band_.runs) longest_ = std::max(longest_, run.end - run.begin);
    nothing_ = band_.cells + 1;
    for (const VoxelRun& run : band_.runs) {
      std::vector<int> starts = {run.begin};
      for (const auto& [dj, dk] : kBeside) {
        const auto [begin, end] = band_.row(run.j + dj, run.k + dk);
        for (const VoxelRun* beside = begin; beside != end; ++beside)
          for (const int at : {beside->begin, beside->end})
            if (at > run.begin && at < run.end) starts.push_back(at);
      }
      std::sort(starts.begin(), starts.end());
      starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
      starts.push_back(run.end);
      for (std::size_t s = 0; s + 1 < starts.size(); ++s)
        add_stretch(run, starts[s], starts[s + 1]);
    }
  }

  void add_stretch(const VoxelRun& run, int begin, int end) {
    std::array<int, 4> beside;
    for (std::size_t n = 0; n < 4; ++n) {
      const int index = band_.find({begin, run.j + kBeside[n][0], run.k + kBeside[n][1]});
      beside[n] = index > 0 ? index : nothing_;
    }
    stretches_.push_back({run.first + begin - run.begin,
                          end - begin,
                          {beside[0], beside[1]},
                          {beside[2], beside[3]}});
  }

  /// Flow follows the gradient, and is cut to length 1.
  void move_flow(const Stretch& s) {
    const float* const u = ahead_.data() + s.begin;
    const float* const u_y = ahead_.data() + s.above[0];
    const float* const u_z = ahead_.data() + s.above[1];
    const float* const c_x = shares_[0].data() + s.begin;
    const float* const c_y = shares_[1].data() + s.begin;
    const float* const c_z = shares_[2].data() + s.begin;
    float* __restrict const x = state_.flow[0].data() + s.begin;
    float* __restrict const y = state_.flow[1].data() + s.begin;
    float* __restrict const z = state_.flow[2].data() + s.begin;
    for (int i = 0; i < s.count; ++i) {
      const float p = x[i] + kStep * c_x[i] * (u[i + 1] - u[i]);
      const float q = y[i] + kStep * c_y[i] * (u_y[i] - u[i]);
      const float r = z[i] + kStep * c_z[i] * (u_z[i] - u[i]);
      const float square = p * p + q * q + r * r;
      const float scale = 1.0F / std::sqrt(square > 1.0F ? square : 1.0F);
      x[i] = p * scale;
      y[i] = q * scale;
      z[i] = r * scale;
    }
  }

  /// What flows out of each cell of a stretch, less what flows in.
  const float* divergence(const Stretch& s) {
    const auto of = [&](std::size_t axis, int at) {
      return std::pair{shares_[axis].data() + at, std::as_const(state_.flow[axis]).data() + at};
    };
    const auto [c_x, x] = of(0, s.begin);
    const auto [c_y, y] = of(1, s.begin);
    const auto [c_z, z] = of(2, s.begin);
    const auto [c_below, y_below] = of(1, s.below[0]);
    const auto [c_under, z_under] = of(2, s.below[1]);
    float* __restrict const out = divergence_.data();
    for (int i = 0; i < s.count; ++i)
      out[i] = c_x[i] * x[i] - c_x[i - 1] * x[i - 1] + c_y[i] * y[i] - c_below[i] * y_below[i] +
               c_z[i] * z[i] - c_under[i] * z_under[i];
    return out;
  }

  void move_side(const Stretch& s) {
    const float* const out = divergence(s);
    const float* const step = step_.data() + s.begin;
    float* __restrict const u = state_.side.data() + s.begin;
    float* __restrict const ahead = ahead_.data() + s.begin;
    for (int i = 0; i < s.count; ++i) {
      const float before = u[i];
      float moved = before + step[i] * out[i];
      moved = moved < 0.0F ? 0.0F : moved;
      moved = moved > 1.0F ? 1.0F : moved;
      u[i] = moved;
      ahead[i] = 2.0F * moved - before;
    }
  }

  void set_bounds(MinimalCut& cut) {
    double primal = 0.0, dual = 0.0;
    for (const Stretch& s : stretches_) {
      const float* const u = state_.side.data();
      const float* const out = divergence(s);
      for (int i = 0; i < s.count; ++i) {
        const auto at = static_cast<std::size_t>(s.begin + i);
        const Eigen::Vector3f density(shares_[0][at] * (u[at + 1] - u[at]),
                                      shares_[1][at] * (u[s.above[0] + i] - u[at]),
                                      shares_[2][at] * (u[s.above[1] + i] - u[at]));
        primal += static_cast<double>(density.norm());
        dual -= static_cast<double>(band_.is_fixed[at] ? state_.side[at] * out[i]
                                                       : std::max(0.0F, out[i]));
      }
    }
    const double voxel_mm2 = band_.lattice.voxel_mm * band_.lattice.voxel_mm;
    cut.primal_mm2 = voxel_mm2 * primal;
    cut.dual_mm2 = voxel_mm2 * dual;
  }

  static constexpr std::array<std::array<int, 2>, 4> kBeside = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

  const VoxelBand& band_;
  AxisFields shares_;
  CutState state_;
  std::vector<float> ahead_;       // side, carried on by its last change
  std::vector<float> step_;        // 0 of fixed cells
  std::vector<float> divergence_;  // of one stretch
  std::vector<Stretch> stretches_;
  int longest_ = 0, nothing_ = 0;  // from nothing_ on there are as many cells without faces
};

}  // namespace

MinimalCut minimal_cut(const VoxelBand& band, const AxisFields& shares, CutState start,
                       const CutStop& stop) {
  return PrimalDual(band, shares, std::move(start)).run(stop);
}

std::vector<Eigen::Vector3f> cut_density(const VoxelBand& band, const AxisFields& shares,
                                         const std::vector<float>& side) {
  std::vector<Eigen::Vector3f> density(static_cast<std::size_t>(band.cells) + 1,
                                       Eigen::Vector3f::Zero());
  for_each_cell(band, [&](const Cell& cell, int index) {
    const auto at = static_cast<std::size_t>(index);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (shares[axis][at] == 0.0F) continue;
      Cell next = cell;
      ++next[axis];
      const auto neighbour = static_cast<std::size_t>(band.find(next));
      density[at][static_cast<int>(axis)] = shares[axis][at] * (side[neighbour] - side[at]);
    }
  });
  return density;
}

}  // namespace coapt
