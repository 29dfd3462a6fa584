// Arrays of numpy as coapt's points and faces, and coapt's as numpy's.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>

#include "core/valve/types.h"

namespace coapt {

/// The numbers themselves, read-only, as long as the array lives; `owner` is kept alive by it.
pybind11::array view(const Points& points, const pybind11::object& owner);
pybind11::array view(const Faces& faces, const pybind11::object& owner);

/// Copies. Throws Problems at `path`: no array, other than n x 3, other than float64 or int32, a number that is not finite.
Points points_of(const pybind11::object& given, const std::string& path);
Faces faces_of(const pybind11::object& given, const std::string& path);

}  // namespace coapt
