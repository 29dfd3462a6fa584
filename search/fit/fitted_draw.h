// A fitted valve as it might be as well: its parameters moved within what the fit left uncertain (Valve::fitted), together.
#pragma once

#include <vector>

#include "core/valve/valve.h"

namespace coapt {

/// Names in Valve::fitted that are no parameters of this valve ("/fit/parameters/2"), with those that are. @pre the valve is valid.
Errors check_fitted_parameters(const Valve& valve);

/// The valve with its fitted parameters moved by L z: L L' the covariance, z standard normal numbers at these shares of
/// their distribution, each in (0, 1); by three prior standard deviations at most. Shares of a half are the valve itself. Errors: what
/// validate() refuses. @pre check_fitted_parameters() is empty; a share for each name.
Expected<Valve> with_fitted_draw(const Valve& valve, const std::vector<double>& shares);

}  // namespace coapt
