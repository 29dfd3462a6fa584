// The few types every part of coapt speaks in: arrays of points, and values that may be errors.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cassert>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace coapt {

using Index = std::ptrdiff_t;  ///< of rows and elements; signed, as std::ssize and Eigen's
using Vec2 = Eigen::Vector2d;  ///< its norm() has the same bits everywhere; std::hypot has not
using Vec3 = Eigen::Vector3d;
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;  ///< n x 3
using Faces = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;      ///< n x 3

enum class ErrorCode {
  InvalidJson,  ///< not JSON, nested too deep or too large
  MissingField,
  UnknownField,
  WrongType,
  OutOfRange,      ///< a number (or a length of an array) outside its accepted range, NaN included
  BadReference,    ///< an index or a name of something that is not there
  BadTopology,     ///< the mesh or the chordae graph does not hang together
  BadGeometry,     ///< flipped or degenerate triangles, metres instead of millimetres
  ImpossibleStep,  ///< a repair step that this valve does not allow
  Unsupported,     ///< a schema, method, preset or file format that is not known
  InputOutput,     ///< a file that cannot be read or written
  Busy,            ///< somebody else has it locked; may be tried again
  NoSpace,         ///< disk, quota or size of the file has no room
};

/// What a caller can fix. `path` is a JSON pointer into the input ("" is the whole of it);
/// `message` says what is wrong and which values are accepted.
struct Error {
  ErrorCode code = ErrorCode::OutOfRange;
  std::string path;
  std::string message;
};
using Errors = std::vector<Error>;

/// A value, or every problem that stands in its way (never an empty list).
template <class T>
class [[nodiscard]] Expected {
 public:
  Expected(T value) : state_(std::move(value)) {}
  Expected(Errors errors) : state_(std::move(errors)) { assert(!std::get<Errors>(state_).empty()); }
  Expected(Error error) : state_(Errors{std::move(error)}) {}

  explicit operator bool() const { return std::holds_alternative<T>(state_); }
  const T& operator*() const& { return std::get<T>(state_); }
  T& operator*() & { return std::get<T>(state_); }
  T&& operator*() && { return std::get<T>(std::move(state_)); }
  const T* operator->() const { return &std::get<T>(state_); }
  T* operator->() { return &std::get<T>(state_); }
  const Errors& errors() const { return std::get<Errors>(state_); }

 private:
  std::variant<T, Errors> state_;
};

}  // namespace coapt
