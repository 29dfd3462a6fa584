#include "io/dicom/segmentation.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

namespace coapt {
namespace {

namespace fs = std::filesystem;

struct Written {
  std::vector<int> segments = {1, 1, 2};  ///< of each frame of 4 x 2 pixels
  std::vector<const char*> heights = {"5", "9", "9"};
  std::vector<Uint8> bits = {0x01, 0x80, 0x0E, 0};  ///< a byte a frame
  const char* type = "BINARY";
  const char* kind = UID_SegmentationStorage;
};

DcmItem& item(DcmItem& of, const DcmTagKey& sequence, long at = 0) {
  DcmItem* found = nullptr;
  of.findOrCreateSequenceItem(sequence, found, at);
  return *found;
}

Expected<LabelMap> read(const Written& written) {
  DcmFileFormat file;
  DcmDataset& data = *file.getDataset();
  data.putAndInsertString(DCM_SOPClassUID, written.kind);
  data.putAndInsertString(DCM_SOPInstanceUID, "1.2.3");
  data.putAndInsertString(DCM_SegmentationType, written.type);
  data.putAndInsertUint16(DCM_BitsAllocated, 1);
  data.putAndInsertUint16(DCM_Rows, 2);
  data.putAndInsertUint16(DCM_Columns, 4);
  DcmItem& shared = item(data, DCM_SharedFunctionalGroupsSequence);
  item(shared, DCM_PlaneOrientationSequence)
      .putAndInsertString(DCM_ImageOrientationPatient, "1\\0\\0\\0\\0\\-1");
  DcmItem& measures = item(shared, DCM_PixelMeasuresSequence);
  measures.putAndInsertString(DCM_PixelSpacing, "0.5\\0.6");
  measures.putAndInsertString(DCM_SliceThickness, "2");
  for (std::size_t i = 0; i < written.segments.size(); ++i) {
    DcmItem& frame = item(data, DCM_PerFrameFunctionalGroupsSequence, static_cast<long>(i));
    item(frame, DCM_SegmentIdentificationSequence)
        .putAndInsertUint16(DCM_ReferencedSegmentNumber, static_cast<Uint16>(written.segments[i]));
    item(frame, DCM_PlanePositionSequence)
        .putAndInsertString(DCM_ImagePositionPatient,
                            (std::string("-3\\") + written.heights[i] + "\\7").c_str());
  }
  for (long k = 0; k < 2; ++k) {
    DcmItem& segment = item(data, DCM_SegmentSequence, k);
    segment.putAndInsertUint16(DCM_SegmentNumber, static_cast<Uint16>(k + 1));
    segment.putAndInsertString(DCM_SegmentLabel, k == 0 ? "Anterior leaflet" : "P2");
  }
  data.putAndInsertUint8Array(DCM_PixelData, written.bits.data(), written.bits.size());
  const fs::path path =
      fs::temp_directory_path() / ("coapt-segmentation-" + std::to_string(getpid()) + ".dcm");
  file.saveFile(path.c_str(), EXS_LittleEndianExplicit);
  Expected<LabelMap> map = read_dicom_segmentation(path);
  fs::remove(path);
  return map;
}

TEST(DicomSegmentation, BitsOfFramesAreVoxelsWhereTheyLie) {
  const Expected<LabelMap> map = read({});
  ASSERT_TRUE(map) << map.errors()[0].message;
  // Rows lead along x, columns along -z, so slices along y: frames at 5 and 9 mm, of 2 mm, with an empty one between.
  EXPECT_EQ(map->size, (std::array<Index, 3>{4, 2, 3}));
  EXPECT_TRUE(map->placed);
  EXPECT_TRUE(map->centre_mm(0, 0, 0).isApprox(Vec3(-3, 5, 7)));
  EXPECT_TRUE(map->centre_mm(1, 1, 2).isApprox(Vec3(-2.4, 9, 6.5)));
  std::vector<std::uint16_t> voxels(24, 0);
  voxels[0] = 1;
  voxels[23] = 1;
  voxels[17] = voxels[18] = voxels[19] = 2;
  EXPECT_EQ(map->voxels, voxels);
  ASSERT_EQ(map->names.size(), 2U);
  EXPECT_EQ(map->names[1].value, 2);
  EXPECT_TRUE(map->names[1].name.starts_with("P2"));
}

TEST(DicomSegmentation, WhatIsNoBinarySegmentationInAGridIsRefused) {
  EXPECT_FALSE(read({.kind = UID_CTImageStorage}));
  EXPECT_FALSE(read({.type = "FRACTIONAL"}));
  EXPECT_FALSE(read({.heights = {"5", "5.9", "9"}}));
  EXPECT_FALSE(read({.bits = {0x01, 0x80}})) << "truncated";
  EXPECT_FALSE(read({.segments = {1, 1, 0}}));
  EXPECT_FALSE(read({.bits = {0x01, 0x0E, 0x0E, 0}})) << "two segments in the same voxels";
}

}  // namespace
}  // namespace coapt
