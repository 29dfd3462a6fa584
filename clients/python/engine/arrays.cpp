#include "clients/python/engine/arrays.h"

#include <cmath>
#include <cstdint>
#include <type_traits>

#include "clients/python/engine/problems.h"
#include "io/mesh/import_valve.h"

namespace py = pybind11;

namespace coapt {
namespace {

template <class Number, class Matrix>
py::array view_of(const Matrix& rows, const py::object& owner) {
  py::array_t<Number> array({rows.rows(), Index{3}}, rows.data(), owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

constexpr Index kMostRows = 3 * kMostFaces;  // corners of the largest mesh that is compared

/// numpy's array of what is given, be it a list. Throws Problems: it has no numbers of these kinds (numpy's letters).
py::array numbers_of(const py::object& given, const std::string& path, const std::string& kinds,
                     const std::string& what) {
  const auto refused = [&](const std::string& is) {
    return Problems({{ErrorCode::WrongType, path, is + ", must be " + what + ", shape (n, 3)"}});
  };
  const std::string type = py::str(py::type::of(given).attr("__name__")).cast<std::string>();
  try {
    const py::array array = py::module_::import("numpy").attr("asarray")(given);
    if (kinds.find(array.dtype().kind()) != std::string::npos) return array;
    if (!py::isinstance<py::array>(given)) throw refused("is a " + type);
    throw refused("is an array of " + py::str(array.dtype()).cast<std::string>());
  } catch (py::error_already_set&) {  // rows of different lengths
    throw refused("is a " + type);
  }
}

/// Rows of three, each number checked on its way from Wide to Matrix's.
template <class Wide, class Matrix>
Matrix rows_of(const py::array& array, const std::string& path) {
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw Problems(
        {{ErrorCode::WrongType, path,
          "has shape " + py::str(array.attr("shape")).cast<std::string>() + ", must have (n, 3)"}});
  if (array.shape(0) > kMostRows)
    throw Problems({{ErrorCode::OutOfRange, path,
                     "has " + std::to_string(array.shape(0)) + " rows, must have at most " +
                         std::to_string(kMostRows)}});
  using Number = typename Matrix::Scalar;
  const auto cast = py::array_t<Wide, py::array::forcecast>::ensure(array);
  const auto numbers = cast.template unchecked<2>();
  Matrix rows(array.shape(0), 3);
  for (Index i = 0; i < rows.rows(); ++i)
    for (Index k = 0; k < 3; ++k) {
      rows(i, k) = static_cast<Number>(numbers(i, k));
      if (static_cast<Wide>(rows(i, k)) != numbers(i, k) || !std::isfinite(rows(i, k)))
        throw Problems({{ErrorCode::OutOfRange, path + '/' + std::to_string(i),
                         std::is_integral_v<Number> ? "holds a number of more than 32 bits"
                                                    : "is not finite: NaN or infinite"}});
    }
  return rows;
}

}  // namespace

py::array view(const Points& points, const py::object& owner) {
  return view_of<double>(points, owner);
}

py::array view(const Faces& faces, const py::object& owner) { return view_of<int>(faces, owner); }

Points points_of(const py::object& given, const std::string& path) {
  return rows_of<double, Points>(numbers_of(given, path, "fiu", "an array of numbers"), path);
}

Faces faces_of(const py::object& given, const std::string& path) {
  return rows_of<std::int64_t, Faces>(numbers_of(given, path, "iu", "an array of integers"), path);
}

}  // namespace coapt
