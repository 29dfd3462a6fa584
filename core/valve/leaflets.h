// Leaflets of valves that are not mitral: any number of them, each with its own tissue.
#pragma once

#include <string>
#include <vector>

namespace coapt {

struct Valve;

/// Isotropic and incompressible, energy per unstressed volume
///   c0 / 2 (I1 - 3) + c1 / 2 (exp(c2 (I1 - 3)^2) - 1),
/// I1 the trace of the right Cauchy-Green tensor (Kamensky et al. 2018, Comput Methods Appl Mech
/// Eng 330:522; fitted to human tricuspid leaflets by Mathur et al. 2022).
struct ExponentialTissue {
  double c0_kpa = 1.0;  ///< three times this is the modulus at small strain
  double c1_kpa = 0.1;
  double c2 = 10.0;

  bool operator==(const ExponentialTissue&) const = default;
};

/// A leaflet of a valve with any number of them.
struct NamedLeaflet {
  std::string name;  ///< unique, for instance "septal"
  double thickness_mm = 0.65;
  ExponentialTissue tissue;

  bool operator==(const NamedLeaflet&) const = default;
};

/// Name of the leaflet of a face: of Valve::leaflets, or anterior, posterior and commissures.
std::string leaflet_name(const Valve& valve, int face);

/// Number of leaflets that leaflet_index() tells apart.
int leaflet_count(const Valve& valve);

/// Of a face: into Valve::leaflets; of a mitral valve 0 anterior, 1 posterior, 2 commissural.
int leaflet_index(const Valve& valve, int face);

/// Of the leaflet of a face.
double thickness_mm(const Valve& valve, int face);

/// Whether it has the landmarks and segments of a mitral valve. Repair, search, studies and the
/// mitral measures need these.
bool is_mitral(const Valve& valve);

}  // namespace coapt
