#include "io/mesh/gltf.h"

#include <algorithm>

#include "io/json/parse_json.h"
#include "io/mesh/gltf_document.h"
#include "io/mesh/little_endian.h"
#include "io/mesh/mesh_builder.h"

namespace coapt {
namespace {

constexpr std::size_t kMostNodes = 100'000, kMostPrimitives = 10'000;
/// What may be required of a reader of the shapes alone.
constexpr std::array<std::string_view, 5> kHarmless = {
    "KHR_mesh_quantization", "KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_"};
enum GltfMode {
  kGltfPoints,
  kGltfLines,
  kGltfLoop,
  kGltfLineStrip,
  kGltfTriangles,
  kGltfStrip,
  kGltfFan
};

std::string name_in(const Json& object) {
  const Json& name = gltf_member(object, "name");
  return name.is_string() ? name.get<std::string>() : std::string();
}

struct PlacedNode {
  long long index;
  Eigen::Matrix4d placed;  ///< of its parent
};

class GltfReader {
 public:
  GltfReader(Json document, std::string_view binary, const MeshLimits& limits)
      : file_(std::move(document), binary), builder_(limits) {}

  Expected<GroupedMesh> read() {
    check_extensions();
    std::vector<PlacedNode> rest;
    for (const long long root : roots()) rest.push_back({root, Eigen::Matrix4d::Identity()});
    std::reverse(rest.begin(), rest.end());
    std::vector<bool> seen(std::min(gltf_member(file_.root(), "nodes").size(), kMostNodes), false);
    while (!rest.empty() && sound()) {
      const PlacedNode node = rest.back();
      rest.pop_back();
      if (node.index < 0 || node.index >= std::ssize(seen) ||
          seen[static_cast<std::size_t>(node.index)]) {
        file_.problems().add(ErrorCode::BadReference, "/nodes",
                             "must be a tree of at most 100,000 nodes; entry " +
                                 std::to_string(node.index) + " is missing or named twice");
        break;
      }
      seen[static_cast<std::size_t>(node.index)] = true;
      take_node(node, rest);
    }
    return finish();
  }

 private:
  bool sound() { return file_.problems().empty() && !builder_.full(); }

  void check_extensions() {
    const Json& required = gltf_member(file_.root(), "extensionsRequired");
    if (!required.is_array()) return;
    for (const Json& extension : required) {
      const std::string name = extension.is_string() ? extension.get<std::string>() : "";
      if (std::none_of(kHarmless.begin(), kHarmless.end(),
                       [&](std::string_view known) { return name.starts_with(known); }))
        file_.problems().add(ErrorCode::Unsupported, "/extensionsRequired",
                             "has '" + name.substr(0, 60) +
                                 "'; save the file without it (meshes must not be compressed)");
    }
  }

  /// Indices of a list of the object.
  std::vector<long long> indices(const Json& object, const char* name) {
    std::vector<long long> list;
    if (const Json& entries = gltf_member(object, name); entries.is_array())
      for (const Json& entry : entries)
        list.push_back(entry.is_number_unsigned() ? entry.get<std::int64_t>() : -1);
    return list;
  }

  /// Of the scene that is shown; without scenes nodes that are nobody's child.
  std::vector<long long> roots() {
    const Json& root = file_.root();
    if (const Json& scenes = gltf_member(root, "scenes"); scenes.is_array() && !scenes.empty())
      return indices(file_.entry("scenes", file_.whole(root, "scene", 0, "")), "nodes");
    const Json& nodes = gltf_member(root, "nodes");
    std::vector<bool> child(nodes.size(), false);
    for (std::size_t i = 0; nodes.is_array() && i < nodes.size(); ++i)
      for (const long long of : indices(nodes[i], "children"))
        if (of >= 0 && of < std::ssize(child)) child[static_cast<std::size_t>(of)] = true;
    std::vector<long long> found;
    for (std::size_t i = 0; nodes.is_array() && i < child.size(); ++i)
      if (!child[i]) found.push_back(static_cast<long long>(i));
    return found;
  }

  Eigen::Matrix4d placed_by(const Json& node, const std::string& path) {
    if (const auto matrix = file_.numbers(node, "matrix", 16, path))
      return Eigen::Map<const Eigen::Matrix4d>(matrix->data());
    Eigen::Matrix4d placed = Eigen::Matrix4d::Identity();
    if (const auto turn = file_.numbers(node, "rotation", 4, path))
      placed.topLeftCorner<3, 3>() =
          Eigen::Quaterniond((*turn)[3], (*turn)[0], (*turn)[1], (*turn)[2])
              .normalized()
              .toRotationMatrix();
    if (const auto scale = file_.numbers(node, "scale", 3, path))
      placed.topLeftCorner<3, 3>() *= Vec3((*scale)[0], (*scale)[1], (*scale)[2]).asDiagonal();
    if (const auto shift = file_.numbers(node, "translation", 3, path))
      placed.topRightCorner<3, 1>() = Vec3((*shift)[0], (*shift)[1], (*shift)[2]);
    return placed;
  }

