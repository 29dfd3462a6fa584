#include "io/dicom/segmentation.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/valve/problem_list.h"
#include "io/image/image_geometry.h"

namespace coapt {
namespace {

constexpr long kMostSegmentFrames = 100'000, kMostSegments = 255;
constexpr double kOffGrid = 0.1;    // of a slice's distance
constexpr double kSameSide = 1e-3;  // of unit vectors
constexpr double kMostOverlap = 0.05;

Error not_read(const std::string& message) { return {ErrorCode::Unsupported, "", message}; }

std::optional<Vec3> vector(DcmItem& item, const DcmTagKey& tag, unsigned long from = 0) {
  Vec3 found;
  for (unsigned long i = 0; i < 3; ++i)
    if (item.findAndGetFloat64(tag, found[static_cast<Index>(i)], from + i).bad()) return {};
  return found;
}

/// Item 0 of a sequence in the group of one frame, else in that of all.
DcmItem* group_item(DcmItem* frame, DcmItem* shared, const DcmTagKey& sequence) {
  DcmItem* item = nullptr;
  for (DcmItem* group : {frame, shared})
    if (group != nullptr && group->findAndGetSequenceItem(sequence, item).good()) return item;
  return nullptr;
}

struct Frame {
  int segment = 0;
  Vec3 position_mm = Vec3::Zero();  ///< of the first voxel's centre
};

class SegmentationReader {
 public:
  explicit SegmentationReader(DcmDataset& data) : data_(data) {}

  Expected<LabelMap> read() {
    if (Errors errors = read_header(); !errors.empty()) return errors;
    if (Errors errors = read_frames(); !errors.empty()) return errors;
    if (Errors errors = place(); !errors.empty()) return errors;
    if (Errors errors = read_voxels(); !errors.empty()) return errors;
    read_names();
    return std::move(map_);
  }

 private:
  Errors read_header() {
    OFString kind, type;
    data_.findAndGetOFString(DCM_SOPClassUID, kind);
    if (kind != UID_SegmentationStorage) return {not_read("is no DICOM segmentation")};
    data_.findAndGetOFString(DCM_SegmentationType, type);
    Uint16 bits = 0;
    data_.findAndGetUint16(DCM_BitsAllocated, bits);
    if (type != "BINARY" || bits != 1)
      return {not_read("must be a binary segmentation, not a fractional one")};
    data_.findAndGetUint16(DCM_Rows, rows_);
    data_.findAndGetUint16(DCM_Columns, columns_);
    if (rows_ == 0 || columns_ == 0) return {not_read("has no images")};
    return {};
  }

  Errors read_frames() {
    DcmItem *shared = nullptr, *frame = nullptr;
    data_.findAndGetSequenceItem(DCM_SharedFunctionalGroupsSequence, shared);
    for (long i = 0;
         i <= kMostSegmentFrames &&
         data_.findAndGetSequenceItem(DCM_PerFrameFunctionalGroupsSequence, frame, i).good();
         ++i) {
      Frame& read = frames_.emplace_back();
      Uint16 segment = 0;
      if (DcmItem* item = group_item(frame, shared, DCM_SegmentIdentificationSequence))
        item->findAndGetUint16(DCM_ReferencedSegmentNumber, segment);
      DcmItem* plane = group_item(frame, shared, DCM_PlanePositionSequence);
      const auto position = plane ? vector(*plane, DCM_ImagePositionPatient) : std::nullopt;
      if (segment < 1 || segment > kMostSegments || !position)
        return {not_read("must say of every frame where it lies and its segment, from 1 to 255")};
      read = {segment, *position};
      DcmItem* orientation = group_item(frame, shared, DCM_PlaneOrientationSequence);
      DcmItem* measures = group_item(frame, shared, DCM_PixelMeasuresSequence);
      if (orientation == nullptr || measures == nullptr)
        return {not_read("does not say the size of its voxels or their directions")};
      const auto along_row = vector(*orientation, DCM_ImageOrientationPatient),
                 along_column = vector(*orientation, DCM_ImageOrientationPatient, 3);
      Float64 down = 0.0, across = 0.0;
      measures->findAndGetFloat64(DCM_PixelSpacing, down, 0);
      measures->findAndGetFloat64(DCM_PixelSpacing, across, 1);
      if (measures->findAndGetFloat64(DCM_SpacingBetweenSlices, apart_mm_).bad())
        measures->findAndGetFloat64(DCM_SliceThickness, apart_mm_);
      if (!along_row || !along_column ||
          (i > 0 && ((*along_row - along_row_).norm() > kSameSide ||
                     (*along_column - along_column_).norm() > kSameSide)))
        return {not_read("must have frames of one orientation")};
      along_row_ = *along_row;
      along_column_ = *along_column;
      map_.to_lps_mm.block<3, 1>(0, 0) = across * along_row_;
      map_.to_lps_mm.block<3, 1>(0, 1) = down * along_column_;
    }
    if (frames_.empty() || std::ssize(frames_) > kMostSegmentFrames)
      return {not_read("must have 1 to 100,000 frames")};
    return {};
  }

