// The valve as it stands in diastole: annulus and papillary tips go back by what systole moves them (SystolicMotion).
//
// The annulus grows in its plane by one factor, its heights stay: of controls' height over width of 13.5 % in systole 11.3 % are
// left (measured in diastole: 10.6, Topilsky 2013, JAHA 2:e000039). The tips move apart along the line between them, both by
// the same; their distance from the annulus stays, as in normal subjects (change 0.8 +- 0.7 mm: Sanfilippo 1992, JACC 19:564).
// Limits: the intertrigonal part widens as the rest does; the annulus's own way towards the apex is left out, because the
// tips share it.
#pragma once

#include "core/valve/valve.h"

namespace coapt {

/// Its unstressed shape, chordae and pressure stay. Errors: what validate() says of the valve that results. @pre the valve is valid and mitral.
Expected<Valve> in_diastole(const Valve& valve);

}  // namespace coapt
