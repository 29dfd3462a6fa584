#include "io/picture/study_charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "io/picture/histogram_chart.h"
#include "io/picture/line_chart.h"
#include "io/picture/text.h"
#include "search/studies/thesis_figures.h"

namespace coapt {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kShareFrom_mm2 = 5.0;  // smaller orifices give wild ratios
constexpr std::array<Hue, 6> kHues = {Hue::Vermillion, Hue::Green, Hue::Blue,
                                      Hue::Purple,     Hue::Sky,   Hue::Orange};
constexpr std::array<Hue, 6> kAnchorHues = {Hue::Blue,   Hue::Vermillion, Hue::Green,
                                            Hue::Purple, Hue::Orange,     Hue::Sky};

template <std::size_t N>
Hue hue(const std::array<Hue, N>& hues, std::size_t i) {
  return hues[i % N];
}

/// In percent of `base`, NaN where that is small.
std::vector<double> share_of(const std::vector<double>& area, const std::vector<double>& base) {
  std::vector<double> share;
  for (std::size_t i = 0; i < std::min(area.size(), base.size()); ++i)
    share.push_back(base[i] >= kShareFrom_mm2 ? 100.0 * area[i] / base[i] : kNaN);
  return share;
}

using Measure = double AnchorSummary::*;

std::vector<AnchorSummary> of_kind(std::vector<AnchorSummary> summaries, Displaced displaced,
                                   Protocol protocol) {
  std::erase_if(summaries, [&](const AnchorSummary& s) {
    return s.displaced != displaced || s.protocol != protocol;
  });
  return summaries;
}

/// Once around, and a ring where it is least.
void add_scan(LinePanel& panel, const std::vector<AnchorSummary>& scan, Measure measure) {
  PanelSeries around{"on the annulus", {}, {}, Hue::Green};
  PanelSeries least{"least", {}, {}, Hue::Ink, Mark::Hollow};
  for (const AnchorSummary& s : scan) {
    around.x.push_back(s.anchor.around);
    around.y.push_back(s.*measure);
    if (std::isfinite(s.*measure) && (least.y.empty() || s.*measure < least.y.front())) {
      least.x = {s.anchor.around};
      least.y = {s.*measure};
    }
  }
  if (!around.x.empty() && around.x.front() == 0.0) {
    around.x.push_back(1.0);
    around.y.push_back(around.y.front());
  }
  if (!least.y.empty())
    panel.words.x_label +=
        "; minimum " + fixed(least.y.front(), 1) + " at " + fixed(least.x.front(), 2);
  panel.series.push_back(around);
  panel.series.push_back(least);
}

void add_levels(LinePanel& panel, const std::vector<AnchorSummary>& anchors, Measure measure) {
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    const AnchorSite& site = anchors[i].anchor;
    const double level = anchors[i].*measure;
    panel.series.push_back(
        {site.name, {0.0, 1.0}, {level, level}, hue(kAnchorHues, i), Mark::Dashed});
    if (site.around > 0.0)
      panel.series.push_back({"", {site.around}, {level}, hue(kAnchorHues, i), Mark::Dot});
  }
}

}  // namespace

const char* class_title(Displaced displaced) {
  switch (displaced) {
    case Displaced::Anterolateral:
      return "Anterolateral muscle displaced";
    case Displaced::Posteromedial:
      return "Posteromedial muscle displaced";
    case Displaced::Both:
      return "Both muscles displaced";
  }
  return "";
}