  void take_node(const PlacedNode& at, std::vector<PlacedNode>& rest) {
    const std::string path = "/nodes/" + std::to_string(at.index);
    const Json& node = file_.entry("nodes", at.index);
    const Eigen::Matrix4d placed = at.placed * placed_by(node, path);
    const std::vector<long long> children = indices(node, "children");
    for (auto child = children.rbegin(); child != children.rend(); ++child)
      rest.push_back({*child, placed});
    const long long mesh = file_.whole(node, "mesh", -1, path);
    if (mesh < 0) return;
    if (!gltf_member(node, "skin").is_null())
      return file_.problems().add(
          ErrorCode::Unsupported, path + "/skin",
          "must not be there: the mesh follows bones; apply them, and save the "
          "file without");
    take_mesh(file_.entry("meshes", mesh), node, placed);
  }

  void take_mesh(const Json& mesh, const Json& node, const Eigen::Matrix4d& placed) {
    const Json& primitives = gltf_member(mesh, "primitives");
    if (!primitives.is_array()) return;
    const std::string names = name_in(node) + ' ' + name_in(mesh);
    const Json& weights =
        gltf_member(gltf_member(node, "weights").is_null() ? mesh : node, "weights");
    for (const Json& primitive : primitives) {
      if (!sound() || found_.groups.size() == kMostPrimitives) return;
      const auto material = file_.whole(primitive, "material", -1, "/meshes");
      found_.groups.push_back(primitives.size() == 1 || material < 0
                                  ? names
                                  : names + ' ' + name_in(file_.entry("materials", material)));
      take_primitive(primitive, weights, placed);
    }
  }

  /// Positions with the targets that are shown.
  std::vector<double> positions_of(const Json& primitive, const Json& weights) {
    const auto position_of = [&](const Json& attributes) {
      const long long accessor = file_.whole(attributes, "POSITION", -1, "/meshes");
      return accessor < 0 ? std::vector<double>() : file_.array(accessor, "VEC3");
    };
    std::vector<double> positions = position_of(gltf_member(primitive, "attributes"));
    const Json& targets = gltf_member(primitive, "targets");
    for (std::size_t i = 0; targets.is_array() && weights.is_array() && i < weights.size(); ++i) {
      const double weight = weights[i].is_number() ? weights[i].get<double>() : 0.0;
      if (weight == 0.0 || i >= targets.size()) continue;
      const std::vector<double> moved = position_of(targets[i]);
      for (std::size_t k = 0; k < std::min(moved.size(), positions.size()); ++k)
        positions[k] += weight * moved[k];
    }
    return positions;
  }

  void take_primitive(const Json& primitive, const Json& weights, const Eigen::Matrix4d& placed) {
    const std::vector<double> positions = positions_of(primitive, weights);
    const long long first = builder_.vertices(),
                    count = static_cast<long long>(positions.size()) / 3;
    std::vector<long long> corners;
    if (const long long accessor = file_.whole(primitive, "indices", -1, "/meshes");
        accessor >= 0) {
      for (const double index : file_.array(accessor, "SCALAR")) {
        if (!(index < static_cast<double>(count)))
          return file_.problems().add(ErrorCode::BadReference,
                                      "/accessors/" + std::to_string(accessor),
                                      "must hold indices below " + std::to_string(count));
        corners.push_back(first + static_cast<long long>(index));
      }
    } else {
      for (long long i = 0; i < count; ++i) corners.push_back(first + i);
    }
    if (!sound()) return;
    for (std::size_t i = 0; i + 2 < positions.size() && !builder_.full(); i += 3) {
      const Eigen::Vector4d at(positions[i], positions[i + 1], positions[i + 2], 1.0);
      builder_.add_vertex((placed * at).head<3>(), 0);
    }
    add_cells(file_.whole(primitive, "mode", kGltfTriangles, "/meshes"), corners);
  }

  void add_cells(long long mode, const std::vector<long long>& corners) {
    const int group = static_cast<int>(found_.groups.size()) - 1;
    const std::size_t size = corners.size();
    const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
      if (!builder_.full()) builder_.add_polygon({corners[a], corners[b], corners[c]}, 0, group);
    };
    const auto line = [&](std::size_t a, std::size_t b) {
      found_.lines.push_back({group, {static_cast<int>(corners[a]), static_cast<int>(corners[b])}});
    };
    for (std::size_t i = 2; mode == kGltfTriangles && i < size; i += 3) triangle(i - 2, i - 1, i);
    for (std::size_t i = 2; mode == kGltfStrip && i < size; ++i)
      triangle(i - 2, i - 1 + i % 2, i - i % 2);
    for (std::size_t i = 2; mode == kGltfFan && i < size; ++i) triangle(0, i - 1, i);
    for (std::size_t i = 1; mode == kGltfLines && i < size; i += 2) line(i - 1, i);
    for (std::size_t i = 1; (mode == kGltfLineStrip || mode == kGltfLoop) && i < size; ++i)
      line(i - 1, i);
    if (mode == kGltfLoop && size > 2) line(size - 1, 0);
  }