  /// The grid that all frames lie in.
  Errors place() {
    const Vec3 normal = along_row_.cross(along_column_);
    std::vector<double> heights;
    for (const Frame& frame : frames_) heights.push_back(normal.dot(frame.position_mm));
    const auto lowest = std::min_element(heights.begin(), heights.end());
    const double span = *std::max_element(heights.begin(), heights.end()) - *lowest;
    const Vec3 origin = frames_[static_cast<std::size_t>(lowest - heights.begin())].position_mm;
    map_.to_lps_mm.block<3, 1>(0, 2) = apart_mm_ * normal;
    map_.to_lps_mm.block<3, 1>(0, 3) = origin;
    map_.placed = true;
    ProblemList problems;
    check_voxel_steps(map_.to_lps_mm, "", problems);
    if (!problems.empty())
      return {not_read("has voxels outside 0.01 to 20 mm, or does not say their size")};
    const Index plane = Index{rows_} * columns_;
    if (!(span / apart_mm_ < static_cast<double>(kMostVoxels / plane)))
      return {not_read("is larger than 134,217,728 voxels")};
    map_.size = {columns_, rows_, std::lround(span / apart_mm_) + 1};
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      const long slice = std::lround((heights[i] - *lowest) / apart_mm_);
      const Vec3 off =
          frames_[i].position_mm - origin - static_cast<double>(slice) * apart_mm_ * normal;
      if (off.norm() > kOffGrid * apart_mm_)
        return {not_read("must have frames at equal distances, above each other")};
      slices_.push_back(slice);
    }
    return {};
  }

  Errors read_voxels() {
    const auto plane = static_cast<std::size_t>(rows_) * columns_;
    const Uint8* bits = nullptr;
    unsigned long bytes = 0;
    if (data_.findAndGetUint8Array(DCM_PixelData, bits, &bytes).bad() || bits == nullptr ||
        bytes < (plane * frames_.size() + 7) / 8)
      return {not_read("is truncated, or its pixels are compressed")};
    map_.voxels.assign(plane * static_cast<std::size_t>(map_.size[2]), 0);
    std::map<int, Index> voxels;
    Index twice = 0;
    for (std::size_t i = 0; i < frames_.size(); ++i)
      for (std::size_t k = 0; k < plane; ++k) {
        const std::size_t bit = i * plane + k;
        if ((bits[bit / 8] >> (bit % 8) & 1) == 0) continue;
        ++voxels[frames_[i].segment];
        std::uint16_t& voxel = map_.voxels[static_cast<std::size_t>(slices_[i]) * plane + k];
        twice += voxel != 0 ? 1 : 0;
        if (voxel == 0) voxel = static_cast<std::uint16_t>(frames_[i].segment);
      }
    Index smallest = 0;
    for (const auto& [segment, count] : voxels)
      smallest = smallest == 0 ? count : std::min(smallest, count);
    if (static_cast<double>(twice) > kMostOverlap * static_cast<double>(smallest))
      return {not_read("has segments that overlap; save them as .seg.nrrd")};
    return {};
  }

  void read_names() {
    DcmItem* segment = nullptr;
    for (long i = 0;
         i < kMostSegments && data_.findAndGetSequenceItem(DCM_SegmentSequence, segment, i).good();
         ++i) {
      Uint16 number = 0;
      OFString label, meaning;
      segment->findAndGetUint16(DCM_SegmentNumber, number);
      segment->findAndGetOFString(DCM_SegmentLabel, label);
      DcmItem* type = nullptr;
      if (segment->findAndGetSequenceItem(DCM_SegmentedPropertyTypeCodeSequence, type).good())
        type->findAndGetOFString(DCM_CodeMeaning, meaning);
      map_.names.push_back({0, number, std::string(label.c_str()) + ' ' + meaning.c_str()});
    }
  }

  DcmDataset& data_;
  Uint16 rows_ = 0, columns_ = 0;
  Vec3 along_row_ = Vec3::UnitX(), along_column_ = Vec3::UnitY();
  Float64 apart_mm_ = 0.0;
  std::vector<Frame> frames_;
  std::vector<long> slices_;  ///< of each frame
  LabelMap map_;
};

}  // namespace

Expected<LabelMap> read_dicom_segmentation(const std::string& path) {
  OFLog::configure(OFLogger::OFF_LOG_LEVEL);  // what it would say may hold names
  DcmFileFormat file;
  if (file.loadFile(path.c_str()).bad())
    return Error{ErrorCode::InputOutput, "", "is a DICOM file that is damaged"};
  return SegmentationReader(*file.getDataset()).read();
}

}  // namespace coapt
