// Which anchor of a papillary suture lasts longer while the disease goes on, the ipsilateral trigone or the saddle peak?
//
// The thesis holds that the trigone's suture bears further remodelling better (5.1.3). Its region of interest compares anchors by
// errors of execution alone; here repairs that close the valve alike are closed along the courses of further disease (durability.h).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/repair/plan.h"
#include "search/studies/configuration.h"

namespace coapt {

struct DurableAnchorOptions {
  int anatomies = 60;
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: all cores
};

/// One repair: the longest suture, in steps of half a millimetre of movement, that leaves no more than `limit_mm2`.
struct DurableAnchor {
  int anatomy = 0;
  Displaced displaced = Displaced::Both;
  bool ring = false;  ///< of the annulus's own size, which stops it from widening
  Anchor anchor = Anchor::IpsilateralTrigone;
  double limit_mm2 = 0.0;
  bool repaired = false;  ///< there is such a suture; else the rest is 0
  double leak_before_mm2 = 0.0;
  double movement_mm = 0.0;  ///< of each sutured muscle
  double suture_mm = 0.0;    ///< posteromedial, or anterolateral alone
  double leak_mm2 = 0.0;
  double durability_mm = 0.0;  ///< Durability::expected_mm
};

/// Random anatomies around the normal human valve (scanned_anatomy), of which those count that are competent until their tips are
/// displaced, by 8 mm as ischaemic disease does (disturbance.h). @param progress anatomies done, planned.
std::vector<DurableAnchor> study_durable_anchors(
    const DurableAnchorOptions& options, const std::function<void(int, int)>& progress = {});

/// Over the anatomies of one half that both anchors repair.
struct DurableAnchorAnswer {
  Displaced displaced = Displaced::Both;
  bool ring = false;
  double limit_mm2 = 0.0;
  bool odd = false;  ///< the odd anatomies, else the even ones
  int anatomies = 0, trigone_longer = 0, peak_longer = 0;  ///< by more than a tenth of a millimetre
  double mean_mm = 0.0, sd_mm = 0.0;                       ///< of trigone less saddle peak
  double movement_mm = 0.0;                                ///< mean of trigone less saddle peak
};
std::vector<DurableAnchorAnswer> durable_anchor_answers(const std::vector<DurableAnchor>& repairs);

/// Columns: those of DurableAnchor.
std::string durable_anchors_csv(const std::vector<DurableAnchor>& repairs);

}  // namespace coapt
