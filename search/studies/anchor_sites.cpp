#include "search/studies/anchor_sites.h"

#include <algorithm>

#include "core/repair/plan.h"
#include "core/valve/leaflet_coordinates.h"

namespace coapt {
namespace {

/// From the muscle's tip to its anchor in displacement space.
Vec3 seen_from_tip(const Valve& valve, const PapillaryApproximation& suture) {
  const Vec3 way = anchor_mm(valve, suture) - papillary_tip_mm(valve, suture.side);
  return {suture.side == Side::Posteromedial ? way.x() : -way.x(), -way.y(), -way.z()};
}

AnchorSite site(const Valve& valve, std::string name, Anchor anchor, double around) {
  const Vec3 lateral = seen_from_tip(
      valve, {.side = Side::Anterolateral, .anchor = anchor, .annulus_around = 0.5 - around});
  const Vec3 medial = seen_from_tip(
      valve, {.side = Side::Posteromedial, .anchor = anchor, .annulus_around = around});
  return {std::move(name), around, {lateral, medial, 0.5 * (lateral + medial)}};
}

}  // namespace

std::vector<AnchorSite> thesis_anchors(const Valve& valve) {
  const auto trigone =
      std::find(valve.annulus.begin(), valve.annulus.end(), valve.landmarks.posteromedial_trigone);
  const double around = annulus_around(valve)[trigone - valve.annulus.begin()];
  return {site(valve, "trigone", Anchor::IpsilateralTrigone, around),
          site(valve, "saddle peak", Anchor::SaddlePeak, 0.25)};
}

std::vector<AnchorSite> annulus_scan(const Valve& valve, int count) {
  std::vector<AnchorSite> sites;
  for (int i = 0; i < count; ++i)
    sites.push_back(site(valve, "annulus", Anchor::AnnulusPoint, static_cast<double>(i) / count));
  return sites;
}

}  // namespace coapt
