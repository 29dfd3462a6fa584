// Starts from a library: closed scenes of one valve, taken beforehand, say where others of it come to rest.
//
// A start is the kriged mean of the library's closed shapes over the places of annulus and papillary tips (Gaussian covariance,
// constant unknown mean; Cressie, Statistics for Spatial Data, 3.2); where that crosses, the nearest closure.
#pragma once

#include <optional>
#include <vector>

#include "core/closure/closure_result.h"
#include "core/valve/valve.h"

namespace coapt {

class ClosureLibrary {
 public:
  /// @param scenes of one mesh; closures that are not trusted are left out
  ClosureLibrary(const std::vector<Valve>& scenes, std::vector<ClosureResult> closures);

  struct Start {
    std::optional<ClosureResult> closure;  ///< none: the library is empty
    bool nearest = false;                  ///< the mean crossed
  };
  Start start_of(const Valve& scene) const;

 private:
  std::vector<ClosureResult> closures_;
  std::vector<Eigen::VectorXd> places_mm_;
  double range_mm_ = 1.0;
  Eigen::MatrixXd inverse_;  ///< of the covariance, bordered by ones
};

}  // namespace coapt
