// What charts of several panels share: round axes, colours of light and dark pages, heading, frame.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace coapt {

inline constexpr double kFigureWidth = 1000.0;  // px; every figure of several panels is that wide

/// Okabe and Ito's, told apart by every kind of sight; lighter on dark pages. Ink: the text's.
enum class Hue { Ink, Blue, Vermillion, Green, Purple, Sky, Orange };
const char* css_class(Hue hue);

/// Steps of the sequential scale, viridis: on light pages from light to dark, on dark ones from dark
/// to light, so that more always stands out more.
inline constexpr int kShades = 8;
/// `share` 0 to 1, clamped: "h0" to "h7".
std::string shade_class(double share);

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};
/// Widened to hold `value`, unless that is not finite.
Extent including(Extent range, double value);

/// A range with round ends, and the distance of its ticks.
struct Axis {
  double low = 0.0, high = 1.0, step = 0.2;
  int decimals = 1;
  bool log = false;  ///< its values are decimal logarithms of what the ticks say
};

/// About `ticks` steps of 1, 2 or 5 times a power of ten that hold the range, and 0 if it is near.
Axis round_axis(Extent range, int ticks = 5);
/// Whole decades that hold the range of logarithms.
Axis decade_axis(Extent range);
/// Multiples of the step.
std::vector<double> ticks_of(const Axis& axis);

/// Pixels, y downwards.
struct PlotBox {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

struct Frame {
  PlotBox plot;
  Axis x, y;
};
double x_at(const Frame& frame, double value);
double y_at(const Frame& frame, double value);

struct FrameWords {
  std::string title, x_label, y_label;
};
/// Grid, ticks and words, which stand up to 26 px above, 40 px below and 48 px left of the plot.
std::string draw_frame(const Frame& frame, const FrameWords& words);

enum class Mark { Line, Dashed, LongDashed, Dotted, DashDotted, Dot, Hollow, Area };
/// Of the path of a line's mark; "" of marks that are no lines.
std::string line_class(Mark mark);
struct LegendEntry {
  std::string label, colour;  ///< colour: class
  Mark mark = Mark::Line;
};

/// A line each, downwards; `y`: baseline of the first.
std::string draw_keys(const std::vector<LegendEntry>& entries, double x, double y);

struct Heading {
  std::string title, note;  ///< a note is wrapped
  std::vector<LegendEntry> legend;
  double width = kFigureWidth;
};

/// Elements and where they end, px.
struct Drawn {
  std::string svg;
  double bottom = 0.0;
};
Drawn draw_heading(const Heading& heading);

/// `count` equal cells in rows of `columns`, from `top` downwards; `height` of each, px.
struct CellGrid {
  int count = 0, columns = 3;
  double top = 0.0, height = 300.0;
  double width = kFigureWidth;  ///< of a row
};
PlotBox cell(const CellGrid& grid, int index);
double bottom_of(const CellGrid& grid);

struct FigureSize {
  double height = 0.0, width = kFigureWidth;
};
/// The whole file; `title` for those who do not see it.
std::string figure_svg(const std::string& title, const std::string& content, FigureSize size);

}  // namespace coapt
