#include "io/image/voxel_stream.h"

#include <bzlib.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "core/valve/number_text.h"
#include "io/mesh/byte_scan.h"
#include "io/mesh/text_scan.h"

namespace coapt {
namespace {

constexpr std::size_t kBlock = 1 << 16;       // of a multiple of eight bytes
constexpr std::size_t kMostInput = 1U << 30;  // handed to a library at once, which count in 32 bits
constexpr int kEitherWindow = 32 + MAX_WBITS;  // gzip or zlib: zlib's manual, inflateInit2

const Error kTruncated = {ErrorCode::InputOutput, "/data", "is truncated or damaged"};

std::optional<std::uint16_t> label_of(double number) {
  if (!(number >= 0.0 && number <= 65535.0) || number != std::floor(number)) return {};
  return static_cast<std::uint16_t>(number);
}

Error no_label(double number) {
  return {ErrorCode::OutOfRange, "/data",
          "has the number " + shown(number) +
              ", must be labels, whole numbers from 0 to 65535 (is this the image instead of its "
              "segmentation?)"};
}

template <class T>
Expected<std::vector<std::uint16_t>> read_as(ByteStream& stream, const VoxelLayout& layout) {
  std::vector<std::uint16_t> labels;
  std::array<char, kBlock> block;
  while (labels.size() < layout.count) {
    const std::size_t numbers = std::min(kBlock / sizeof(T), layout.count - labels.size());
    if (!stream.read(block.data(), numbers * sizeof(T))) return kTruncated;
    std::string_view bytes(block.data(), numbers * sizeof(T));
    for (std::size_t i = 0; i < numbers; ++i) {
      const auto number = static_cast<double>(*take_binary<T>(bytes, layout.order));
      const std::optional<std::uint16_t> label = label_of(number);
      if (!label) return no_label(number);
      labels.push_back(*label);
    }
  }
  return labels;
}

}  // namespace

void ByteStream::Ender::operator()(z_stream* stream) const {
  inflateEnd(stream);
  delete stream;
}

struct Bzip2Stream {
  bz_stream state{};
};

void ByteStream::Ender::operator()(Bzip2Stream* stream) const {
  BZ2_bzDecompressEnd(&stream->state);
  delete stream;
}

ByteStream::ByteStream(std::string_view bytes, Packing packing) : bytes_(bytes) {
  if (packing == Packing::Zlib) {
    inflater_.reset(new z_stream{});
    inflateInit2(inflater_.get(), kEitherWindow);
  } else if (packing == Packing::Bzip2) {
    decompressor_.reset(new Bzip2Stream);
    BZ2_bzDecompressInit(&decompressor_->state, 0, 0);
  }
}

bool ByteStream::read(char* into, std::size_t size) { return fill(into, size) == size; }

std::size_t ByteStream::fill(char* into, std::size_t size) {
  if (inflater_) return inflate_into(into, size);
  if (decompressor_) return decompress_into(into, size);
  size = std::min(size, bytes_.size());
  std::memcpy(into, bytes_.data(), size);
  bytes_.remove_prefix(size);
  return size;
}

bool ByteStream::skip(std::uint64_t size) {
  std::array<char, kBlock> block;
  while (size > 0) {
    const std::size_t part = std::min<std::uint64_t>(size, kBlock);
    if (!read(block.data(), part)) return false;
    size -= part;
  }
  return true;
}

bool ByteStream::ends_whole() {
  constexpr std::size_t kMostLeft = 1 << 20;
  std::array<char, kBlock> block;
  for (std::size_t left = 0; left < kMostLeft;) {
    const std::size_t count = fill(block.data(), kBlock);
    left += count;
    if (count < kBlock) break;
  }
  return !damaged_;
}

std::size_t ByteStream::inflate_into(char* into, std::size_t size) {
  z_stream& stream = *inflater_;
  stream.next_out = reinterpret_cast<Bytef*>(into);
  stream.avail_out = static_cast<uInt>(size);
  while (stream.avail_out > 0 && !(ended_ && bytes_.empty())) {
    const std::size_t given = std::min(bytes_.size(), kMostInput);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes_.data()));
    stream.avail_in = static_cast<uInt>(given);
    const uInt before = stream.avail_out;
    const int state = inflate(&stream, Z_NO_FLUSH);
    const std::size_t used = given - stream.avail_in;
    bytes_.remove_prefix(used);
    if (state == Z_STREAM_END) {  // another member may follow (RFC 1952, 2.2)
      ended_ = true;
      if (stream.avail_out > 0 && bytes_.empty()) break;
      if (inflateReset(&stream) != Z_OK) break;
    } else if (state != Z_OK || (used == 0 && stream.avail_out == before)) {
      damaged_ = !ended_;  // what follows a member may be none
      break;
    } else {
      ended_ = false;
    }
  }
  return size - stream.avail_out;
}

