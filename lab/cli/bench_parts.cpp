#include "lab/cli/bench_parts.h"

#include <algorithm>

namespace coapt {

bool asked_for(const std::vector<std::string>& asked, const std::string& name) {
  return asked.empty() || std::find(asked.begin(), asked.end(), name) != asked.end();
}

Expected<std::vector<LatticeCase>> chosen_cases(const std::vector<std::string>& asked,
                                                const Valve& real) {
  std::vector<LatticeCase> cases = lattice_cases(real);
  for (const std::string& name : asked)
    if (std::none_of(cases.begin(), cases.end(), [&](const auto& c) { return c.name == name; }))
      return Error{
          ErrorCode::BadReference, "--lattice",
          "is \"" + name +
              "\", must be functional, porcine-both, human-pm, real, ischaemic or flail-p2"};
  std::erase_if(cases, [&](const auto& one) { return !asked_for(asked, one.name); });
  return cases;
}

}  // namespace coapt
