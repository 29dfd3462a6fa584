#include "io/exchange/mesh_leaflets.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

TriangleMesh triangle(double x) {
  TriangleMesh mesh{Points(3, 3), Faces(1, 3), {}};
  mesh.vertices_mm << x, 0, 0, x + 1, 0, 0, x, 1, 0;
  mesh.faces << 0, 1, 2;
  return mesh;
}

MeshParts parts(const std::vector<std::string>& names) {
  MeshParts all;
  all.told_apart_by = "objects";
  for (const std::string& name : names)
    all.parts.push_back({name, triangle(static_cast<double>(all.parts.size())), {}});
  return all;
}

TEST(MeshLeaflets, ByNameInAnyOrder) {
  const Expected<MeshLeaflets> found = leaflets_of(parts({"Posterior", "ANTERIOR_LEAFLET"}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->order.claim, LeafletClaim::Named);
  EXPECT_EQ(found->leaflets[0].vertices_mm(0, 0), 1.0);
  EXPECT_EQ(found->order.called[0], "part 2");
}

TEST(MeshLeaflets, TwoWithoutNamesAreLeftToAnatomy) {
  const Expected<MeshLeaflets> found = leaflets_of(parts({"", "DOE"}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->order.claim, LeafletClaim::Guessed);
  for (const ImportDecision& decision : found->decisions)
    EXPECT_EQ(sentence(decision).find("DOE"), std::string::npos);
}

TEST(MeshLeaflets, ScallopsMakeALeaflet) {
  const Expected<MeshLeaflets> found = leaflets_of(parts({"P1", "A2", "P2", "A1", "P3", "A3"}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->leaflets[0].faces.rows(), 3);
  EXPECT_EQ(found->leaflets[1].faces.rows(), 3);
  EXPECT_EQ(found->order.called[1], "parts 1, 3 and 5");
}

TEST(MeshLeaflets, ALineIsTheAnnulusAndWhatIsLeftIsSaid) {
  MeshParts all = parts({"anterior", "posterior", "left ventricle"});
  all.parts.push_back({"", {Points(0, 3), Faces(0, 3), {}}, Points::Random(20, 3)});
  const Expected<MeshLeaflets> found = leaflets_of(std::move(all));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->annulus_mm.rows(), 20);
  EXPECT_NE(found->decisions.back().value.find("not used: part 3"), std::string::npos)
      << found->decisions.back().value;
}

TEST(MeshLeaflets, AThirdLeafletAndThreePartsAreRefused) {
  EXPECT_EQ(leaflets_of(parts({"anterior", "posterior", "septal"})).errors()[0].code,
            ErrorCode::Unsupported);
  EXPECT_FALSE(leaflets_of(parts({"", "", ""})));
  const Expected<MeshLeaflets> both =
      leaflets_of(parts({"mitral anterior", "mitral posterior", "tricuspid septal leaflet"}));
  ASSERT_TRUE(both) << "the mitral ones are named so";
  EXPECT_NE(both->decisions.back().value.find("not used: part 3"), std::string::npos);
}

TEST(MeshLeaflets, NumbersThatAreGivenGoBeforeNames) {
  const Expected<MeshLeaflets> found =
      leaflets_of(parts({"anterior", "posterior", ""}), {{2}, {1}, {}});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->order.claim, LeafletClaim::Given);
  EXPECT_EQ(found->leaflets[0].vertices_mm(0, 0), 1.0);
  EXPECT_EQ(found->order.swap, "say --label anterior=1 --label posterior=2");
  ASSERT_EQ(found->parts.size(), 3U);
  EXPECT_EQ(found->parts[0].part, "posterior");
  EXPECT_EQ(found->parts[2].part, "");
  const Expected<MeshLeaflets> one = leaflets_of(parts({"anterior", ""}), {{2}, {}, {}});
  ASSERT_TRUE(one);
  EXPECT_EQ(one->leaflets[0].vertices_mm(0, 0), 1.0);
}

TEST(MeshLeaflets, APartThatIsNotThereIsNamed) {
  const auto refused = [](const LabelNumbers& given) {
    return leaflets_of(parts({"", ""}), given).errors()[0].path;
  };
  EXPECT_EQ(refused({{3}, {}, {}}), "/label_numbers/anterior");
  EXPECT_EQ(refused({{1}, {1}, {}}), "/label_numbers");
}

}  // namespace
}  // namespace coapt
