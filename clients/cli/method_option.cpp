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

}  // namespace coapt
