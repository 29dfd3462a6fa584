// A lock that one process takes on a file of its own, beside the one that it means, and that ends with
// the process however that ends.
#pragma once

#include <string>
#include <utility>

#include "core/valve/types.h"

namespace coapt {

/// Between processes of one machine and between several locks of one process.
class FileLock {
 public:
  /// Makes the file if it is missing; it stays. Does not wait: Busy if somebody has it; NoSpace or
  /// InputOutput if it cannot be made.
  static Expected<FileLock> take(const std::string& path);

  ~FileLock();
  FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  FileLock& operator=(FileLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }

 private:
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}

  int descriptor_ = -1;
};

}  // namespace coapt
