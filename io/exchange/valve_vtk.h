// A valve in legacy VTK.
//
// Data of faces: leaflet (0 anterior, 1 posterior), segment (order of Segment: 0 A1 to 7 PC), Green-Lagrange
// strains from the unstressed shape, crossing (1: the triangle passes through another one). Of points: height_mm over the annular plane, positive to the atrium.
// Of lines: chorda (index), kind (order of ChordaKind), rest_length_mm, diameter_mm, tension_n.
// Chordae run from the papillary head to the leaflet, one line cell a straight piece; those that insert end
// at a vertex of the mesh, in the same printed decimals (attached_vertex()); to_insertion_x, _y and _z (mm) lead from there
// to where they insert. Ruptured ones are left out.
#pragma once

#include <array>

#include "io/exchange/exported_valve.h"
#include "io/mesh/vtk.h"

namespace coapt {

inline constexpr std::array<const char*, 3> kToInsertion = {"to_insertion_x", "to_insertion_y",
                                                            "to_insertion_z"};

/// The faces of both leaflets, or of one with the vertices it has.
VtkPolyData leaflets_vtk(const ClosedValve& exported, const ValveShape& shape);
VtkPolyData leaflet_vtk(const ClosedValve& exported, const ValveShape& shape, Leaflet leaflet);

/// The chordae alone. FEBio Studio reads one kind of cell a file.
VtkPolyData chordae_vtk(const ClosedValve& exported, const ValveShape& shape);

/// Both, for viewers.
VtkPolyData valve_vtk(const ClosedValve& exported, const ValveShape& shape);

}  // namespace coapt
