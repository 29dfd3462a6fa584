#include "io/picture/anchor_question_chart.h"

#include <algorithm>
#include <limits>

#include "io/picture/heat_map.h"
#include "io/picture/study_charts.h"

namespace coapt {
namespace {

constexpr double kRow_px = 34.0, kWords_px = 110.0, kLeft_px = 130.0, kRight_px = 20.0;

const char* short_name(AnchorObjective objective) {
  switch (objective) {
    case AnchorObjective::Mean:
      return "mean";
    case AnchorObjective::Sd:
      return "sd";
    case AnchorObjective::LengthSensitivity:
      return "length";
    case AnchorObjective::Movement:
      return "movement";
    case AnchorObjective::LeakingShare:
      return "leaking";
  }
  return "";
}

std::vector<Protocol> protocols_of(const std::vector<AnchorAnswer>& answers) {
  std::vector<Protocol> protocols;
  for (const AnchorAnswer& answer : answers)
    if (std::find(protocols.begin(), protocols.end(), answer.protocol) == protocols.end())
      protocols.push_back(answer.protocol);
  std::reverse(protocols.begin(), protocols.end());  // rows go upwards
  return protocols;
}

}  // namespace

std::string anchor_question_svg(const std::vector<AnchorAnswer>& answers) {
  const std::vector<Protocol> protocols = protocols_of(answers);
  HeatMap map;
  for (const Protocol protocol : protocols) map.row_ticks.emplace_back(to_string(protocol));
  for (const AnchorObjective objective : kAnchorObjectives)
    map.column_ticks.emplace_back(short_name(objective));
  for (const Displaced displaced : kDisplaced) {
    map.blocks.emplace_back(class_title(displaced));
    std::vector<std::vector<double>> block(
        protocols.size(),
        std::vector<double>(kAnchorObjectives.size(), std::numeric_limits<double>::quiet_NaN()));
    for (const AnchorAnswer& a : answers) {
      if (a.displaced != displaced || a.anatomies == 0) continue;
      const auto row = static_cast<std::size_t>(
          std::find(protocols.begin(), protocols.end(), a.protocol) - protocols.begin());
      block[row][static_cast<std::size_t>(a.objective)] =
          100.0 * (a.trigone_wins + 0.5 * a.ties) / static_cast<double>(a.anatomies);
    }
    map.values.push_back(block);
  }
  const Drawn heading =
      draw_heading({"Anatomies in which the trigone is the better anchor",
                    "Percentage of anatomies where the trigone yields lower values than the saddle "
                    "peak, for mean and sd of the orifice in the region of interest, sd due to "
                    "suture length, displacement of the muscle, and leaking fraction of the "
                    "region. A tie (within 1 %) counts half. By protocol.",
                    {}});
  const HeatScale scale{0.0, 100.0, 0};
  const double top = heading.bottom;
  const double bottom = top + kWords_px + kRow_px * static_cast<double>(protocols.size());
  std::string svg = heading.svg;
  if (!protocols.empty())
    svg += draw_heat_map(map, scale, {kLeft_px, top, kFigureWidth - kRight_px, bottom});
  svg += draw_scale(scale, "percent of anatomies", kLeft_px, bottom + 14.0);
  return figure_svg("Anatomies in which the trigone is the better anchor", svg, {bottom + 64.0});
}

}  // namespace coapt
