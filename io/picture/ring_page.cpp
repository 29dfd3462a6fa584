#include "io/picture/ring_page.h"

#include <cmath>

#include "core/repair/limits.h"
#include "core/repair/rings.h"
#include "io/picture/ring_picture.h"
#include "io/picture/study_page.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

using RingTable = std::vector<std::vector<std::string>>;

constexpr double kDrawnSize_mm = 30.0;

std::string gain_words(const MeanInterval& gain, int decimals) {
  return fixed(gain.mean, decimals) + " (" + fixed(gain.low, decimals) + " to " +
         fixed(gain.high, decimals) + ")";
}

std::string candidate_words(const RingCandidate& candidate) {
  const std::string share = fixed(candidate.width_over_transverse, 2) + " of the annulus's width";
  const auto* name = std::get_if<std::string>(&candidate.shape);
  return (name != nullptr ? *name : std::get<DesignedShape>(candidate.shape).name) + ", " + share;
}

RingTable verdict_table(const RingDesignResult& result) {
  RingTable table = {{"Members", "n", "below 5 mm², design %", "generic %", "gain, points (95 %)",
                      "leak, design mm²", "generic mm²", "gain, mm² (95 %)"}};
  for (const RingVerdict& v : result.verdicts)
    table.push_back({v.aetiology.empty() ? "all held out" : v.aetiology, std::to_string(v.members),
                     fixed(v.design.below_percent, 1), fixed(v.generic.below_percent, 1),
                     gain_words(v.below_percent, 1), fixed(v.design.leak_mm2, 1),
                     fixed(v.generic.leak_mm2, 1), gain_words(v.leak_mm2, 1)});
  return table;
}

RingTable burden_table(const RingDesignResult& result) {
  const RingVerdict& all = result.verdicts.front();
  const auto row = [](const char* name, const RingFigures& f) {
    return std::vector<std::string>{name,
                                    fixed(f.size_mm, 1),
                                    fixed(f.gradient_mmhg, 1),
                                    fixed(f.stenotic_percent, 0),
                                    fixed(f.undersized_percent, 0),
                                    fixed(f.durability_mm, 1),
                                    fixed(f.suture_max_n, 2),
                                    fixed(f.suture_normal_n, 2)};
  };
  return {{"Ring", "mean size, mm", "gradient, mmHg", "above 5 mmHg, %", "above 4 sizes, %",
           "reserve against progression, mm", "largest suture force, N", "of it out of plane, N"},
          row("design", all.design),
          row("generic", all.generic)};
}

RingTable terms_table(const RingDesign& design) {
  RingTable table = {{"Term", "share of the width", "at 30 mm, mm", "accepted"}};
  for (const RingTermRow& row : kRingTerms) {
    const double share = design.shape.terms.*row.member;
    table.push_back({row.name, fixed(share, 3), fixed(kDrawnSize_mm * share, 1), shown(row.range)});
  }
  table.push_back({"width_over_transverse", fixed(design.width_over_transverse, 3), "",
                   shown(kRingWidthShares)});
  return table;
}

RingTable dimensions_table(const RingTerms& terms) {
  RingTable table = {{"size, mm", "depth, mm", "circumference, mm", "area, mm²", "height, mm",
                      "saddle, mm", "P3 drawn in, mm"}};
  for (double size = kRingSizesMm.min; size <= kRingSizesMm.max; size += kRingSizeStep_mm) {
    const RingDimensions d = dimensions_of(terms, size);
    table.push_back({fixed(size, 0), fixed(d.depth_mm, 1), fixed(d.circumference_mm, 1),
                     fixed(d.area_mm2, 0), fixed(d.height_mm, 1), fixed(d.saddle_mm, 1),
                     fixed(d.p3_inset_mm, 1)});
  }
  return table;
}

std::string asked_of(const std::string& aetiology, int members) {
  return counted(members, "held-out member") + (aetiology.empty() ? "" : ", " + aetiology);
}

RingTable contrast_table(const RingClaims& claims) {
  RingTable table = {{"Question", "evaluated on", "below 5 mm², points", "leak, mm²",
                      "largest suture force, N", "out of plane, N"}};
  for (const RingContrast& c : claims.contrasts)
    table.push_back({c.second + " less " + c.first, asked_of(c.aetiology, c.members),
                     gain_words(c.below_percent, 1), gain_words(c.leak_mm2, 2),
                     gain_words(c.suture_max_n, 3), gain_words(c.suture_normal_n, 3)});
  return table;
}

