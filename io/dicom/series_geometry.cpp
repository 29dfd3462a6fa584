// DICOM PS3.3 C.7.6.2 (image plane), C.7.6.16.2 (functional groups of multi-frame images), C.8.24.3 (plane of an ultrasound
// volume, which need not be tied to the patient).

#include "io/dicom/series_geometry.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <fstream>
#include <optional>

namespace coapt {
namespace {

constexpr std::size_t kMostFiles = 10'000;
constexpr long kMostFrames = 10'000;
constexpr double kSameDirection = 1e-3, kSameSpacing = 0.02;  // of unit vectors; of the distance

/// One image, or one frame of an image.
struct Slice {
  std::array<Index, 2> size = {0, 0};  ///< columns, rows
  std::optional<Vec3> position_mm;     ///< of the first pixel's centre
  Vec3 along_row = Vec3::UnitX(), along_column = Vec3::UnitY();
  bool oriented = false;                          ///< to the patient
  std::array<double, 2> spacing_mm = {0.0, 0.0};  ///< from column to column, from row to row
  double thickness_mm = 0.0;  ///< distance to the next one, as the file says; 0: it does not
  std::string series;         ///< compared, never shown
};

std::optional<std::vector<double>> numbers(DcmItem& item, const DcmTagKey& tag, unsigned count) {
  std::vector<double> list(count);
  for (unsigned i = 0; i < count; ++i)
    if (item.findAndGetFloat64(tag, list[i], i).bad()) return {};
  return list;
}

void read_plane(DcmItem& item, const DcmTagKey& tag, std::optional<Vec3>& position_mm) {
  if (const auto list = numbers(item, tag, 3))
    position_mm = Vec3((*list)[0], (*list)[1], (*list)[2]);
}

bool read_directions(DcmItem& item, const DcmTagKey& tag, Slice& slice) {
  const auto list = numbers(item, tag, 6);
  if (!list) return false;
  slice.along_row = Vec3((*list)[0], (*list)[1], (*list)[2]);
  slice.along_column = Vec3((*list)[3], (*list)[4], (*list)[5]);
  return true;
}

void read_spacing(DcmItem& item, Slice& slice) {
  if (const auto list = numbers(item, DCM_PixelSpacing, 2))
    slice.spacing_mm = {(*list)[1], (*list)[0]};
  if (const auto between = numbers(item, DCM_SpacingBetweenSlices, 1))
    slice.thickness_mm = (*between)[0];
  else if (const auto thickness = numbers(item, DCM_SliceThickness, 1))
    slice.thickness_mm = (*thickness)[0];
}

/// What a functional group of all frames or of one says.
void read_group(DcmItem& group, Slice& slice) {
  DcmItem* item = nullptr;
  if (group.findAndGetSequenceItem(DCM_PixelMeasuresSequence, item).good())
    read_spacing(*item, slice);
  if (group.findAndGetSequenceItem(DCM_PlaneOrientationSequence, item).good())
    slice.oriented = read_directions(*item, DCM_ImageOrientationPatient, slice) || slice.oriented;
  if (group.findAndGetSequenceItem(DCM_PlanePositionSequence, item).good())
    read_plane(*item, DCM_ImagePositionPatient, slice.position_mm);
  if (group.findAndGetSequenceItem(DCM_PlaneOrientationVolumeSequence, item).good())
    (void)read_directions(*item, DCM_ImageOrientationVolume, slice);
  if (group.findAndGetSequenceItem(DCM_PlanePositionVolumeSequence, item).good())
    read_plane(*item, DCM_ImagePositionVolume, slice.position_mm);
}

Error refused(const std::string& message) { return {ErrorCode::BadGeometry, "", message}; }

Errors read_file(const std::string& path, std::vector<Slice>& slices) {
  DcmFileFormat file;
  if (file.loadFileUntilTag(path.c_str(), EXS_Unknown, EGL_noChange, 4096, ERM_autoDetect,
                            DCM_PixelData)
          .bad())
    return {Error{ErrorCode::InputOutput, "", "has a DICOM file that is damaged"}};
  DcmDataset& data = *file.getDataset();
  Slice slice;
  Uint16 rows = 0, columns = 0;
  data.findAndGetUint16(DCM_Rows, rows);
  data.findAndGetUint16(DCM_Columns, columns);
  if (rows == 0 || columns == 0) return {};  // no image: a report, a directory
  slice.size = {columns, rows};
  OFString series;
  data.findAndGetOFString(DCM_SeriesInstanceUID, series);
  slice.series = series.c_str();
  slice.oriented = read_directions(data, DCM_ImageOrientationPatient, slice);
  read_plane(data, DCM_ImagePositionPatient, slice.position_mm);
  read_spacing(data, slice);
  DcmItem* shared = nullptr;
  if (data.findAndGetSequenceItem(DCM_SharedFunctionalGroupsSequence, shared).good())
    read_group(*shared, slice);
  DcmItem* frame = nullptr;
  if (data.findAndGetSequenceItem(DCM_PerFrameFunctionalGroupsSequence, frame, 0).bad()) {
    slices.push_back(slice);
    return {};
  }
  for (long i = 0;
       data.findAndGetSequenceItem(DCM_PerFrameFunctionalGroupsSequence, frame, i).good(); ++i) {
    if (i == kMostFrames) return {refused("has an image of more than 10,000 frames")};
    slices.push_back(slice);
    read_group(*frame, slices.back());
  }
  return {};
}

/// All in one grid?
Errors check(const std::vector<Slice>& slices) {
  const Slice& first = slices.front();
  for (const Slice& slice : slices) {
    if (slice.series != first.series)
      return {refused("has images of several series; must hold only one, so remove the others")};
    if (slice.size != first.size || slice.oriented != first.oriented ||
        slice.spacing_mm != first.spacing_mm ||
        (slice.along_row - first.along_row).norm() > kSameDirection ||
        (slice.along_column - first.along_column).norm() > kSameDirection ||
        slice.position_mm.has_value() != first.position_mm.has_value())
      return {refused("has images of different size, spacing or direction; must form one volume")};
  }
  const bool square = std::abs(first.along_row.norm() - 1.0) < kSameDirection &&
                      std::abs(first.along_column.norm() - 1.0) < kSameDirection &&
                      std::abs(first.along_row.dot(first.along_column)) < kSameDirection;
  if (!square) return {refused("has row and column directions that are not orthogonal")};
  return {};
}

/// From each image to the next one, equal for all.
Expected<Vec3> step_mm(const std::vector<Slice>& slices, const Vec3& normal) {
  const Slice& first = slices.front();
  if (slices.size() == 1 || !first.position_mm) return Vec3(first.thickness_mm * normal);
  const Vec3 step =
      (*slices.back().position_mm - *first.position_mm) / static_cast<double>(slices.size() - 1);
  for (std::size_t i = 0; i < slices.size(); ++i) {
    const Vec3 off = *slices[i].position_mm - *first.position_mm - static_cast<double>(i) * step;
    if (!(off.norm() <= kSameSpacing * step.norm() + 1e-9) || !(step.norm() > 0.0))
      return refused(
          "has images at unequal distances, or several at one position (phases of the cardiac "
          "cycle?); must form one volume");
  }
  return step;
}

}  // namespace

bool is_dicom_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(132, '\0');
  return file.read(head.data(), 132) && head.substr(128) == "DICM";
}

