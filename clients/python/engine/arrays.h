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

/// Copies of arrays or lists of any numbers, faces of any integers. Throws Problems at `path`: neither, other than n x 3, a number that is not
/// finite or has more than 32 bits.
Points points_of(const pybind11::object& given, const std::string& path);
Faces faces_of(const pybind11::object& given, const std::string& path);

}  // namespace coapt
