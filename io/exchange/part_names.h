// What names of files and of labels say about the part of a valve that they hold.
#pragma once

#include <optional>
#include <string_view>

#include "io/mesh/import_valve.h"

namespace coapt {

/// Commissure: tissue of the posterior leaflet or, of points, a place. Other: of the mitral valve or the heart, but nothing that an
/// import takes. OtherLeaflet: of another valve.
enum class NamedPart {
  Anterior,
  Posterior,
  Commissure,
  Annulus,
  Chordae,
  Tips,
  Other,
  OtherLeaflet
};

/// "Anterior leaflet", "AMVL", "valve_ant.stl", "A.ply", "P2" (a scallop is of its leaflet, a commissural one of the posterior);
/// in any case. None: nothing, or both leaflets.
std::optional<NamedPart> part_named(std::string_view name);

/// The side of the valve that a name says: "A1" and "P3", "anterolateral commissure", "PM papillary tip".
std::optional<Side> side_named(std::string_view name);

/// The side of the annulus on which what a name says lies: the left atrium; the left ventricle or a papillary muscle.
std::optional<AnnulusSide> annulus_side_named(std::string_view name);

/// Whether it names the mitral valve.
bool is_mitral(std::string_view name);

/// Whether it names a scallop, of which several make a leaflet: "P1", "A2 segment", "commissure".
bool is_scallop(std::string_view name);

}  // namespace coapt
