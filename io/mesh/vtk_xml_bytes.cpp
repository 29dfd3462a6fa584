#include "io/mesh/vtk_xml_bytes.h"

#include <lzma.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>

namespace coapt {
namespace {

constexpr std::uint64_t kMaxLzmaMemory = std::uint64_t{256} << 20;

/// Bytes that an array may unpack to, and what all arrays of the file may have.
struct Room {
  std::uint64_t bytes = 0, of_file = 0;
};

Error too_large(const std::string& path, const Room& room) {
  return {ErrorCode::OutOfRange, path,
          "makes the arrays of the file larger than the " + std::to_string(room.of_file >> 20) +
              " MiB accepted; save it without those that are not needed"};
}

Error damaged(const std::string& path) {
  return {ErrorCode::InputOutput, path, "is truncated or damaged"};
}

int digit_of(char letter) {
  if (letter >= 'A' && letter <= 'Z') return letter - 'A';
  if (letter >= 'a' && letter <= 'z') return letter - 'a' + 26;
  if (letter >= '0' && letter <= '9') return letter - '0' + 52;
  return letter == '+' ? 62 : letter == '/' ? 63 : -1;
}

/// A stretch of bytes out of base64 or as it stands.
class Source {
 public:
  explicit Source(const StoredBytes& stored) : bytes_(stored.bytes), raw_(stored.raw) {}

  /// The first `size` bytes of a stretch that begins here; none if there are not as many.
  std::optional<std::string> peek(std::uint64_t size) const {
    if (raw_) {
      if (bytes_.size() < size) return {};
      return std::string(bytes_.substr(0, size));
    }
    const std::uint64_t groups = (size + 2) / 3;
    if (bytes_.size() / 4 < groups) return {};
    std::string out;
    out.reserve(3 * groups);
    for (std::uint64_t g = 0; g < groups; ++g) {
      std::uint32_t bits = 0;
      for (std::uint64_t k = 0; k < 4; ++k) {
        const char letter = bytes_[4 * g + k];
        const int digit = letter == '=' && g + 1 == groups ? 0 : digit_of(letter);
        if (digit < 0) return {};
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
      }
      for (const int shift : {16, 8, 0}) out += static_cast<char>(bits >> shift & 0xFF);
    }
    out.resize(size);
    return out;
  }

  /// Behind a stretch of this size, coded by itself.
  void skip(std::uint64_t size) {
    bytes_.remove_prefix(std::min<std::uint64_t>(bytes_.size(), raw_ ? size : (size + 2) / 3 * 4));
  }

 private:
  std::string_view bytes_;
  bool raw_;
};

template <class T>
T little_endian_at(std::string_view bytes, std::size_t at) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes.data() + at, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

bool inflate_zlib(std::string_view block, std::string& out) {
  uLongf size = out.size();
  return uncompress(reinterpret_cast<Bytef*>(out.data()), &size,
                    reinterpret_cast<const Bytef*>(block.data()), block.size()) == Z_OK &&
         size == out.size();
}

bool inflate_lzma(std::string_view block, std::string& out) {
  std::uint64_t memory = kMaxLzmaMemory;
  std::size_t in_at = 0, out_at = 0;
  return lzma_stream_buffer_decode(&memory, 0, nullptr,
                                   reinterpret_cast<const std::uint8_t*>(block.data()), &in_at,
                                   block.size(), reinterpret_cast<std::uint8_t*>(out.data()),
                                   &out_at, out.size()) == LZMA_OK &&
         out_at == out.size();
}

Expected<std::string> unpacked_blocks(const StoredBytes& stored, const std::string& path,
                                      const Room& room) {
  const bool lzma = stored.compressor == "vtkLZMADataCompressor";
  if (!lzma && stored.compressor != "vtkZLibDataCompressor")
    return Error{ErrorCode::Unsupported, path,
                 "is compressed by '" + std::string(stored.compressor.substr(0, 40)) +
                     "', accepted: vtkZLibDataCompressor, vtkLZMADataCompressor, none"};
  const std::uint64_t width = stored.wide_header ? 8 : 4;
  const auto count_at = [&](const std::string& head, std::uint64_t i) {
    return stored.wide_header ? little_endian_at<std::uint64_t>(head, 8 * i)
                              : little_endian_at<std::uint32_t>(head, 4 * i);
  };
  Source source(stored);
  const auto first = source.peek(width);
  if (!first) return damaged(path);
  const std::uint64_t blocks = count_at(*first, 0);
  if (blocks > stored.bytes.size()) return damaged(path);
  const auto head = source.peek(width * (3 + blocks));
  if (!head) return damaged(path);
  source.skip(width * (3 + blocks));
  const std::uint64_t whole = count_at(*head, 1), shorter = count_at(*head, 2),
                      last = shorter > 0 ? shorter : whole;
  if (blocks > 0 &&
      (last > whole || whole > room.bytes || (blocks - 1) * whole + last > room.bytes))
    return too_large(path, room);
  std::uint64_t packed_size = 0;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const std::uint64_t size = count_at(*head, 3 + i);
    if (size > stored.bytes.size()) return damaged(path);
    packed_size += size;
  }
  const auto packed = source.peek(packed_size);
  if (!packed) return damaged(path);
  std::string all, block;
  std::size_t at = 0;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const std::uint64_t size = count_at(*head, 3 + i);
    block.resize(i + 1 == blocks ? last : whole);
    const std::string_view in = std::string_view(*packed).substr(at, size);
    if (!(lzma ? inflate_lzma(in, block) : inflate_zlib(in, block))) return damaged(path);
    all += block;
    at += size;
  }
  return all;
}

