#include "io/image/nifti.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <limits>

#include "io/image/label_map.h"

namespace coapt {
namespace {

template <class T>
void put(std::string& bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof(T));
}

/// 2 x 2 x 1 voxels of one byte, 0.5 x 0.6 x 0.7 mm, without a frame.
std::string plain() {
  std::string bytes(352, '\0');
  put<std::int32_t>(bytes, 0, 348);
  const std::int16_t dim[] = {3, 2, 2, 1, 1, 1, 1, 1};
  std::memcpy(bytes.data() + 40, dim, sizeof dim);
  put<std::int16_t>(bytes, 70, 2);
  const float pixdim[] = {1, 0.5F, 0.6F, 0.7F};
  std::memcpy(bytes.data() + 76, pixdim, sizeof pixdim);
  put<float>(bytes, 108, 352);
  put<float>(bytes, 112, 1);
  bytes[123] = 2;
  std::memcpy(bytes.data() + 344, "n+1", 4);
  return bytes + std::string("\0\1\2\3", 4);
}

/// After one field was changed.
template <class T>
std::string changed(std::size_t at, T value) {
  std::string bytes = plain();
  put<T>(bytes, at, value);
  return bytes;
}

std::string path_of(const std::string& bytes, Index most = kMostVoxels) {
  const Expected<LabelMap> map = read_nifti(bytes, most);
  return map ? "none" : map.errors().front().path;
}

TEST(Nifti, WithoutAFormOnlyTheVoxelsSizeIsKnown) {
  const Expected<LabelMap> map = read_nifti(plain());
  ASSERT_TRUE(map) << map.errors()[0].path;
  EXPECT_FALSE(map->placed);
  EXPECT_EQ(map->voxels, (std::vector<std::uint16_t>{0, 1, 2, 3}));
  EXPECT_TRUE(map->centre_mm(1, 1, 1).isApprox(Vec3(0.5, 0.6, 0.7), 1e-6));
}

TEST(Nifti, QuaternionOfAQuarterTurnLeadsToLps) {
  std::string bytes = changed<std::int16_t>(252, 1);
  put<float>(bytes, 264, std::sqrt(0.5F));  // d: a quarter turn about z, so i leads along y of RAS
  put<float>(bytes, 268, 10.0F);
  const Expected<LabelMap> map = read_nifti(bytes);
  ASSERT_TRUE(map);
  EXPECT_TRUE(map->placed);
  EXPECT_TRUE(map->centre_mm(0, 0, 0).isApprox(Vec3(-10, 0, 0), 1e-6));
  EXPECT_TRUE(map->centre_mm(1, 0, 0).isApprox(Vec3(-10, -0.5, 0), 1e-6));
  put<float>(bytes, 76, -1.0F);  // qfac: slices the other way
  EXPECT_NEAR(read_nifti(bytes)->centre_mm(0, 0, 1).z(), -0.7, 1e-6);
}

/// With rows of the sform that scale by `edges`, and the qform's quaternion of no turn if wanted.
std::string with_rows(const Vec3& edges, bool quaternion, float shear = 0.0F, float shift = 0.0F) {
  std::string bytes = changed<std::int16_t>(254, 1);
  if (quaternion) put<std::int16_t>(bytes, 252, 1);
  for (std::size_t row = 0; row < 3; ++row)
    put<float>(bytes, 280 + 16 * row + 4 * row, static_cast<float>(edges[static_cast<Index>(row)]));
  put<float>(bytes, 280 + 4, shear);
  put<float>(bytes, 280 + 12, shift);
  return bytes;
}

TEST(Nifti, RowsThatContradictPixdimGiveWayToTheQuaternionOrAreRefused) {
  const Vec3 right(0.5, 0.6, 0.7);
  for (const Vec3& wrong : {Vec3(1, 1, 1), Vec3(0.5, 0.6, 0.75), Vec3(5, 6, 7)}) {
    const Expected<LabelMap> map = read_nifti(with_rows(wrong, true));
    ASSERT_TRUE(map) << map.errors()[0].message;
    EXPECT_TRUE(map->centre_mm(1, 1, 1).cwiseAbs().isApprox(right, 1e-6));
    EXPECT_NE(map->frame_doubt.find("the qform is used"), std::string::npos);
    EXPECT_EQ(path_of(with_rows(wrong, false)), "/srow");
  }
  const Expected<LabelMap> same = read_nifti(with_rows(right * 1.001, true));
  ASSERT_TRUE(same);
  EXPECT_EQ(same->frame_doubt, "");
}

TEST(Nifti, AShearOrAnotherPlaceIsDoubted) {
  const Vec3 edges(0.5, 0.6, 0.7);
  EXPECT_NE(read_nifti(with_rows(edges, false, 0.05F))->frame_doubt.find("sheared"),
            std::string::npos);
  EXPECT_NE(read_nifti(with_rows(edges, true, 0.0F, 3.0F))->frame_doubt.find("up to 3 mm"),
            std::string::npos);
}

TEST(Nifti, MetresAreMillimetres) {
  std::string bytes = changed<char>(123, 1);
  const float pixdim[] = {1, 0.0005F, 0.0006F, 0.0007F};
  std::memcpy(bytes.data() + 76, pixdim, sizeof pixdim);
  EXPECT_NEAR(read_nifti(bytes)->centre_mm(1, 0, 0).x(), 0.5, 1e-6);
}

TEST(Nifti, WhatIsWrongIsNamed) {
  EXPECT_EQ(path_of(plain()), "none");
  EXPECT_EQ(path_of(plain().substr(0, 100)), "");
  EXPECT_EQ(path_of(plain().substr(0, 355)), "/data");
  EXPECT_EQ(path_of(changed<std::int32_t>(0, 347)), "");
  EXPECT_EQ(path_of(changed<char>(345, 'i')), "");
  EXPECT_EQ(path_of(changed<std::int16_t>(40, 2)), "/dim");
  EXPECT_EQ(path_of(changed<std::int16_t>(42, -2)), "/dim");
  EXPECT_EQ(path_of(changed<std::int16_t>(42, 32767)), "/data");
  std::string vectors = changed<std::int16_t>(40, 5);
  put<std::int16_t>(vectors, 50, 2);
  EXPECT_EQ(path_of(vectors), "/dim");
  EXPECT_EQ(path_of(plain(), 3), "/dim");
  EXPECT_EQ(path_of(changed<std::int16_t>(70, 128)), "/datatype");
  EXPECT_EQ(path_of(changed<float>(112, 0.5F)), "/scl_slope");
  EXPECT_EQ(path_of(changed<float>(112, std::numeric_limits<float>::quiet_NaN())), "none");
  EXPECT_EQ(path_of(changed<float>(108, std::numeric_limits<float>::infinity())), "/vox_offset");
  EXPECT_EQ(path_of(changed<float>(80, 0.0F)), "/pixdim/0");
  EXPECT_EQ(path_of(changed<float>(80, std::numeric_limits<float>::quiet_NaN())), "/pixdim/0");
  EXPECT_EQ(path_of(changed<std::int16_t>(254, 1)), "/srow/0");
}

TEST(Nifti, WhatUnpacksToMoreThanItSaysIsReadNoFurther) {
  std::string bytes = plain() + std::string(std::size_t{64} << 20, '\7');
  std::string packed(bytes.size() / 100, '\0');
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, 16 + MAX_WBITS, 9, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  ASSERT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  const Expected<LabelMap> map = read_nifti(packed);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->voxels, (std::vector<std::uint16_t>{0, 1, 2, 3}));
  EXPECT_EQ(path_of(packed.substr(0, 20)), "");
}