std::size_t ByteStream::decompress_into(char* into, std::size_t size) {
  bz_stream& stream = decompressor_->state;
  stream.next_out = into;
  stream.avail_out = static_cast<unsigned>(size);
  while (stream.avail_out > 0 && !(ended_ && bytes_.empty())) {
    const std::size_t given = std::min(bytes_.size(), kMostInput);
    stream.next_in = const_cast<char*>(bytes_.data());
    stream.avail_in = static_cast<unsigned>(given);
    const unsigned before = stream.avail_out;
    const int state = BZ2_bzDecompress(&stream);
    const std::size_t used = given - stream.avail_in;
    bytes_.remove_prefix(used);
    if (state == BZ_STREAM_END) {  // another one may follow, of pbzip2
      ended_ = true;
      if (stream.avail_out > 0 && bytes_.empty()) break;
      char* const next = stream.next_out;
      const unsigned left = stream.avail_out;
      BZ2_bzDecompressEnd(&stream);
      stream = {};
      if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK) return size - left;
      stream.next_out = next;
      stream.avail_out = left;
    } else if (state != BZ_OK || (used == 0 && stream.avail_out == before)) {
      damaged_ = !ended_;
      break;
    } else {
      ended_ = false;
    }
  }
  return size - stream.avail_out;
}

Packing packing_of(std::string_view file) {
  if (file.starts_with("\x1f\x8b")) return Packing::Zlib;
  return file.starts_with("BZh") ? Packing::Bzip2 : Packing::None;
}

Expected<std::string> unpack(std::string_view file, Packing packing, std::size_t most_bytes) {
  ByteStream stream(file, packing);
  std::string bytes;
  std::array<char, kBlock> block;
  while (const std::size_t count = stream.fill(block.data(), kBlock)) {
    bytes.append(block.data(), count);
    if (bytes.size() > most_bytes)
      return Error{
          ErrorCode::OutOfRange, "",
          "unpacks to more than the " + std::to_string(most_bytes >> 20) + " MiB accepted"};
  }
  return bytes;
}

Errors check_end(ByteStream& stream) {
  if (stream.ends_whole()) return {};
  return {{ErrorCode::InputOutput, "/data",
           "is damaged: it does not agree with its checksum, or ends before it"}};
}

std::size_t bytes_of(VoxelType type) {
  constexpr std::array<std::size_t, 10> kBytes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kBytes[static_cast<std::size_t>(type)];
}

Expected<std::vector<std::uint16_t>> read_labels(ByteStream& stream, const VoxelLayout& layout) {
  switch (layout.type) {
    case VoxelType::Int8:
      return read_as<std::int8_t>(stream, layout);
    case VoxelType::Uint8:
      return read_as<std::uint8_t>(stream, layout);
    case VoxelType::Int16:
      return read_as<std::int16_t>(stream, layout);
    case VoxelType::Uint16:
      return read_as<std::uint16_t>(stream, layout);
    case VoxelType::Int32:
      return read_as<std::int32_t>(stream, layout);
    case VoxelType::Uint32:
      return read_as<std::uint32_t>(stream, layout);
    case VoxelType::Int64:
      return read_as<std::int64_t>(stream, layout);
    case VoxelType::Uint64:
      return read_as<std::uint64_t>(stream, layout);
    case VoxelType::Float32:
      return read_as<float>(stream, layout);
    case VoxelType::Float64:
      return read_as<double>(stream, layout);
  }
  return kTruncated;
}

Expected<std::vector<std::uint16_t>> read_label_words(std::string_view text, std::size_t count) {
  constexpr std::string_view kBlanks = " \t\r\n\f\v,";
  std::vector<std::uint16_t> labels;
  while (labels.size() < count) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    if (text.empty()) return kTruncated;
    const std::size_t end = std::min(text.find_first_of(kBlanks), text.size());
    const std::optional<double> number = to_number(text.substr(0, end));
    const std::optional<std::uint16_t> label = label_of(number.value_or(-1.0));
    if (!label) return no_label(number.value_or(std::numeric_limits<double>::quiet_NaN()));
    labels.push_back(*label);
    text.remove_prefix(end);
  }
  return labels;
}

}  // namespace coapt
