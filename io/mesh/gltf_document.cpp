#include "io/mesh/gltf_document.h"

#include <cstdint>
#include <limits>

#include "io/mesh/byte_scan.h"
#include "io/mesh/vtk_xml_bytes.h"

namespace coapt {
namespace {

constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr long long kMostWhole = std::numeric_limits<std::int32_t>::max();
constexpr long long kMostElements = 12'000'000;  // three corners of each of the triangles accepted
constexpr long long kMostStride = 65'535;

/// Of a component type (5.1.3 of the specification): bytes, and what a normalized number is divided by.
struct Component {
  std::size_t bytes;
  double most;
};

std::optional<Component> component_of(long long type) {
  switch (type) {
    case 5120:
      return Component{1, 127.0};
    case 5121:
      return Component{1, 255.0};
    case 5122:
      return Component{2, 32767.0};
    case 5123:
      return Component{2, 65535.0};
    case 5125:
      return Component{4, 4294967295.0};
    case 5126:
      return Component{4, 1.0};
    default:
      return {};
  }
}

template <class T>
double binary_number(std::string_view bytes) {
  return static_cast<double>(*take_binary<T>(bytes, std::endian::little));
}

/// @pre component_of(type); bytes of it
double number_at(std::string_view bytes, long long type) {
  switch (type) {
    case 5120:
      return binary_number<std::int8_t>(bytes);
    case 5121:
      return binary_number<std::uint8_t>(bytes);
    case 5122:
      return binary_number<std::int16_t>(bytes);
    case 5123:
      return binary_number<std::uint16_t>(bytes);
    case 5125:
      return binary_number<std::uint32_t>(bytes);
    default:
      return binary_number<float>(bytes);
  }
}

const Json kNull;

}  // namespace

Expected<GltfChunks> gltf_chunks(std::string_view bytes) {
  if (!bytes.starts_with("glTF")) return GltfChunks{bytes, {}};
  const Error truncated = {ErrorCode::InputOutput, "", "is truncated or damaged"};
  bytes.remove_prefix(4);
  const auto version = take_binary<std::uint32_t>(bytes, std::endian::little);
  if (!version || !take_binary<std::uint32_t>(bytes, std::endian::little)) return truncated;
  if (*version != 2)
    return Error{ErrorCode::Unsupported, "",
                 "is glTF version " + std::to_string(*version) + ", must be version 2"};
  GltfChunks chunks;
  while (!bytes.empty()) {
    const auto length = take_binary<std::uint32_t>(bytes, std::endian::little);
    const auto type = take_binary<std::uint32_t>(bytes, std::endian::little);
    if (!length || !type || bytes.size() < *length) return truncated;
    if (type == kJsonChunk && chunks.document.empty()) chunks.document = bytes.substr(0, *length);
    if (type == kBinaryChunk && chunks.binary.empty()) chunks.binary = bytes.substr(0, *length);
    bytes.remove_prefix(*length);
  }
  return chunks;
}

const Json& gltf_member(const Json& object, std::string_view name) {
  if (!object.is_object()) return kNull;
  const auto found = object.find(name);
  return found == object.end() ? kNull : *found;
}

GltfDocument::GltfDocument(Json document, std::string_view binary)
    : root_(std::move(document)), binary_(binary) {}

const Json& GltfDocument::entry(const char* list, long long index) {
  const Json& entries = gltf_member(root_, list);
  if (entries.is_array() && index >= 0 && index < static_cast<long long>(entries.size()))
    return entries[static_cast<std::size_t>(index)];
  problems_.add(ErrorCode::BadReference, std::string("/") + list,
                "has no entry " + std::to_string(index) + ", which is named");
  return kNull;
}

long long GltfDocument::whole(const Json& object, const char* name, long long otherwise,
                              const std::string& path) {
  const Json& value = gltf_member(object, name);
  if (value.is_null()) return otherwise;
  if (value.is_number_integer())
    if (const auto number = value.get<std::int64_t>(); number >= 0 && number <= kMostWhole)
      return number;
  problems_.add(ErrorCode::WrongType, path + '/' + name, "must be a whole number below 2^31");
  return otherwise;
}

std::optional<std::vector<double>> GltfDocument::numbers(const Json& object, const char* name,
                                                         std::size_t count,
                                                         const std::string& path) {
  const Json& list = gltf_member(object, name);
  if (list.is_null()) return {};
  std::vector<double> found;
  if (list.is_array() && list.size() == count)
    for (const Json& number : list)
      if (number.is_number()) found.push_back(number.get<double>());
  if (found.size() == count) return found;
  problems_.add(ErrorCode::WrongType, path + '/' + name,
                "must be " + std::to_string(count) + " numbers");
  return {};
}

std::string_view GltfDocument::buffer(long long index) {
  const std::string path = "/buffers/" + std::to_string(index);
  const Json& uri = gltf_member(entry("buffers", index), "uri");
  if (uri.is_null() && index == 0) return binary_;
  constexpr std::string_view kCoding = ";base64,";
  const std::string text = uri.is_string() ? uri.get<std::string>() : std::string();
  const std::size_t coded = text.find(kCoding);
  if (!text.starts_with("data:") || coded == std::string::npos) {
    problems_.add(ErrorCode::MissingField, path,
                  "is in another file; provide it together with this one, or save as .glb");
    return {};
  }
  if (decoded_.size() <= static_cast<std::size_t>(index))
    decoded_.resize(static_cast<std::size_t>(index) + 1);
  std::optional<std::string>& bytes = decoded_[static_cast<std::size_t>(index)];
  if (!bytes) bytes = from_base64(std::string_view(text).substr(coded + kCoding.size()));
  if (bytes) return *bytes;
  problems_.add(ErrorCode::InputOutput, path, "is truncated or damaged");
  return {};
}

std::string_view GltfDocument::view(long long index, long long& stride) {
  const std::string path = "/bufferViews/" + std::to_string(index);
  const Json& of = entry("bufferViews", index);
  if (of.is_null()) return {};
  const long long offset = whole(of, "byteOffset", 0, path),
                  length = whole(of, "byteLength", 0, path);
  stride = whole(of, "byteStride", 0, path);
  const std::string_view bytes = buffer(whole(of, "buffer", 0, path));
  if (!problems_.empty()) return {};
  if (offset + length <= static_cast<long long>(bytes.size()) && stride <= kMostStride)
    return bytes.substr(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
  problems_.add(ErrorCode::BadReference, path,
                "must lie within its buffer of " + std::to_string(bytes.size()) + " bytes");
  return {};
}

std::vector<double> GltfDocument::array(long long accessor, std::string_view type) {
  const std::string path = "/accessors/" + std::to_string(accessor);
  const Json& of = entry("accessors", accessor);
  const auto wrong = [&](ErrorCode code, const std::string& message) {
    problems_.add(code, path, message);
    return std::vector<double>();
  };
  if (of.is_null()) return {};
  if (gltf_member(of, "type") != type)
    return wrong(ErrorCode::WrongType, "must be of type " + std::string(type));
  if (!gltf_member(of, "sparse").is_null())
    return wrong(ErrorCode::Unsupported, "is sparse; save the file without sparse accessors");
  const long long kind = whole(of, "componentType", 0, path), count = whole(of, "count", 0, path),
                  offset = whole(of, "byteOffset", 0, path);
  const std::optional<Component> component = component_of(kind);
  if (!component || count > kMostElements)
    return wrong(ErrorCode::OutOfRange,
                 "must have a component type from 5120 to 5126 and at most 12,000,000 elements");
  long long stride = 0;
  const std::string_view bytes = view(whole(of, "bufferView", -1, path), stride);
  if (!problems_.empty() || count == 0) return {};
  const long long components = type == "SCALAR" ? 1 : 3,
                  size = components * static_cast<long long>(component->bytes);
  if (stride == 0) stride = size;
  if (offset + stride * (count - 1) + size > static_cast<long long>(bytes.size()))
    return wrong(ErrorCode::BadReference,
                 "must lie within its buffer view of " + std::to_string(bytes.size()) + " bytes");
  const double unit = gltf_member(of, "normalized") == true ? 1.0 / component->most : 1.0;
  std::vector<double> list;
  list.reserve(static_cast<std::size_t>(count * components));
  for (long long i = 0; i < count; ++i)
    for (long long k = 0; k < components; ++k) {
      const auto at = static_cast<std::size_t>(offset + stride * i) +
                      static_cast<std::size_t>(k) * component->bytes;
      list.push_back(unit * number_at(bytes.substr(at, component->bytes), kind));
    }
  return list;
}

}  // namespace coapt