/// Four volumes of four voxels along `axis`.
std::string four(std::size_t axis, const std::string& voxels) {
  std::string bytes = changed<std::int16_t>(40, static_cast<std::int16_t>(axis));
  put<std::int16_t>(bytes, 40 + 2 * axis, 4);
  return bytes.substr(0, 352) + voxels;
}

TEST(Nifti, OneMaskALabelIsALayerALabelWithoutTheBackground) {
  const std::string masks("\1\1\1\0\0\0\0\1\0\0\0\0\0\0\0\0", 16);
  for (const std::size_t axis : {4U, 5U}) {
    const Expected<LabelMap> map = read_nifti(four(axis, masks));
    ASSERT_TRUE(map) << map.errors()[0].path;
    EXPECT_EQ(map->masks, 4);
    EXPECT_EQ(map->layers, 3) << "the first is the background";
    EXPECT_EQ(map->phases, 1);
    EXPECT_EQ(labels_of(*map).size(), 1U);
  }
  const std::string more("\1\0\0\0\0\1\0\0\0\0\1\0\0\0\0\1", 16);
  const Expected<LabelMap> map = read_nifti(four(4, more));
  ASSERT_TRUE(map);
  EXPECT_EQ(map->masks, 4);
  EXPECT_EQ(map->layers, 4) << "no mask is most of the image";
  EXPECT_EQ(labels_of(*map).size(), 4U);
  EXPECT_EQ(read_nifti(four(4, more), kMostVoxels, 2)->masks, 0) << "a phase was given";
}

TEST(Nifti, PhasesAreNoMasks) {
  for (const std::string& voxels : {std::string("\0\0\0\0\1\2\0\0\1\2\0\0\0\0\0\0", 16),
                                    std::string("\0\0\0\0\1\1\0\0\1\1\0\0\1\1\0\0", 16)}) {
    const Expected<LabelMap> map = read_nifti(four(4, voxels));
    ASSERT_TRUE(map);
    EXPECT_EQ(map->masks, 0);
    EXPECT_EQ(map->phase, 2) << "the first that has labels";
  }
}

}  // namespace
}  // namespace coapt
