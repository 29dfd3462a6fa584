// What is wrong with an input, on its way to Python.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "io/json/result_json.h"

namespace coapt {

/// In Python _engine.Problems; its text is the list of problems as JSON.
struct Problems : std::runtime_error {
  explicit Problems(const Errors& errors) : std::runtime_error(to_json(errors).dump()) {}
};

/// The value. Throws Problems, whose paths begin below `path`.
template <class T>
T taken(Expected<T> value, const std::string& path = "") {
  if (value) return *std::move(value);
  Errors errors = value.errors();
  for (Error& error : errors) error.path = path + error.path;
  throw Problems(errors);
}

}  // namespace coapt
