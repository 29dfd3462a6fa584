// A legacy VTK file as a stream of words, whether its numbers are text or binary.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "io/mesh/text_scan.h"

namespace coapt {

class VtkWords {
 public:
  explicit VtkWords(std::string_view text) : lines_(text) {}

  /// The next word of the file, or number of a binary block; empty at its end.
  std::string_view next();
  /// Before the word that next() gave last; not inside a binary block.
  void back() {
    if (!ended_) at_ = last_;
  }
  void skip_line() { at_ = text_line_.size(); }
  /// The rest of the line, then lines until one is empty.
  void skip_block();
  std::optional<std::string_view> whole_line();
  int line() const { return lines_.number(); }

  void set_binary() { binary_ = true; }
  bool binary() const { return binary_; }
  /// In a binary file the next `count` words are numbers of VTK's type (big-endian) behind this line. False: the type is not
  /// known, or the file ends before.
  bool block(std::string_view type, long long count);
  /// Leaves out the rest of a block. @return false if there is none
  bool skip_numbers();

 private:
  /// Of one number in a binary file; none of an unknown type.
  enum class Binary { Int8, Uint8, Int16, Uint16, Int32, Uint32, Int64, Uint64, Float32, Float64 };
  static std::optional<Binary> binary_of(std::string_view type);
  std::string_view number();

  LineScanner lines_;
  std::string_view text_line_;     ///< of any length: some writers have all numbers in one
  std::size_t at_ = 0, last_ = 0;  ///< behind the word given last, and where it begins
  bool ended_ = false, binary_ = false;
  std::string_view block_;  ///< bytes that are left of it
  Binary type_ = Binary::Float64;
  std::array<char, 32> text_{};
};

}  // namespace coapt
