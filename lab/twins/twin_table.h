#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "lab/twins/twin_study.h"

namespace coapt {

/// A line a parameter of a twin, and one each for its leak, the rms distance of nodes ("nodes"), of nodes from the surface
/// ("surface") and of the measured points ("points"). Columns: twin, quantity, unit, prior, prior_sd, truth, value, sd,
/// identifiable; empty where there is no number. `prior` of leak and distances: before the fit.
std::string twins_csv(const std::vector<Twin>& twins);

/// In words: distances, errors by kind of parameter, coverage of the 90 % intervals, share of even and odd twins apart.
void print_twins(std::ostream& out, const std::vector<Twin>& twins);

/// Even twins, by which fits were tuned, and odd ones, which judge: each half by `print_half`, after its name.
void print_halves(
    std::ostream& out, const std::vector<Twin>& twins,
    const std::function<void(std::ostream&, const std::vector<const Twin*>&)>& print_half);

}  // namespace coapt
