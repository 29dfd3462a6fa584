#include "core/metrics/least_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace coapt {
namespace {

constexpr int kIterations = 400, kLook = 25;
constexpr double kEnough_mm2 = 0.1, kEnough = 0.015;  // between both bounds; of the upper one
constexpr float kStep = 0.288675f;  // 1 / sqrt(12): its square times |grad|^2 <= 12 is 1

constexpr int kEight = 8;  // voxels at once

/// Voxels one behind the other along x, in eights, and from each to the place of its neighbours along y and z.
struct Row {
  int first = 0, eights = 0;
  int up_y = 0, down_y = 0, up_z = 0, down_z = 0;
};

// g++ compiles these loops once more for each instruction set, and the program takes the best when it starts: the same bits. That
// arrays are apart it believes of parameters alone, and of functions that are not inlined.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define COAPT_EACH_SET __attribute__((noinline, target_clones("avx512f", "avx2", "default")))
#else
#define COAPT_EACH_SET
#endif
using In = const float* __restrict;
using Out = float* __restrict;

/// The dual's step: more flows (p) where u rises, but no more than 1; and as much of it as is free (c) passes (f).
/// @param ahead u carried on by its last step
COAPT_EACH_SET void flow(const std::vector<Row>& rows, In ahead, In cx, In cy, In cz, Out px,
                         Out py, Out pz, Out fx, Out fy, Out fz) {
  for (const Row& row : rows)
    for (int eight = row.first; eight < row.first + kEight * row.eights; eight += kEight)
      for (int k = 0; k < kEight; ++k) {
        const int i = eight + k;
        const float x = px[i] + kStep * cx[i] * (ahead[i + 1] - ahead[i]);
        const float y = py[i] + kStep * cy[i] * (ahead[i + row.up_y] - ahead[i]);
        const float z = pz[i] + kStep * cz[i] * (ahead[i + row.up_z] - ahead[i]);
        const float square = x * x + y * y + z * z;
        const float scale = 1.0f / std::sqrt(square > 1.0f ? square : 1.0f);
        px[i] = x * scale;
        py[i] = y * scale;
        pz[i] = z * scale;
        fx[i] = cx[i] * px[i];
        fy[i] = cy[i] * py[i];
        fz[i] = cz[i] * pz[i];
      }
}

/// The primal's step: u rises where more flows out than in.
/// @param steps 0 where u is fixed
COAPT_EACH_SET void move(const std::vector<Row>& rows, In fx, In fy, In fz, In steps, Out u,
                         Out ahead) {
  for (const Row& row : rows)
    for (int eight = row.first; eight < row.first + kEight * row.eights; eight += kEight)
      for (int k = 0; k < kEight; ++k) {
        const int i = eight + k;
        const float out =
            fx[i] - fx[i - 1] + fy[i] - fy[i + row.down_y] + fz[i] - fz[i + row.down_z];
        const float raised = u[i] + steps[i] * out;
        const float above = raised > 0.0f ? raised : 0.0f;
        const float moved = above < 1.0f ? above : 1.0f;
        ahead[i] = 2.0f * moved - u[i];
        u[i] = moved;
      }
}

/// What is kept of each voxel, row by row along x. A row reaches over all voxels of the band on it and on the next rows along y and z,
/// which look back at it; places that are not in the band have walls all round.
class Field {
 public:
  Field(const VoxelGrid& grid, const std::vector<BandVoxel>& band)
      : grid_(grid), places_(band.size()) {
    lay_out(band);
    const auto count = static_cast<std::size_t>(count_);
    for (auto* values :
         {&u_, &ahead_, &steps_, &px_, &py_, &pz_, &cx_, &cy_, &cz_, &fx_, &fy_, &fz_})
      values->assign(count, 0.0f);
    fill(band);
  }

  void iterate() {
    flow(rows_, ahead_.data(), cx_.data(), cy_.data(), cz_.data(), px_.data(), py_.data(),
         pz_.data(), fx_.data(), fy_.data(), fz_.data());
    move(rows_, fx_.data(), fy_.data(), fz_.data(), steps_.data(), u_.data(), ahead_.data());
  }

  /// Area of the cut as it stands, and a lower bound of all cuts' areas.
  std::array<double, 2> bounds_mm2() const {
    double upper = 0.0, lower = 0.0;
    for (const Row& row : rows_)
      for (int i = row.first; i < row.first + kEight * row.eights; ++i) {
        const auto k = static_cast<std::size_t>(i);
        upper += change(row, i).norm();
        const double out = static_cast<double>(
            fx_[k - 1] - fx_[k] + fy_[static_cast<std::size_t>(i + row.down_y)] - fy_[k] +
            fz_[static_cast<std::size_t>(i + row.down_z)] - fz_[k]);
        lower += steps_[k] > 0.0f ? std::min(0.0, out) : static_cast<double>(u_[k]) * out;
      }
    const double square = grid_.side_mm * grid_.side_mm;
    return {square * upper, square * lower};
  }

  LeastSurface result() const {
    LeastSurface surface;
    const auto [upper_mm2, lower_mm2] = bounds_mm2();
    surface.upper_mm2 = upper_mm2;
    surface.lower_mm2 = lower_mm2;
    std::vector<Vec3> parts(static_cast<std::size_t>(count_), Vec3::Zero());
    for (const Row& row : rows_)
      for (int i = row.first; i < row.first + kEight * row.eights; ++i)
        parts[static_cast<std::size_t>(i)] = grid_.side_mm * grid_.side_mm * change(row, i);
    for (const int place : places_) {
      surface.u.push_back(u_[static_cast<std::size_t>(place)]);
      surface.parts_mm2.push_back(parts[static_cast<std::size_t>(place)]);
    }
    return surface;
  }

