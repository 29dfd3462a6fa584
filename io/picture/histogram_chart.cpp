#include "io/picture/histogram_chart.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "io/picture/svg.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr int kBins = 30;
// The view ends this much past this share of the values; a long tail would squeeze the rest.
constexpr double kMostInView = 0.97, kFurther = 1.3;
constexpr double kWordLine = 15.0;  // px

std::vector<double> finite(const std::vector<double>& values) {
  std::vector<double> kept;
  std::copy_if(values.begin(), values.end(), std::back_inserter(kept),
               [](double value) { return std::isfinite(value); });
  return kept;
}

/// Ends on the bins' borders.
Axis bins_of(const HistogramPanel& panel) {
  std::vector<double> all;
  for (const Sample& sample : panel.samples) {
    const std::vector<double> values = finite(sample.values);
    all.insert(all.end(), values.begin(), values.end());
  }
  if (all.empty()) return {};
  std::sort(all.begin(), all.end());
  const auto last = static_cast<std::size_t>(kMostInView * static_cast<double>(all.size() - 1));
  return round_axis({all.front(), std::min(all.back(), kFurther * all[last])}, kBins);
}

struct Counts {
  std::vector<int> in;
  int beyond = 0;
};

Counts counts_of(const Sample& sample, const Axis& bins) {
  const auto count = static_cast<int>(std::lround((bins.high - bins.low) / bins.step));
  Counts counts{std::vector<int>(static_cast<std::size_t>(count)), 0};
  for (const double value : finite(sample.values)) {
    const double bin = std::floor((value - bins.low) / bins.step);
    if (value > bins.high)
      ++counts.beyond;
    else
      ++counts.in[static_cast<std::size_t>(std::clamp(static_cast<int>(bin), 0, count - 1))];
  }
  return counts;
}

/// Filled steps, then their outline: both stay visible where samples overlap.
std::string draw_bins(const Frame& frame, const Axis& bins, const std::vector<int>& counts,
                      Hue hue) {
  std::string steps;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double left = bins.low + static_cast<double>(i) * bins.step;
    steps += "V" + fixed(y_at(frame, counts[i]), 1) + "H" + fixed(x_at(frame, left + bins.step), 1);
  }
  const std::string path = "M" + fixed(x_at(frame, bins.low), 1) + " " +
                           fixed(y_at(frame, 0.0), 1) + steps + "V" + fixed(y_at(frame, 0.0), 1);
  return "<path class=\"area " + std::string(css_class(hue)) + "\" d=\"" + path + "Z\"/>\n" +
         "<path class=\"line outline " + css_class(hue) + "\" d=\"" + path + "\"/>\n";
}

struct Moments {
  double mean = 0.0, sd = 0.0;
};

Moments moments(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, std::sqrt(squares / count)};  // as in summarise() of the studies
}

std::string draw_words(const Frame& frame, const HistogramPanel& panel, std::size_t index,
                       int beyond) {
  const Sample& sample = panel.samples[index];
  const std::vector<double> values = finite(sample.values);
  if (values.empty()) return "";
  const Moments m = moments(values);
  const double y = frame.plot.top + 8.0 + kWordLine * 2.0 * static_cast<double>(index);
  const std::string end = "text-anchor=\"end\" class=\"" + std::string(css_class(sample.hue));
  std::string svg =
      text_at(frame.plot.right, y, end + "\"",
              sample.label + ": " + fixed(m.mean, 1) + " ± " + fixed(m.sd, 1) + " " + panel.unit);
  const std::string tail = beyond > 0 ? ", " + std::to_string(beyond) + " beyond" : "";
  svg += text_at(frame.plot.right, y + kWordLine - 1.5, end + " tick\"",
                 "n " + std::to_string(values.size()) + tail);
  if (m.mean <= frame.x.high) {
    const double x = x_at(frame, m.mean);
    svg +=
        line_at((std::string("line dashed ") + css_class(sample.hue)).c_str(), x, frame.plot.bottom,
                x, frame.plot.top + 0.3 * (frame.plot.bottom - frame.plot.top));
  }
  return svg;
}

std::string draw_panel(const HistogramPanel& panel, const PlotBox& box) {
  const Axis bins = bins_of(panel);
  std::vector<Counts> counts;
  Extent most{0.0, 1.0};
  for (const Sample& sample : panel.samples) {
    counts.push_back(counts_of(sample, bins));
    for (const int count : counts.back().in) most = including(most, count);
  }
  Axis x = round_axis({bins.low, bins.high}, 5);
  x.low = bins.low, x.high = bins.high;
  most.high *= 1.3;  // room for the words
  const Frame frame{{box.left + 60.0, box.top + 30.0, box.right - 16.0, box.bottom - 46.0},
                    x,
                    round_axis(most, 4)};
  std::string svg = draw_frame(frame, panel.words);
  for (std::size_t i = 0; i < panel.samples.size(); ++i)
    svg += draw_bins(frame, bins, counts[i].in, panel.samples[i].hue);
  for (std::size_t i = 0; i < panel.samples.size(); ++i)
    svg += draw_words(frame, panel, i, counts[i].beyond);
  return svg;
}

}  // namespace

std::string histogram_chart_svg(const HistogramChart& chart) {
  Heading heading{chart.title, chart.note, {}};
  if (!chart.panels.empty())
    for (const Sample& sample : chart.panels.front().samples)
      heading.legend.push_back({sample.label, css_class(sample.hue), Mark::Area});
  const Drawn head = draw_heading(heading);
  const CellGrid grid{static_cast<int>(chart.panels.size()), chart.columns, head.bottom,
                      chart.panel_height};
  std::string svg = head.svg;
  for (int i = 0; i < grid.count; ++i)
    svg += draw_panel(chart.panels[static_cast<std::size_t>(i)], cell(grid, i));
  return figure_svg(chart.title, svg, {bottom_of(grid)});
}

}  // namespace coapt
