#include "core/closure/stiffness_laplacian.h"

#include <algorithm>

namespace coapt {
namespace {

using kernels::kLanes;

constexpr double kLeastDiagonal_n_per_mm = 1e-3;  // of what is not membrane; nothing is singular
// A side's weight where the corner across it is stiffer than both ends together: obtuse faces, squeezed ones.
constexpr double kLeastWeight = 0.05;

using Four = float __attribute__((vector_size(16)));
Four load(const kernels::Quad<float>& quad) {
  Four result;
  __builtin_memcpy(&result, quad.at, sizeof result);
  return result;
}
void store(const Four& four, kernels::Quad<float>& quad) {
  __builtin_memcpy(quad.at, &four, sizeof four);
}

}  // namespace

template <class R>
StiffnessLaplacian<R>::StiffnessLaplacian(const RelaxationModel<R>& laid) {
  int rows = 0;
  for (const kernels::NodeBlock<R>& block : laid.blocks)
    for (const R free : block.free.at) row_of_.push_back(free > R(0) ? rows++ : -1);
  diagonal_.resize(static_cast<std::size_t>(rows));
  lay_matrix(laid);
  factor_.analyzePattern(matrix_);
}

template <class R>
void StiffnessLaplacian<R>::lay_matrix(const RelaxationModel<R>& laid) {
  const auto rows = static_cast<int>(diagonal_.size());
  const auto row_at = [&](int offset) {
    const auto node = static_cast<std::size_t>(offset) / sizeof(kernels::Quad<R>);
    return node < row_of_.size() ? row_of_[node] : -1;
  };
  std::vector<Eigen::Triplet<double>> entries;
  for (int row = 0; row < rows; ++row) entries.emplace_back(row, row, 1.0);
  for (std::size_t b = 0; b < laid.faces.size(); ++b) {
    const kernels::FaceBlock<R>& face = laid.faces[b];
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (!(face.least_mm4.at[lane] > R(0))) continue;  // padding
      for (std::size_t k = 0; k < 3; ++k) {
        const auto corner = [&](std::size_t at) {
          return static_cast<int>((3 * b + at % 3) * kLanes + lane);
        };
        const int from = row_at(face.node[k].at[lane]),
                  to = row_at(face.node[(k + 1) % 3].at[lane]);
        sides_.push_back({{corner(k), corner(k + 1), corner(k + 2)}, {from, to}, -1});
        if (from >= 0 && to >= 0)
          entries.emplace_back(std::max(from, to), std::min(from, to), -1e-3);
      }
    }
  }
  matrix_.resize(rows, rows);
  matrix_.setFromTriplets(entries.begin(), entries.end());
  const auto entry = [&](int row, int column) {
    const int* inner = matrix_.innerIndexPtr();
    const int* outer = matrix_.outerIndexPtr();
    return static_cast<int>(
        std::lower_bound(inner + outer[column], inner + outer[column + 1], row) - inner);
  };
  for (int row = 0; row < rows; ++row) diagonal_[row] = entry(row, row);
  for (Side& side : sides_) {
    const auto [from, to] = side.end;
    if (from >= 0 && to >= 0) side.both = entry(std::max(from, to), std::min(from, to));
    for (int& end : side.end) end = end < 0 ? -1 : diagonal_[end];
  }
}

template <class R>
void StiffnessLaplacian<R>::refresh(const std::vector<kernels::Quad<R>>& corners,
                                    const std::vector<kernels::Quad<R>>& nodes) {
  double* value = matrix_.valuePtr();
  std::fill(value, value + matrix_.nonZeros(), 0.0);
  // Membrane first, as its corners have it, to know what is not.
  for (const Side& side : sides_)
    if (side.end[0] >= 0) value[side.end[0]] -= static_cast<double>(corners[side.corner[0]].at[3]);
  for (std::size_t node = 0; node < row_of_.size(); ++node)
    if (row_of_[node] >= 0) {
      double& rest = value[diagonal_[row_of_[node]]];
      rest = std::max(rest + static_cast<double>(nodes[node].at[3]), kLeastDiagonal_n_per_mm);
    }
  for (const Side& side : sides_) {
    const auto stiffness = [&](int k) {
      return static_cast<double>(corners[side.corner[k]].at[3]);
    };
    const double ends = stiffness(0) + stiffness(1);
    const double weight = std::max(0.25 * (ends - stiffness(2)), kLeastWeight * ends);
    for (const int end : side.end)
      if (end >= 0) value[end] += weight;
    if (side.both >= 0) value[side.both] -= weight;
  }
  factor_.factorize(matrix_);
  const auto& lower = factor_.matrixL().nestedExpression();
  if (first_.empty()) lay_factor();
  for (std::size_t k = 0; k < entry_.size(); ++k)
    value_[k] = static_cast<float>(lower.valuePtr()[entry_[k]]);
  for (std::size_t row = 0; row < inverse_.size(); ++row)
    inverse_[row] = static_cast<float>(1.0 / factor_.vectorD()[static_cast<Index>(row)]);
}

template <class R>
void StiffnessLaplacian<R>::lay_factor() {
  const auto& lower = factor_.matrixL().nestedExpression();
  const auto rows = static_cast<int>(diagonal_.size());
  for (int column = 0; column < rows; ++column) {
    first_.push_back(static_cast<int>(below_.size()));
    for (int k = lower.outerIndexPtr()[column]; k < lower.outerIndexPtr()[column + 1]; ++k)
      if (lower.innerIndexPtr()[k] > column)
        below_.push_back(lower.innerIndexPtr()[k]), entry_.push_back(k);
  }
  first_.push_back(static_cast<int>(below_.size()));
  value_.resize(entry_.size());
  inverse_.resize(diagonal_.size());
  solved_.resize(diagonal_.size());
  const auto& order = factor_.permutationP().indices();
  for (const int row : row_of_) place_.push_back(row < 0 ? -1 : order.size() ? order[row] : row);
}

template <class R>
void StiffnessLaplacian<R>::solve(std::vector<kernels::Quad<R>>& nodes) {
  for (std::size_t node = 0; node < place_.size(); ++node)
    if (place_[node] >= 0)
      for (int k = 0; k < 4; ++k)
        solved_[place_[node]].at[k] = k < 3 ? static_cast<float>(nodes[node].at[k]) : 0.0f;
  const auto rows = static_cast<int>(inverse_.size());
  for (int j = 0; j < rows; ++j) {
    const Four at = load(solved_[j]);
    for (int k = first_[j]; k < first_[j + 1]; ++k) {
      kernels::Quad<float>& below = solved_[below_[k]];
      store(load(below) - value_[k] * at, below);
    }
  }
  for (int j = rows - 1; j >= 0; --j) {
    Four sum = load(solved_[j]) * inverse_[j];
    for (int k = first_[j]; k < first_[j + 1]; ++k) sum -= value_[k] * load(solved_[below_[k]]);
    store(sum, solved_[j]);
  }
  for (std::size_t node = 0; node < place_.size(); ++node)
    if (place_[node] >= 0)
      for (int k = 0; k < 3; ++k) nodes[node].at[k] = static_cast<R>(solved_[place_[node]].at[k]);
}

template class StiffnessLaplacian<float>;
template class StiffnessLaplacian<double>;

}  // namespace coapt
