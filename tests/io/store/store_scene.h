// A folder that is gone after the test, and closures by number.
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <string>

#include "search/studies/orifice_table.h"

namespace coapt {

inline const std::string kSubject = "00000000000000000000000000000001";

class TemporaryFolder {
 public:
  explicit TemporaryFolder(
      const std::filesystem::path& parent = std::filesystem::temp_directory_path()) {
    std::string path = parent / "coapt_store_XXXXXX";
    if (mkdtemp(path.data()) != nullptr) path_ = path;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

/// All different, not in the order of the store's key.
inline ConfigurationKey numbered_key(int i) {
  return {i % 7, 100'000'000, (i * 7919) % 10'007, i, -i, 0, i / 2, -3, i % 3};
}

inline OrificeSample numbered_sample(int i) { return {i / 3.0, i / 7.0, i % 2 == 0}; }

}  // namespace coapt
