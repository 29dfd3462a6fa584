#include "io/mesh/gltf.h"

#include <gtest/gtest.h>

#include <numbers>

#include "io/json/json.h"
#include "io/mesh/little_endian.h"
#include "io/mesh/mesh_parts.h"

namespace coapt {
namespace {

/// A triangle (0 0 0), (1 0 0), (0 2 0) in a buffer of 36 bytes, and its corners 0, 1, 2 in the next 6.
std::string buffer() {
  std::string bytes;
  for (const float number : {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 2.0F, 0.0F})
    append_little_endian(bytes, number);
  for (const int corner : {0, 1, 2})
    append_little_endian(bytes, static_cast<std::uint16_t>(corner));
  return bytes;
}

/// Of one node per name, with the triangle.
Json triangles(const std::vector<std::string>& names) {
  Json document = Json::parse(R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[]}],"nodes":[],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
                 {"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],
    "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
    "buffers":[{"byteLength":42,"uri":"triangle.bin"}]})");
  for (std::size_t i = 0; i < names.size(); ++i) {
    document["scenes"][0]["nodes"].push_back(i);
    document["nodes"].push_back({{"name", names[i]}, {"mesh", 0}});
  }
  return document;
}

std::string file(const Json& document) { return gltf_with_buffer(document.dump(), buffer()); }

GroupedMesh read(const Json& document) {
  Expected<GroupedMesh> mesh = read_gltf(file(document));
  EXPECT_TRUE(mesh) << (mesh ? "" : mesh.errors()[0].path + mesh.errors()[0].message);
  return mesh ? *std::move(mesh) : GroupedMesh{};
}

std::string path_of_problem(const std::string& bytes) {
  const Expected<GroupedMesh> mesh = read_gltf(bytes);
  return mesh ? "none" : mesh.errors()[0].path;
}

TEST(Gltf, NodesWithMeshesAreNamedParts) {
  const Expected<MeshParts> parts =
      read_mesh_parts(file(triangles({"Anterior leaflet", "P2"})), "glb", 0);
  ASSERT_TRUE(parts) << parts.errors()[0].message;
  ASSERT_EQ(parts->parts.size(), 2U);
  EXPECT_TRUE(parts->parts[0].name.starts_with("Anterior leaflet"));
  EXPECT_TRUE(parts->parts[1].name.starts_with("P2"));
  EXPECT_EQ(parts->parts[1].mesh.vertices_mm.row(2), Eigen::RowVector3d(0, 2, 0));
}

TEST(Gltf, AMeshLiesWhereItsNodesPutIt) {
  Json document = triangles({"leaf"});
  const double half = std::numbers::sqrt2 / 2.0;
  document["nodes"][0]["translation"] = {10, 0, 0};
  document["nodes"][0]["scale"] = {3, 1, 1};
  document["nodes"].push_back({{"children", {0}}, {"rotation", {0, 0, half, half}}});
  document["scenes"][0]["nodes"] = {1};
  // (1 0 0) is scaled to (3 0 0), moved to (13 0 0), and turned about z by a quarter.
  EXPECT_TRUE(read(document).mesh.vertices_mm.row(1).isApprox(Eigen::RowVector3d(0, 13, 0), 1e-6));
  document["nodes"][1] = {{"children", {0}},
                          {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 7, 1}}};
  EXPECT_TRUE(read(document).mesh.vertices_mm.row(1).isApprox(Eigen::RowVector3d(13, 0, 7), 1e-6));
}

TEST(Gltf, DefaultWeightsOfMorphTargetsAreShown) {
  Json document = triangles({"leaf"});
  document["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
  EXPECT_EQ(read(document).mesh.vertices_mm(2, 1), 2.0);
  document["meshes"][0]["weights"] = {0.5};
  EXPECT_EQ(read(document).mesh.vertices_mm(2, 1), 3.0);
}

TEST(Gltf, ALoopOfLinesIsALine) {
  Json document = triangles({"leaf", "annulus"});
  document["meshes"].push_back(
      {{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"mode", 2}}}}});
  document["nodes"][1]["mesh"] = 1;
  const Expected<MeshParts> parts = read_mesh_parts(file(document), "glb", 0);
  ASSERT_TRUE(parts);
  ASSERT_EQ(parts->parts.size(), 2U);
  EXPECT_EQ(parts->parts[1].line_mm.rows(), 3);
}

