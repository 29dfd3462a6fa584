#include "io/exchange/valve_vtk.h"

#include "core/closure/crossing.h"
#include "core/metrics/annulus.h"
#include "core/metrics/leaflet_sides.h"
#include "core/metrics/loads.h"
#include "core/valve/patient_frame.h"

namespace coapt {
namespace {

std::vector<VtkScalars> face_data(const ClosedValve& exported, const ValveShape& shape) {
  VtkScalars leaflet{"leaflet", {}, true}, segment{"segment", {}, true},
      circumferential{"strain_circumferential", {}}, radial{"strain_radial", {}},
      crossing{"crossing", std::vector<double>(exported.valve.segments.size(), 0.0), true};
  for (const Leaflet side : leaflet_sides(exported.valve))
    leaflet.values.push_back(static_cast<double>(side));
  for (const Segment s : exported.valve.segments) segment.values.push_back(static_cast<double>(s));
  for (const FaceStrain& strain : face_strains(exported.valve, shape.vertices_mm)) {
    circumferential.values.push_back(strain.circumferential);
    radial.values.push_back(strain.radial);
  }
  for (const auto& [f, g] : crossing_pairs(exported.valve.faces, shape.vertices_mm))
    for (const int face : {f, g}) crossing.values[static_cast<std::size_t>(face)] = 1.0;
  return {leaflet, segment, circumferential, radial, crossing};
}

std::string title_of(const Valve& valve, const ValveShape& shape) {
  const std::string title = lies_in_patient_frame(valve) ? kPatientVtkTitle : kVtkTitle;
  return title + (shape.doubt.empty() ? "" : "; " + shape.doubt);
}

VtkScalars heights(const Valve& valve, const Points& points_mm) {
  const AnnulusFrame plane = annulus_frame(valve, AnnulusAxis::Commissures);
  const Eigen::VectorXd height = (points_mm.rowwise() - plane.origin_mm.transpose()) * plane.normal;
  return {"height_mm", {height.begin(), height.end()}};
}

}  // namespace

VtkPolyData leaflets_vtk(const ClosedValve& exported, const ValveShape& shape) {
  VtkPolyData data{
      title_of(exported.valve, shape), shape.vertices_mm, {}, exported.valve.faces, {}, {}, {}};
  data.point_data = {heights(exported.valve, shape.vertices_mm)};
  data.face_data = face_data(exported, shape);
  return data;
}

VtkPolyData leaflet_vtk(const ClosedValve& exported, const ValveShape& shape, Leaflet leaflet) {
  const VtkPolyData both = leaflets_vtk(exported, shape);
  const std::vector<Leaflet> sides = leaflet_sides(exported.valve);
  std::vector<Eigen::Index> faces, vertices;
  std::vector<int> index_of(static_cast<std::size_t>(both.points_mm.rows()), -1);
  for (std::size_t f = 0; f < sides.size(); ++f) {
    if (sides[f] != leaflet) continue;
    faces.push_back(static_cast<Eigen::Index>(f));
    for (const int vertex : both.faces.row(faces.back())) {
      int& index = index_of[static_cast<std::size_t>(vertex)];
      if (index >= 0) continue;
      index = static_cast<int>(vertices.size());
      vertices.push_back(vertex);
    }
  }
  const auto chosen = [](const std::vector<VtkScalars>& all, const auto& rows) {
    std::vector<VtkScalars> some;
    for (const VtkScalars& scalars : all) {
      some.push_back({scalars.name, {}, scalars.integers});
      for (const Eigen::Index row : rows)
        some.back().values.push_back(scalars.values[static_cast<std::size_t>(row)]);
    }
    return some;
  };
  VtkPolyData one{
      both.title, both.points_mm(vertices, Eigen::all), {}, both.faces(faces, Eigen::all), {}, {},
      {}};
  for (int& vertex : one.faces.reshaped()) vertex = index_of[static_cast<std::size_t>(vertex)];
  one.point_data = chosen(both.point_data, vertices);
  one.face_data = chosen(both.face_data, faces);
  return one;
}

VtkPolyData chordae_vtk(const ClosedValve& exported, const ValveShape& shape) {
  const Valve& valve = exported.valve;
  const ValveShape attached = attached_shape(valve, shape);
  VtkScalars chordae{"chorda", {}, true}, kind{"kind", {}, true}, rest{"rest_length_mm", {}},
      diameter{"diameter_mm", {}}, tension{"tension_n", {}};
  std::array<VtkScalars, 3> on;
  for (std::size_t k = 0; k < 3; ++k) on[k].name = kToInsertion[k];
  std::vector<Vec3> points;
  VtkPolyData data{title_of(valve, shape), {}, {}, Faces(0, 3), {}, {}, {}};
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    const Chorda& chorda = valve.chordae[c];
    if (chorda.ruptured) continue;
    const int first = static_cast<int>(points.size());  // the head, then the end of each segment
    points.push_back(attached.heads_mm.row(chorda.head));
    for (std::size_t s = 0; s < chorda.segments.size(); ++s) {
      const auto row = static_cast<Eigen::Index>(s);
      points.push_back(attached.chorda_ends_mm[c].row(row));
      for (std::size_t k = 0; k < 3; ++k)
        on[k].values.push_back(shape.chorda_ends_mm[c](row, static_cast<Eigen::Index>(k)) -
                               points.back()[static_cast<Eigen::Index>(k)]);
      data.lines.push_back(
          {first + chorda.segments[s].parent + 1, first + static_cast<int>(s) + 1});
      chordae.values.push_back(static_cast<double>(c));
      kind.values.push_back(static_cast<double>(chorda.kind));
      rest.values.push_back(chorda.segments[s].rest_length_mm);
      diameter.values.push_back(chorda.segments[s].diameter_mm);
      tension.values.push_back(shape.tension_n.empty() ? 0.0 : shape.tension_n[c][s]);
    }
  }
  data.points_mm.resize(std::ssize(points), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    data.points_mm.row(static_cast<Eigen::Index>(i)) = points[i];
  data.line_data = {chordae, kind, rest, diameter, tension, on[0], on[1], on[2]};
  return data;
}

VtkPolyData valve_vtk(const ClosedValve& exported, const ValveShape& shape) {
  VtkPolyData all = leaflets_vtk(exported, shape);
  const VtkPolyData lines = chordae_vtk(exported, shape);
  const Eigen::Index vertices = all.points_mm.rows();
  all.points_mm.conservativeResize(vertices + lines.points_mm.rows(), 3);
  all.points_mm.bottomRows(lines.points_mm.rows()) = lines.points_mm;
  for (const auto& [start, end] : lines.lines)
    all.lines.push_back({start + static_cast<int>(vertices), end + static_cast<int>(vertices)});
  all.line_data = lines.line_data;
  all.point_data = {heights(exported.valve, all.points_mm)};
  return all;
}

}  // namespace coapt