Expected<ImageGeometry> read_series_geometry(const std::vector<std::string>& paths) {
  OFLog::configure(OFLogger::OFF_LOG_LEVEL);  // what it would say may hold names
  std::vector<Slice> slices;
  if (paths.size() > kMostFiles) return refused("has more than the 10,000 files accepted");
  for (const std::string& path : paths)
    if (is_dicom_file(path))
      if (Errors errors = read_file(path, slices); !errors.empty()) return errors;
  if (slices.empty()) return Error{ErrorCode::MissingField, "", "has no DICOM image"};
  if (Errors errors = check(slices); !errors.empty()) return errors;
  const Slice first = slices.front();
  const Vec3 normal = first.along_row.cross(first.along_column);
  if (first.position_mm)
    std::stable_sort(slices.begin(), slices.end(), [&](const Slice& a, const Slice& b) {
      return normal.dot(*a.position_mm) < normal.dot(*b.position_mm);
    });
  const Expected<Vec3> step = step_mm(slices, normal);
  if (!step) return step.errors();
  ImageGeometry image;
  image.size = {first.size[0], first.size[1], std::ssize(slices)};
  image.placed = first.oriented && first.position_mm.has_value();
  image.to_lps_mm.block<3, 1>(0, 0) = first.spacing_mm[0] * first.along_row;
  image.to_lps_mm.block<3, 1>(0, 1) = first.spacing_mm[1] * first.along_column;
  image.to_lps_mm.block<3, 1>(0, 2) = *step;
  if (image.placed) image.to_lps_mm.block<3, 1>(0, 3) = *slices.front().position_mm;
  ProblemList problems;
  check_voxel_steps(image.to_lps_mm, "", problems);
  if (!problems.empty())
    return refused(
        "does not state its voxel size (pixel spacing and distance between images), or states one "
        "outside 0.01 to 20 mm");
  return image;
}

}  // namespace coapt
