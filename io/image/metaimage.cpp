// MetaImage (itk.org/Wiki/MetaIO/Documentation): lines "Key = value", of which the last one is ElementDataFile, then the
// voxels. Directions are LPS, one vector after the other.

#include "io/image/metaimage.h"

#include <map>
#include <optional>

#include "core/valve/problem_list.h"
#include "io/image/image_geometry.h"
#include "io/image/label_phases.h"
#include "io/image/voxel_stream.h"
#include "io/mesh/text_scan.h"

namespace coapt {
namespace {

constexpr int kMostHeaderLines = 1000;

struct MetaHeader {
  std::map<std::string, std::string, std::less<>> fields;
  std::string_view data;
  std::string_view field(std::string_view name) const {
    const auto found = fields.find(name);
    return found == fields.end() ? std::string_view() : found->second;
  }
  bool is_true(std::string_view name) const {
    const std::string_view value = field(name);
    return value == "True" || value == "true" || value == "1";
  }
};

std::optional<VoxelType> meta_type_of(std::string_view name) {
  static const std::map<std::string_view, VoxelType> kTypes = {
      {"MET_CHAR", VoxelType::Int8},       {"MET_UCHAR", VoxelType::Uint8},
      {"MET_SHORT", VoxelType::Int16},     {"MET_USHORT", VoxelType::Uint16},
      {"MET_INT", VoxelType::Int32},       {"MET_UINT", VoxelType::Uint32},
      {"MET_LONG", VoxelType::Int32},      {"MET_ULONG", VoxelType::Uint32},
      {"MET_LONG_LONG", VoxelType::Int64}, {"MET_ULONG_LONG", VoxelType::Uint64},
      {"MET_FLOAT", VoxelType::Float32},   {"MET_DOUBLE", VoxelType::Float64}};
  const auto found = kTypes.find(name);
  if (found == kTypes.end()) return {};
  return found->second;
}

Expected<MetaHeader> meta_header_of(std::string_view bytes) {
  MetaHeader header;
  LineScanner lines(bytes);
  for (auto line = lines.next(); line && line->number <= kMostHeaderLines; line = lines.next()) {
    const std::string_view text = trimmed(line->text);
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) break;
    const std::string key(trimmed(text.substr(0, equals)));
    header.fields[key] = trimmed(text.substr(equals + 1));
    if (key != "ElementDataFile") continue;
    header.data = lines.rest();
    return header;
  }
  return Error{ErrorCode::InputOutput, "",
               "is not a MetaImage, or is truncated: its header must end with ElementDataFile"};
}

/// The numbers of a field; empty if one is none.
std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> list;
  for (const std::string_view word : words(text)) {
    const auto number = to_number(word);
    if (!number) return {};
    list.push_back(*number);
  }
  return list;
}

class MetaImageReader {
 public:
  MetaImageReader(MetaHeader header, Index most_voxels, int phase)
      : header_(std::move(header)), most_voxels_(most_voxels), phase_(phase) {}

  Expected<LabelMap> read() {
    if (header_.field("ElementDataFile") != "LOCAL")
      return Error{ErrorCode::Unsupported, "/ElementDataFile",
                   "names another file; provide it together with this one, or save as .mha"};
    read_size();
    if (problems_.empty()) read_geometry();
    if (!problems_.empty()) return std::move(problems_).take();
    if (Errors errors = read_voxels(); !errors.empty()) return errors;
    return std::move(map_);
  }

 private:
  void read_size() {
    const std::vector<double> size = numbers_in(header_.field("DimSize"));
    axes_ = size.size();
    bool good = axes_ == 3 || axes_ == 4;
    Index voxels = 1;
    for (std::size_t i = 0; good && i < 3; ++i) {
      good = size[i] >= 1.0 && size[i] <= static_cast<double>(most_voxels_ / voxels);
      if (!good) break;
      map_.size[i] = static_cast<Index>(size[i]);
      voxels *= map_.size[i];
    }
    if (good && axes_ == 4) {
      good = size[3] >= 1.0 && size[3] <= kMostPhases;
      if (good) map_.phases = static_cast<int>(size[3]);
    }
    if (!good)
      problems_.add(ErrorCode::OutOfRange, "/DimSize",
                    "must be three numbers, or four with the phases, of at most " +
                        std::to_string(most_voxels_) + " voxels");
    if (const auto channels = header_.field("ElementNumberOfChannels");
        !channels.empty() && channels != "1")
      problems_.add(ErrorCode::Unsupported, "/ElementNumberOfChannels", "must be 1");
  }

