// What has been published on the shape and size of rings, asked of valves.
//
// Saddle: flat and saddle-shaped rings compared by forces (Jensen 2008, Circulation 118:S250: a flat ring bears larger out-of-plane forces
// in pigs). Asymmetry: a saddle-shaped ring against one with P3 drawn in, in a sheep's ventricle with ischaemic regurgitation (Wong 2012,
// Ann Thorac Surg 93:776, PMC3432639). Size: seven sizes in three pigs with functional regurgitation (Gaidulis and Padala 2023, Ann Biomed
// Eng 51:1984, PMC10826925): rings above 32 mm did not close the valve, smaller ones did, and tethering stayed.
#pragma once

#include "search/rings/ring_gain.h"

namespace coapt {

/// The second ring less the first, of the same size in the same valves, as planned.
struct RingContrast {
  std::string first, second;
  std::string aetiology;  ///< of the members asked; empty: all
  int members = 0;
  RingFigures of_first, of_second;
  MeanInterval below_percent;                  ///< points
  MeanInterval leak_mm2;                       ///< second less first: negative is better
  MeanInterval suture_max_n, suture_normal_n;  ///< likewise
};

/// One size of a generic ring in all members asked, whatever their annulus.
struct RingSizeFigures {
  double size_mm = 0.0;
  RingFigures figures;
};

struct RingClaims {
  std::vector<RingContrast> contrasts;  ///< flat and saddle; symmetric and asymmetric
  std::vector<RingSizeFigures> sizes;   ///< "generic-classic", 24 to 40 mm
  std::string sizes_aetiology;          ///< of the members of `sizes`; empty: all
  int sizes_members = 0;
  double tenting_before_mm = 0.0;  ///< mean over them, without a ring
};

/// @param members prepared. Of a population with ischaemic members the last two questions are asked of those alone.
RingClaims ask_claims(const RingTrial& trial, const std::vector<RingMember>& members, int threads);

}  // namespace coapt
