// Records of one kind in a file, appended as they are made: what a killed study goes on from.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include "core/valve/types.h"

namespace coapt {

/// The file: 48 bytes that name the records, then the records. Errors: InputOutput; Unsupported for a file of other records, not
/// a byte of which is changed.
class RecordFile {
 public:
  /// Makes the file if it is missing. @param id 32 hexadecimal digits of all that decides the records (fnv1a_128())
  /// @param record_size what follows the last whole record, of a process that was killed while it wrote, is cut off
  static Expected<RecordFile> open(const std::string& path, const std::string& id,
                                   std::size_t record_size);

  /// The records that were in the file when it was opened.
  const std::string& records() const { return records_; }
  /// Handed to the system when it returns: they outlive the process, not a loss of power.
  Errors append(std::string_view records);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  RecordFile(std::string path, std::string records, std::FILE* file);

  std::string path_, records_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace coapt
