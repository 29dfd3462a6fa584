// One label map as nibabel, VTK and teem's unu write it (write_image_files.py).
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>

#include "io/image/label_map.h"

namespace coapt {
namespace {

namespace fs = std::filesystem;

const fs::path kFiles = fs::path(COAPT_SOURCE_DIR) / "tests/io/image/files";

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Eigen::Matrix3d axes() {
  return (Eigen::AngleAxisd(std::numbers::pi / 9, Vec3::UnitX()) *
          Eigen::AngleAxisd(std::numbers::pi / 6, Vec3::UnitZ()))
             .toRotationMatrix() *
         Vec3(0.5, 0.6, 0.8).asDiagonal();
}

void expect_labels(const LabelMap& map, const std::string& name) {
  EXPECT_EQ(map.size, (std::array<Index, 3>{6, 5, 4})) << name;
  std::vector<std::uint16_t> labels;
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 5; ++j)
      for (int i = 0; i < 6; ++i)
        labels.push_back(static_cast<std::uint16_t>((i + 2 * j + 3 * k) % 4));
  EXPECT_EQ(map.voxels, labels) << name;
}

TEST(ImageFiles, OfOtherProgramsHaveTheirLabelsAndTheirPlace) {
  for (const char* name :
       {"sform.nii.gz", "qform.nii", "big-endian.nii", "nifti-2.nii.gz", "real-numbers.nii.gz",
        "vtk.nii.gz", "raw.nrrd", "gzip.nrrd", "ascii.nrrd"}) {
    const Expected<LabelMap> map = read_label_map(bytes_of(kFiles / name));
    ASSERT_TRUE(map) << name << map.errors()[0].path << map.errors()[0].message;
    expect_labels(*map, name);
    EXPECT_TRUE(map->placed) << name;
    for (const Vec3& at : {Vec3(0, 0, 0), Vec3(5, 0, 0), Vec3(0, 4, 0), Vec3(0, 0, 3)})
      EXPECT_LT((map->centre_mm(at.x(), at.y(), at.z()) - (Vec3(12.5, -40.25, 310.0) + axes() * at))
                    .norm(),
                1e-4)
          << name;
  }
}

TEST(ImageFiles, WithoutAFrameKnowTheirVoxelsSize) {
  for (const char* name : {"no-frame.nii.gz", "no-frame.nrrd"}) {
    const Expected<LabelMap> map = read_label_map(bytes_of(kFiles / name));
    ASSERT_TRUE(map) << name << map.errors()[0].message;
    expect_labels(*map, name);
    EXPECT_FALSE(map->placed) << name;
    EXPECT_LT((map->centre_mm(1, 1, 1) - Vec3(0.5, 0.6, 0.8)).norm(), 1e-6) << name;
  }
}

TEST(ImageFiles, DamageThatOnlyAChecksumShowsIsRefused) {
  std::string bytes = bytes_of(kFiles / "gzip.nrrd");
  ASSERT_TRUE(read_label_map(bytes + std::string(16, '\0'))) << "padded";
  bytes[bytes.size() - 8] ^= 1;  // the first byte of the checksum
  const Expected<LabelMap> damaged = read_label_map(bytes);
  ASSERT_FALSE(damaged);
  EXPECT_NE(damaged.errors()[0].message.find("checksum"), std::string::npos);
}

TEST(ImageFiles, CutShortAnywhereAreRefused) {
  for (const fs::path& path : fs::directory_iterator(kFiles)) {
    if (fs::is_directory(path)) continue;
    const std::string bytes = bytes_of(path);
    // The end of a packed file has its checksum.
    const bool packed = path.extension() == ".gz" || path == kFiles / "gzip.nrrd";
    for (std::size_t length = 0; length + (packed ? 0 : 2) < bytes.size(); ++length)
      EXPECT_FALSE(read_label_map(std::string_view(bytes).substr(0, length))) << path << length;
  }
}

}  // namespace
}  // namespace coapt
