#include "io/image/nrrd.h"

#include <bzlib.h>
#include <gtest/gtest.h>

#include <cstring>

#include "io/image/label_map.h"

namespace coapt {
namespace {

const std::string kHead =
    "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 1\nspace: left-posterior-superior\n"
    "space directions: (0.5,0,0) (0,0.6,0) (0,0,0.7)\nspace origin: (1,2,3)\n";

std::string with(std::string text, const std::string& old, const std::string& other) {
  return text.replace(text.find(old), old.size(), other);
}

Error error_of(const std::string& bytes, Index most = kMostVoxels) {
  const Expected<LabelMap> map = read_nrrd(bytes, most);
  return map ? Error{ErrorCode::Busy, "none", ""} : map.errors().front();
}

TEST(Nrrd, RawVoxelsWithTheirFrame) {
  const Expected<LabelMap> map =
      read_nrrd(kHead + "encoding: raw\n\n" + std::string("\0\1\2\3", 4));
  ASSERT_TRUE(map) << map.errors()[0].message;
  EXPECT_EQ(map->size, (std::array<Index, 3>{2, 2, 1}));
  EXPECT_EQ(map->voxels, (std::vector<std::uint16_t>{0, 1, 2, 3}));
  EXPECT_TRUE(map->placed);
  EXPECT_TRUE(map->centre_mm(1, 1, 1).isApprox(Vec3(1.5, 2.6, 3.7)));
}

TEST(Nrrd, ShearedDirectionsAreDoubted) {
  const std::string voxels = "encoding: raw\n\n" + std::string("\0\1\2\3", 4);
  EXPECT_EQ(read_nrrd(kHead + voxels)->frame_doubt, "");
  const Expected<LabelMap> map = read_nrrd(with(kHead, "(0,0,0.7)", "(0.2,0,0.67)") + voxels);
  ASSERT_TRUE(map);
  EXPECT_NE(map->frame_doubt.find("17 degrees off a right angle"), std::string::npos)
      << map->frame_doubt;
}

TEST(Nrrd, UnitsOfAFileThatAreNotMillimetresAreConverted) {
  const std::string bytes = kHead + "encoding: ascii\n\n0 1\n2 3\n";
  const auto in = [&](const std::string& units) {
    return read_nrrd(with(bytes, "encoding", "space units: " + units + "\nencoding"));
  };
  EXPECT_TRUE(in("\"cm\" \"mm\" \"\"")->centre_mm(1, 1, 1).isApprox(Vec3(15.0, 2.6, 3.7)));
  ASSERT_FALSE(in("\"mm\" \"mm\" \"pixel\""));
  EXPECT_EQ(in("\"mm\" \"mm\" \"pixel\"").errors()[0].path, "/space units");
  const Expected<LabelMap> phases = read_nrrd(
      "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 1 2 1 1\nkinds: time domain domain domain\n"
      "spacings: 20 0.5 0.6 0.7\nunits: \"ms\" \"cm\" \"cm\" \"cm\"\nencoding: ascii\n\n0 1\n");
  ASSERT_TRUE(phases) << phases.errors()[0].message;
  EXPECT_TRUE(phases->centre_mm(1, 0, 0).isApprox(Vec3(5.0, 0.0, 0.0)));
}

TEST(Nrrd, OtherSpacesAreTurnedToLps) {
  const std::string bytes = kHead + "encoding: ascii\n\n0 1\n2 3\n";
  const auto corner = [&](const std::string& space) {
    const Expected<LabelMap> map = read_nrrd(with(bytes, "left-posterior-superior", space));
    return map ? map->centre_mm(1, 1, 1) : Vec3::Zero().eval();
  };
  EXPECT_TRUE(corner("LPS").isApprox(Vec3(1.5, 2.6, 3.7)));
  EXPECT_TRUE(corner("right-anterior-superior").isApprox(Vec3(-1.5, -2.6, 3.7)));
  EXPECT_TRUE(corner("left-anterior-superior").isApprox(Vec3(1.5, -2.6, 3.7)));
}

TEST(Nrrd, WithoutASpaceOnlyTheVoxelsSizeIsKnown) {
  const Expected<LabelMap> map = read_nrrd(
      "NRRD0001\ntype: short\ndimension: 3\nsizes: 2 1 1\nspacings: 0.5 0.6 0.7\nendian: big\n"
      "encoding: raw\n\n" +
      std::string("\1\2\0\3", 4));
  ASSERT_TRUE(map) << map.errors()[0].message;
  EXPECT_FALSE(map->placed);
  EXPECT_EQ(map->voxels, (std::vector<std::uint16_t>{258, 3}));
  EXPECT_TRUE(map->centre_mm(1, 1, 1).isApprox(Vec3(0.5, 0.6, 0.7)));
}

TEST(Nrrd, LayersOfSlicerAreSortedAndItsSegmentsNamed) {
  std::string bytes = with(kHead, "dimension: 3\nsizes: 2 2 1", "dimension: 4\nsizes: 2 2 2 1");
  bytes = with(bytes, "(0.5,0,0)", "none (0.5,0,0)") + "kinds: list domain domain domain\n" +
          "Segment0_Name:=Anterior leaflet\nSegment0_LabelValue:=4\nSegment0_Layer:=1\n"
          "Segment1_Name:=ring\nSegment1_LabelValue:=1\nSegment1_Layer:=0\n"
          "PatientName:=DOE^JANE\nencoding: raw\n\n" +
          std::string("\1\4\0\4\1\0\0\0", 8);
  const Expected<LabelMap> map = read_nrrd(bytes);
  ASSERT_TRUE(map) << map.errors()[0].message;
  EXPECT_EQ(map->layers, 2);
  EXPECT_EQ(map->voxels, (std::vector<std::uint16_t>{1, 0, 1, 0, 4, 4, 0, 0}));
  ASSERT_EQ(map->names.size(), 2U);
  EXPECT_EQ(map->names[0].name, "Anterior leaflet");
  EXPECT_EQ(map->names[0].value, 4);
  EXPECT_EQ(map->names[0].layer, 1);
  const std::vector<LabelAt> labels = labels_of(*map);
  ASSERT_EQ(labels.size(), 2U);
  EXPECT_EQ(labels[1].layer, 1);
  EXPECT_EQ(labels[1].value, 4);
}

TEST(Nrrd, AListWithoutNamesIsOfPhasesWhereOneIsAskedFor) {
  const std::string list =
      with(with(kHead, "dimension: 3\nsizes: 2 2 1", "dimension: 4\nsizes: 2 2 2 1"), "(0.5,0,0)",
           "none (0.5,0,0)") +
      "kinds: list domain domain domain\n";
  const std::string data = "encoding: raw\n\n" + std::string("\1\4\0\4\1\0\0\0", 8);
  const Expected<LabelMap> second = read_nrrd(list + data, kMostVoxels, 2);
  ASSERT_TRUE(second) << second.errors()[0].message;
  EXPECT_EQ(second->phases, 2);
  EXPECT_EQ(second->phase, 2);
  EXPECT_EQ(second->voxels, (std::vector<std::uint16_t>{4, 4, 0, 0}));
  EXPECT_EQ(read_nrrd(list + data, kMostVoxels, 3).errors()[0].path, "/phase");
  EXPECT_EQ(read_nrrd(list + data)->layers, 2);
  const std::string named = "Segment0_Name:=ring\nSegment0_LabelValue:=1\n";
  EXPECT_EQ(read_nrrd(list + named + data, kMostVoxels, 2)->layers, 2) << "they are segments";
}

std::string bzipped(std::string bytes) {
  std::string packed(1000, '\0');
  auto size = static_cast<unsigned>(packed.size());
  BZ2_bzBuffToBuffCompress(packed.data(), &size, bytes.data(), static_cast<unsigned>(bytes.size()),
                           9, 0, 0);
  return packed.substr(0, size);
}

TEST(Nrrd, Bzip2InOneStreamOrSeveralCutShortAnywhere) {
  const std::string head = kHead + "encoding: bzip2\n\n", voxels("\0\1\2\3", 4);
  for (const std::string& packed :
       {bzipped(voxels), bzipped(voxels.substr(0, 2)) + bzipped(voxels.substr(2))}) {
    const Expected<LabelMap> map = read_nrrd(head + packed);
    ASSERT_TRUE(map) << map.errors()[0].message;
    EXPECT_EQ(map->voxels, (std::vector<std::uint16_t>{0, 1, 2, 3}));
    for (std::size_t size = 0; size + 20 < packed.size(); ++size)
      EXPECT_EQ(error_of(head + packed.substr(0, size)).path, "/data") << size;
  }
}

TEST(Nrrd, AFileThatIsCompressedAsAWholeIsReadAsItself) {
  const std::string plain = kHead + "encoding: raw\n\n" + std::string("\0\1\2\3", 4);
  const std::string packed = bzipped(plain);
  const Expected<LabelMap> map = read_label_map(packed);
  ASSERT_TRUE(map) << map.errors()[0].message;
  EXPECT_EQ(map->voxels, (std::vector<std::uint16_t>{0, 1, 2, 3}));
  EXPECT_FALSE(read_label_map(packed.substr(0, packed.size() / 2)));
  EXPECT_FALSE(read_label_map(bzipped("no map at all")));
  const auto bomb = read_label_map(bzipped(kHead + std::string(std::size_t{17} << 20, '\7')), 4);
  ASSERT_FALSE(bomb);
  EXPECT_NE(bomb.errors()[0].message.find("16 MiB"), std::string::npos);
}

TEST(Nrrd, WhatIsWrongIsNamed) {
  const std::string good = kHead + "encoding: ascii\n\n0 1 2 3";
  EXPECT_EQ(error_of("P6").code, ErrorCode::Unsupported);
  EXPECT_EQ(error_of(kHead).code, ErrorCode::InputOutput);
  EXPECT_EQ(error_of(with(good, "0 1 2 3", "0 1 2")).path, "/data");
  EXPECT_EQ(error_of(with(good, "0 1 2 3", "0 1 2 -3")).code, ErrorCode::OutOfRange);
  EXPECT_EQ(error_of(with(good, "0 1 2 3", "0 1 2 3.5")).code, ErrorCode::OutOfRange);
  EXPECT_EQ(error_of(with(good, "2 2 1", "2 2")).path, "/sizes");
  EXPECT_EQ(error_of(with(good, "2 2 1", "2 2 0")).path, "/sizes");
  EXPECT_EQ(error_of(with(good, "2 2 1", "9223372036854775807 9223372036854775807 2")).path,
            "/sizes");
  EXPECT_EQ(error_of(good, 3).path, "/sizes");
  EXPECT_EQ(error_of(with(good, "uchar", "block")).path, "/type");
  EXPECT_EQ(error_of(with(good, "uchar", "float")).path, "none");
  EXPECT_EQ(error_of(with(good, "ascii", "hex")).path, "/encoding");
  EXPECT_EQ(error_of(with(good, "left-posterior-superior", "inner")).path, "/space");
  EXPECT_EQ(error_of(with(good, "(0.5,0,0)", "(0.5,0)")).path, "/space directions");
  EXPECT_EQ(error_of(with(good, "(0.5,0,0)", "(0,0,0)")).path, "/space directions/0");
  EXPECT_EQ(error_of(with(good, "(0.5,0,0)", "(0,0.5,0)")).path, "/space directions");
  EXPECT_EQ(error_of(with(good, "(0.5,0,0)", "(nan,0.5,0)")).path, "/space directions/0");
  EXPECT_EQ(error_of(with(good, "encoding", "data file: other.raw\nencoding")).path, "/data file");
  EXPECT_EQ(error_of(with(good, "encoding", "line skip: -3\nencoding")).path, "/byte skip");
}

}  // namespace
}  // namespace coapt
