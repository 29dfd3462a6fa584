#include "search/studies/geometry_findings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "search/rank_correlation.h"
#include "search/studies/finding_text.h"
#include "search/studies/thesis_figures.h"

namespace coapt {
namespace {

constexpr double kDilationTolerance = 0.15;  // share of the thesis's orifice
constexpr double kLeastLeak_mm2 = 5.0;       // smaller orifices have no meaningful ratio
constexpr double kTableTolerance = 0.98;     // Spearman over table 4.1
constexpr double kIncreaseTolerance = 0.15;  // share, of the synergy

double dilated(const AnnulusStudy& study, double percent, std::size_t height = 0) {
  const auto& dilations = study.dilation_percent;
  const auto found = std::find(dilations.begin(), dilations.end(), percent);
  return study.area_mm2[height][found - dilations.begin()];
}

/// Increments of the orifice per mm along the diagonal of all axes, up to the middle node and from
/// there.
bool superlinear(const DisplacementGrid& grid) {
  const int last = grid.nodes - 1, middle = last / 2;
  const double low = grid.at(0, 0, 0), half = grid.at(middle, middle, middle);
  return (grid.at(last, last, last) - half) * middle > (half - low) * (last - middle);
}

Finding growth_finding(const DisplacementGrid& grid) {
  const int last = grid.nodes - 1, middle = last / 2;
  return {std::string("displacement-grows-superlinearly-") + to_string(grid.displaced),
          "4.3.1",
          "growth is superlinear",
          in_words({grid.at(0, 0, 0), grid.at(middle, middle, middle), grid.at(last, last, last)}) +
              " mm2 at 0 / " + in_words(grid.step_mm * middle, 0) + " / " +
              in_words(grid.step_mm * last, 0) + " mm along all axes",
          "the second part of the way adds more per mm than the first",
          superlinear(grid)};
}

Finding axes_finding(const DisplacementGrid& grid) {
  const Vec3 slope = mean_gradient(grid);
  return {std::string("apical-most-then-transverse-then-posterior-") + to_string(grid.displaced),
          "4.3.1",
          "most sensitive to apical, then transverse, then posterior displacement",
          in_words({slope.z(), slope.x(), slope.y()}) +
              " mm2 per mm apical / transverse / posterior (mean gradient)",
          "in that order",
          slope.z() > slope.x() && slope.x() > slope.y()};
}

}  // namespace

std::vector<Finding> annulus_findings(const AnnulusStudy& study) {
  std::vector<Finding> all;
  const std::vector<double> ours = {dilated(study, 0), dilated(study, 10), dilated(study, 20),
                                    dilated(study, 30)};
  bool near = true;
  for (std::size_t k = 0; k < 3; ++k)
    near &= std::abs(ours[k + 1] / thesis::kDilated_mm2[k] - 1.0) <= kDilationTolerance;
  const std::string text = in_words(ours) + " mm2 at 0 / 10 / 20 / 30 %";
  all.push_back({"dilation-orifice", "4.3.1", "6.7 / 32.0 / 86.9 mm2 at 10 / 20 / 30 %", text,
                 "each within 15 %", near});
  all.push_back({"dilation-grows-superlinearly", "4.3.1", "each 10 % adds more than the one before",
                 text, "each 10 % adds more than the one before",
                 ours[1] - ours[0] < ours[2] - ours[1] && ours[2] - ours[1] < ours[3] - ours[2]});
  all.push_back({"dilation-hardly-matters-at-first", "4.3.1", "growth is negligible at first",
                 in_words(dilated(study, 5) - ours[0], 1) + " mm2 more at 5 %, " +
                     in_words(ours[3] - dilated(study, 25), 1) + " mm2 more from 25 to 30 %",
                 "the first 5 % add less than a tenth of what the last 5 % do",
                 dilated(study, 5) - ours[0] < 0.1 * (ours[3] - dilated(study, 25))});
  double by_height = 0.0;
  for (std::size_t h = 1; h < study.height_percent.size(); ++h)
    for (const double d : study.dilation_percent)
      by_height = std::max(by_height, std::abs(dilated(study, d, h) - dilated(study, d)));
  all.push_back({"flattening-matters-far-less-than-dilation", "4.3.1",
                 "large changes of annular height have a minimal impact",
                 "at most " + in_words(by_height, 1) + " mm2 by height, " +
                     in_words(ours[3] - ours[0], 1) + " mm2 by dilation",
                 "less than a fifth", by_height < 0.2 * (ours[3] - ours[0])});
  double least = std::numeric_limits<double>::infinity(), most = -least;
  double sum = 0.0;
  int counted = 0;
  for (const double d : study.dilation_percent) {
    if (d < 15.0 || dilated(study, d) < kLeastLeak_mm2) continue;
    const double change = dilated(study, d, 1) / dilated(study, d) - 1.0;
    least = std::min(least, change);
    most = std::max(most, change);
    sum += change;
    ++counted;
  }
  const double mean = counted > 0 ? sum / counted : std::numeric_limits<double>::quiet_NaN();
  all.push_back({"flattening-by-25-percent-shrinks-orifice-5-to-10-percent", "4.3.1",
                 "at large dilation, 25 % less height shrinks the orifice by 5 to 10 %",
                 "mean change " + in_percent(mean, 1) + " (" + in_percent(least, 1) + " to " +
                     in_percent(most, 1) + ") at 15 to 30 % dilation",
                 "mean between -5 and -10 %", mean <= -0.05 && mean >= -0.10});
  return all;
}

std::vector<Finding> papillary_findings(const PapillaryStudy& study) {
  const auto& [al, pm, both] = study.grids;
  std::vector<Finding> all;
  std::vector<double> ours, theirs;
  double squares = 0.0;
  for (std::size_t k = 0; k < study.grids.size(); ++k) {
    const std::array<double, 7> row = largest_orifices(study.grids[k]);
    for (std::size_t axes = 0; axes < row.size(); ++axes) {
      ours.push_back(row[axes]);
      theirs.push_back(thesis::kDisplaced_mm2[k][axes]);
      squares += std::pow(ours.back() - theirs.back(), 2);
    }
  }
  const double rho = rank_correlation(ours, theirs);
  all.push_back({"table-4.1", "4.3.1", "21 largest orifices, 0.5 to 191.7 mm2",
                 "Spearman " + in_words(rho, 3) + ", rms difference " +
                     in_words(std::sqrt(squares / 21.0), 1) + " mm2",
                 "Spearman at least 0.98", rho >= kTableTolerance});
  for (const DisplacementGrid& grid : study.grids) {
    all.push_back(growth_finding(grid));
    all.push_back(axes_finding(grid));
  }
  int above = 0;
  for (std::size_t i = 0; i < al.area_mm2.size(); ++i)
    if (pm.area_mm2[i] > al.area_mm2[i]) ++above;
  const double share = static_cast<double>(above) / static_cast<double>(al.area_mm2.size());
  all.push_back({"posteromedial-more-sensitive", "4.3.1",
                 "posteromedial displacement leaks more in over 90 % of configurations",
                 in_percent(share), "over 90 %", share > 0.9});
  const Synergy s = synergy(study);
  all.push_back({"both-exceed-the-sum", "4.3.1",
                 "in 81 % of configurations; 92 % from 1 mm, 100 % from 2 mm along each axis",
                 in_percent(s.share) + "; " + in_percent(s.share_from_1mm) + "; " +
                     in_percent(s.share_from_2mm),
                 "at least that often",
                 s.share >= thesis::kSynergyShare && s.share_from_1mm >= thesis::kSynergyFrom1mm &&
                     s.share_from_2mm >= thesis::kSynergyFrom2mm});
  all.push_back({"both-exceed-the-sum-by-37-percent", "4.3.1", "37 % more on average",
                 in_percent(s.mean_increase) + " more in the mean of the configurations, " +
                     in_percent(s.total_increase) + " over all orifices together",
                 "the mean within 15 points",
                 std::abs(s.mean_increase - thesis::kSynergyIncrease) <= kIncreaseTolerance});
  const double together = mean_gradient(both).x(),
               apart = mean_gradient(al).x() + mean_gradient(pm).x();
  all.push_back({"lateral-sensitivity-rises-when-both-move", "4.3.1",
                 "sensitivity to lateral displacement increases dramatically when both move",
                 in_words(together, 1) + " mm2 per mm, against " + in_words(apart, 1) +
                     " of either alone together",
                 "more than the sum", together > apart});
  return all;
}

std::vector<Finding> belly_findings(const std::array<Vec3, 3>& shift_mm) {
  std::vector<double> lateral, apical;
  for (const Vec3& shift : shift_mm) {
    lateral.push_back(-shift.x());
    apical.push_back(-shift.z());
  }
  const bool follows = *std::min_element(lateral.begin(), lateral.end()) > 0.0 &&
                       lateral[0] == *std::max_element(lateral.begin(), lateral.end());
  return {{"anterior-leaflet-follows-lateral-displacement", "4.4",
           "A1, A2, A3 shift about 1 mm towards a tip displaced 6 mm laterally, the nearest most",
           in_words(lateral) + " mm laterally, " + in_words(apical) + " mm apically",
           "all outwards, A1 most", follows}};
}

}  // namespace coapt
