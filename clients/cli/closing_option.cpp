#include "clients/cli/closing_option.h"

#include <limits>
#include <map>
#include <string>

#include "clients/cli/method_option.h"

namespace coapt {

void add_closing_option(Command command, ClosingOption& option) {
  add_method_option(command, option.closure.method);
  add_membrane_option(command, option.closure.membrane);
  std::map<std::string, Certainty> certainties;
  for (const Certainty word : {Certainty::Quick, Certainty::Sure, Certainty::Proof})
    certainties[to_string(word)] = word;
  command
      .add_choice(
          "--certainty", option.certainty, certainties,
          "Effort spent on the numerical error of the leak: quick (default), the mesh as given; "
          "sure, also four times the triangles, and the mesh as given at half the speed, which may "
          "end in another "
          "shape; proof, also finer and finer meshes until the leak settles, as --converge does")
      .show_argument("WORD");
  add_converge_option(command, option.converge);
  command
      .add_option("--accuracy", option.accuracy_mm2,
                  "Accuracy of the leak, mm2: refine the mesh and choose the tolerances to reach "
                  "it (method fast)")
      .check(number_from(0.0, std::numeric_limits<double>::max()))
      .show_argument("MM2")
      .excludes("--converge");
}

void add_closing(const ClosingOption& option, Json& request) {
  const ClosureOptions usual;
  if (option.closure.method != usual.method) request["method"] = to_string(option.closure.method);
  if (option.closure.membrane != usual.membrane)
    request["membrane"] = to_string(option.closure.membrane);
  if (option.accuracy_mm2) request["accuracy_mm2"] = *option.accuracy_mm2;
  if (option.converge.wanted) request["converge"] = converge_json(option.converge);
  if (option.certainty != Certainty::Quick) request["certainty"] = to_string(option.certainty);
}

}  // namespace coapt
