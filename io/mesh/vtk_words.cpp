#include "io/mesh/vtk_words.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <map>
#include <utility>

namespace coapt {
namespace {

/// From the front of `bytes`, which holds at least one.
template <class T>
void take_big_endian(std::string_view& bytes, T& value) {
  std::array<char, sizeof(T)> raw{};
  for (std::size_t i = 0; i < sizeof(T); ++i)
    raw[i] = bytes[std::endian::native == std::endian::big ? i : sizeof(T) - 1 - i];
  std::memcpy(&value, raw.data(), sizeof(T));
  bytes.remove_prefix(sizeof(T));
}

}  // namespace

std::string_view VtkWords::next() {
  if (!block_.empty()) return number();
  while ((last_ = text_line_.find_first_not_of(kLineBlanks, at_)) == std::string_view::npos) {
    const auto line = lines_.next();
    if (!line) {
      ended_ = true;
      return {};
    }
    text_line_ = line->text;
    at_ = 0;
  }
  at_ = std::min(text_line_.find_first_of(kLineBlanks, last_), text_line_.size());
  return text_line_.substr(last_, at_ - last_);
}

void VtkWords::skip_block() {
  skip_line();
  for (auto line = lines_.next(); line && !trimmed(line->text).empty();) line = lines_.next();
}

std::optional<std::string_view> VtkWords::whole_line() {
  skip_line();
  const auto line = lines_.next();
  if (!line) return {};
  return line->text;
}

std::optional<VtkWords::Binary> VtkWords::binary_of(std::string_view type) {
  // vtkDataWriter's names; a vtkIdType of legacy files has four bytes.
  static const std::map<std::string_view, Binary> kTypes = {{"char", Binary::Int8},
                                                            {"signed_char", Binary::Int8},
                                                            {"unsigned_char", Binary::Uint8},
                                                            {"short", Binary::Int16},
                                                            {"unsigned_short", Binary::Uint16},
                                                            {"int", Binary::Int32},
                                                            {"vtkIdType", Binary::Int32},
                                                            {"vtktypeint32", Binary::Int32},
                                                            {"unsigned_int", Binary::Uint32},
                                                            {"vtktypeuint32", Binary::Uint32},
                                                            {"long", Binary::Int64},
                                                            {"vtktypeint64", Binary::Int64},
                                                            {"unsigned_long", Binary::Uint64},
                                                            {"vtktypeuint64", Binary::Uint64},
                                                            {"float", Binary::Float32},
                                                            {"double", Binary::Float64}};
  const auto found = kTypes.find(type);
  if (found == kTypes.end()) return {};
  return found->second;
}

bool VtkWords::block(std::string_view type, long long count) {
  if (!binary_ || count == 0) return true;
  const std::optional<Binary> known = binary_of(type);
  if (!known) return false;
  constexpr std::array<std::size_t, 10> kBytes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  const std::size_t bytes =
      static_cast<std::size_t>(count) * kBytes[static_cast<std::size_t>(*known)];
  if (lines_.rest().size() < bytes) return false;
  type_ = *known;
  skip_line();
  block_ = lines_.rest().substr(0, bytes);
  lines_.skip(bytes);
  return true;
}

bool VtkWords::skip_numbers() {
  const bool any = !block_.empty();
  block_ = {};
  return any;
}

std::string_view VtkWords::number() {
  const auto shown = [&](auto value) {
    take_big_endian(block_, value);
    const auto end = std::to_chars(text_.data(), text_.data() + text_.size(), value).ptr;
    return std::string_view(text_.data(), static_cast<std::size_t>(end - text_.data()));
  };
  switch (type_) {
    case Binary::Int8:
      return shown(std::int8_t{0});
    case Binary::Uint8:
      return shown(std::uint8_t{0});
    case Binary::Int16:
      return shown(std::int16_t{0});
    case Binary::Uint16:
      return shown(std::uint16_t{0});
    case Binary::Int32:
      return shown(std::int32_t{0});
    case Binary::Uint32:
      return shown(std::uint32_t{0});
    case Binary::Int64:
      return shown(std::int64_t{0});
    case Binary::Uint64:
      return shown(std::uint64_t{0});
    case Binary::Float32:
      return shown(0.0F);
    case Binary::Float64:
      return shown(0.0);
  }
  return {};
}

}  // namespace coapt
