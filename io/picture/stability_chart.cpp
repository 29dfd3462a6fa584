#include "io/picture/stability_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "io/picture/svg.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr double kCellWidth = 26.0, kCellHeight = 17.0;
constexpr double kLeft = 90.0, kTop = 92.0, kPanelGap = 20.0;
constexpr double kColumns = 7.0;  // of the widest panel
constexpr double kPanelTitle = 16.0, kLevelLabels = 14.0, kPanelBelow = 16.0;
constexpr double kSceneTitle = 16.0;
constexpr std::size_t kPanelsInRow = 4;

struct Style {
  StabilityOutcome outcome;
  const char *letter, *colour, *ink, *meaning;
};

// Okabe and Ito's colours, told apart by every kind of sight; a letter says the same.
constexpr std::array<Style, 5> kStyles = {
    {{StabilityOutcome::Settles, "S", "#009e73", "#ffffff", "settles"},
     {StabilityOutcome::OtherEquilibrium, "O", "#56b4e9", "#000000", "settles elsewhere"},
     {StabilityOutcome::Crosses, "X", "#d55e00", "#ffffff", "settles, leaflets cross"},
     {StabilityOutcome::Stalls, "N", "#f0e442", "#000000", "does not settle"},
     {StabilityOutcome::BlowsUp, "B", "#000000", "#ffffff", "blows up"}}};

const Style& style_of(StabilityOutcome outcome) {
  return kStyles[static_cast<std::size_t>(outcome)];
}

const char* axis_title(Difficulty axis) {
  switch (axis) {
    case Difficulty::Step:
      return "step, factor";
    case Difficulty::ContactStiffness:
      return "contact stiffness, factor";
    case Difficulty::ChordaeModulus:
      return "chordae modulus, factor";
    case Difficulty::Pressure:
      return "pressure, kPa";
    case Difficulty::Slivers:
      return "slivers, edge ratio";
    case Difficulty::Resolution:
      return "resolution, triangles";
    case Difficulty::Dilation:
      return "AP dilation, %";
    case Difficulty::Tips:
      return "tips displaced, mm";
  }
  return "";
}

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string square(double x, double y, const Style& style, const std::string& letter, bool framed) {
  std::string svg = "<rect x=\"" + fixed(x + 0.5, 1) + "\" y=\"" + fixed(y + 0.5, 1) +
                    "\" width=\"" + fixed(kCellWidth - 1.0, 1) + "\" height=\"" +
                    fixed(kCellHeight - 1.0, 1) + "\" fill=\"" + style.colour + "\"" +
                    (framed ? " class=\"nominal\"" : "") + "/>\n";
  return svg + text_at(x + 0.5 * kCellWidth, y + 12.5,
                       "class=\"letter\" style=\"fill:" + std::string(style.ink) + "\"", letter);
}

/// What a list has, each once, in the order of its first appearance.
template <class T, class Of>
std::vector<T> each_once(const std::vector<const StabilityCell*>& cells, const Of& of) {
  std::vector<T> found;
  for (const StabilityCell* cell : cells)
    if (std::find(found.begin(), found.end(), of(*cell)) == found.end()) found.push_back(of(*cell));
  return found;
}

std::vector<const StabilityCell*> those(const std::vector<const StabilityCell*>& cells,
                                        const std::function<bool(const StabilityCell&)>& wanted) {
  std::vector<const StabilityCell*> found;
  for (const StabilityCell* cell : cells)
    if (wanted(*cell)) found.push_back(cell);
  return found;
}

/// Cells of one scene and axis at (x, y), their top left corner.
std::string draw_panel(double x, double y, const std::vector<const StabilityCell*>& cells,
                       const std::vector<std::string>& methods) {
  std::string svg = text_at(x, y - 5.0, "class=\"axis\"", axis_title(cells.front()->axis));
  const auto levels = each_once<double>(cells, [](const auto& c) { return c.level; });
  const double below = y + kCellHeight * static_cast<double>(methods.size());
  for (std::size_t l = 0; l < levels.size(); ++l)
    svg += text_at(x + kCellWidth * (static_cast<double>(l) + 0.5), below + 11.0, "class=\"level\"",
                   number(levels[l]));
  // Framed cells come last, so that no neighbour covers their frame.
  for (const bool framed : {false, true})
    for (const StabilityCell* cell : cells) {
      if (cell->nominal != framed) continue;
      const auto row = std::find(methods.begin(), methods.end(), cell->method) - methods.begin();
      const auto column = std::find(levels.begin(), levels.end(), cell->level) - levels.begin();
      const Style& style = style_of(cell->outcome);
      svg += square(
          x + kCellWidth * static_cast<double>(column), y + kCellHeight * static_cast<double>(row),
          style, style.letter + (cell->attempts > 1 ? std::to_string(cell->attempts) : ""), framed);
    }
  return svg;
}

