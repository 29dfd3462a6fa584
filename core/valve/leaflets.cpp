#include "core/valve/leaflets.h"

#include <optional>

#include "core/valve/leaflet_of.h"
#include "core/valve/valve.h"

namespace coapt {
namespace {

constexpr int kMitralLeaflets = 3;  // commissures count as one

}  // namespace

bool is_mitral(const Valve& valve) { return valve.leaflets.empty(); }

int leaflet_count(const Valve& valve) {
  return is_mitral(valve) ? kMitralLeaflets : static_cast<int>(valve.leaflets.size());
}

int leaflet_index(const Valve& valve, int face) {
  if (!is_mitral(valve)) return valve.face_leaflet[face];
  const std::optional<Leaflet> leaflet = leaflet_of(valve.segments[face]);
  return leaflet ? static_cast<int>(*leaflet) : kMitralLeaflets - 1;
}

std::string leaflet_name(const Valve& valve, int face) {
  const int index = leaflet_index(valve, face);
  if (!is_mitral(valve)) return valve.leaflets[index].name;
  return index < kMitralLeaflets - 1 ? to_string(static_cast<Leaflet>(index)) : "commissures";
}

double thickness_mm(const Valve& valve, int face) {
  return is_mitral(valve) ? valve.tissue.thickness_mm
                          : valve.leaflets[valve.face_leaflet[face]].thickness_mm;
}

}  // namespace coapt
