// Input files of Abaqus (.inp), as far as a valve of shells and trusses needs them: what the lines
// say, before anything is made of it.
//
// Read: one part with *NODE, *ELEMENT (S4R, S4, S3R, S3, T3D2), *NSET and *ELSET (with GENERATE),
// *DISTRIBUTION of element axes, *ORIENTATION, *SHELL SECTION, *SOLID SECTION; *SURFACE of elements;
// *MATERIAL with *DENSITY, *HYPERELASTIC, OGDEN and *ANISOTROPIC HYPERELASTIC, USER; one *STEP with
// *BOUNDARY (displacements) and *DSLOAD (pressure). Names are in capitals, as Abaqus does not tell
// cases apart. Passed over: contact, friction, amplitudes, mass scaling, output. Anything else is
// refused, because it might change the model.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/valve/types.h"

namespace coapt {

struct AbaqusElement {
  std::vector<int> nodes;  ///< node numbers: 2 of a truss, 3 or 4 of a shell
};

/// *SHELL SECTION (size: thickness, mm) or *SOLID SECTION (size: area of trusses, mm2).
struct AbaqusSection {
  bool shell = false;
  std::string elements, material, orientation;  ///< names; orientation may be empty
  double size = 0.0;
  int line = 0;
};

struct AbaqusMaterial {
  double density_t_per_mm3 = 0.0;
  std::vector<std::array<double, 2>> ogden;  ///< mu (MPa) and alpha of each term
  std::vector<double> constants;             ///< of a user's law
};

/// A row of *BOUNDARY: node or set, axis 0 to 2, mm.
struct AbaqusMotion {
  std::string target;  ///< number of a node, or a set
  int axis = 0;
  double amount_mm = 0.0;
};

/// Element sets with a side each.
struct AbaqusSurface {
  struct Part {
    std::string elements;
    bool positive = true;  ///< SPOS, the side that the element's normal points to
  };
  std::vector<Part> parts;
  double max_ratio = 0.0;  ///< of thickness to the elements' size in contact; 0: not given
};

struct AbaqusPressure {
  std::string surface;
  double mpa = 0.0;
};

/// Units mm, t, s, hence N and MPa; by number, or by name in capitals.
struct AbaqusModel {
  std::map<int, Vec3> nodes;
  std::map<int, AbaqusElement> elements;
  std::map<std::string, std::vector<int>> node_sets, element_sets;
  std::map<std::string, std::map<int, Vec3>> distributions;  ///< first axis of each element
  std::map<std::string, std::string> orientations;           ///< orientation -> distribution
  std::vector<AbaqusSection> sections;
  std::map<std::string, AbaqusMaterial> materials;
  std::map<std::string, AbaqusSurface> surfaces;
  std::vector<AbaqusMotion> motions;
  std::vector<AbaqusPressure> pressures;
};

/// Errors: pointers are "/lines/N", N from 1.
Expected<AbaqusModel> read_abaqus(std::string_view text);

}  // namespace coapt
