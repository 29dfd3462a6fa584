#include <gtest/gtest.h>

#include <cstring>

#include "io/exchange/valve_glb.h"
#include "io/json/json.h"
#include "still_valve.h"

namespace coapt {
namespace {

template <class T>
T number_at(const std::string& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

Json json_of(const std::string& glb) {
  return Json::parse(glb.substr(20, number_at<std::uint32_t>(glb, 12)));
}

/// Three floats of an accessor's row.
Vec3 vector_of(const std::string& glb, int accessor, int row) {
  const Json json = json_of(glb);
  const std::size_t view = json["accessors"][static_cast<std::size_t>(accessor)]["bufferView"];
  const std::size_t binary = 20 + number_at<std::uint32_t>(glb, 12) + 8;
  const std::size_t at = binary + json["bufferViews"][view]["byteOffset"].get<std::size_t>() +
                         static_cast<std::size_t>(12 * row);
  return {number_at<float>(glb, at), number_at<float>(glb, at + 4), number_at<float>(glb, at + 8)};
}

TEST(Glb, TheHeaderSaysHowLongTheFileIs) {
  const std::string glb = write_glb(still_valve());
  EXPECT_EQ(glb.substr(0, 4), "glTF");
  EXPECT_EQ(number_at<std::uint32_t>(glb, 4), 2U);
  EXPECT_EQ(number_at<std::uint32_t>(glb, 8), glb.size());
  EXPECT_EQ(glb.size() % 4, 0U);
}

TEST(Glb, PointsAreMetresWithTheAtriumUp) {
  const ClosedValve exported = still_valve();
  const std::string glb = write_glb(exported);
  const Json json = json_of(glb);
  const int position = json["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
  const int sheet = json["accessors"][static_cast<std::size_t>(position)]["count"].get<int>() / 2;
  const auto middle = [&](int vertex) -> Vec3 {
    return 0.5 * (vector_of(glb, position, vertex) + vector_of(glb, position, vertex + sheet));
  };
  const auto thickness = [&](int vertex) {
    return (vector_of(glb, position, vertex) - vector_of(glb, position, vertex + sheet)).norm();
  };
  // Face 0 begins with vertex 0, at (18, 0, 0) mm; its third corner is vertex 8: (13.5, 0, -8).
  EXPECT_LT((middle(0) - Vec3(0.018, 0.0, 0.0)).norm(), 1e-7);
  EXPECT_LT((middle(2) - Vec3(0.0135, -0.008, 0.0)).norm(), 1e-7);
  EXPECT_NEAR(thickness(2), 0.001, 1e-8);
  // Vertex 1 of the face is vertex 1: y anterior becomes -z.
  EXPECT_LT(middle(1).z(), -0.009);
}

TEST(Glb, TheMotionIsATargetAndEndsInTheClosedValve) {
  const std::string glb = write_glb(still_valve());
  const Json json = json_of(glb);
  const Json& primitive = json["meshes"][0]["primitives"][0];
  ASSERT_EQ(primitive["targets"].size(), 1U);
  const int target = primitive["targets"][0]["POSITION"];
  EXPECT_LT((vector_of(glb, target, 5) - Vec3(0.0, 0.002, 0.0)).norm(), 1e-8);
  ASSERT_EQ(json["animations"].size(), 1U);
  EXPECT_EQ(json["animations"][0]["channels"].size(), 3U);  // leaflets and chordae
  ASSERT_EQ(json["nodes"].size(), 4U);
  EXPECT_EQ(json["nodes"][1]["name"], "anterior leaflet");
  EXPECT_EQ(json["nodes"][2]["name"], "posterior leaflet");
}

TEST(Glb, ColoursEndWhereSegmentsDo) {
  const Json json = json_of(write_glb(still_valve()));
  int count = 0;
  for (const std::size_t leaflet : {0, 1}) {
    const std::size_t colours = json["meshes"][leaflet]["primitives"][0]["attributes"]["COLOR_0"];
    count += json["accessors"][colours]["count"].get<int>();
  }
  // Above and below: six blocks of segments round the valve, each with one column of three vertices more than columns: 8 + 6 columns.
  EXPECT_EQ(count, 2 * 3 * (8 + 6));
}

TEST(Glb, LeafletsHaveRimsWhereTheValveEndsAndNotWhereTheyMeet) {
  const ClosedValve exported = still_valve();
  const Json json = json_of(write_glb(exported));
  int triangles = 0;
  for (const std::size_t leaflet : {0, 1}) {
    const std::size_t indices = json["meshes"][leaflet]["primitives"][0]["indices"];
    triangles += json["accessors"][indices]["count"].get<int>() / 3;
  }
  // Two sides, and two triangles at each of the eight edges of the annulus and of the free edge.
  EXPECT_EQ(triangles, 2 * exported.valve.faces.rows() + 2 * (8 + 8));
}

TEST(Glb, TheOpenValveIsStillAndTheNoticeIsInIt) {
  const Json json = json_of(write_open_glb(still_valve()));
  EXPECT_FALSE(json.contains("animations"));
  EXPECT_FALSE(json["meshes"][0].contains("weights"));
  EXPECT_NE(json["asset"]["copyright"].get<std::string>().find("research software"),
            std::string::npos);
  EXPECT_EQ(json["asset"]["extras"]["provenance"][0], "made by hand for tests");
}

TEST(Glb, ARingAndASutureAreAMeshOfTheirOwn) {
  ClosedValve exported = still_valve();
  exported.plan.steps = {
      Annuloplasty{OwnRing{1}},
      PapillaryApproximation{Side::Anterolateral, Anchor::SaddlePeak, 0.25, 20.0}};
  const Json json = json_of(write_glb(exported));
  ASSERT_EQ(json["meshes"].size(), 4U);
  EXPECT_EQ(json["meshes"][3]["name"], "repair");
  const std::size_t position = json["meshes"][3]["primitives"][0]["attributes"]["POSITION"];
  EXPECT_EQ(json["accessors"][position]["count"], 12 * (8 + 1));
}

}  // namespace
}  // namespace coapt
