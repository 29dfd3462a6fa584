#include "io/picture/text_table.h"

#include <algorithm>
#include <cmath>

#include "core/valve/number_text.h"

namespace coapt {

std::string figure_cell(double value) { return std::isfinite(value) ? significant(value, 3) : "-"; }

int width_of(const std::string& text) {
  return static_cast<int>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

void print_table(std::ostream& out, const TableRows& rows) {
  std::vector<int> widths(rows.front().size(), 0);
  for (const std::vector<std::string>& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], width_of(row[c]));
  for (const std::vector<std::string>& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string fill(static_cast<std::size_t>(widths[c] - width_of(row[c])), ' ');
      out << (c == 0 ? row[c] + fill : "  " + fill + row[c]);
    }
    out << '\n';
  }
}

}  // namespace coapt
