#include "farm/work/import_work.h"

#include <gtest/gtest.h>

#include "io/json/valve_json.h"
#include "io/mesh/write_mesh.h"
#include "tests/io/mesh/cone_scene.h"

namespace coapt {
namespace {

/// Two sheets with their contour, and a mesh that is none.
WorkRequest asked() {
  const ImportSource source = cone_source_with_gaps();
  ImportCase cone{"cone", {}};
  for (const TriangleMesh& sheet : source.leaflets)
    cone.files.push_back({"sheet.obj", *write_mesh(sheet, "obj")});
  std::string contour = "x,y,z\n";
  for (const auto point : source.annulus_mm.rowwise())
    contour += std::to_string(point.x()) + ',' + std::to_string(point.y()) + ',' +
               std::to_string(point.z()) + '\n';
  cone.files.push_back({"annulus.csv", contour});
  return imports_request({cone, {"torn", {{"skirt.obj", "f 1 2 3"}}}}, {.seed = 3});
}

TEST(ImportWork, TellsHowFarEachGoesWhateverTheThreads) {
  const Expected<Work> work = open_work(asked());
  ASSERT_TRUE(work) << work.errors().front().message;
  ASSERT_EQ(work->items, 2);
  const std::string bytes = work->compute(0, 2, 2);
  EXPECT_EQ(work->compute(0, 1, 1) + work->compute(1, 1, 1), bytes);
  EXPECT_EQ(work->objection(0, 2, bytes), "");
  const Expected<std::vector<ImportOutcome>> outcomes = import_outcomes(bytes);
  ASSERT_TRUE(outcomes);
  EXPECT_NE(outcomes->front().row["stage"], "refused") << outcomes->front().row;
  const Expected<Valve> valve = read_valve(outcomes->front().valve);
  ASSERT_TRUE(valve);
  EXPECT_EQ(valve->name, "cone");
  EXPECT_EQ(valve->drawn_chordae->seed, 3);
  EXPECT_EQ(outcomes->back().row["stage"], "refused");
  const auto reason = outcomes->back().row["reason"].get<std::string>();
  EXPECT_FALSE(reason.starts_with("/")) << reason;
  EXPECT_EQ(outcomes->back().valve, "");
}

TEST(ImportWork, ObjectsToWhatNoStudyCanShow) {
  const Expected<Work> work = open_work(asked());
  ASSERT_TRUE(work);
  const auto packed = [](const std::string& row, const std::string& valve) {
    std::string bytes;
    for (const std::string& text : {row, valve}) {
      const std::uint64_t size = text.size();
      bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
      bytes += text;
    }
    return bytes;
  };
  const std::string row = R"({"stage": "refused", "reason": "is torn", "looks": []})";
  EXPECT_EQ(work->objection(1, 1, packed(row, "")), "");
  EXPECT_NE(work->objection(1, 1, packed(row, "{}")), "") << "a valve that was refused";
  EXPECT_NE(work->objection(1, 1, packed(row, "").substr(0, 30)), "");
  EXPECT_NE(work->objection(0, 2, packed(row, "")), "") << "one of two";
  for (const char* wrong :
       {"{", "[]", R"({"stage": "refused"})", R"({"stage": "sure", "reason": "", "looks": []})",
        R"({"stage": "refused", "reason": "", "looks": [1]})",
        R"({"stage": "refused", "reason": "", "looks": [], "leak_mm2": "none"})"})
    EXPECT_NE(work->objection(1, 1, packed(wrong, "")), "") << wrong;
  EXPECT_NE(work->objection(
                0, 1, packed(R"({"stage": "closed", "reason": "", "looks": []})", "no valve")),
            "");
}

TEST(ImportWork, NamesWhatIsWrongWithARequest) {
  WorkRequest request = asked();
  request.parts.front() =
      R"({"imports": [{"name": "a", "slicerheart": false, "files": [{"name": "b", "part": 99}]}], "seed": -1, "evaluations": 0})";
  const Expected<Work> work = open_work(request);
  ASSERT_FALSE(work);
  ASSERT_EQ(work.errors().size(), 2u);
  EXPECT_EQ(work.errors()[0].path, "/imports/0/files/0/part");
  EXPECT_EQ(work.errors()[1].path, "/seed");
}

}  // namespace
}  // namespace coapt
