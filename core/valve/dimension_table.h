// The numbers of a parametric valve, each by the name that files, options and messages have for it.
#pragma once

#include <optional>
#include <vector>

#include "core/valve/parametric.h"
#include "core/valve/problem_list.h"

namespace coapt {

struct Dimension {
  const char* name;  ///< of the file's field; the option is "--" and the name with dashes
  const char* what;
  const char* unit;  ///< with its leading blank, or empty
  Range accepted;
  std::optional<double> (*get)(const ParametricValve&);  ///< none: left out, what `what` says
  void (*set)(ParametricValve&, double);
  bool material = false;  ///< pressure or tissue: with_material() gives it to any valve
};

const std::vector<Dimension>& dimension_table();

/// Those that are material.
std::vector<const Dimension*> material_table();

struct MaterialValue {
  const Dimension* dimension;  ///< material
  double value;
};

/// The valve with these in place of its own; moduli are times the default's, not the valve's. Errors: names of the table out of
/// range, or what validate() says of the valve. @pre the valve is valid and mitral.
Expected<Valve> with_material(const Valve& valve, const std::vector<MaterialValue>& values);

}  // namespace coapt
