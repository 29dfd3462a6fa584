#include "io/image/metaimage.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include "io/image/detached.h"
#include "io/image/nifti.h"
#include "io/image/nrrd.h"
#include "io/image/write_label_map.h"

namespace coapt {
namespace {

const std::string kMetaHead =
    "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
    "CompressedData = False\nTransformMatrix = 0 1 0 -1 0 0 0 0 1\nOffset = 10 20 30\n"
    "ElementSpacing = 0.5 0.6 0.7\nDimSize = 2 2 1\nElementType = MET_UCHAR\n";
const std::string kFourVoxels("\0\1\2\3", 4);

std::string exchanged(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  compress(reinterpret_cast<Bytef*>(out.data()), &size,
           reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  out.resize(size);
  return out;
}

TEST(MetaImage, DirectionsFollowEachOtherAndLeadToLps) {
  const Expected<LabelMap> map =
      read_metaimage(kMetaHead + "ElementDataFile = LOCAL\n" + kFourVoxels);
  ASSERT_TRUE(map) << map.errors()[0].message;
  EXPECT_EQ(map->voxels, (std::vector<std::uint16_t>{0, 1, 2, 3}));
  EXPECT_TRUE(map->placed);
  EXPECT_LT((map->centre_mm(1, 0, 0) - Vec3(10, 20.5, 30)).norm(), 1e-12);
  EXPECT_LT((map->centre_mm(0, 1, 0) - Vec3(9.4, 20, 30)).norm(), 1e-12);
}

TEST(MetaImage, MayBePackedByZlib) {
  const std::string head = exchanged(kMetaHead, "CompressedData = False", "CompressedData = True");
  const Expected<LabelMap> map =
      read_label_map(head + "ElementDataFile = LOCAL\n" + deflated(kFourVoxels));
  ASSERT_TRUE(map) << map.errors()[0].message;
  EXPECT_EQ(map->voxels, (std::vector<std::uint16_t>{0, 1, 2, 3}));
}

TEST(MetaImage, WhatIsMissingIsNamed) {
  const std::string end = "ElementDataFile = LOCAL\n";
  EXPECT_EQ(read_metaimage(kMetaHead).errors()[0].code, ErrorCode::InputOutput);
  EXPECT_EQ(read_metaimage(kMetaHead + "ElementDataFile = x.raw\n").errors()[0].path,
            "/ElementDataFile");
  EXPECT_EQ(read_metaimage(kMetaHead + end + "\1").errors()[0].path, "/data");
  EXPECT_EQ(
      read_metaimage(exchanged(kMetaHead, "2 2 1", "2 2000000 1000000") + end).errors()[0].path,
      "/DimSize");
  EXPECT_EQ(read_metaimage(exchanged(kMetaHead, "0.5 0.6 0.7", "0.5") + end).errors()[0].path,
            "/ElementSpacing");
  EXPECT_EQ(read_metaimage(exchanged(kMetaHead, "MET_UCHAR", "MET_OTHER") + end).errors()[0].path,
            "/ElementType");
}

TEST(MetaImage, OfSeveralPhasesTheFirstWithLabelsOrTheOneAskedFor) {
  std::string head = exchanged(kMetaHead, "NDims = 3", "NDims = 4");
  head = exchanged(head, "0 1 0 -1 0 0 0 0 1", "0 1 0 0 -1 0 0 0 0 0 1 0 0 0 0 1");
  head = exchanged(head, "10 20 30", "10 20 30 0");
  head = exchanged(head, "0.5 0.6 0.7", "0.5 0.6 0.7 1");
  head = exchanged(head, "2 2 1", "2 2 1 3") + "ElementDataFile = LOCAL\n" + std::string(4, '\0') +
         kFourVoxels + std::string(4, '\5');
  const Expected<LabelMap> map = read_metaimage(head);
  ASSERT_TRUE(map) << map.errors()[0].message;
  EXPECT_EQ(map->phase, 2);
  EXPECT_EQ(map->phases, 3);
  EXPECT_EQ(map->voxels[3], 3);
  EXPECT_EQ(read_metaimage(head, kMostVoxels, 3)->voxels[0], 5);
  EXPECT_EQ(read_metaimage(head, kMostVoxels, 4).errors()[0].path, "/phase");
}

TEST(Detached, VoxelsAreJoinedToEitherHeader) {
  const std::string mhd = kMetaHead + "ElementDataFile = voxels.raw\n";
  EXPECT_EQ(*data_file_of(mhd), std::optional<std::string>("voxels.raw"));
  EXPECT_EQ(read_metaimage(attached(mhd, kFourVoxels))->voxels[3], 3);
  const std::string nhdr =
      "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 1\nspacings: 1 1 1\n"
      "data file: voxels.raw\nencoding: raw\n";
  for (const std::string end : {"", "\n", "\n\n", "\nbehind the header\ndata file: other.raw\n"}) {
    EXPECT_EQ(*data_file_of(nhdr + end), std::optional<std::string>("voxels.raw"));
    const Expected<LabelMap> map = read_nrrd(attached(nhdr + end, kFourVoxels));
    ASSERT_TRUE(map) << map.errors()[0].message;
    EXPECT_EQ(map->voxels[3], 3);
  }
}

TEST(Detached, NoFileOfAnotherFolderAndNoListIsTaken) {
  for (const std::string name : {"../secret", "/etc/passwd", "a\\b", "LIST", "x%03d.raw 1 9 1"})
    EXPECT_FALSE(data_file_of(kMetaHead + "ElementDataFile = " + name + '\n')) << name;
  EXPECT_EQ(*data_file_of(kMetaHead + "ElementDataFile = LOCAL\n"), std::optional<std::string>());
  EXPECT_EQ(*data_file_of("v 1 2 3\n"), std::optional<std::string>());
}

TEST(Phases, AreAnAxisOfNiftiAndOfNrrd) {
  const std::string nrrd =
      "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 2 2 2 1\nkinds: list domain domain domain\n"
      "space: left-posterior-superior\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\n"
      "encoding: raw\naxis 0 index type:=time\n\n";
  const Expected<LabelMap> map = read_nrrd(nrrd + std::string("\0\1\0\2\0\3\0\4", 8));
  ASSERT_TRUE(map) << map.errors()[0].message;
  EXPECT_EQ(map->phase, 2);
  EXPECT_EQ(map->layers, 1);
  EXPECT_EQ(map->voxels, (std::vector<std::uint16_t>{1, 2, 3, 4}));
}

LabelMap small_map() {
  LabelMap map;
  map.size = {2, 2, 1};
  map.voxels = {0, 1, 2, 3};
  map.to_lps_mm << 0, -0.6, 0, 10, 0.5, 0, 0, 20, 0, 0, 0.7, 30, 0, 0, 0, 1;
  map.placed = true;
  map.names = {{0, 1, "Anterior leaflet"}, {0, 3, "Annulus"}};
  return map;
}

TEST(WriteLabelMap, WhatIsWrittenIsReadAgain) {
  const LabelMap map = small_map();
  for (const std::string& bytes : {write_nrrd(map, "a note"), write_nifti(map, "a note")}) {
    const Expected<LabelMap> read = read_label_map(bytes);
    ASSERT_TRUE(read) << read.errors()[0].message;
    EXPECT_EQ(read->voxels, map.voxels);
    EXPECT_EQ(read->size, map.size);
    EXPECT_TRUE(read->placed);
    EXPECT_LT((read->to_lps_mm - map.to_lps_mm).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_NE(bytes.find("a note"), std::string::npos);
  }
  const Expected<LabelMap> named = read_nrrd(write_nrrd(map, ""));
  ASSERT_EQ(named->names.size(), 2U);
  EXPECT_EQ(named->names[1].name, "Annulus");
  EXPECT_EQ(named->names[1].value, 3);
}

}  // namespace
}  // namespace coapt
