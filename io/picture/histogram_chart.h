// Small multiples of histograms laid over each other: two or more samples, the same bins.
#pragma once

#include <string>
#include <vector>

#include "io/picture/chart_frame.h"

namespace coapt {

struct Sample {
  std::string label;
  std::vector<double> values;  ///< those that are not finite do not count
  Hue hue = Hue::Blue;
};

struct HistogramPanel {
  FrameWords words;
  std::string unit;
  std::vector<Sample> samples;
};

/// About 30 bins of round width from 0 (or the least) to a third past the 97th percentile; what lies beyond is
/// said in words, as are the mean and sd of each sample, all its values included.
struct HistogramChart {
  std::string title, note;
  std::vector<HistogramPanel> panels;
  int columns = 3;
  double panel_height = 300.0;  ///< px, words included
};

std::string histogram_chart_svg(const HistogramChart& chart);

}  // namespace coapt
