#pragma once

#include <filesystem>

namespace coapt {

/// Draws a table beside it with lab/charts/plot.py. If that fails (matplotlib is not installed), standard error says so;
/// the table is there all the same.
void draw(const std::filesystem::path& table);

}  // namespace coapt
