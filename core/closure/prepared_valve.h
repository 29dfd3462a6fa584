// What all closures of one unstressed valve have in common, made once: its model, laid out for the
// kernels. Searches and studies move annulus and papillary tips thousands of times; a closure from
// a start near its end spends a quarter of its time on this otherwise.
#pragma once

#include <vector>

#include "core/closure/closure_options.h"
#include "core/closure/relaxation_layout.h"

namespace coapt {

class PreparedValve {
 public:
  /// @param load_share |F|, ClosureModel::load_share; its own, whatever valve it serves.
  /// @pre validate(valve) is empty.
  PreparedValve(const Valve& valve, const ClosureOptions& options,
                std::vector<double> load_share = {});

  /// Whether that valve differs from the prepared one at most in where its annulus and its papillary
  /// tips are under pressure, and the options in nothing that its model depends on.
  bool serves(const Valve& valve, const ClosureOptions& options) const;

  /// Of a valve that it serves.
  ClosureModel model(const Valve& valve) const;

  /// Of a node in a step of a fast closure; shorter where no chorda holds a scallop.
  double longest_move_mm() const { return longest_move_mm_; }

  const ContactLaw& contact() const { return contact_; }
  const RelaxationLayout<float>& layout() const { return layout_; }

 private:
  Valve valve_;
  Membrane membrane_;
  double longest_move_mm_;
  ContactLaw contact_;
  ClosureModel model_;
  RelaxationLayout<float> layout_;
};

}  // namespace coapt
