// What disease does to a valve: annular dilation and flattening, papillary displacement (thesis 4.2.2), growth of the whole and of
// its leaflets, chordae longer or ruptured, tissue that has changed.
//
// First the whole valve grows about the origin of its annulus's frame: annulus, leaflets, tips, chordae; not the tissue's thickness.
// Everything happens to the annulus and tips under pressure, in the annulus's own frame as it was
// before (AnnulusFrame). The height over its plane is scaled. Then what lies behind the line
// through the trigones moves backwards in proportion to its distance behind that line, just so much
// that the anteroposterior diameter grows by the percentage; what lies on the line or in front of
// it, the intertrigonal part, stays, and nothing moves transversely. The valve is not centred
// again: the trigones' place is the reference. A leaflet grows away from the annulus: each point's
// distance from the annulus at its `around` (leaflet_coordinates.h), by the percentage.
#pragma once

#include <optional>
#include <vector>

#include "core/valve/valve.h"

namespace coapt {

/// Of what the tissue was, in per cent: each [1, 1000].
struct TissueChange {
  double thickness_percent = 100.0;
  double extension_percent =
      100.0;  ///< what the unpressurised heart leaves of the transition strains
  double circumferential_stiffness_percent = 100.0;  ///< moduli below and above the transition
  double radial_stiffness_percent = 100.0;
};

void change_tissue(const TissueChange& change, Tissue& tissue);

/// Marginal chordae that hold a scallop (ruptures.h).
struct ChordalElongation {
  Segment segment = Segment::P2;
  double percent = 0.0;  ///< [-50, 200] of their lengths
};

struct Remodelling {
  double growth_percent = 0.0;            ///< [-50, 100] of all lengths
  double ap_dilation_percent = 0.0;       ///< [-50, 100]; transverse dimension and trigones held
  double annular_height_percent = 100.0;  ///< [0, 200] of the present height
  /// Displacement of the tips: transverse (outwards, away from the other side), posterior, apical;
  /// each
  /// [-30, 30] mm along the valve's x, -y, -z.
  Vec3 anterolateral_mm = Vec3::Zero();
  Vec3 posteromedial_mm = Vec3::Zero();
  double leaflet_growth_percent = 0.0;         ///< [-50, 100] of the heights
  double chordal_elongation_percent = 0.0;     ///< [-50, 200] of the lengths of all chordae
  std::vector<ChordalElongation> elongated{};  ///< and further, scallop by scallop
  TissueChange tissue{};
  std::vector<Segment> ruptured{};          ///< whose marginal chordae are (ruptures.h)
  std::optional<SystolicMotion> systole{};  ///< of the diseased heart; left out: as before
};

/// Values outside their ranges, by pointers into Remodelling.
Errors check_remodelling(const Remodelling& change);

/// The valve changed so; indices are kept. Errors point to the fields of Remodelling ("/anterolateral_mm/2"): out of range, a segment that no marginal chorda holds, or leaving
/// a valve that validate() refuses. @pre the valve is valid and mitral.
Expected<Valve> remodel(const Valve& valve, const Remodelling& change);

/// The annulus alone, grown so, unchecked: the anteroposterior diameter by so many mm, not below zero.
void grow_annulus(double ap_growth_mm, Valve& valve);

}  // namespace coapt
