#include "io/exchange/valve_glb.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "core/valve/leaflet_of.h"
#include "core/valve/vertex_normals.h"
#include "io/exchange/glb.h"
#include "io/exchange/tubes.h"
#include "io/exchange/valve_markups.h"
#include "io/json/version.h"

namespace coapt {
namespace {

constexpr std::size_t kMostTargets = 16;
constexpr double kClosingSeconds = 1.5, kHoldSeconds = 1.0;
constexpr double kRingRadius_mm = 1.2, kSutureRadius_mm = 0.35;
constexpr double kOverlap_mm = 0.15;  // of the ring's pieces, so that no wedge gapes between them

// Linear, not sRGB. Anterior warm, posterior cool, the middle segment darker; commissures pale.
constexpr Colour8 kSegmentColours[] = {
    {222, 130, 110, 255}, {200, 88, 74, 255},   {222, 130, 110, 255}, {120, 150, 205, 255},
    {82, 112, 180, 255},  {120, 150, 205, 255}, {190, 170, 165, 255}, {190, 170, 165, 255}};
constexpr Colour8 kChordaColour = {215, 200, 170, 255}, kNeochordaColour = {40, 160, 70, 255},
                  kRingColour = {225, 225, 230, 255}, kSutureColour = {30, 60, 200, 255};

/// A mesh in all its states, the first is the one that is there. Tubes hardly turn: they have the normals of the
/// first state alone.
struct MorphedMesh {
  std::string name;
  std::vector<Points> vertices_mm, normals;
  std::vector<Colour8> colours;
  Faces faces;
};

/// From the valve's axes to glTF's.
Points turned(const Points& vectors) {
  Points out(vectors.rows(), 3);
  out << vectors.col(0), vectors.col(2), -vectors.col(1);
  return out;
}

Points in_metres(const Points& points_mm) { return 1e-3 * turned(points_mm); }

/// Edges that one face alone has, each as the corners (face, corner of its start).
std::vector<std::pair<Eigen::Index, int>> free_edges(const Faces& faces) {
  std::set<std::pair<int, int>> directed;
  for (const auto& face : faces.rowwise())
    for (int k = 0; k < 3; ++k) directed.insert({face[k], face[(k + 1) % 3]});
  std::vector<std::pair<Eigen::Index, int>> edges;
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
    for (int k = 0; k < 3; ++k)
      if (!directed.contains({faces(f, (k + 1) % 3), faces(f, k)})) edges.push_back({f, k});
  return edges;
}

/// Both sides of a sheet of faces and the rim that joins them: vertex i above, i + sheet_vertices below.
Faces thick(const Faces& sheet, int sheet_vertices,
            const std::vector<std::pair<Eigen::Index, int>>& rim) {
  Faces faces(2 * sheet.rows() + 2 * std::ssize(rim), 3);
  faces.topRows(sheet.rows()) = sheet;
  for (Eigen::Index f = 0; f < sheet.rows(); ++f)
    faces.row(sheet.rows() + f) << sheet(f, 0) + sheet_vertices, sheet(f, 2) + sheet_vertices,
        sheet(f, 1) + sheet_vertices;
  Eigen::Index next = 2 * sheet.rows();
  for (const auto& [f, k] : rim) {
    const int a = sheet(f, k), b = sheet(f, (k + 1) % 3);
    faces.row(next++) << b, a, a + sheet_vertices;
    faces.row(next++) << b, a + sheet_vertices, b + sheet_vertices;
  }
  return faces;
}

/// The faces of a leaflet, or of the commissures, with their thickness, without which coapting leaflets seem apart, and a vertex for
/// each segment that it lies in, so that colours end where segments do.
MorphedMesh leaflet(const std::string& name, std::optional<Leaflet> of, const Valve& valve,
                    const std::vector<ValveShape>& states) {
  MorphedMesh mesh{name, {}, {}, {}, {}};
  std::vector<Eigen::Index> faces;
  for (Eigen::Index f = 0; f < valve.faces.rows(); ++f)
    if (leaflet_of(valve.segments[static_cast<std::size_t>(f)]) == of) faces.push_back(f);
  Faces sheet = valve.faces(faces, Eigen::all);
  std::vector<int> source;
  std::map<std::pair<int, Segment>, int> index;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Segment segment = valve.segments[static_cast<std::size_t>(faces[i])];
    for (int& vertex : sheet.row(static_cast<Eigen::Index>(i))) {
      const auto [found, fresh] =
          index.try_emplace({vertex, segment}, static_cast<int>(source.size()));
      if (fresh) {
        source.push_back(vertex);
        mesh.colours.push_back(kSegmentColours[static_cast<std::size_t>(segment)]);
      }
      vertex = found->second;
    }
  }
  std::vector<std::pair<Eigen::Index, int>> rim;
  for (const auto& [f, k] : free_edges(valve.faces))
    if (const auto found = std::lower_bound(faces.begin(), faces.end(), f);
        found != faces.end() && *found == f)
      rim.emplace_back(found - faces.begin(), k);
  mesh.faces = thick(sheet, static_cast<int>(source.size()), rim);
  const std::vector<Colour8> above = mesh.colours;
  mesh.colours.insert(mesh.colours.end(), above.begin(), above.end());
  for (const ValveShape& state : states) {
    const Points middle = state.vertices_mm(source, Eigen::all);
    Points normals = vertex_normals(state.vertices_mm, valve.faces)(source, Eigen::all);
    for (auto normal : normals.rowwise())
      if (!(normal.norm() > 0.0)) normal = Vec3::UnitZ().transpose();
    const Points half = 0.5 * valve.tissue.thickness_mm * normals;
    mesh.vertices_mm.emplace_back(2 * middle.rows(), 3) << middle + half, middle - half;
    mesh.normals.emplace_back(2 * middle.rows(), 3) << normals, -normals;
  }
  return mesh;
}

/// @param axes_of the tubes of a state
template <class AxesOf>
MorphedMesh tubes(const std::string& name, const std::vector<ValveShape>& states,
                  const AxesOf& axes_of, const std::vector<Colour8>& colour_of_piece) {
  MorphedMesh mesh{name, {}, {}, {}, {}};
  const std::vector<TubeAxis> first = axes_of(states.front());
  for (const ValveShape& state : states) {
    Tubes shape = make_tubes(axes_of(state), first);
    mesh.vertices_mm.push_back(std::move(shape.vertices_mm));
    if (mesh.normals.empty()) mesh.normals.push_back(std::move(shape.normals));
    mesh.faces = std::move(shape.faces);
  }
  for (const Colour8& colour : colour_of_piece)
    mesh.colours.insert(mesh.colours.end(), 2 * kTubeSides, colour);
  return mesh;
}

MorphedMesh chordae(const Valve& valve, const std::vector<ValveShape>& states) {
  std::vector<Colour8> colours;
  const auto axes_of = [&](const ValveShape& state) {
    std::vector<TubeAxis> axes;
    colours.clear();
    for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
      const Chorda& chorda = valve.chordae[c];
      if (chorda.ruptured) continue;
      for (std::size_t s = 0; s < chorda.segments.size(); ++s) {
        axes.push_back({segment_start(state, chorda, c, s),
                        state.chorda_ends_mm[c].row(static_cast<Eigen::Index>(s)),
                        0.5 * chorda.segments[s].diameter_mm});
        colours.push_back(chorda.kind == ChordaKind::Neochorda ? kNeochordaColour : kChordaColour);
      }
    }
    return axes;
  };
  (void)axes_of(states.front());
  return tubes("chordae", states, axes_of, colours);
}

