// What names of files and of labels say about the part of a valve that they hold.
#pragma once

#include <optional>
#include <string_view>

namespace coapt {

enum class NamedPart { Anterior, Posterior, Annulus, Chordae, Tips };

/// "Anterior leaflet", "AMVL", "valve_ant.stl", "A.ply"; in any case. None: nothing, or both leaflets, or a part that no
/// import takes (a commissure).
std::optional<NamedPart> part_named(std::string_view name);

}  // namespace coapt