  void read_geometry() {
    auto spacing = numbers_in(header_.field("ElementSpacing"));
    if (spacing.empty()) spacing = numbers_in(header_.field("ElementSize"));
    if (spacing.size() != axes_)
      return problems_.add(ErrorCode::MissingField, "/ElementSpacing",
                           "must have as many numbers as DimSize, to define the voxel size");
    auto directions = first_of({"TransformMatrix", "Rotation", "Orientation"});
    const auto offset = first_of({"Offset", "Position", "Origin"});
    map_.placed = directions.size() == axes_ * axes_;
    for (Index axis = 0; axis < 3; ++axis)
      for (Index k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(axis) * axes_ + static_cast<std::size_t>(k);
        const double cosine = map_.placed ? directions[at] : axis == k ? 1.0 : 0.0;
        map_.to_lps_mm(k, axis) = spacing[static_cast<std::size_t>(axis)] * cosine;
      }
    if (offset.size() == axes_)
      for (std::size_t k = 0; k < 3; ++k) map_.to_lps_mm(static_cast<Index>(k), 3) = offset[k];
    check_voxel_steps(map_.to_lps_mm, "/ElementSpacing", problems_);
  }

  std::vector<double> first_of(std::initializer_list<std::string_view> names) const {
    for (const std::string_view name : names)
      if (const auto found = header_.field(name); !found.empty()) return numbers_in(found);
    return {};
  }

  Errors read_voxels() {
    const std::optional<VoxelType> type = meta_type_of(header_.field("ElementType"));
    if (!type)
      return {Error{ErrorCode::Unsupported, "/ElementType",
                    "must be a type of whole numbers (MET_CHAR to MET_ULONG_LONG), MET_FLOAT or "
                    "MET_DOUBLE"}};
    VoxelLayout layout;
    layout.type = *type;
    layout.order =
        header_.is_true("BinaryDataByteOrderMSB") || header_.is_true("ElementByteOrderMSB")
            ? std::endian::big
            : std::endian::little;
    layout.count = static_cast<std::size_t>(map_.size[0] * map_.size[1] * map_.size[2]);
    std::string_view data = header_.data;
    const bool packed = header_.is_true("CompressedData");
    const std::size_t needed =
        layout.count * bytes_of(*type) * static_cast<std::size_t>(map_.phases);
    if (const auto skipped = to_integer(header_.field("HeaderSize"))) {
      if (*skipped == -1 && !packed && data.size() >= needed)
        data.remove_prefix(data.size() - needed);
      else if (*skipped > 0 && *skipped <= static_cast<long long>(data.size()))
        data.remove_prefix(static_cast<std::size_t>(*skipped));
    }
    if (header_.field("BinaryData") == "False")
      return {Error{ErrorCode::Unsupported, "/BinaryData", "must be True"}};
    ByteStream stream(data, packed ? Packing::Zlib : Packing::None);
    return read_phase(stream, layout, phase_, most_voxels_, map_);
  }

  MetaHeader header_;
  Index most_voxels_;
  int phase_;
  std::size_t axes_ = 3;
  LabelMap map_;
  ProblemList problems_;
};

}  // namespace

Expected<LabelMap> read_metaimage(std::string_view bytes, Index most_voxels, int phase) {
  Expected<MetaHeader> header = meta_header_of(bytes);
  if (!header) return header.errors();
  return MetaImageReader(*std::move(header), most_voxels, phase).read();
}

}  // namespace coapt
