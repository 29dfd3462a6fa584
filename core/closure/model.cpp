#include "core/closure/model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/closure/self_contact.h"

namespace coapt {
namespace {

// Share of the critical step that is used: the contact forces, which the bound leaves out, need the
// rest.
constexpr double kStepSafety = 0.7;

struct Edge {
  double area_mm2 = 0.0;    // of the faces that share it
  double cos2_theta = 0.0;  // area-weighted, angle between edge and fibre
};

Vec3 vertex(const Points& points, int i) { return points.row(i); }

/// Thesis equation 2.3, for moduli and for the transition strain.
double orthotropic(double circumferential, double radial, double cos2) {
  return std::sqrt(circumferential * circumferential * cos2 + radial * radial * (1.0 - cos2));
}

using Edges = std::map<std::pair<int, int>, Edge>;

Edges collect_edges(const Valve& valve) {
  Edges edges;
  for (int f = 0; f < valve.faces.rows(); ++f) {
    const Vec3 a = vertex(valve.rest_mm, valve.faces(f, 0));
    const Vec3 b = vertex(valve.rest_mm, valve.faces(f, 1));
    const Vec3 c = vertex(valve.rest_mm, valve.faces(f, 2));
    const double area = 0.5 * (b - a).cross(c - a).norm();
    const Vec3 fibre = valve.fibre.row(f);
    for (int k = 0; k < 3; ++k) {
      const int i = valve.faces(f, k), j = valve.faces(f, (k + 1) % 3);
      const Vec3 direction = (vertex(valve.rest_mm, j) - vertex(valve.rest_mm, i)).normalized();
      const double cosine = direction.dot(fibre);
      Edge& edge = edges[std::minmax(i, j)];
      edge.area_mm2 += area;
      edge.cos2_theta += area * cosine * cosine;
    }
  }
  for (auto& [key, edge] : edges) edge.cos2_theta = std::min(1.0, edge.cos2_theta / edge.area_mm2);
  return edges;
}

void add_springs(const Valve& valve, const Edges& edges, ClosureModel& model) {
  const Tissue& tissue = valve.tissue;
  const auto [stretch1, stretch2] = prestretch(tissue);
  for (const auto& [key, edge] : edges) {
    Spring spring;
    spring.a = key.first;
    spring.b = key.second;
    spring.rest_mm = (vertex(valve.rest_mm, spring.a) - vertex(valve.rest_mm, spring.b)).norm() *
                     orthotropic(1.0 / stretch1, 1.0 / stretch2, edge.cos2_theta);
    const double per_modulus =
        tissue.thickness_mm * edge.area_mm2 / (spring.rest_mm * spring.rest_mm);
    const double pre =
        orthotropic(tissue.circumferential_pre_kpa, tissue.radial_pre_kpa, edge.cos2_theta);
    const double post =
        orthotropic(tissue.circumferential_post_kpa, tissue.radial_post_kpa, edge.cos2_theta);
    spring.pre_n_per_mm = pre * kMpaPerKpa * per_modulus;
    spring.post_n_per_mm = post * kMpaPerKpa * per_modulus;
    spring.transition =
        orthotropic(tissue.circumferential_transition, tissue.radial_transition, edge.cos2_theta);
    model.springs.push_back(spring);
  }
}

void add_membrane(const Valve& valve, Membrane membrane, ClosureModel& model) {
  const Tissue& tissue = valve.tissue;
  const Edges edges = collect_edges(valve);
  for (const auto& [key, edge] : edges) model.edges.push_back({key.first, key.second});
  // What leaflets with a tissue of their own are made of does not depend on the membrane asked for.
  if (!is_mitral(valve)) {
    std::size_t f = 0;
    for (const Sheet& sheet : make_sheets(valve))
      model.exponential_sheets.push_back(
          {sheet, exponential_law(valve.leaflets[valve.face_leaflet[f++]].tissue)});
  } else {
    switch (membrane) {
      case Membrane::Springs:
        add_springs(valve, edges, model);
        break;
      case Membrane::Continuum:
        model.law = sheet_law(tissue);
        model.sheets = make_sheets(valve);
        break;
    }
  }
  for (int f = 0; f < valve.faces.rows(); ++f) {
    const Vec3 a = vertex(valve.rest_mm, valve.faces(f, 0));
    const Vec3 b = vertex(valve.rest_mm, valve.faces(f, 1));
    const Vec3 c = vertex(valve.rest_mm, valve.faces(f, 2));
    const double third = (b - a).cross(c - a).norm() / 6.0;
    for (int k = 0; k < 3; ++k) {
      const int i = valve.faces(f, k);
      model.area_mm2[i] += third;
      model.mass_g[i] += tissue.density_g_per_mm3 * thickness_mm(valve, f) * third;
    }
  }
}

void add_chordae(const Valve& valve, ClosureModel& model) {
  const int heads = static_cast<int>(model.rest_mm.rows() - std::ssize(valve.heads));
  int next_branch = model.vertices;
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    const Chorda& chorda = valve.chordae[c];
    std::vector<int> branch_node(chorda.segments.size(), -1);
    for (std::size_t s = 0; s < chorda.segments.size(); ++s) {
      const ChordaSegment& segment = chorda.segments[s];
      Cable cable;
      cable.chorda = static_cast<int>(c);
      cable.segment = static_cast<int>(s);
      cable.start = segment.parent < 0 ? heads + chorda.head : branch_node[segment.parent];
      if (segment.inserts) {
        cable.end = insertion_zone(valve, segment.insertion, segment.zone_mm);
      } else {
        cable.end = {{next_branch, 1.0}};
        branch_node[s] = next_branch;
        model.rest_mm.row(next_branch) = segment.branch_point_mm;
        if (chorda.ruptured) model.fixed[next_branch] = true;
        ++next_branch;
      }
      const double section_mm2 =
          0.25 * std::numbers::pi * segment.diameter_mm * segment.diameter_mm;
      cable.rest_mm = segment.rest_length_mm;
      const double modulus_kpa =
          segment.modulus_kpa > 0.0 ? segment.modulus_kpa : valve.tissue.chordae_kpa;
      cable.stiffness_n_per_mm = modulus_kpa * kMpaPerKpa * section_mm2 / segment.rest_length_mm;
      const double half_mass =
          0.5 * valve.tissue.density_g_per_mm3 * section_mm2 * segment.rest_length_mm;
      model.mass_g[cable.start] += half_mass;
      for (const NodeShare& share : cable.end) model.mass_g[share.node] += share.weight * half_mass;
      if (!chorda.ruptured) model.cables.push_back(cable);
    }
  }
}

/// A tie is two cables from its knot, a free node, each half as long: so it pulls at zones on
/// either side.
void add_ties(const Valve& valve, ClosureModel& model) {
  auto knot =
      static_cast<int>(model.rest_mm.rows() - std::ssize(valve.heads) - std::ssize(valve.ties));
  for (std::size_t t = 0; t < valve.ties.size(); ++t, ++knot) {
    const Tie& tie = valve.ties[t];
    for (const Insertion& insertion : {tie.anterior, tie.posterior}) {
      Cable cable;
      cable.chorda = -1;
      cable.segment = static_cast<int>(t);
      cable.start = knot;
      cable.end = insertion_zone(valve, insertion, tie.zone_mm);
      cable.rest_mm = 0.5 * tie.rest_length_mm;
      cable.stiffness_n_per_mm = 2.0 * tie.stiffness_n_per_mm;
      model.rest_mm.row(knot) += 0.5 * end_position(cable, model.rest_mm).transpose();
      model.cables.push_back(cable);
    }
    model.mass_g[knot] = valve.tissue.density_g_per_mm3 * tie.rest_length_mm;  // 1 mm2 thick
  }
}

/// omega_max^2 <= max over nodes of row sum / m, 2 k for each spring; the step bound is 2 /
/// omega_max.
double stable_step_ms(const ClosureModel& model) {
  std::vector<double> row_sum(model.mass_g.size(), 0.0);
  for (const Spring& s : model.springs) {
    row_sum[s.a] += 2.0 * s.post_n_per_mm;
    row_sum[s.b] += 2.0 * s.post_n_per_mm;
  }
  for (const Sheet& sheet : model.sheets) {
    const auto sums = stiffest_row_sums(model.law, sheet);
    for (std::size_t k = 0; k < 3; ++k) row_sum[sheet.node[k]] += sums[k];
  }
  for (const Hinge& hinge : model.hinges) {
    const auto sums = row_sums(hinge, model.rest_mm);
    for (std::size_t k = 0; k < 4; ++k) row_sum[hinge.node[k]] += sums[k];
  }
  for (const ExponentialSheet& exponential : model.exponential_sheets) {
    const auto sums = stiffest_row_sums(exponential);
    for (std::size_t k = 0; k < 3; ++k) row_sum[exponential.sheet.node[k]] += sums[k];
  }
  for (const Cable& c : model.cables) {
    row_sum[c.start] += 2.0 * c.stiffness_n_per_mm;
    for (const NodeShare& share : c.end)
      row_sum[share.node] += 2.0 * share.weight * c.stiffness_n_per_mm;
  }
  double omega2 = 0.0;
  for (std::size_t i = 0; i < row_sum.size(); ++i)
    if (!model.fixed[i]) omega2 = std::max(omega2, row_sum[i] / model.mass_g[i]);
  return kStepSafety * 2.0 / std::sqrt(omega2);
}

}  // namespace