/// Ring, papillary sutures, ties and seams; neochordae are among the chordae.
MorphedMesh repair(const ClosedValve& exported, const std::vector<ValveShape>& states) {
  std::vector<Colour8> colours;
  const auto axes_of = [&](const ValveShape& state) {
    std::vector<TubeAxis> axes;
    colours.clear();
    for (const Markup& markup : repair_markups(exported, state)) {
      const bool is_ring = markup.type == MarkupType::ClosedCurve;
      const auto is_called = [&](std::string_view start) { return markup.name.starts_with(start); };
      if (!is_ring && !is_called("suture:") && !is_called(kTieMarkup) && !is_called("seam:"))
        continue;
      const Eigen::Index points = markup.points_mm.rows();
      for (Eigen::Index i = is_ring ? 0 : 1; i < points; ++i) {
        const Vec3 from = markup.points_mm.row((i + points - 1) % points),
                   to = markup.points_mm.row(i);
        const Vec3 over = is_ring ? Vec3(kOverlap_mm * (to - from).normalized()) : Vec3::Zero();
        axes.push_back({from - over, to + over, is_ring ? kRingRadius_mm : kSutureRadius_mm});
        colours.push_back(is_ring ? kRingColour : kSutureColour);
      }
    }
    return axes;
  };
  if (axes_of(states.front()).empty()) return {};
  return tubes("repair", states, axes_of, colours);
}

/// States at equal ways of the leaflets (rms), the last, which is the closed one, left out.
std::vector<ValveShape> evenly_spaced(std::vector<ValveShape> states) {
  if (states.size() < 2) return {};
  std::vector<double> way = {0.0};
  for (std::size_t i = 1; i < states.size(); ++i)
    way.push_back(way.back() + (states[i].vertices_mm - states[i - 1].vertices_mm).norm());
  const std::size_t wanted = std::min(kMostTargets, states.size() - 1);
  std::vector<ValveShape> chosen;
  for (std::size_t i = 0, next = 0; i + 1 < states.size() && next < wanted; ++i) {
    if (way[i] < way.back() * static_cast<double>(next) / static_cast<double>(wanted)) continue;
    chosen.push_back(std::move(states[i]));
    ++next;
  }
  return chosen;
}

