#include "io/store/record_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace coapt {
namespace {

constexpr std::size_t kSize = 4;
const std::string kRecordsId(32, 'a'), kOtherId(32, 'b');

class RecordFiles : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::remove(path_); }
  void TearDown() override { std::filesystem::remove(path_); }

  std::string path_ = (std::filesystem::temp_directory_path() /
                       ("coapt-records-" + std::to_string(getpid()) + ".bin"))
                          .string();
};

TEST_F(RecordFiles, KeepsWholeRecordsOfAProcessThatWasKilledWhileItWrote) {
  {
    Expected<RecordFile> file = RecordFile::open(path_, kRecordsId, kSize);
    ASSERT_TRUE(file);
    EXPECT_EQ(file->records(), "");
    EXPECT_TRUE(file->append("onesTWOS").empty());
  }
  std::ofstream(path_, std::ios::binary | std::ios::app) << "thr";
  {
    Expected<RecordFile> file = RecordFile::open(path_, kRecordsId, kSize);
    ASSERT_TRUE(file);
    EXPECT_EQ(file->records(), "onesTWOS");
    EXPECT_TRUE(file->append("Four").empty());
  }
  EXPECT_EQ(RecordFile::open(path_, kRecordsId, kSize)->records(), "onesTWOSFour");
}

TEST_F(RecordFiles, OfAnotherKindAreRefusedAndNotChanged) {
  ASSERT_TRUE(RecordFile::open(path_, kRecordsId, kSize)->append("ones").empty());
  const auto size = std::filesystem::file_size(path_);
  const Expected<RecordFile> other = RecordFile::open(path_, kOtherId, kSize);
  ASSERT_FALSE(other);
  EXPECT_EQ(other.errors().front().code, ErrorCode::Unsupported);
  EXPECT_EQ(std::filesystem::file_size(path_), size);
}

TEST_F(RecordFiles, ThatCannotBeWrittenAreToldSo) {
  const Expected<RecordFile> file = RecordFile::open("/nowhere/records.bin", kRecordsId, kSize);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.errors().front().code, ErrorCode::InputOutput);
}

}  // namespace
}  // namespace coapt
