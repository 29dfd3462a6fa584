// The parts of a valve out of a label map: leaflets as closed shells, the annulus as a line.
//
// Which label is what: as given; else by the names that the file gives its labels; else the closed band is the annulus, and two
// labels that are thin as leaflets are the leaflets, of which leaflet_order.h tells which is which. Several labels may be one part
// (P1, P2 and P3, or commissures of their own). A leaflet of another valve is refused, or left out where the mitral ones are named so. What is not
// used is said.
#pragma once

#include "io/image/label_map.h"
#include "io/mesh/import_valve.h"

namespace coapt {

/// Which labels are what, 1 to 65535; several make one part; none: found. Where layers of a map hold one label each, and
/// all the same number, the labels count from 1 by layer.
struct LabelNumbers {
  std::vector<int> anterior, posterior, annulus;

  bool any() const { return !anterior.empty() || !posterior.empty() || !annulus.empty(); }
};

struct LabelUse {
  bool annulus = true;       ///< false: it came as a file of its own
  bool phase_given = false;  ///< LabelMap::phase, by the user
};

struct LabelParts {
  std::vector<TriangleMesh>
      leaflets;  ///< the anterior, then the posterior one, as `order` says; closed, oriented outwards
  LeafletOrder order;
  Points annulus_mm;               ///< empty if there is no such label
  double annulus_band_mm = 0.0;    ///< ImportSource::annulus_band_mm
  std::vector<SourcePart> parts;   ///< every label
  std::vector<ImportedTip> sided;  ///< middles of labels whose names say their side
  std::vector<ImportedWitness>
      witnesses;  ///< of the others, chambers and papillary muscles by name
  std::vector<ImportDecision> decisions;
};

/// The labels of a map as LabelNumbers calls them, none taken as anything.
std::vector<SourcePart> labels_in(const LabelMap& map);

/// Errors: labels that are not there ("/label_numbers/anterior"), more of them than leaflets, and those of label_surface() and
/// label_curve(). No decision repeats a name that stands in the file.
Expected<LabelParts> label_parts(const LabelMap& map, const LabelNumbers& numbers,
                                 const LabelUse& with = {});

}  // namespace coapt
