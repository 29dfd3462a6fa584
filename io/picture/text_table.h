// Tables for a terminal.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace coapt {

using TableRows = std::vector<std::vector<std::string>>;  ///< the first is the head; all as long

/// Three digits, "-" of what is not finite.
std::string figure_cell(double value);

/// Columns that a text takes: a character of UTF-8 is one wide.
int width_of(const std::string& text);

/// Columns aligned: the first to the left, the others to the right.
void print_table(std::ostream& out, const TableRows& rows);

}  // namespace coapt
