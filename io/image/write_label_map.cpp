#include "io/image/write_label_map.h"

#include <zlib.h>

#include <bit>
#include <cstring>

#include "core/valve/number_text.h"

namespace coapt {
namespace {

std::string voxels_of(const LabelMap& map) {
  std::string bytes(map.voxels.size(), '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(map.voxels[i]);
  return bytes;
}

std::string gzipped(const std::string& bytes) {
  z_stream stream{};
  deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

std::string vector_text(const Vec3& v) {
  return '(' + significant(v[0], 12) + ',' + significant(v[1], 12) + ',' + significant(v[2], 12) +
         ')';
}

/// Fields of a header, in little-endian order.
class HeaderBytes {
 public:
  explicit HeaderBytes(std::size_t size) : bytes_(size, '\0') {}

  template <class T>
  void put(std::size_t at, T value) {
    static_assert(std::endian::native == std::endian::little);
    std::memcpy(bytes_.data() + at, &value, sizeof value);
  }
  void put_text(std::size_t at, std::string_view text, std::size_t room) {
    std::memcpy(bytes_.data() + at, text.data(), std::min(text.size(), room));
  }
  std::string take() && { return std::move(bytes_); }

 private:
  std::string bytes_;
};

}  // namespace

std::string write_nrrd(const LabelMap& map, const std::string& note) {
  std::string text = "NRRD0004\n";
  if (!note.empty()) text += "# " + note + '\n';
  text += "type: unsigned char\ndimension: 3\n";
  text += "space: left-posterior-superior\nsizes:";
  for (const Index size : map.size) text += ' ' + std::to_string(size);
  text += "\nspace directions:";
  for (Index axis = 0; axis < 3; ++axis)
    text += ' ' + vector_text(map.to_lps_mm.col(axis).head<3>());
  text += "\nkinds: domain domain domain\nendian: little\nencoding: gzip\nspace origin: " +
          vector_text(map.to_lps_mm.col(3).head<3>()) + '\n';
  for (std::size_t i = 0; i < map.names.size(); ++i) {
    const LabelName& label = map.names[i];
    const std::string segment = "Segment" + std::to_string(i) + '_';
    text += segment + "ID:=Segment_" + std::to_string(label.value) + '\n';
    text += segment + "Name:=" + label.name + '\n';
    text += segment + "LabelValue:=" + std::to_string(label.value) + '\n';
    text += segment + "Layer:=0\n" + segment + "Extent:=";
    for (const Index size : map.size)
      text += (text.back() == '=' ? "0 " : " 0 ") + std::to_string(size - 1);
    text += '\n';
  }
  return text + '\n' + gzipped(voxels_of(map));
}

std::string write_nifti(const LabelMap& map, const std::string& note) {
  // Places as nifti1.h has them: 348 bytes, then four that say that no extension follows.
  HeaderBytes header(352);
  header.put<std::int32_t>(0, 348);
  header.put<std::int16_t>(40, 3);
  for (std::size_t i = 0; i < 3; ++i)
    header.put(42 + 2 * i, static_cast<std::int16_t>(map.size[i]));
  for (std::size_t i = 3; i < 7; ++i) header.put<std::int16_t>(42 + 2 * i, 1);
  header.put<std::int16_t>(70, 2);  // unsigned char
  header.put<std::int16_t>(72, 8);
  header.put(76, 1.0F);
  for (std::size_t i = 0; i < 3; ++i)
    header.put(80 + 4 * i,
               static_cast<float>(map.to_lps_mm.col(static_cast<Index>(i)).head<3>().norm()));
  header.put(108, 352.0F);
  header.put<char>(123, 2);  // mm
  header.put_text(148, note, 79);
  header.put<std::int16_t>(254, 1);  // scanner
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      header.put(
          280 + 16 * row + 4 * column,
          static_cast<float>((row < 2 ? -1.0 : 1.0) *
                             map.to_lps_mm(static_cast<Index>(row), static_cast<Index>(column))));
  header.put_text(344, std::string_view("n+1\0", 4), 4);
  return std::move(header).take() + voxels_of(map);
}

std::string write_nifti_gz(const LabelMap& map, const std::string& note) {
  return gzipped(write_nifti(map, note));
}

}  // namespace coapt
