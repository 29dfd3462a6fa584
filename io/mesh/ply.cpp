// PLY 1.0: ASCII and binary of either byte order. The element "vertex" must have x, y and z, the
// element "face" a list "vertex_indices" (or "vertex_index"); other elements and properties are
// passed over.

#include "io/mesh/ply.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "io/mesh/byte_scan.h"
#include "io/mesh/mesh_builder.h"
#include "io/mesh/text_scan.h"

namespace coapt {
namespace {

enum class Scalar { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

struct Property {
  std::string_view name;
  Scalar type = Scalar::Float32;
  std::optional<Scalar> count;  ///< a list, and the type of its length
};

struct Element {
  std::string_view name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

enum class Encoding { Ascii, Little, Big };

struct Header {
  Encoding encoding = Encoding::Ascii;
  std::vector<Element> elements;
};

constexpr std::size_t kMaxElements = 20, kMaxProperties = 100;
constexpr const char* kPropertyTypes =
    "the type of a property must be char, uchar, short, ushort, int, uint, float or double";

std::optional<Scalar> scalar_named(std::string_view name) {
  constexpr std::pair<std::string_view, Scalar> kNames[] = {
      {"char", Scalar::Int8},      {"int8", Scalar::Int8},       {"uchar", Scalar::Uint8},
      {"uint8", Scalar::Uint8},    {"short", Scalar::Int16},     {"int16", Scalar::Int16},
      {"ushort", Scalar::Uint16},  {"uint16", Scalar::Uint16},   {"int", Scalar::Int32},
      {"int32", Scalar::Int32},    {"uint", Scalar::Uint32},     {"uint32", Scalar::Uint32},
      {"float", Scalar::Float32},  {"float32", Scalar::Float32}, {"double", Scalar::Float64},
      {"float64", Scalar::Float64}};
  for (const auto& [known, scalar] : kNames) {
    if (known == name) return scalar;
  }
  return {};
}

/// What is wrong with a line of the header, or "".
std::string read_header_line(const std::vector<std::string_view>& tokens, Header& header) {
  const std::string_view keyword = tokens[0];
  if (keyword == "comment" || keyword == "obj_info") return "";
  if (keyword == "format" && tokens.size() == 3) {
    if (tokens[1] == "ascii") return header.encoding = Encoding::Ascii, "";
    if (tokens[1] == "binary_little_endian") return header.encoding = Encoding::Little, "";
    if (tokens[1] == "binary_big_endian") return header.encoding = Encoding::Big, "";
    return "format must be ascii, binary_little_endian or binary_big_endian";
  }
  if (keyword == "element" && tokens.size() == 3) {
    const auto count = to_integer(tokens[2]);
    if (!count || *count < 0 || *count > std::numeric_limits<std::int32_t>::max()) {
      return "the number of elements must be from 0 to 2147483647";
    }
    if (header.elements.size() == kMaxElements) return "must have at most 20 elements";
    header.elements.push_back({tokens[1], static_cast<std::uint64_t>(*count), {}});
    return "";
  }
  if (keyword == "property" && !header.elements.empty()) {
    auto& properties = header.elements.back().properties;
    if (properties.size() == kMaxProperties)
      return "must have at most 100 properties of an element";
    if (tokens.size() == 3) {
      const auto type = scalar_named(tokens[1]);
      if (!type) return kPropertyTypes;
      properties.push_back({tokens[2], *type, {}});
      return "";
    }
    if (tokens.size() == 5 && tokens[1] == "list") {
      const auto count = scalar_named(tokens[2]);
      const auto type = scalar_named(tokens[3]);
      if (!count || !type) return kPropertyTypes;
      if (*count >= Scalar::Float32) return "the length of a list must be an integer type";
      properties.push_back({tokens[4], *type, count});
      return "";
    }
  }
  return "must be format, comment, element or property";
}

/// Numbers one after the other, from lines of text or from bytes.
class Values {
 public:
  Values(std::string_view body, Encoding encoding, int line)
      : body_(body), encoding_(encoding), line_(line) {}

  std::optional<double> next(Scalar type) {
    if (encoding_ == Encoding::Ascii) return next_word();
    switch (type) {
      case Scalar::Int8:
        return next_binary<std::int8_t>();
      case Scalar::Uint8:
        return next_binary<std::uint8_t>();
      case Scalar::Int16:
        return next_binary<std::int16_t>();
      case Scalar::Uint16:
        return next_binary<std::uint16_t>();
      case Scalar::Int32:
        return next_binary<std::int32_t>();
      case Scalar::Uint32:
        return next_binary<std::uint32_t>();
      case Scalar::Float32:
        return next_binary<float>();
      case Scalar::Float64:
        return next_binary<double>();
    }
    return {};
  }

  int line() const { return encoding_ == Encoding::Ascii ? line_ : 0; }
  bool ended() const { return body_.empty(); }

 private:
  template <class T>
  std::optional<double> next_binary() {
    const auto order = encoding_ == Encoding::Big ? std::endian::big : std::endian::little;
    const auto value = take_binary<T>(body_, order);
    if (!value) body_ = {};
    return value;
  }