std::string annulus_svg(const AnnulusStudy& study, bool with_thesis) {
  LineChart chart;
  chart.title = "Orifice of a dilated and flattened annulus";
  chart.note =
      "Thesis, figure 4.5. Trigones, papillary tips and transverse diameter are fixed. Right: "
      "orifice with the flattened annulus in percent of that with the unflattened annulus at the "
      "same dilation, from 5 mm² upwards.";
  chart.columns = 2;
  chart.panel_height = 380.0;
  LinePanel areas{{"Orifice", "anteroposterior dilation, %", "orifice, mm²"}, {}};
  LinePanel shares{{"Relative to the unflattened annulus", "anteroposterior dilation, %",
                    "share of the orifice, %"},
                   {}};
  for (std::size_t h = 0; h < std::min(study.height_percent.size(), study.area_mm2.size()); ++h) {
    PanelSeries series{"height " + fixed(study.height_percent[h], 0) + " %", study.dilation_percent,
                       study.area_mm2[h], hue(kHues, h)};
    areas.series.push_back(series);
    series.y = share_of(study.area_mm2[h], study.area_mm2.front());
    shares.series.push_back(series);
  }
  // At first "negligible" (4.3.1).
  if (with_thesis)
    areas.series.push_back(
        {"thesis, 100 %",
         {0.0, thesis::kDilation_percent[0], thesis::kDilation_percent[1],
          thesis::kDilation_percent[2]},
         {0.0, thesis::kDilated_mm2[0], thesis::kDilated_mm2[1], thesis::kDilated_mm2[2]},
         Hue::Ink,
         Mark::Hollow});
  chart.panels = {areas, shares};
  return line_chart_svg(chart);
}

std::string anchors_histogram_svg(const ApproximationStudy& study) {
  HistogramChart chart;
  chart.title = "Anchors of the papillary suture";
  chart.note = std::string("Thesis, figure 4.10; protocol ") + to_string(study.protocol) +
               ". Each entry is one displaced configuration after repair: mean (above) and sd "
               "(below) of the orifice over its region of interest. Dashed line and text: mean ± "
               "sd of the entries; beyond: outside the last bin.";
  chart.panel_height = 290.0;
  const auto add_row = [&](double RegionOrifice::*measure, const char* words) {
    for (const Displaced displaced : kDisplaced) {
      HistogramPanel panel{{class_title(displaced), words, "configurations"}, "mm²", {}};
      for (std::size_t a = 0; a < study.anchors.size(); ++a) {
        Sample sample{study.anchors[a].name, {}, hue(kAnchorHues, a)};
        for (const Approximation& found : study.approximations)
          if (found.displaced == displaced && found.anchor == a)
            sample.values.push_back(found.region.*measure);
        panel.samples.push_back(sample);
      }
      chart.panels.push_back(panel);
    }
  };
  add_row(&RegionOrifice::mean_mm2, "mean orifice of the region, mm²");
  add_row(&RegionOrifice::sd_mm2, "sd of the orifice in the region, mm²");
  return histogram_chart_svg(chart);
}

std::string anchor_scan_svg(const std::vector<AnchorSummary>& scan,
                            const std::vector<AnchorSummary>& thesis) {
  LineChart chart;
  chart.title = "Anchors around the annulus";
  chart.note =
      "Mean over all displaced configurations of the region's mean orifice (above) and sd (below). "
      "Position: fraction of the annulus from the posteromedial commissure (0) over the saddle "
      "peak "
      "(0.25) to the anterolateral commissure (0.5) and onwards; mirrored for the anterolateral "
      "muscle.";
  chart.panel_height = 280.0;
  const auto add_row = [&](Measure measure, const char* words) {
    for (const Displaced displaced : kDisplaced) {
      LinePanel panel{{class_title(displaced), "anchor position", words}, {}};
      panel.x_axis = Axis{0.0, 1.0, 0.25, 2};
      panel.y_holds = {0.0, 0.0};
      const Protocol protocol = scan.empty() && !thesis.empty() ? thesis.front().protocol
                                : scan.empty()                  ? Protocol::LookupExtended
                                                                : scan.front().protocol;
      add_scan(panel, of_kind(scan, displaced, protocol), measure);
      add_levels(panel, of_kind(thesis, displaced, protocol), measure);
      chart.panels.push_back(panel);
    }
  };
  add_row(&AnchorSummary::mean_mm2, "mean orifice, mm²");
  add_row(&AnchorSummary::sd_mm2, "sd of the orifice, mm²");
  return line_chart_svg(chart);
}

}  // namespace coapt