RingTable size_table(const RingClaims& claims) {
  RingTable table = {
      {"generic-classic, mm", "below 5 mm², %", "leak, mm²", "tenting, mm", "gradient, mmHg"}};
  for (const RingSizeFigures& size : claims.sizes)
    table.push_back({fixed(size.size_mm, 0), fixed(size.figures.below_percent, 0),
                     fixed(size.figures.leak_mm2, 1), fixed(size.figures.tenting_mm, 1),
                     fixed(size.figures.gradient_mmhg, 1)});
  return table;
}

}  // namespace

RingDimensions dimensions_of(const RingTerms& terms, double size_mm) {
  const Points contour = ring_contour_mm(terms, size_mm);
  RingDimensions dimensions{.size_mm = size_mm,
                            .depth_mm = terms.ap_over_transverse * size_mm,
                            .height_mm = contour.col(2).maxCoeff() - contour.col(2).minCoeff(),
                            .saddle_mm = terms.saddle * size_mm,
                            .p3_inset_mm = terms.p3_inset * size_mm};
  for (Index i = 0; i < contour.rows(); ++i) {
    const Vec3 a = contour.row(i), b = contour.row((i + 1) % contour.rows());
    dimensions.circumference_mm += (b - a).norm();
    dimensions.area_mm2 += 0.5 * (a.x() * b.y() - b.x() * a.y());
  }
  return dimensions;
}

std::string ring_dimensions_csv(const RingTerms& terms) {
  std::string csv = "size_mm,depth_mm,circumference_mm,area_mm2,height_mm,saddle_mm,p3_inset_mm\n";
  for (double size = kRingSizesMm.min; size <= kRingSizesMm.max; size += kRingSizeStep_mm) {
    const RingDimensions d = dimensions_of(terms, size);
    csv += fixed(size, 0) + ',' + fixed(d.depth_mm, 2) + ',' + fixed(d.circumference_mm, 2) + ',' +
           fixed(d.area_mm2, 1) + ',' + fixed(d.height_mm, 2) + ',' + fixed(d.saddle_mm, 2) + ',' +
           fixed(d.p3_inset_mm, 2) + '\n';
  }
  return csv;
}

std::string ring_page_html(const RingDesignResult& result, const std::string& made_for) {
  const RingDesign& design = result.search.design;
  const RingVerdict& all = result.verdicts.front();
  const std::string lead =
      "Made for " + made_for + ": " + counted(result.searched_members, "member") +
      " searched on, " + counted(result.held_out_members, "member") +
      " held out. Against the best generic shape (" +
      candidate_words(result.search.generic.candidate) + ") it gains " +
      gain_words(all.below_percent, 1) +
      " percentage points in the fraction of closures that leak less than 5 mm².";
  const RingClaims& claims = result.claims;
  const std::vector<PageSection> sections = {
      {"Shape",
       "Compared with the generic shapes, all 30 mm wide. The sizing rule selects the size closest "
       "to " +
           fixed(design.width_over_transverse, 2) + " of the transverse diameter of the annulus.",
       ring_picture_svg(beside_generic(design.shape, kDrawnSize_mm)), terms_table(design)},
      {"Held-out members",
       "The search used neither these members nor these disturbances. Gains: design minus generic, "
       "positive is better; 95 % bootstrap intervals.",
       "", verdict_table(result)},
      {"Side effects", "Means over the held-out members.", "", burden_table(result)},
      {"Saddle and asymmetry",
       "Rings of the same size in the same valves. Saddle-shaped rings are generally preferred to "
       "flat ones, for less stress and better coaptation (Jedrzejczyk 2021, Front Cardiovasc Med "
       "8:799994). A saddle-shaped and an asymmetric ring were compared in a sheep's ventricle "
       "with "
       "ischaemic regurgitation by Wong 2012 (PMC3432639).",
       "", contrast_table(claims)},
      {"Sizes",
       "Evaluated on " + asked_of(claims.sizes_aetiology, claims.sizes_members) +
           "; tenting without a ring: " + fixed(claims.tenting_before_mm, 1) +
           " mm. Gaidulis and Padala 2023 (PMC10826925) tested seven sizes in three pigs: rings "
           "above 32 mm did not close the valve, smaller ones did, and tethering persisted.",
       "", size_table(claims)},
      {"Dimensions", "Dimensions of the contour along which the centre line of the core runs.", "",
       dimensions_table(design.shape.terms)}};
  return study_page("Designed ring " + design.shape.name, lead, sections);
}

}  // namespace coapt
