#include "io/exchange/abaqus_valve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "core/valve/validate.h"
#include "io/exchange/abaqus_input.h"

namespace coapt {
namespace {

constexpr double kKpaPerMpa = 1e3;
constexpr double kGramsPerTonne = 1e6;

/// "PART.NAME" without the instance.
std::string local(const std::string& name) { return name.substr(name.rfind('.') + 1); }

std::string leaflet_called(const std::string& elements) {
  std::string name = elements.substr(0, elements.find("_LEAFLET_ELEMENTS"));
  std::transform(name.begin(), name.end(), name.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return name;
}

class Conversion {
 public:
  Conversion(const AbaqusModel& model, const AbaqusImport& options) : model_(model) {
    valve_.name = options.name;
    valve_.provenance = options.provenance;
  }
  Expected<Valve> run();

 private:
  Error missing(const char* path, const std::string& message) const {
    return {ErrorCode::MissingField, path, message};
  }
  std::optional<Error> number_vertices();
  std::optional<Error> add_leaflets();
  void add_face(const std::vector<int>& nodes, int leaflet, const Vec3& axis);
  void find_motions();
  std::optional<Error> add_annulus();
  std::optional<Error> add_chordae();
  void add_chorda(int head, int from, int first);
  std::optional<Error> add_loads();
  void touch_as_thinned();
  void bend_as_at_rest();
  Vec3 place(int node) const { return model_.nodes.at(node); }
  Vec3 moved(int node) const {
    const auto motion = motion_.find(node);
    return motion == motion_.end() ? place(node) : Vec3(place(node) + motion->second);
  }

  const AbaqusModel& model_;
  Valve valve_;
  bool flipped_ = true;  // element normals point to the ventricle
  std::map<int, int> vertex_of_;
  std::vector<std::array<int, 3>> faces_;
  std::vector<Vec3> fibres_;
  std::map<int, Vec3> motion_;               // prescribed, by node
  std::map<int, std::vector<int>> trusses_;  // node -> nodes
  std::map<std::pair<int, int>, const AbaqusSection*> truss_section_;
  std::map<int, int> face_at_;  // vertex -> one of its faces
};

std::optional<Error> Conversion::number_vertices() {
  std::set<int> used;
  for (const AbaqusSection& section : model_.sections) {
    const auto set = model_.element_sets.find(section.elements);
    if (set == model_.element_sets.end() || !model_.materials.contains(section.material))
      return Error{ErrorCode::BadReference, "/lines/" + std::to_string(section.line),
                   "names an element set or a material that does not exist"};
    for (const int e : set->second) {
      const auto element = model_.elements.find(e);
      const std::size_t corners =
          element == model_.elements.end() ? 0 : element->second.nodes.size();
      if (section.shell ? corners < 3 : corners != 2)
        return Error{
            ErrorCode::BadReference, "/lines/" + std::to_string(section.line),
            "holds element " + std::to_string(e) + ", which is missing or of another kind"};
      for (const int n : element->second.nodes) {
        if (!model_.nodes.contains(n))
          return Error{ErrorCode::BadReference, "/lines/" + std::to_string(section.line),
                       "needs node " + std::to_string(n) + ", which is missing"};
        if (section.shell) used.insert(n);
      }
    }
  }
  for (const int n : used) vertex_of_.emplace(n, static_cast<int>(vertex_of_.size()));
  valve_.rest_mm.resize(std::ssize(vertex_of_), 3);
  for (const auto& [n, vertex] : vertex_of_) valve_.rest_mm.row(vertex) = place(n);
  return {};
}

/// `axis`: the material's first direction, zero if there is none.
void Conversion::add_face(const std::vector<int>& nodes, int leaflet, const Vec3& axis) {
  std::array<int, 3> face;
  for (std::size_t k = 0; k < 3; ++k) face[k] = vertex_of_.at(nodes[k]);
  if (flipped_) std::swap(face[1], face[2]);
  const auto at = [&](std::size_t k) -> Vec3 { return valve_.rest_mm.row(face[k]); };
  const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
  Vec3 fibre = axis - axis.dot(normal) * normal;
  if (!(fibre.norm() > 1e-3)) fibre = at(1) - at(0);
  for (const int vertex : face) face_at_.emplace(vertex, static_cast<int>(faces_.size()));
  faces_.push_back(face);
  fibres_.push_back(fibre.normalized());
  valve_.face_leaflet.push_back(leaflet);
}

std::optional<Error> Conversion::add_leaflets() {
  for (const AbaqusSection& section : model_.sections) {
    if (!section.shell) continue;
    const AbaqusMaterial& material = model_.materials.at(section.material);
    if (!section.material.starts_with("VUANISO_ISO") || material.constants.size() != 4)
      return Error{ErrorCode::Unsupported, "/lines/" + std::to_string(section.line),
                   "has the material " + section.material +
                       "; supported are exponential ones (VUANISO_ISO*, four constants)"};
    const auto leaflet = static_cast<int>(valve_.leaflets.size());
    const std::vector<double>& c = material.constants;
    valve_.leaflets.push_back({leaflet_called(section.elements),
                               section.size,
                               {kKpaPerMpa * c[0], kKpaPerMpa * c[2], c[3]}});
    valve_.tissue.density_g_per_mm3 = kGramsPerTonne * material.density_t_per_mm3;
    const auto orientation = model_.orientations.find(section.orientation);
    const auto axes = orientation == model_.orientations.end()
                          ? model_.distributions.end()
                          : model_.distributions.find(orientation->second);
    for (const int e : model_.element_sets.at(section.elements)) {
      const std::vector<int>& n = model_.elements.at(e).nodes;
      Vec3 axis = Vec3::Zero();
      if (axes != model_.distributions.end() && axes->second.contains(e)) axis = axes->second.at(e);
      if (n.size() == 3) {
        add_face(n, leaflet, axis);
      } else if ((place(n[0]) - place(n[2])).norm() <= (place(n[1]) - place(n[3])).norm()) {
        add_face({n[0], n[1], n[2]}, leaflet, axis);
        add_face({n[0], n[2], n[3]}, leaflet, axis);
      } else {
        add_face({n[0], n[1], n[3]}, leaflet, axis);
        add_face({n[1], n[2], n[3]}, leaflet, axis);
      }
    }
  }
  if (faces_.empty()) return missing("/sections", "has no *SHELL SECTION; leaflets are shells");
  valve_.faces.resize(std::ssize(faces_), 3);
  valve_.fibre.resize(std::ssize(faces_), 3);
  for (Index f = 0; f < std::ssize(faces_); ++f) {
    valve_.faces.row(f) << faces_[f][0], faces_[f][1], faces_[f][2];
    valve_.fibre.row(f) = fibres_[f];
  }
  return {};
}

void Conversion::find_motions() {
  for (const AbaqusMotion& motion : model_.motions) {
    const std::string target = local(motion.target);
    std::vector<int> nodes;
    if (const auto set = model_.node_sets.find(target); set != model_.node_sets.end())
      nodes = set->second;
    else
      nodes = {std::atoi(target.c_str())};
    for (const int n : nodes) {
      if (!model_.nodes.contains(n)) continue;
      Vec3& amount = motion_.try_emplace(n, Vec3::Zero()).first->second;
      amount[motion.axis] = motion.amount_mm;
    }
  }
}

/// The boundary loop of prescribed nodes, in the direction of the faces.
std::optional<Error> Conversion::add_annulus() {
  std::map<std::pair<int, int>, int> walked;
  for (const auto& face : faces_)
    for (std::size_t k = 0; k < 3; ++k) ++walked[{face[k], face[(k + 1) % 3]}];
  std::map<int, int> node_of;
  for (const auto& [node, vertex] : vertex_of_) node_of[vertex] = node;
  std::map<int, int> next;
  for (const auto& [edge, count] : walked)
    if (!walked.contains({edge.second, edge.first}) && motion_.contains(node_of.at(edge.first)) &&
        motion_.contains(node_of.at(edge.second)))
      next[edge.first] = edge.second;
  if (next.empty())
    return missing("/boundary", "prescribes no motion along an edge of the shells: the annulus");
  const int first = next.begin()->first;
  for (int at = first; valve_.annulus.size() < next.size();) {
    valve_.annulus.push_back(at);
    const auto step = next.find(at);
    if (step == next.end())
      return Error{ErrorCode::BadTopology, "/boundary",
                   "prescribes the motion of an edge that is no closed loop, at node " +
                       std::to_string(node_of.at(at))};
    at = step->second;
    if (at == first) break;
  }
  valve_.annulus_mm.resize(std::ssize(valve_.annulus), 3);
  for (Index i = 0; i < std::ssize(valve_.annulus); ++i)
    valve_.annulus_mm.row(i) = moved(node_of.at(valve_.annulus[i]));
  return {};
}

/// The tree that leaves a head for the node `first`.
void Conversion::add_chorda(int head, int from, int first) {
  Chorda chorda;
  chorda.id = valve_.heads[head].id + "-" + std::to_string(first);
  chorda.head = head;
  struct Branch {
    int parent, from, to;
  };
  std::vector<Branch> open = {{-1, from, first}};
  while (!open.empty()) {
    const auto [parent, start, second] = open.back();
    open.pop_back();
    ChordaSegment segment;
    segment.parent = parent;
    segment.zone_mm = 0.0;  // fans are there, strand by strand
    int before = start, at = second;
    double area_mm2 = 0.0, stretch_per_n = 0.0;
    for (;;) {
      const AbaqusSection& section = *truss_section_.at(std::minmax(before, at));
      double modulus_mpa = 0.0;
      for (const auto& term : model_.materials.at(section.material).ogden)
        modulus_mpa += 3.0 * term[0];
      const double length = (place(at) - place(before)).norm();
      segment.rest_length_mm += length;
      area_mm2 += section.size * length;
      stretch_per_n += length / (modulus_mpa * section.size);
      if (vertex_of_.contains(at) || trusses_.at(at).size() != 2) break;
      const std::vector<int>& both = trusses_.at(at);
      before = std::exchange(at, both[0] == before ? both[1] : both[0]);
    }
    area_mm2 /= segment.rest_length_mm;
    segment.diameter_mm = std::sqrt(4.0 * area_mm2 / std::numbers::pi);
    segment.modulus_kpa = kKpaPerMpa * segment.rest_length_mm / (stretch_per_n * area_mm2);
    const auto vertex = vertex_of_.find(at);
    segment.inserts = vertex != vertex_of_.end();
    if (segment.inserts) {
      segment.insertion.face = face_at_.at(vertex->second);
      const auto& face = faces_[segment.insertion.face];
      for (std::size_t k = 0; k < 3; ++k)
        segment.insertion.weights[k] = face[k] == vertex->second ? 1.0 : 0.0;
    } else {
      segment.branch_point_mm = place(at);
      const auto own = static_cast<int>(chorda.segments.size());
      for (const int n : trusses_.at(at))
        if (n != before) open.push_back({own, at, n});
    }
    chorda.segments.push_back(segment);
  }
  valve_.chordae.push_back(std::move(chorda));
}

std::optional<Error> Conversion::add_chordae() {
  for (const AbaqusSection& section : model_.sections) {
    if (section.shell) continue;
    if (model_.materials.at(section.material).ogden.empty() || !(section.size > 0.0))
      return Error{ErrorCode::Unsupported, "/lines/" + std::to_string(section.line),
                   "has trusses without area or without an Ogden law"};
    for (const int e : model_.element_sets.at(section.elements)) {
      const std::vector<int>& n = model_.elements.at(e).nodes;
      trusses_[n[0]].push_back(n[1]);
      trusses_[n[1]].push_back(n[0]);
      truss_section_[std::minmax(n[0], n[1])] = &section;
    }
  }
  std::size_t segments = 0;
  for (const auto& [node, ends] : trusses_) {
    if (!motion_.contains(node) || vertex_of_.contains(node)) continue;
    const auto head = static_cast<int>(valve_.heads.size());
    valve_.heads.push_back({std::to_string(node), Side::Anterolateral, place(node), moved(node)});
    for (const int first : ends) {
      add_chorda(head, node, first);
      segments += valve_.chordae.back().segments.size();
    }
    // A ring of trusses would be walked for ever.
    if (segments > 2 * truss_section_.size())
      return Error{ErrorCode::BadTopology, "/sections", "has trusses that form a ring"};
  }
  return {};
}

std::optional<Error> Conversion::add_loads() {
  if (model_.pressures.size() != 1)
    return missing("/pressure", "has " + std::to_string(model_.pressures.size()) +
                                    " *DSLOAD lines, must have one");
  const AbaqusPressure& pressure = model_.pressures.front();
  const auto surface = model_.surfaces.find(local(pressure.surface));
  if (surface == model_.surfaces.end() || surface->second.parts.empty())
    return Error{ErrorCode::BadReference, "/pressure", "acts on a surface that does not exist"};
  const bool positive = surface->second.parts.front().positive;
  for (const auto& part : surface->second.parts)
    if (part.positive != positive)
      return Error{ErrorCode::Unsupported, "/pressure",
                   "acts on both sides of the shells; only one side is supported"};
  // It pushes against the side it acts on: from the ventricle.
  flipped_ = positive == (pressure.mpa > 0.0);
  valve_.pressure_kpa = kKpaPerMpa * std::abs(pressure.mpa);
  return {};
}

void Conversion::touch_as_thinned() {
  double thickness = std::numeric_limits<double>::infinity(), ratio = 0.0;
  for (const NamedLeaflet& leaflet : valve_.leaflets)
    thickness = std::min(thickness, leaflet.thickness_mm);
  for (const auto& [name, surface] : model_.surfaces) ratio = std::max(ratio, surface.max_ratio);
  double diagonal = std::numeric_limits<double>::infinity();
  for (const auto& [number, element] : model_.elements) {
    const std::vector<int>& n = element.nodes;
    if (n.size() != 4) continue;
    diagonal = std::min(
        {diagonal, (place(n[0]) - place(n[2])).norm(), (place(n[1]) - place(n[3])).norm()});
  }
  valve_.tissue.thickness_mm = ratio > 0.0 ? std::min(thickness, ratio * diagonal) : thickness;
}

void Conversion::bend_as_at_rest() {
  double sum = 0.0;
  for (const NamedLeaflet& leaflet : valve_.leaflets)
    sum += 3.0 * leaflet.tissue.c0_kpa / kKpaPerMpa * std::pow(leaflet.thickness_mm, 3) /
           (12.0 * (1.0 - 0.25));
  valve_.tissue.bending_n_mm = sum / static_cast<double>(valve_.leaflets.size());
}

Expected<Valve> Conversion::run() {
  for (const auto step :
       {&Conversion::add_loads, &Conversion::number_vertices, &Conversion::add_leaflets})
    if (const std::optional<Error> error = (this->*step)()) return *error;
  find_motions();
  for (const auto step : {&Conversion::add_annulus, &Conversion::add_chordae})
    if (const std::optional<Error> error = (this->*step)()) return *error;
  touch_as_thinned();
  bend_as_at_rest();
  valve_.provenance.push_back(
      "read from an input file of Abaqus: " + std::to_string(valve_.leaflets.size()) +
      " leaflets, quadrilaterals split along their shorter diagonal, chordae as stiff as their "
      "Ogden law at rest, leaflets incompressible");
  if (Errors errors = validate(valve_); !errors.empty()) return errors;
  return std::move(valve_);
}

}  // namespace

Expected<Valve> read_abaqus_valve(std::string_view text, const AbaqusImport& options) {
  const Expected<AbaqusModel> model = read_abaqus(text);
  if (!model) return model.errors();
  return Conversion(*model, options).run();
}

}  // namespace coapt
