#include "clients/python/engine/arrays.h"

#include <vector>

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

/// @param type numpy's name of Number
template <class Number, class Matrix>
Matrix rows_of(const py::object& given, const std::string& path, const std::string& type) {
  if (!py::isinstance<py::array>(given))
    throw Problems({{ErrorCode::WrongType, path,
                     "is a " + py::str(py::type::of(given).attr("__name__")).cast<std::string>() +
                         ", must be an array of " + type + ", shape (n, 3)"}});
  const auto array = py::reinterpret_borrow<py::array>(given);
  if (!py::isinstance<py::array_t<Number>>(array))
    throw Problems({{ErrorCode::WrongType, path,
                     "is an array of " + py::str(array.dtype()).cast<std::string>() +
                         ", must be of " + type}});
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw Problems(
        {{ErrorCode::WrongType, path,
          "has shape " + py::str(array.attr("shape")).cast<std::string>() + ", must have (n, 3)"}});
  if (array.shape(0) > kMostRows)
    throw Problems({{ErrorCode::OutOfRange, path,
                     "has " + std::to_string(array.shape(0)) + " rows, must have at most " +
                         std::to_string(kMostRows)}});
  const auto numbers = array.cast<py::array_t<Number>>().template unchecked<2>();
  Matrix rows(array.shape(0), 3);
  for (Index i = 0; i < rows.rows(); ++i)
    for (Index k = 0; k < 3; ++k) rows(i, k) = numbers(i, k);
  return rows;
}

}  // namespace

py::array view(const Points& points, const py::object& owner) {
  return view_of<double>(points, owner);
}

py::array view(const Faces& faces, const py::object& owner) { return view_of<int>(faces, owner); }

Points points_of(const py::object& given, const std::string& path) {
  Points points = rows_of<double, Points>(given, path, "float64");
  for (Index i = 0; i < points.rows(); ++i)
    if (!points.row(i).allFinite())
      throw Problems({{ErrorCode::OutOfRange, path + '/' + std::to_string(i),
                       "is not finite: NaN or infinite"}});
  return points;
}

Faces faces_of(const py::object& given, const std::string& path) {
  return rows_of<int, Faces>(given, path, "int32");
}

}  // namespace coapt
