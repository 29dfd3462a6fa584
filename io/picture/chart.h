#pragma once

#include <string>
#include <vector>

namespace coapt {

struct Series {
  std::string label;
  std::vector<double> x, y;
  bool line = true;  ///< through the points; else markers alone
  bool dashed = false;
};
struct Chart {
  std::string title, x_label, y_label;
  std::vector<Series> series;
  bool log_x = false;  ///< decades; x must be > 0
};
std::string chart_svg(const Chart& chart);

}  // namespace coapt
