#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "core/valve/types.h"

namespace coapt {

using Found = std::vector<std::pair<ErrorCode, std::string>>;

/// Codes and paths of the problems that stood in the way of a value.
template <class T>
Found problems_of(const Expected<T>& read) {
  Found list;
  if (read) return list;
  for (const Error& error : read.errors()) list.emplace_back(error.code, error.path);
  return list;
}

}  // namespace coapt
