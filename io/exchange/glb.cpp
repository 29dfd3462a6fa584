#include "io/exchange/glb.h"

#include "io/mesh/little_endian.h"

namespace coapt {
namespace {

constexpr int kUnsignedByte = 5121, kUnsignedInt = 5125, kFloat = 5126;  // component types
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;         // targets
constexpr std::uint32_t kMagic = 0x46546C67, kJson = 0x4E4F534A, kBinary = 0x004E4942;

std::string padded(std::string chunk, char with) {
  chunk.resize((chunk.size() + 3) / 4 * 4, with);
  return chunk;
}

void append_chunk(std::string& file, std::uint32_t type, const std::string& chunk) {
  append_little_endian(file, static_cast<std::uint32_t>(chunk.size()));
  append_little_endian(file, type);
  file += chunk;
}

}  // namespace

void GlbBuffer::append(float number) { append_little_endian(bytes_, number); }

int GlbBuffer::add(Json accessor, std::size_t start, int target) {
  Json view = {{"buffer", 0}, {"byteOffset", start}, {"byteLength", bytes_.size() - start}};
  if (target != 0) view["target"] = target;
  accessor["bufferView"] = views_.size();
  views_.push_back(std::move(view));
  accessors_.push_back(std::move(accessor));
  return static_cast<int>(accessors_.size()) - 1;
}

int GlbBuffer::add_vectors(const Points& vectors, bool bounds) {
  const std::size_t start = bytes_.size();
  const Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> single = vectors.cast<float>();
  for (const float number : single.reshaped<Eigen::RowMajor>()) append(number);
  Json accessor = {{"componentType", kFloat}, {"count", vectors.rows()}, {"type", "VEC3"}};
  if (bounds)
    for (int axis = 0; axis < 3; ++axis) {
      accessor["min"].push_back(single.col(axis).minCoeff());
      accessor["max"].push_back(single.col(axis).maxCoeff());
    }
  return add(std::move(accessor), start, kArrayBuffer);
}

int GlbBuffer::add_colours(const std::vector<Colour8>& colours) {
  const std::size_t start = bytes_.size();
  for (const Colour8& colour : colours)
    for (const std::uint8_t channel : colour) append_little_endian(bytes_, channel);
  return add({{"componentType", kUnsignedByte},
              {"normalized", true},
              {"count", colours.size()},
              {"type", "VEC4"}},
             start, kArrayBuffer);
}

int GlbBuffer::add_triangles(const Faces& faces) {
  const std::size_t start = bytes_.size();
  for (const int vertex : faces.reshaped<Eigen::RowMajor>())
    append_little_endian(bytes_, static_cast<std::uint32_t>(vertex));
  return add({{"componentType", kUnsignedInt}, {"count", faces.size()}, {"type", "SCALAR"}}, start,
             kElementArrayBuffer);
}

int GlbBuffer::add_scalars(const std::vector<double>& scalars, bool bounds) {
  const std::size_t start = bytes_.size();
  for (const double number : scalars) append(static_cast<float>(number));
  Json accessor = {{"componentType", kFloat}, {"count", scalars.size()}, {"type", "SCALAR"}};
  if (bounds) {
    const auto [least, most] = std::minmax_element(scalars.begin(), scalars.end());
    accessor["min"] = {static_cast<float>(*least)};
    accessor["max"] = {static_cast<float>(*most)};
  }
  return add(std::move(accessor), start, 0);
}

std::string GlbBuffer::file(Json document) const {
  const std::string binary = padded(bytes_, '\0');
  document["accessors"] = accessors_;
  document["bufferViews"] = views_;
  document["buffers"] = {{{"byteLength", binary.size()}}};
  const std::string json = padded(document.dump(), ' ');
  constexpr std::size_t kHeaders = 12 + 8 + 8;
  std::string file;
  append_little_endian(file, kMagic);
  append_little_endian(file, std::uint32_t{2});
  append_little_endian(file, static_cast<std::uint32_t>(kHeaders + json.size() + binary.size()));
  append_chunk(file, kJson, json);
  append_chunk(file, kBinary, binary);
  return file;
}

}  // namespace coapt