ClosureModel make_closure_model(const Valve& valve, Membrane membrane) {
  ClosureModel model;
  model.vertices = static_cast<int>(valve.rest_mm.rows());
  model.faces = valve.faces;
  const Index told = is_mitral(valve) ? std::ssize(valve.segments) : std::ssize(valve.face_leaflet);
  for (int f = 0; f < told; ++f)
    model.leaflet.push_back(std::min(kLeaflets - 1, leaflet_index(valve, f)));
  model.pressure_mpa = valve.pressure_kpa * kMpaPerKpa;
  int branch_points = 0;
  for (const Chorda& chorda : valve.chordae)
    for (const ChordaSegment& segment : chorda.segments) branch_points += segment.inserts ? 0 : 1;
  const int first_head = model.vertices + branch_points + static_cast<int>(valve.ties.size());
  const int nodes = first_head + static_cast<int>(valve.heads.size());
  model.rest_mm.setZero(nodes, 3);
  model.fixed.assign(nodes, false);
  model.mass_g.assign(nodes, 0.0);
  model.area_mm2.assign(model.vertices, 0.0);
  model.rest_mm.topRows(model.vertices) = valve.rest_mm;
  for (const int vertex : valve.annulus) model.fixed[vertex] = true;
  for (std::size_t h = 0; h < valve.heads.size(); ++h) {
    const int node = first_head + static_cast<int>(h);
    model.fixed[node] = true;
    model.rest_mm.row(node) = valve.heads[h].rest_mm;
  }
  add_membrane(valve, membrane, model);
  model.hinges = make_hinges(valve);
  add_chordae(valve, model);
  add_ties(valve, model);
  set_targets(valve, model);
  model.stable_step_ms = stable_step_ms(model);
  return model;
}