Json primitive(const MorphedMesh& mesh, GlbBuffer& buffer) {
  Json json = {{"attributes",
                {{"POSITION", buffer.add_vectors(in_metres(mesh.vertices_mm[0]), true)},
                 {"NORMAL", buffer.add_vectors(turned(mesh.normals[0]), false)},
                 {"COLOR_0", buffer.add_colours(mesh.colours)}}},
               {"indices", buffer.add_triangles(mesh.faces)},
               {"material", 0}};
  for (std::size_t i = 1; i < mesh.vertices_mm.size(); ++i) {
    Json target = {{"POSITION", buffer.add_vectors(
                                    in_metres(mesh.vertices_mm[i] - mesh.vertices_mm[0]), true)}};
    if (i < mesh.normals.size())
      target["NORMAL"] = buffer.add_vectors(turned(mesh.normals[i] - mesh.normals[0]), false);
    json["targets"].push_back(std::move(target));
  }
  return json;
}

/// One target after the other at full weight, then none, which is the closed valve; linear between them.
Json closing(std::size_t targets, int meshes, GlbBuffer& buffer) {
  std::vector<double> seconds, weights;
  for (std::size_t key = 0; key <= targets; ++key) {
    seconds.push_back(kClosingSeconds * static_cast<double>(key) / static_cast<double>(targets));
    for (std::size_t target = 0; target < targets; ++target)
      weights.push_back(target == key ? 1.0 : 0.0);
  }
  seconds.push_back(kClosingSeconds + kHoldSeconds);
  weights.insert(weights.end(), targets, 0.0);
  const Json sampler = {{"input", buffer.add_scalars(seconds, true)},
                        {"output", buffer.add_scalars(weights, false)},
                        {"interpolation", "LINEAR"}};
  Json animation = {{"name", "closing"}, {"samplers", {sampler}}};
  for (int node = 1; node <= meshes; ++node)
    animation["channels"].push_back(
        {{"sampler", 0}, {"target", {{"node", node}, {"path", "weights"}}}});
  return animation;
}

std::string scene(const ClosedValve& exported, const ValveShape& shape,
                  std::vector<ValveShape> targets) {
  const Valve& valve = exported.valve;
  std::vector<ValveShape> states = std::move(targets);
  states.insert(states.begin(), shape);
  const std::size_t target_count = states.size() - 1;

  GlbBuffer buffer;
  Json document = {
      {"asset",
       {{"version", "2.0"},
        {"generator", "coapt " + std::string(version())},
        {"copyright", kResearchNotice},
        {"extras",
         {{"valve", valve.name},
          {"provenance", valve.provenance},
          {"notice", kResearchNotice},
          {"units", "metres; y to the atrium, x posteromedial, z posterior"}}}}},
      {"scene", 0},
      {"scenes", {{{"nodes", {0}}}}},
      {"nodes", {{{"name", valve.name}}}},
      {"meshes", Json::array()},
      {"materials",
       {{{"name", "tissue"},
         {"doubleSided", true},
         {"pbrMetallicRoughness", {{"metallicFactor", 0.0}, {"roughnessFactor", 0.6}}}}}}};
  if (!shape.doubt.empty()) document["asset"]["extras"]["closure"] = shape.doubt;
  for (const MorphedMesh& mesh : {leaflet("anterior leaflet", Leaflet::Anterior, valve, states),
                                  leaflet("posterior leaflet", Leaflet::Posterior, valve, states),
                                  leaflet("commissures", std::nullopt, valve, states),
                                  chordae(valve, states), repair(exported, states)}) {
    if (mesh.faces.rows() == 0) continue;
    Json json = {{"name", mesh.name}, {"primitives", {primitive(mesh, buffer)}}};
    if (target_count > 0) json["weights"] = std::vector<double>(target_count, 0.0);
    const std::size_t index = document["meshes"].size();
    document["meshes"].push_back(std::move(json));
    document["nodes"][0]["children"].push_back(index + 1);
    document["nodes"].push_back({{"name", mesh.name}, {"mesh", index}});
  }
  if (target_count > 0)
    document["animations"] =
        Json::array({closing(target_count, static_cast<int>(document["meshes"].size()), buffer)});
  return buffer.file(std::move(document));
}

}  // namespace

std::string write_glb(const ClosedValve& exported) {
  return scene(exported, closed_shape(exported), evenly_spaced(motion_shapes(exported)));
}

std::string write_open_glb(const ClosedValve& exported) {
  return scene(exported, unstressed_shape(exported.valve), {});
}

}  // namespace coapt
