// A search problem solved exhaustively: the cost of every combination of a few discrete variables.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/valve/types.h"

namespace coapt::rivals {

struct LatticeVariable {
  std::string name;     ///< one line
  bool ordered = true;  ///< a size or a length; else a category, whose values have no order
  int count = 2;        ///< values, 2 to kMostValues: dlib refuses one, pagmo may hang on it

  bool operator==(const LatticeVariable&) const = default;
};

struct LatticeTable {
  std::string name;                        ///< one line
  std::vector<LatticeVariable> variables;  ///< 2 to kMostVariables
  /// Of each combination, in mixed radix with variable 0 fastest; lower is better, infinity is
  /// impossible, one at least is finite. Combinations that are the same plan have the same cost.
  std::vector<double> costs;
  /// Number of each combination's plan, from 0, for combinations that are the same; empty: all differ.
  std::vector<int> plans{};

  bool operator==(const LatticeTable&) const = default;
};

constexpr int kMostVariables = 10;  ///< as many as NLopt's AGS takes
constexpr int kMostValues = 1000;
constexpr std::size_t kMostCombinations = 1'000'000;

/// Where the combination's cost is. @pre 0 <= at[k] < count of variable k.
std::size_t index_of(const LatticeTable& table, std::span<const int> at);
/// Its inverse.
std::vector<int> combination_of(const LatticeTable& table, std::size_t index);

/// Text of one thing a line, costs as %.17g in the table's order:
///
///     coapt-lattice 1
///     name NAME
///     ordered COUNT NAME      (or: category COUNT NAME)
///     costs COUNT
///     COST
///     plans COUNT             (not if all differ)
///     NUMBER
///
/// Lines end in \n. An error is the first of the text, with its line.
Expected<LatticeTable> read_lattice(std::string_view text);
std::string write_lattice(const LatticeTable& table);

}  // namespace coapt::rivals