TEST(Gltf, NumbersOfOneByteAreReadAsTheirAccessorSays) {
  Json document = triangles({"leaf"});
  document["accessors"][0] = {{"bufferView", 0}, {"byteOffset", 12},   {"componentType", 5121},
                              {"count", 3},      {"normalized", true}, {"type", "VEC3"}};
  document["bufferViews"][0]["byteStride"] = 4;
  document["extensionsRequired"] = {"KHR_mesh_quantization"};
  // 1.0F is 00 00 80 3F: its third byte is 128 of 255.
  EXPECT_NEAR(read(document).mesh.vertices_mm(0, 2), 128.0 / 255.0, 1e-12);
}

TEST(Gltf, WhatAFileNamesBesideItIsFound) {
  Json document = triangles({"leaf"});
  EXPECT_EQ(**gltf_buffer_file(document.dump()), "triangle.bin");
  document["buffers"][0]["uri"] = "my%20triangle.bin";
  EXPECT_EQ(**gltf_buffer_file(document.dump()), "my triangle.bin");
  EXPECT_EQ(path_of_problem(document.dump()), "/buffers/0");
  for (const char* other : {"../triangle.bin", "/etc/passwd", "a%2Fb.bin", "http://host/b"}) {
    document["buffers"][0]["uri"] = other;
    EXPECT_FALSE(gltf_buffer_file(document.dump())) << other;
  }
  document["buffers"][0]["uri"] = "data:application/octet-stream;base64,AAAA";
  EXPECT_FALSE(*gltf_buffer_file(document.dump()));
}

TEST(Gltf, EveryDamageHasAPlace) {
  const std::vector<std::pair<std::string, Json>> changes = {
      {"/extensionsRequired", {{"extensionsRequired", {"KHR_draco_mesh_compression"}}}},
      {"/asset/version", {{"asset", {{"version", "1.0"}}}}},
      {"/scenes", {{"scene", 3}}},
      {"/accessors/0",
       {{"accessors",
         {{{"bufferView", 0}, {"componentType", 5126}, {"count", 4}, {"type", "VEC3"}}}}}},
      {"/bufferViews/0",
       {{"bufferViews", {{{"buffer", 0}, {"byteOffset", 40}, {"byteLength", 36}}}}}},
      {"/buffers", {{"bufferViews", {{{"buffer", 7}, {"byteLength", 36}}}}}}};
  for (const auto& [path, change] : changes) {
    Json document = triangles({"leaf"});
    document.merge_patch(change);
    const bool is_glb = path != "/asset/version";  // of which no .glb is made
    EXPECT_EQ(path_of_problem(is_glb ? file(document) : document.dump()), path) << change;
  }
  Json document = triangles({"leaf"});
  document["nodes"][0]["children"] = {0};
  EXPECT_EQ(path_of_problem(file(document)), "/nodes");
  document = triangles({"leaf"});
  document["nodes"][0]["skin"] = 0;
  EXPECT_EQ(path_of_problem(file(document)), "/nodes/0/skin");
  document = triangles({"leaf"});
  document["accessors"][0]["sparse"] = Json::object();
  EXPECT_EQ(path_of_problem(file(document)), "/accessors/0");
  const std::string whole = file(triangles({"leaf"}));
  for (std::size_t size = 0; size < whole.size(); size += 7)
    EXPECT_NE(path_of_problem(whole.substr(0, size)), "none") << size;
}

TEST(Gltf, WhatIsNestedDeeplyIsRefused) {
  const std::string open(100'000, '['), closed(100'000, ']');
  EXPECT_FALSE(read_gltf(R"({"asset":{"version":"2.0"},"extras":)" + open + closed + '}'));
}

}  // namespace
}  // namespace coapt