 private:
  void lay_out(const std::vector<BandVoxel>& band) {
    const int width = grid_.size[0], lines_of_layer = grid_.size[1];
    struct Range {
      int low = std::numeric_limits<int>::max(), high = -1;
      void include(const Range& other) {
        low = std::min(low, other.low);
        high = std::max(high, other.high);
      }
    };
    std::vector<Range> of_band(static_cast<std::size_t>(lines_of_layer * grid_.size[2]));
    for (const BandVoxel& voxel : band)
      of_band[static_cast<std::size_t>(voxel.voxel / width)].include(
          {voxel.voxel % width, voxel.voxel % width});
    std::vector<Range> ranges = of_band;
    for (std::size_t line = 0; line < of_band.size(); ++line) {
      if (of_band[line].high < 0) continue;
      const int at = static_cast<int>(line);
      if (at % lines_of_layer > 0) ranges[line - 1].include(of_band[line]);
      if (at >= lines_of_layer)
        ranges[static_cast<std::size_t>(at - lines_of_layer)].include(of_band[line]);
    }
    std::vector<int> lines;
    // Where x = 0 of each line would stand.
    std::vector<int> origins(ranges.size(), 0);
    count_ = width + kEight;
    for (std::size_t line = 0; line < ranges.size(); ++line) {
      if (ranges[line].high < 0) continue;
      const int eights = (ranges[line].high - ranges[line].low) / kEight + 1;
      origins[line] = count_ - ranges[line].low;
      rows_.push_back({count_, eights, 0, 0, 0, 0});
      lines.push_back(static_cast<int>(line));
      count_ += kEight * eights + 1;
    }
    count_ += width + kEight;
    const auto to = [&](int from, int line, bool exists) {
      if (!exists || ranges[static_cast<std::size_t>(line)].high < 0) return 0;
      return origins[static_cast<std::size_t>(line)] - origins[static_cast<std::size_t>(from)];
    };
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const int line = lines[r], y = line % lines_of_layer, z = line / lines_of_layer;
      rows_[r].up_y = to(line, line + 1, y + 1 < lines_of_layer);
      rows_[r].down_y = to(line, line - 1, y > 0);
      rows_[r].up_z = to(line, line + lines_of_layer, z + 1 < grid_.size[2]);
      rows_[r].down_z = to(line, line - lines_of_layer, z > 0);
    }
    for (std::size_t i = 0; i < band.size(); ++i)
      places_[i] = origins[static_cast<std::size_t>(band[i].voxel / width)] + band[i].voxel % width;
  }

  void fill(const std::vector<BandVoxel>& band) {
    std::vector<int> place_of(static_cast<std::size_t>(grid_.count()), -1);
    for (std::size_t i = 0; i < band.size(); ++i)
      place_of[static_cast<std::size_t>(band[i].voxel)] = static_cast<int>(i);
    const std::array<std::vector<float>*, 3> shares{&cx_, &cy_, &cz_};
    for (std::size_t i = 0; i < band.size(); ++i) {
      const auto place = static_cast<std::size_t>(places_[i]);
      u_[place] = ahead_[place] = band[i].u;
      steps_[place] = band[i].is_fixed ? 0.0f : kStep;
      const std::array<int, 3> at = grid_.place(band[i].voxel);
      for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        if (at[k] + 1 >= grid_.size[k]) continue;
        const int next = place_of[static_cast<std::size_t>(band[i].voxel + grid_.stride(axis))];
        if (next < 0 || (band[i].is_fixed && band[static_cast<std::size_t>(next)].is_fixed))
          continue;
        (*shares[k])[place] = static_cast<float>(band[i].free[k]) / kPointsOfSquare;
      }
    }
  }

  /// By how much u rises to the next voxels, as far as the squares between are free.
  Vec3 change(const Row& row, int i) const {
    const auto k = static_cast<std::size_t>(i);
    return {static_cast<double>(cx_[k] * (u_[k + 1] - u_[k])),
            static_cast<double>(cy_[k] * (u_[static_cast<std::size_t>(i + row.up_y)] - u_[k])),
            static_cast<double>(cz_[k] * (u_[static_cast<std::size_t>(i + row.up_z)] - u_[k]))};
  }

  const VoxelGrid& grid_;
  std::vector<int> places_;  // of the band's voxels
  std::vector<Row> rows_;
  int count_ = 0;
  std::vector<float> u_, ahead_, steps_, px_, py_, pz_, cx_, cy_, cz_, fx_, fy_, fz_;
};

}  // namespace

LeastSurface least_surface(const VoxelGrid& grid, const std::vector<BandVoxel>& band) {
  Field field(grid, band);
  for (int iteration = 1; iteration <= kIterations; ++iteration) {
    field.iterate();
    if (iteration % kLook != 0) continue;
    const auto [upper_mm2, lower_mm2] = field.bounds_mm2();
    if (upper_mm2 - lower_mm2 <= std::max(kEnough_mm2, kEnough * upper_mm2)) break;
  }
  return field.result();
}

}  // namespace coapt
