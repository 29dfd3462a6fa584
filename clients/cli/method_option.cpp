#include "clients/cli/method_option.h"

#include <map>
#include <string>

namespace coapt {

void add_method_option(Command command, Method& method) {
  const std::map<std::string, Method> methods = {{to_string(Method::Fast), Method::Fast},
                                                 {to_string(Method::Thesis), Method::Thesis}};
  command
      .add_choice("--method", method, methods,
                  "Closure solver: fast (default), or thesis, the reference solver")
      .show_argument("METHOD");
}

void add_membrane_option(Command command, Membrane& membrane) {
  const std::map<std::string, Membrane> membranes = {
      {to_string(Membrane::Springs), Membrane::Springs},
      {to_string(Membrane::Continuum), Membrane::Continuum}};
  command
      .add_choice("--membrane", membrane, membranes,
                  "Membrane model: continuum (default), a finite-element membrane that converges "
                  "under refinement, or springs, the model of the thesis")
      .show_argument("MEMBRANE");
}

}  // namespace coapt
