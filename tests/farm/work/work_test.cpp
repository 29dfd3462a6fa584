#include "farm/work/work.h"

#include <gtest/gtest.h>

#include "farm/work/work_file.h"

namespace coapt {
namespace {

TEST(WorkFile, HoldsAnyBytes) {
  const std::string zeros("\0\n\0", 3);
  const WorkRequest request{"orifices", {"{}", "", zeros, "coapt.work/1 plans 3\n"}};
  EXPECT_EQ(write_work({"plans", {"{}", "ab"}}), "coapt.work/1 plans 2\n2\n{}2\nab");
  const Expected<WorkRequest> back = read_work(write_work(request));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->kind, request.kind);
  EXPECT_EQ(back->parts, request.parts);
}

TEST(WorkFile, CutAnywhereOrOfAnotherKindItIsRefused) {
  const std::string bytes = write_work({"plans", {"{}", "ab"}});
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(read_work(std::string_view(bytes).substr(0, size))) << size;
  for (const char* wrong :
       {"coapt.work/2 plans 0\n", "coapt.work/1 plans\n", "coapt.work/1  0\n",
        "coapt.work/1 plans -1\n", "coapt.work/1 plans 1\n99999999999999999999\n",
        "coapt.work/1 plans 0\nx"})
    EXPECT_FALSE(read_work(wrong)) << wrong;
}

TEST(Work, IsNamedByKindAndEveryByte) {
  const WorkRequest request{"plans", {"{}", "ab"}};
  EXPECT_EQ(work_id(request).size(), 64u);
  EXPECT_EQ(work_id(request), work_id({"plans", {"{}", "ab"}}));
  EXPECT_NE(work_id(request), work_id({"orifices", {"{}", "ab"}}));
  EXPECT_NE(work_id(request), work_id({"plans", {"{}a", "b"}}));
  // printf 'plans\n%s\n%s' $(printf '{}' | sha256sum | head -c 64) $(printf ab | sha256sum | head -c 64) | sha256sum
  EXPECT_EQ(work_id(request), "c6f7ecee30d52a4f924354e5623dcb268534096cbdfaab42c01df15e798fc259");
  EXPECT_NE(work_revision().find("closures"), std::string::npos);
}

TEST(Work, OfAnUnknownKindOrWithoutPartsIsRefused) {
  EXPECT_EQ(open_work({"weather", {"{}"}}).errors().front().code, ErrorCode::Unsupported);
  EXPECT_EQ(open_work({"plans", {}}).errors().front().code, ErrorCode::MissingField);
  EXPECT_FALSE(open_work({"plans", {"not JSON"}}));
}

}  // namespace
}  // namespace coapt
