// The numbers of an image out of a stretch of bytes that may be compressed: read in blocks, so that what a file unpacks to is
// bounded by what was asked of it and not by what it holds.
#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/image/label_map.h"

struct z_stream_s;  // of zlib

namespace coapt {

struct Bzip2Stream;  // of its library, which names no struct

enum class Packing { None, Zlib, Bzip2 };  ///< Zlib: gzip, too

/// Of a whole file (.nii.gz, .nrrd.bz2), by its first bytes: gzip or bzip2.
Packing packing_of(std::string_view file);

/// Bytes as they stand, or unpacked.
class ByteStream {
 public:
  ByteStream(std::string_view bytes, Packing packing);

  /// Fills `size` bytes. False: there are not as many, or they are damaged.
  bool read(char* into, std::size_t size);
  /// Fills as many as there are, up to `size`.
  std::size_t fill(char* into, std::size_t size);
  bool skip(std::uint64_t size);
  /// Whether what is left unpacks to its end, where the checksum stands; of more than a megabyte that is left it is not asked.
  bool ends_whole();

 private:
  std::size_t inflate_into(char* into, std::size_t size);
  std::size_t decompress_into(char* into, std::size_t size);

  struct Ender {
    void operator()(z_stream_s* stream) const;
    void operator()(Bzip2Stream* stream) const;
  };
  std::string_view bytes_;
  bool ended_ = false;    ///< at the end of a member, whose checksum is right
  bool damaged_ = false;  ///< within one
  std::unique_ptr<z_stream_s, Ender> inflater_;       ///< none: not of zlib
  std::unique_ptr<Bzip2Stream, Ender> decompressor_;  ///< none: not of bzip2
};

enum class VoxelType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Int64, Uint64, Float32, Float64 };

/// All of such a file, or what stands before its damage. Errors: more than `most_bytes`.
Expected<std::string> unpack(std::string_view file, Packing packing, std::size_t most_bytes);

struct VoxelLayout {
  VoxelType type = VoxelType::Uint8;
  std::endian order = std::endian::little;
  std::size_t count = 0;
};

std::size_t bytes_of(VoxelType type);

/// Errors at "/data": truncated or damaged; numbers that are not whole or not from 0 to 65535.
Expected<std::vector<std::uint16_t>> read_labels(ByteStream& stream, const VoxelLayout& layout);

/// After the last numbers of a stream: damage that only its checksum shows, at "/data".
Errors check_end(ByteStream& stream);

/// Numbers as words.
Expected<std::vector<std::uint16_t>> read_label_words(std::string_view text, std::size_t count);

}  // namespace coapt
