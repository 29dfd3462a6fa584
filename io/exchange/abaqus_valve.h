// A valve from the input file of another code: shells become leaflets, trusses chordae.
//
// - Each *SHELL SECTION is a leaflet, named as its element set. Quadrilaterals are split along their
//   shorter diagonal. Vertices keep the order of their node numbers, so that states of the other
//   code compare node by node. Law: exponential (leaflets.h), of materials VUANISO_ISO*; constants
//   c0, D, c1, c2. D is not used (exponential.h says why).
// - Nodes with prescribed motion on a boundary loop of the shells are the annulus.
// - Trusses that start at other prescribed nodes are chordae; runs without branches become one
//   segment. They are as stiff as their Ogden law at rest, E = 3 sum mu: under pressure the chordae
//   of the Texas TriValve stretch by less than 0.3 % (95 %), where its law departs from that by 3 %.
// - Leaflets touch at MAXRATIO x the shortest edge or diagonal of the shells where that is below
//   their thickness: Abaqus/Explicit thins shells in contact so. In the frames of the Texas TriValve
//   mid-surfaces in contact lie 0.16 mm apart (median), 0.17 by this rule, 0.65 by the thickness.
// - They bend as incompressible shells of their modulus at rest, 3 c0 t^3 / (12 (1 - 1/4)), the mean
//   of the leaflets.
// - Coordinates are kept: z must point to the atrium, the annulus lie around the origin.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/valve/valve.h"

namespace coapt {

struct AbaqusImport {
  std::string name = "imported";
  std::vector<std::string> provenance;
};

/// A valve that passes validate(). Errors: "/lines/N" where a line cannot be read, else the pointers
/// of validate() or of the part that is missing ("/sections", "/boundary").
Expected<Valve> read_abaqus_valve(std::string_view text, const AbaqusImport& options);

}  // namespace coapt
