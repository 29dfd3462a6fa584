// A valve as a model of FEBio (.feb, format 4.0), to be closed there: millimetres, newtons, MPa, tonnes, seconds.
//
// Written after FEBio's user's manual and sources (FEBioXML, version 4); no FEBio has read these files.
//
// Leaflets: tri3 shells with the tissue's thickness. Tissue: a solid mixture of a neo-Hookean matrix with the
// radial modulus below the transition (Poisson's ratio 0.45) and two families of fiber-pow-linear, circumferential
// and radial, whose linear range begins at the transition stretch with the modulus above it. The toe's power is
// high, so that little is borne before: at the transition less than 1 % of the modulus. What differs from coapt: the circumferential
// modulus below the transition (0.5 % of the one above), bending and shear stiffness.
// Chordae: one nonlinear spring for each piece, tension only, slack until its own rest length, from head to
// branch point to the nearest vertex (attached_vertex()); ruptured ones are left out.
// Annulus and heads go from their unstressed places to those under pressure while the pressure is raised, then
// stay. Leaflets slide on each other without friction (sliding-elastic), anterior against posterior side.
#pragma once

#include <string>

#include "core/valve/valve.h"

namespace coapt {

std::string write_feb(const Valve& valve);

}  // namespace coapt
