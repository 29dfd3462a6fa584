// A plan space as a few discrete variables, as an optimiser that knows nothing of branches sees it: the
// decisions, and the parameters of all branches, of which those that a plan does not have do nothing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "search/plans/plan_space.h"

namespace coapt {

struct FlatVariable {
  std::string name;
  bool ordered = true;  ///< else a category
  int count = 2;        ///< values, at least 2
};

class FlatSpace {
 public:
  /// @pre `space` outlives it.
  explicit FlatSpace(const PlanSpace& space);

  const std::vector<FlatVariable>& variables() const { return variables_; }

  struct Point {
    std::size_t branch = 0;
    LatticePoint at;
  };
  /// Nothing where there is no such branch. A variable with more values than the branch's parameter goes over
  /// them in proportion. @param values one for each variable.
  std::optional<Point> point(const std::vector<int>& values) const;

 private:
  struct Decision {
    int variable = -1;                // -1: the same in all branches
    std::vector<std::string> values;  // words of the branches
  };

  const PlanSpace& space_;
  std::vector<FlatVariable> variables_;
  std::vector<Decision> decisions_;
};

}  // namespace coapt