std::string draw_legend() {
  std::string svg;
  double x = 14.0;
  for (const Style& style : kStyles) {
    svg += square(x, 32.0, style, style.letter, false);
    svg += text_at(x + kCellWidth + 5.0, 45.0, "class=\"axis\"", style.meaning);
    x += kCellWidth + 28.0 + 6.2 * static_cast<double>(std::string(style.meaning).size());
  }
  return svg;
}

}  // namespace

std::string stability_csv(const std::vector<StabilityCell>& cells) {
  std::ostringstream csv;
  const auto add = [&](double value) {
    csv << ',';
    if (std::isfinite(value)) csv << value;
  };
  csv << "scene,axis,level,nominal,method,outcome,steps,seconds,residual,crossing_pairs,attempts,"
         "from_reference_mm,end_from_reference_mm,orifice_difference_mm2\n";
  for (const StabilityCell& c : cells) {
    csv << c.scene << ',' << to_string(c.axis) << ',' << c.level << ','
        << (c.nominal ? "true" : "false") << ',' << c.method << ',' << to_string(c.outcome) << ','
        << c.steps << ',' << c.seconds;
    add(c.residual);
    csv << ',' << c.crossing_pairs << ',' << c.attempts;
    add(c.from_reference_mm);
    add(c.end_from_reference_mm);
    add(c.orifice_difference_mm2);
    csv << '\n';
  }
  return csv.str();
}

std::string stability_svg(const std::vector<StabilityCell>& cells) {
  std::vector<const StabilityCell*> all;
  for (const StabilityCell& cell : cells) all.push_back(&cell);
  const auto methods = each_once<std::string>(all, [](const auto& c) { return c.method; });
  const double rows = kCellHeight * static_cast<double>(methods.size());
  std::string body;
  double y = kTop, width = 640.0;
  for (const std::string& scene :
       each_once<std::string>(all, [](const auto& c) { return c.scene; })) {
    body += text_at(14.0, y + 4.0, "class=\"scene\"",
                    scene == kCommissures ? "human-normal, annulus 20 % narrower: surplus tissue "
                                            "at the commissures"
                                          : scene);
    y += kSceneTitle;
    const auto here = those(all, [&](const auto& c) { return c.scene == scene; });
    const auto axes = each_once<Difficulty>(here, [](const auto& c) { return c.axis; });
    double x = kLeft;
    for (std::size_t a = 0; a < axes.size(); ++a) {
      const auto panel = those(here, [&](const auto& c) { return c.axis == axes[a]; });
      if (a % kPanelsInRow == 0) {
        x = kLeft;
        y += a == 0 ? kPanelTitle : rows + kLevelLabels + kPanelBelow + kPanelTitle;
        for (std::size_t m = 0; m < methods.size(); ++m)
          body += text_at(kLeft - 8.0, y + kCellHeight * static_cast<double>(m) + 12.5,
                          "class=\"method\"", methods[m]);
      }
      body += draw_panel(x, y, panel, methods);
      x += kPanelGap + kCellWidth * kColumns;
      width = std::max(width, x);
    }
    y += rows + kLevelLabels + kPanelBelow + 12.0;
  }
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"coapt-map\" viewBox=\"0 0 " +
         fixed(width, 0) + " " + fixed(y - 8.0, 0) +
         "\" role=\"img\" aria-label=\"Map of stability\">\n<style>\n"
         ".coapt-map{color:#26313d;font:12px system-ui,\"Segoe UI\",\"DejaVu Sans\",sans-serif}\n"
         "@media (prefers-color-scheme:dark){.coapt-map{color:#d8dee6}}\n"
         ".coapt-map text{fill:currentColor}\n"
         ".coapt-map .title{font-size:16px;font-weight:600}\n"
         ".coapt-map .scene{font-size:14px;font-weight:600}.coapt-map .axis{opacity:.85}\n"
         ".coapt-map .method{text-anchor:end}\n"
         ".coapt-map .level{text-anchor:middle;font-size:9px;opacity:.8}\n"
         ".coapt-map .letter{text-anchor:middle;font-size:11px;font-weight:600}\n"
         ".coapt-map .nominal{stroke:currentColor;stroke-width:2}\n"
         "</style>\n" +
         text_at(14.0, 22.0, "class=\"title\"",
                 "Where each method closes a valve and where it fails") +
         draw_legend() +
         text_at(14.0, 67.0, "class=\"level\" style=\"text-anchor:start;font-size:11px\"",
                 "Framed: nominal. A number: attempts of coapt's ladder. All are at rest at "
                 "residual 0.01.") +
         body + "</svg>\n";
}

}  // namespace coapt
