#include "search/rings/ring_claims.h"

#include <algorithm>
#include <cmath>

#include "core/metrics/measure.h"
#include "core/repair/limits.h"
#include "search/parallel.h"
#include "search/rings/ring_cost.h"

namespace coapt {
namespace {

constexpr const char* kIschaemic = "ischaemic";
constexpr double kWidthShare =
    0.85;  // a usual undersizing: two to three sizes of an annulus of 36 to 40 mm
/// A saddle as high as of a normal annulus (0.15 of its width), P3 drawn in by 1.5 mm and lowered by as much at 30 mm.
constexpr RingTerms kFlat{.ap_over_transverse = 0.75},
    kSaddle{.ap_over_transverse = 0.75, .saddle = 0.15};
constexpr RingTerms kAsymmetric{
    .ap_over_transverse = 0.75, .p3_inset = 0.05, .saddle = 0.0, .p3_elevation = -0.05};

std::vector<double> differences(const std::vector<RingOutcome>& first,
                                const std::vector<RingOutcome>& second,
                                double (*figure)(const RingOutcome&)) {
  std::vector<double> all;
  for (std::size_t i = 0; i < first.size(); ++i)
    if (const double one = figure(second[i]) - figure(first[i]); std::isfinite(one))
      all.push_back(one);
  return all;
}

RingContrast contrast(const RingTrial& trial, const std::vector<RingMember>& members,
                      const DesignedShape& first, const DesignedShape& second, int threads) {
  const auto outcomes = [&](const DesignedShape& shape) {
    return try_ring(trial, members, {shape, kWidthShare}, {}, threads);
  };
  const std::vector<RingOutcome> of_first = outcomes(first), of_second = outcomes(second);
  const auto gain = [&](double (*figure)(const RingOutcome&)) {
    return mean_interval(differences(of_first, of_second, figure));
  };
  return {.first = first.name,
          .second = second.name,
          .aetiology = "",
          .members = static_cast<int>(members.size()),
          .of_first = figures_of(of_first),
          .of_second = figures_of(of_second),
          .below_percent = gain([](const RingOutcome& o) { return 100.0 * share_below(o); }),
          .leak_mm2 = gain(mean_leak_mm2),
          .suture_max_n = gain([](const RingOutcome& o) { return o.suture_max_n; }),
          .suture_normal_n = gain([](const RingOutcome& o) { return o.suture_normal_n; })};
}

std::vector<RingSizeFigures> try_sizes(const RingTrial& trial,
                                       const std::vector<RingMember>& members, int threads) {
  std::vector<RingSizeFigures> sizes;
  for (double size = kRingSizesMm.min; size <= kRingSizesMm.max; size += kRingSizeStep_mm) {
    std::vector<RingOutcome> outcomes(members.size());
    for_each_index(static_cast<int>(members.size()), threads, [&](int i) {
      RingOutcome& outcome = outcomes[static_cast<std::size_t>(i)];
      outcome = trial(members[static_cast<std::size_t>(i)],
                      {CatalogueRing{"generic-classic", size}}, {.opening = true});
      outcome.size_mm = size;
    });
    sizes.push_back({size, figures_of(outcomes)});
  }
  return sizes;
}

}  // namespace

RingClaims ask_claims(const RingTrial& trial, const std::vector<RingMember>& members, int threads) {
  std::vector<RingMember> ischaemic;
  for (const RingMember& member : members)
    if (member.aetiology == kIschaemic) ischaemic.push_back(member);
  RingClaims claims;
  if (!ischaemic.empty()) claims.sizes_aetiology = kIschaemic;
  const std::vector<RingMember>& asked = ischaemic.empty() ? members : ischaemic;
  claims.sizes_members = static_cast<int>(asked.size());
  claims.contrasts = {
      contrast(trial, members, {"flat", kFlat}, {"saddle", kSaddle}, threads),
      contrast(trial, asked, {"symmetric", kFlat}, {"asymmetric", kAsymmetric}, threads)};
  claims.contrasts[1].aetiology = claims.sizes_aetiology;
  claims.sizes = try_sizes(trial, asked, threads);
  for (const RingMember& member : asked)
    if (member.before != nullptr)
      claims.tenting_before_mm += measure(member.valve, *member.before).tenting_height_mm /
                                  static_cast<double>(asked.size());
  return claims;
}

}  // namespace coapt
