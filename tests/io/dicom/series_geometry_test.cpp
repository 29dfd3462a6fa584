// Series that pydicom wrote (tests/io/image/write_image_files.py).
#include "io/dicom/series_geometry.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <numbers>

namespace coapt {
namespace {

namespace fs = std::filesystem;

const fs::path kImages = fs::path(COAPT_SOURCE_DIR) / "tests/io/image/files";

std::vector<std::string> files_of(const fs::path& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : fs::directory_iterator(folder)) paths.push_back(entry.path());
  return paths;
}

TEST(SeriesGeometry, SlicesAreSortedByPlaceWhateverTheirNames) {
  const Expected<ImageGeometry> image = read_series_geometry(files_of(kImages / "series"));
  ASSERT_TRUE(image) << image.errors()[0].message;
  EXPECT_EQ(image->size, (std::array<Index, 3>{6, 5, 4}));
  EXPECT_TRUE(image->placed);
  const Eigen::Matrix3d axes = (Eigen::AngleAxisd(std::numbers::pi / 9, Vec3::UnitX()) *
                                Eigen::AngleAxisd(std::numbers::pi / 6, Vec3::UnitZ()))
                                   .toRotationMatrix() *
                               Vec3(0.5, 0.6, 0.8).asDiagonal();
  EXPECT_TRUE((image->to_lps_mm.topLeftCorner<3, 3>().isApprox(axes, 1e-9)));
  EXPECT_TRUE((image->to_lps_mm.topRightCorner<3, 1>().isApprox(Vec3(12.5, -40.25, 310.0), 1e-9)));
}

TEST(SeriesGeometry, WithoutTheOrientationOnlySpacingIsKnown) {
  const Expected<ImageGeometry> image =
      read_series_geometry(files_of(kImages / "series-without-orientation"));
  ASSERT_TRUE(image) << image.errors()[0].message;
  EXPECT_FALSE(image->placed);
  EXPECT_TRUE(
      image->to_lps_mm.isApprox(Eigen::Matrix4d(Eigen::Vector4d(0.5, 0.6, 0.8, 1.0).asDiagonal())));
}

TEST(SeriesGeometry, OtherFilesAreNoImages) {
  EXPECT_EQ(read_series_geometry(files_of(kImages)).errors()[0].code, ErrorCode::MissingField);
  EXPECT_EQ(read_series_geometry({}).errors()[0].message, "has no DICOM image");
}

TEST(SeriesGeometry, AMissingSliceAndTwoSeriesAreRefused) {
  std::vector<std::string> paths = files_of(kImages / "series");
  std::erase(paths, (kImages / "series/0.dcm").string());  // the last but one by place
  const Expected<ImageGeometry> gap = read_series_geometry(paths);
  ASSERT_FALSE(gap);
  EXPECT_NE(gap.errors()[0].message.find("unequal distances"), std::string::npos);
  std::vector<std::string> twice = files_of(kImages / "series");
  twice.push_back(twice.front());
  EXPECT_FALSE(read_series_geometry(twice));
}

TEST(SeriesGeometry, DamagedFilesAreRefusedWithoutAWordOfTheirContents) {
  std::ifstream file(kImages / "series/1.dcm", std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(file), {}};
  const fs::path path =
      fs::temp_directory_path() / ("coapt-damaged-" + std::to_string(getpid()) + ".dcm");
  for (std::size_t length = 132; length + 60 < whole.size(); length += 7) {
    std::ofstream(path, std::ios::binary) << whole.substr(0, length);
    const Expected<ImageGeometry> image = read_series_geometry({path});
    if (image) continue;
    for (const char* secret : {"DOE", "MRN", "1948", "Elsewhere"})
      EXPECT_EQ(image.errors()[0].message.find(secret), std::string::npos);
  }
  fs::remove(path);
}

}  // namespace
}  // namespace coapt