/// At most `most` bytes, which is known before one is unpacked.
Expected<std::string> unpacked(const StoredBytes& stored, const std::string& path,
                               const Room& room) {
  if (!stored.compressor.empty()) return unpacked_blocks(stored, path, room);
  const std::uint64_t width = stored.wide_header ? 8 : 4;
  const Source source(stored);
  const auto head = source.peek(width);
  if (!head) return damaged(path);
  const std::uint64_t size = stored.wide_header ? little_endian_at<std::uint64_t>(*head, 0)
                                                : little_endian_at<std::uint32_t>(*head, 0);
  if (size > stored.bytes.size()) return damaged(path);
  if (size > room.bytes) return too_large(path, room);
  auto all = source.peek(width + size);
  if (!all) return damaged(path);
  return all->substr(width);
}

template <class T>
Expected<std::vector<double>> numbers_as(const StoredBytes& stored, const std::string& path,
                                         UnpackBudget& budget) {
  const Room room{budget.left_bytes / sizeof(double) * sizeof(T), budget.most_bytes};
  const Expected<std::string> bytes = unpacked(stored, path, room);
  if (!bytes) return bytes.errors();
  if (bytes->size() % sizeof(T) != 0) return damaged(path);
  std::vector<double> numbers;
  numbers.reserve(bytes->size() / sizeof(T));
  for (std::size_t at = 0; at < bytes->size(); at += sizeof(T))
    numbers.push_back(static_cast<double>(little_endian_at<T>(*bytes, at)));
  budget.left_bytes -= sizeof(double) * numbers.size();
  return numbers;
}

}  // namespace

std::optional<std::string> from_base64(std::string_view text) {
  if (text.size() % 4 != 0) return {};
  const std::size_t padding = text.ends_with("==") ? 2 : text.ends_with('=') ? 1 : 0;
  return Source({text, false, false, {}}).peek(text.size() / 4 * 3 - padding);
}

Expected<std::vector<double>> unpacked_numbers(const StoredBytes& stored, std::string_view type,
                                               const std::string& path, UnpackBudget& budget) {
  if (type == "Float32") return numbers_as<float>(stored, path, budget);
  if (type == "Float64") return numbers_as<double>(stored, path, budget);
  if (type == "Int8") return numbers_as<std::int8_t>(stored, path, budget);
  if (type == "UInt8") return numbers_as<std::uint8_t>(stored, path, budget);
  if (type == "Int16") return numbers_as<std::int16_t>(stored, path, budget);
  if (type == "UInt16") return numbers_as<std::uint16_t>(stored, path, budget);
  if (type == "Int32") return numbers_as<std::int32_t>(stored, path, budget);
  if (type == "UInt32") return numbers_as<std::uint32_t>(stored, path, budget);
  if (type == "Int64") return numbers_as<std::int64_t>(stored, path, budget);
  if (type == "UInt64") return numbers_as<std::uint64_t>(stored, path, budget);
  return Error{ErrorCode::Unsupported, path,
               "has type '" + std::string(type.substr(0, 20)) +
                   "', accepted: Float32, Float64, Int8 to Int64, UInt8 to UInt64"};
}

}  // namespace coapt