void set_targets(const Valve& valve, ClosureModel& model) {
  model.target_mm = model.rest_mm;
  for (std::size_t i = 0; i < valve.annulus.size(); ++i)
    model.target_mm.row(valve.annulus[i]) = valve.annulus_mm.row(i);
  int node = model.vertices;
  for (const Chorda& chorda : valve.chordae)
    for (const ChordaSegment& segment : chorda.segments) {
      if (segment.inserts) continue;
      const PapillaryHead& head = valve.heads[chorda.head];
      model.target_mm.row(node++) = segment.branch_point_mm + head.tip_mm - head.rest_mm;
    }
  node += static_cast<int>(valve.ties.size());
  for (const PapillaryHead& head : valve.heads) model.target_mm.row(node++) = head.tip_mm;
}

std::vector<std::array<int, 2>> edges_of(const Faces& faces, const std::vector<int>& chosen) {
  std::vector<std::array<int, 2>> edges;
  for (const int f : chosen)
    for (int k = 0; k < 3; ++k) {
      const int i = faces(f, k), j = faces(f, (k + 1) % 3);
      edges.push_back({std::min(i, j), std::max(i, j)});
    }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

double tension_n(const Cable& cable, const Points& x) {
  const double length = (end_position(cable, x) - vertex(x, cable.start)).norm();
  return std::max(0.0, cable.stiffness_n_per_mm * (length - cable.rest_mm));
}

void add_elastic_forces(const ClosureModel& model, const Points& x, Points& force) {
  for (const Spring& s : model.springs) {
    const Vec3 d = vertex(x, s.b) - vertex(x, s.a);
    const double length = d.norm();
    const double knee = (1.0 + s.transition) * s.rest_mm;
    const double pull = length <= knee ? s.pre_n_per_mm * (length - s.rest_mm)
                                       : s.pre_n_per_mm * s.transition * s.rest_mm +
                                             s.post_n_per_mm * (length - knee);
    const Vec3 f = (pull / length) * d;
    force.row(s.a) += f;
    force.row(s.b) -= f;
  }
  for (const Sheet& sheet : model.sheets) add_sheet_forces(model.law, sheet, x, force);
  for (const Hinge& hinge : model.hinges) add_hinge_forces(hinge, x, force);
  for (const ExponentialSheet& sheet : model.exponential_sheets) add_sheet_forces(sheet, x, force);
  for (const Cable& c : model.cables) {
    const Vec3 d = end_position(c, x) - vertex(x, c.start);
    const double length = d.norm();
    if (length <= c.rest_mm) continue;
    const Vec3 f = (c.stiffness_n_per_mm * (length - c.rest_mm) / length) * d;
    force.row(c.start) += f;
    for (const NodeShare& share : c.end) force.row(share.node) -= share.weight * f;
  }
}

void add_pressure_forces(const ClosureModel& model, const Points& x, Points& force) {
  for (int f = 0; f < model.faces.rows(); ++f) {
    const int i = model.faces(f, 0), j = model.faces(f, 1), k = model.faces(f, 2);
    const Vec3 a = vertex(x, i);
    // Half the cross product is area times normal; a third of the load goes to each vertex.
    const Vec3 share = (load_mpa(model, f) / 6.0) * (vertex(x, j) - a).cross(vertex(x, k) - a);
    force.row(i) += share;
    force.row(j) += share;
    force.row(k) += share;
  }
}

}  // namespace coapt
