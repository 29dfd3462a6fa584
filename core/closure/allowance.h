// What is left of a closure's budget while its attempts spend it.
#pragma once

#include "core/closure/closure_options.h"

namespace coapt {

class Allowance {
 public:
  Allowance(const ClosureBudget& budget, int vertices)
      : budget_(budget), left_(budget.vertex_steps), vertices_(vertices) {}

  /// False once the budget is spent or the closure cancelled, and from then on.
  bool spend(int steps) {
    left_ -= static_cast<double>(steps) * vertices_;
    spent_ = spent_ || left_ < 0.0 || budget_.is_cancelled();
    return !spent_;
  }
  bool spent() const { return spent_; }

 private:
  const ClosureBudget& budget_;
  double left_;
  int vertices_;
  bool spent_ = false;
};

}  // namespace coapt