  Expected<GroupedMesh> finish() {
    if (!file_.problems().empty()) return std::move(file_.problems()).take();
    if (builder_.faces() == 0 && !found_.lines.empty()) {
      Expected<Points> points = std::move(builder_).take_points();
      if (!points) return points.errors();
      found_.mesh = {*std::move(points), Faces(0, 3), {}};
      return std::move(found_);
    }
    Expected<TriangleMesh> mesh = std::move(builder_).take();
    if (!mesh) return mesh.errors();
    found_.mesh = *std::move(mesh);
    found_.grouped_by = "nodes";
    for (std::size_t i = 0; i < found_.groups.size(); ++i)
      found_.group_of_polygon.push_back(static_cast<int>(i));
    return std::move(found_);
  }

  GltfDocument file_;
  MeshBuilder builder_;
  GroupedMesh found_;  ///< its polygons are numbered by their groups
};

struct ReadGltf {
  Json document;
  std::string_view binary;
};

Expected<ReadGltf> parsed(std::string_view bytes) {
  const Expected<GltfChunks> chunks = gltf_chunks(bytes);
  if (!chunks) return chunks.errors();
  Expected<Json> document = parse_json(chunks->document);
  if (!document) return document.errors();
  const Json& version = gltf_member(gltf_member(*document, "asset"), "version");
  if (!version.is_string() || !version.get<std::string>().starts_with("2"))
    return Error{ErrorCode::Unsupported, "/asset/version", "must be 2.0: it is no glTF 2.0 file"};
  return ReadGltf{*std::move(document), chunks->binary};
}

/// "%20" and the like as they are meant.
std::string without_escapes(const std::string& uri) {
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const auto digit = [&](std::size_t at) {
      constexpr std::string_view kDigits = "0123456789abcdef";
      return at < uri.size() ? kDigits.find(static_cast<char>(uri[at] | (uri[at] > '9' ? 32 : 0)))
                             : std::string_view::npos;
    };
    const std::size_t high = digit(i + 1), low = digit(i + 2);
    const bool escaped =
        uri[i] == '%' && high != std::string_view::npos && low != std::string_view::npos;
    name += escaped ? static_cast<char>(16 * high + low) : uri[i];
    if (escaped) i += 2;
  }
  return name;
}

}  // namespace

Expected<GroupedMesh> read_gltf(std::string_view bytes, const MeshLimits& limits) {
  Expected<ReadGltf> file = parsed(bytes);
  if (!file) return file.errors();
  return GltfReader(std::move(file->document), file->binary, limits).read();
}

Expected<std::optional<std::string>> gltf_buffer_file(std::string_view bytes) {
  const Expected<ReadGltf> file = parsed(bytes);
  if (!file) return std::optional<std::string>();  // read_gltf() says what is wrong
  std::optional<std::string> name;
  const Json& buffers = gltf_member(file->document, "buffers");
  if (!buffers.is_array()) return name;
  for (const Json& buffer : buffers) {
    const Json& uri = gltf_member(buffer, "uri");
    if (!uri.is_string() || uri.get<std::string>().starts_with("data:")) continue;
    if (buffers.size() > 1)
      return Error{ErrorCode::Unsupported, "",
                   "names several files of buffers, must name one; save as .glb"};
    name = without_escapes(uri.get<std::string>());
    if (name->empty() || name->find_first_of("/\\:") != std::string::npos)
      return Error{ErrorCode::Unsupported, "",
                   "names a file in another folder, must be in the same folder; save as .glb"};
  }
  return name;
}

std::string gltf_with_buffer(std::string_view bytes, std::string_view buffer) {
  Json document = parsed(bytes)->document;
  document["buffers"][0].erase("uri");
  std::string file;
  const auto append_chunk = [&](std::uint32_t type, std::string_view chunk) {
    append_little_endian(file, static_cast<std::uint32_t>(chunk.size()));
    append_little_endian(file, type);
    file += chunk;
  };
  file = "glTF";
  append_little_endian(file, std::uint32_t{2});
  append_little_endian(file, std::uint32_t{0});
  append_chunk(0x4E4F534A, document.dump());
  append_chunk(0x004E4942, buffer);
  return file;
}

}  // namespace coapt
