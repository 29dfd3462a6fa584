// STL, ASCII and binary. Vertices with the same coordinates are one vertex.
//
// A binary file may begin with "solid" as well: it is binary if its length is what its count says.

#include "io/mesh/stl.h"

#include <cstdint>
#include <map>

#include "io/mesh/byte_scan.h"
#include "io/mesh/mesh_builder.h"
#include "io/mesh/text_scan.h"

namespace coapt {
namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kFacetBytes = 50;

/// Adds corners and every three of them as a triangle.
class Welder {
 public:
  explicit Welder(MeshBuilder& mesh) : mesh_(mesh) {}

  void add_corner(const Vec3& p, int line) {
    long long vertex = mesh_.vertices();
    if (p.allFinite())  // else there is no order, and the builder says what is wrong with it
      vertex = index_.try_emplace({p.x(), p.y(), p.z()}, vertex).first->second;
    if (vertex == mesh_.vertices()) mesh_.add_vertex(p, line);
    triangle_.push_back(vertex);
    if (triangle_.size() < 3) return;
    mesh_.add_polygon(triangle_, line);
    triangle_.clear();
  }

  bool complete() const { return triangle_.empty(); }

 private:
  MeshBuilder& mesh_;
  std::map<std::array<double, 3>, long long> index_;
  std::vector<long long> triangle_;
};

std::uint32_t facet_count(std::string_view bytes) {
  bytes.remove_prefix(kHeaderBytes);
  return take_binary<std::uint32_t>(bytes, std::endian::little).value_or(0);
}

void read_binary(std::string_view bytes, MeshBuilder& mesh) {
  const std::uint32_t facets = facet_count(bytes);
  bytes.remove_prefix(kHeaderBytes + sizeof facets);
  if (bytes.size() / kFacetBytes < facets) {
    mesh.add_problem(ErrorCode::InputOutput, "/faces", 0,
                     "is truncated: " + std::to_string(facets) + " facets announced, bytes for " +
                         std::to_string(bytes.size() / kFacetBytes));
    return;
  }
  Welder welder(mesh);
  for (std::uint32_t facet = 0; facet < facets && !mesh.full(); ++facet) {
    std::string_view record = bytes.substr(facet * kFacetBytes, kFacetBytes);
    record.remove_prefix(3 * sizeof(float));  // the normal
    for (int corner = 0; corner < 3; ++corner) {
      Vec3 p;
      for (double& coordinate : p) {
        coordinate = take_binary<float>(record, std::endian::little).value_or(0.0F);
      }
      welder.add_corner(p, 0);
    }
  }
}

void read_ascii(std::string_view text, MeshBuilder& mesh, StlFile& file) {
  Welder welder(mesh);
  LineScanner lines(text);
  bool ended = false;
  while (const auto line = lines.next()) {
    if (mesh.full()) return;
    const auto tokens = words(line->text);
    if (tokens.empty()) continue;
    if (tokens[0] == "endsolid") ended = true;
    if (tokens[0] == "solid")
      file.solids.emplace_back(
          trimmed(std::string_view(tokens[0].end(), line->text.data() + line->text.size())));
    if (tokens[0] == "endfacet" && !welder.complete()) {
      mesh.add_problem(ErrorCode::WrongType, "/faces/" + std::to_string(mesh.faces()), line->number,
                       "must have three vertices");
      return;
    }
    if (tokens[0] != "vertex") continue;
    Vec3 p;
    bool good = tokens.size() == 4;
    for (std::size_t axis = 0; good && axis < 3; ++axis) {
      const auto coordinate = to_number(tokens[axis + 1]);
      good = coordinate.has_value();
      if (good) p[static_cast<Eigen::Index>(axis)] = *coordinate;
    }
    if (!good) {
      mesh.add_problem(ErrorCode::WrongType, "/vertices_mm/" + std::to_string(mesh.vertices()),
                       line->number, "must be 'vertex' and three numbers");
      return;
    }
    welder.add_corner(p, line->number);
    if (welder.complete())
      file.solid_of_polygon.push_back(static_cast<int>(file.solids.size()) - 1);
  }
  if (!ended) {
    mesh.add_problem(ErrorCode::InputOutput, "", lines.number(), "is truncated: no endsolid");
  }
}

}  // namespace

Expected<StlFile> read_stl_file(std::string_view bytes, const MeshLimits& limits) {
  MeshBuilder mesh(limits);
  StlFile file;
  const bool has_header = bytes.size() >= kHeaderBytes + sizeof(std::uint32_t);
  const bool exact = has_header && bytes.size() == kHeaderBytes + sizeof(std::uint32_t) +
                                                       kFacetBytes * facet_count(bytes);
  if (!exact && bytes.starts_with("solid")) {
    read_ascii(bytes, mesh, file);
  } else if (has_header) {
    read_binary(bytes, mesh);
  } else {
    mesh.add_problem(ErrorCode::InputOutput, "", 0,
                     "is not an STL file: it has neither 'solid' nor a header of 84 bytes");
  }
  Expected<TriangleMesh> taken = std::move(mesh).take();
  if (!taken) return taken.errors();
  file.mesh = *std::move(taken);
  return file;
}

Expected<TriangleMesh> read_stl(std::string_view bytes, const MeshLimits& limits) {
  Expected<StlFile> file = read_stl_file(bytes, limits);
  if (!file) return file.errors();
  return std::move(file->mesh);
}

}  // namespace coapt
