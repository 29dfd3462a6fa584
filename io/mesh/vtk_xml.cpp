#include "io/mesh/vtk_xml.h"

#include <algorithm>

#include "io/mesh/text_scan.h"

namespace coapt {
namespace {

constexpr std::string_view kSpace = " \t\r\n\f\v";

bool is_space(char letter) { return kSpace.find(letter) != kSpace.npos; }

/// Without space at either end, ends of lines included.
std::string_view without_space(std::string_view text) {
  const auto first = text.find_first_not_of(kSpace);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

/// `name="value"` and `name='value'`, up to the end of `text`; none if it is anything else.
std::optional<std::map<std::string, std::string, std::less<>>> attributes_of(
    std::string_view text) {
  std::map<std::string, std::string, std::less<>> attributes;
  for (text = without_space(text); !text.empty(); text = without_space(text)) {
    const auto equals = text.find('=');
    if (equals == text.npos) return {};
    const std::string name(without_space(text.substr(0, equals)));
    text = without_space(text.substr(equals + 1));
    if (text.empty() || (text[0] != '"' && text[0] != '\'')) return {};
    const auto end = text.find(text[0], 1);
    if (end == text.npos) return {};
    attributes[name] = std::string(text.substr(1, end - 1));
    text.remove_prefix(end + 1);
  }
  return attributes;
}

/// The element that begins at `open`, a '<'; `next`: behind it.
std::optional<XmlElement> element_at(std::string_view bytes, std::size_t open, std::size_t& next) {
  const auto close = bytes.find('>', open);
  if (close == bytes.npos) return {};
  std::string_view inside = bytes.substr(open + 1, close - open - 1);
  if (inside.ends_with('/')) inside.remove_suffix(1);
  std::size_t length = 0;
  while (length < inside.size() && !is_space(inside[length])) ++length;
  auto attributes = attributes_of(inside.substr(length));
  if (!attributes) return {};
  next = close + 1;
  const auto following = std::min(bytes.find('<', next), bytes.size());
  return XmlElement{std::string(inside.substr(0, length)), *std::move(attributes),
                    bytes.substr(next, following - next)};
}

Error unreadable(const std::string& message) { return {ErrorCode::InputOutput, "", message}; }

Expected<std::vector<double>> read_words(std::string_view text, const std::string& path) {
  std::vector<double> numbers;
  while (!(text = without_space(text)).empty()) {
    std::size_t length = 0;
    while (length < text.size() && !is_space(text[length])) ++length;
    const auto number = to_number(text.substr(0, length));
    if (!number) return Error{ErrorCode::WrongType, path, "must hold numbers"};
    numbers.push_back(*number);
    text.remove_prefix(length);
  }
  return numbers;
}

}  // namespace

std::string XmlElement::attribute(std::string_view key) const {
  const auto found = attributes.find(key);
  return found == attributes.end() ? std::string() : found->second;
}

Expected<VtkXml> read_vtk_xml(std::string_view bytes, std::string_view type) {
  VtkXml file;
  std::size_t at = bytes.find('<');
  while (at != bytes.npos) {
    if (bytes.substr(at).starts_with("<!--")) {
      const auto end = bytes.find("-->", at);
      at = end == bytes.npos ? end : bytes.find('<', end);
      continue;
    }
    if (bytes.substr(at).starts_with("<?") || bytes.substr(at).starts_with("<!")) {
      at = bytes.find('<', at + 1);
      continue;
    }
    std::size_t next = 0;
    auto element = element_at(bytes, at, next);
    if (!element) return unreadable("is no XML from byte " + std::to_string(at) + " on");
    if (file.elements.empty() && element->name != "VTKFile") break;
    if (element->name == "AppendedData") {
      file.appended_raw = element->attribute("encoding") == "raw";
      const auto mark = bytes.find('_', next);
      if (mark == bytes.npos) return unreadable("has no underscore before its appended data");
      file.appended = bytes.substr(mark + 1);
      break;
    }
    file.elements.push_back(*std::move(element));
    at = bytes.find('<', next);
  }
  if (file.elements.empty())
    return unreadable("is not a VTK XML file: its first element must be VTKFile");
  const XmlElement& root = file.elements.front();
  if (root.attribute("type") != type)
    return Error{ErrorCode::Unsupported, "",
                 "is a VTK file of type '" + root.attribute("type").substr(0, 40) + "', must be " +
                     std::string(type)};
  if (root.attribute("byte_order") == "BigEndian")
    return Error{ErrorCode::Unsupported, "", "is big-endian; save it as LittleEndian"};
  file.wide_header = root.attribute("header_type") == "UInt64";
  file.compressor = root.attribute("compressor");
  return file;
}

Expected<std::vector<double>> read_data_array(const VtkXml& file, const XmlElement& array,
                                              const std::string& path, UnpackBudget& budget) {
  const std::string format = array.attribute("format");
  if (format == "ascii") {
    Expected<std::vector<double>> numbers = read_words(array.text, path);
    if (numbers) budget.left_bytes -= std::min(budget.left_bytes, sizeof(double) * numbers->size());
    return numbers;
  }
  StoredBytes stored{without_space(array.text), false, file.wide_header, file.compressor};
  if (format == "appended") {
    const auto offset = to_integer(without_space(array.attribute("offset")));
    if (!offset || *offset < 0 || static_cast<std::size_t>(*offset) >= file.appended.size())
      return Error{ErrorCode::OutOfRange, path, "has an offset outside the appended data"};
    stored.bytes = file.appended.substr(static_cast<std::size_t>(*offset));
    stored.raw = file.appended_raw;
  } else if (format != "binary") {
    return Error{ErrorCode::Unsupported, path,
                 "has format '" + format.substr(0, 20) + "', accepted: ascii, binary, appended"};
  }
  return unpacked_numbers(stored, array.attribute("type"), path, budget);
}

}  // namespace coapt