  std::optional<double> next_word() {
    constexpr std::string_view kBlanks = " \t\r\n";
    const std::size_t start = std::min(body_.find_first_not_of(kBlanks), body_.size());
    line_ += static_cast<int>(
        std::count(body_.begin(), body_.begin() + static_cast<std::ptrdiff_t>(start), '\n'));
    body_.remove_prefix(start);
    const std::string_view word = body_.substr(0, body_.find_first_of(kBlanks));
    body_.remove_prefix(word.size());
    return to_number(word);
  }

  std::string_view body_;
  Encoding encoding_;
  int line_;
};

bool is_face_number(const Element& element, const Property& property) {
  return element.name == "face" && !property.count && property.type < Scalar::Float32;
}

/// Reads one element record; false if the file ends or holds what is no number.
bool read_record(const Element& element, Values& values, MeshBuilder& mesh,
                 std::vector<PlyNumbers>& face_numbers) {
  Vec3 position = Vec3::Zero();
  std::vector<long long> corners;
  std::size_t number = 0;
  for (const Property& property : element.properties) {
    if (!property.count) {
      const auto value = values.next(property.type);
      if (!value) return false;
      if (is_face_number(element, property) && number < face_numbers.size())
        face_numbers[number++].of_polygon.push_back(*value);
      if (property.name == "x") position.x() = *value;
      if (property.name == "y") position.y() = *value;
      if (property.name == "z") position.z() = *value;
      continue;
    }
    const auto length = values.next(*property.count);
    if (!length) return false;
    const bool polygon = property.name == "vertex_indices" || property.name == "vertex_index";
    for (double i = 0.0; i < *length; i += 1.0) {
      const auto value = values.next(property.type);
      if (!value) return false;
      const bool index =
          *value >= 0.0 && *value <= 2147483647.0;  // so that the conversion is defined
      if (!polygon || corners.size() == kMaxWords) continue;
      corners.push_back(index ? static_cast<long long>(*value) : -1);
    }
  }
  if (element.name == "vertex") mesh.add_vertex(position, values.line());
  if (element.name == "face") mesh.add_polygon(corners, values.line());
  return true;
}

bool has_property(const Header& header, std::string_view element, std::string_view property) {
  return std::any_of(header.elements.begin(), header.elements.end(), [&](const Element& e) {
    return e.name == element && std::any_of(e.properties.begin(), e.properties.end(),
                                            [&](const Property& p) { return p.name == property; });
  });
}

bool check_header(const Header& header, MeshBuilder& mesh) {
  for (const std::string_view axis : {"x", "y", "z"}) {
    if (has_property(header, "vertex", axis)) continue;
    mesh.add_problem(ErrorCode::MissingField, "/vertices_mm", 0,
                     "needs the property " + std::string(axis) + " of the element vertex");
    return false;
  }
  if (has_property(header, "face", "vertex_indices") ||
      has_property(header, "face", "vertex_index")) {
    return true;
  }
  mesh.add_problem(ErrorCode::MissingField, "/faces", 0,
                   "needs the list vertex_indices of the element face");
  return false;
}

void read_body(const Header& header, Values values, MeshBuilder& mesh,
               std::vector<PlyNumbers>& face_numbers) {
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;
    if (element.name == "face" && face_numbers.empty())
      for (const Property& property : element.properties)
        if (is_face_number(element, property))
          face_numbers.push_back({std::string(property.name), {}});
    for (std::uint64_t i = 0; i < element.count && !mesh.full(); ++i) {
      if (read_record(element, values, mesh, face_numbers)) continue;
      const std::string path =
          (element.name == "vertex" ? "/vertices_mm/" : "/faces/") + std::to_string(i);
      mesh.add_problem(
          values.ended() ? ErrorCode::InputOutput : ErrorCode::WrongType, path, values.line(),
          values.ended()
              ? "is truncated: the header announces " + std::to_string(element.count) + " of these"
              : "must be numbers");
      return;
    }
  }
}

}  // namespace

Expected<PlyFile> read_ply_file(std::string_view bytes, const MeshLimits& limits) {
  MeshBuilder mesh(limits);
  std::vector<PlyNumbers> face_numbers;
  LineScanner lines(bytes);
  const auto first = lines.next();
  if (!first || trimmed(first->text) != "ply") {
    return Error{ErrorCode::InputOutput, "", "line 1: must be 'ply'"};
  }
  Header header;
  while (const auto line = lines.next()) {
    const auto tokens = words(line->text);
    if (tokens.empty()) continue;
    if (tokens[0] == "end_header") {
      if (check_header(header, mesh)) {
        read_body(header, Values(lines.rest(), header.encoding, lines.number() + 1), mesh,
                  face_numbers);
      }
      Expected<TriangleMesh> read = std::move(mesh).take();
      if (!read) return read.errors();
      return PlyFile{*std::move(read), std::move(face_numbers)};
    }
    const std::string wrong = read_header_line(tokens, header);
    if (!wrong.empty()) {
      return Error{ErrorCode::Unsupported, "",
                   "line " + std::to_string(line->number) + ": header: " + wrong};
    }
  }
  return Error{ErrorCode::InputOutput, "", "is truncated: no end_header"};
}

}  // namespace coapt
