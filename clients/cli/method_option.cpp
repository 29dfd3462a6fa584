#include <map>
#include <string>

#include "clients/cli/commands.h"

namespace coapt {

void add_method_option(CLI::App& command, Method& method) {
  const std::map<std::string, Method> methods = {{to_string(Method::Fast), Method::Fast},
                                                 {to_string(Method::Thesis), Method::Thesis}};
  command.add_option("--method", method, "How to close: fast (default) or thesis, its reference")
      ->transform(CLI::CheckedTransformer(methods))
      ->option_text("METHOD");
}

void add_membrane_option(CLI::App& command, Membrane& membrane) {
  const std::map<std::string, Membrane> membranes = {
      {to_string(Membrane::Springs), Membrane::Springs},
      {to_string(Membrane::Continuum), Membrane::Continuum}};
  command
      .add_option("--membrane", membrane,
                  "What carries the leaflets' tension: springs (default) or continuum, triangles "
                  "that converge under refinement")
      ->transform(CLI::CheckedTransformer(membranes))
      ->option_text("MEMBRANE");
}

}  // namespace coapt
