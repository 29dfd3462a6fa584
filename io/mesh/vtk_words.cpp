#include "io/mesh/vtk_words.h"

#include <charconv>
#include <cstdint>
#include <map>
#include <utility>

#include "io/mesh/byte_scan.h"

namespace coapt {

std::string_view VtkWords::next() {
  if (!block_.empty()) return number();
  while (at_ == words_.size()) {
    const auto line = lines_.next();
    if (!line) {
      ended_ = true;
      return {};
    }
    words_ = words(line->text);
    at_ = 0;
  }
  return words_[at_++];
}

void VtkWords::skip_block() {
  at_ = words_.size();
  for (auto line = lines_.next(); line && !trimmed(line->text).empty();) line = lines_.next();
}

std::optional<std::string_view> VtkWords::whole_line() {
  at_ = words_.size();
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
                                                            {"unsigned_int", Binary::Uint32},
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
    if (!value) return std::string_view{};
    const auto end = std::to_chars(text_.data(), text_.data() + text_.size(), *value).ptr;
    return std::string_view(text_.data(), static_cast<std::size_t>(end - text_.data()));
  };
  constexpr auto kBig = std::endian::big;
  switch (type_) {
    case Binary::Int8:
      return shown(take_binary<std::int8_t>(block_, kBig));
    case Binary::Uint8:
      return shown(take_binary<std::uint8_t>(block_, kBig));
    case Binary::Int16:
      return shown(take_binary<std::int16_t>(block_, kBig));
    case Binary::Uint16:
      return shown(take_binary<std::uint16_t>(block_, kBig));
    case Binary::Int32:
      return shown(take_binary<std::int32_t>(block_, kBig));
    case Binary::Uint32:
      return shown(take_binary<std::uint32_t>(block_, kBig));
    case Binary::Int64:
      return shown(take_binary<std::int64_t>(block_, kBig));
    case Binary::Uint64:
      return shown(take_binary<std::uint64_t>(block_, kBig));
    case Binary::Float32:
      return shown(take_binary<float>(block_, kBig));
    case Binary::Float64:
      return shown(take_binary<double>(block_, kBig));
  }
  return {};
}

}  // namespace coapt
