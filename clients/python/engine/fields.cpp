#include "clients/python/engine/fields.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <vector>

#include "clients/python/engine/shapes.h"
#include "core/metrics/coaptation.h"
#include "core/metrics/loads.h"

namespace py = pybind11;

namespace coapt {
namespace {

/// F x 2
py::array_t<double> strain_of(const Valve& valve, const Points& closed_mm) {
  const std::vector<FaceStrain> strains = face_strains(valve, closed_mm);
  py::array_t<double> strain({std::ssize(strains), std::ptrdiff_t{2}});
  for (std::ptrdiff_t f = 0; f < std::ssize(strains); ++f) {
    strain.mutable_at(f, 0) = strains[static_cast<std::size_t>(f)].circumferential;
    strain.mutable_at(f, 1) = strains[static_cast<std::size_t>(f)].radial;
  }
  return strain;
}

void add_row(const Vec3& point, std::vector<double>& rows) {
  rows.insert(rows.end(), point.begin(), point.end());
}

}  // namespace

py::dict fields_of(const ClosedValve& closed) {
  const auto& [valve, closure, measure, plan, repair] = closed;
  py::dict fields;
  if (!closure.closed_mm.allFinite()) return fields;
  py::list segments, chordae, tensions, line_chorda, line_tensions;
  for (const Segment segment : valve.segments) segments.append(to_string(segment));
  std::vector<double> lines_mm;  // of each line its start, then its end
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    const Chorda& chorda = valve.chordae[c];
    const Points& ends_mm = closure.branch_points_mm[c];
    double at_head = 0.0;
    for (std::size_t s = 0; s < chorda.segments.size(); ++s) {
      const int parent = chorda.segments[s].parent;
      add_row(parent < 0 ? valve.heads[chorda.head].tip_mm : Vec3(ends_mm.row(parent)), lines_mm);
      add_row(ends_mm.row(static_cast<Index>(s)), lines_mm);
      line_chorda.append(c);
      line_tensions.append(closure.tension_n[c][s]);
      if (parent < 0) at_head += closure.tension_n[c][s];
    }
    chordae.append(chorda.id);
    tensions.append(at_head);
  }
  fields["strain"] = strain_of(valve, closure.closed_mm);
  fields["contact"] = nodes_in_contact({closure.closed_mm, valve.faces, {}, {}},
                                       kContactThicknesses * valve.tissue.thickness_mm);
  fields["segments"] = segments;
  fields["chordae"] = chordae;
  fields["tension_n"] = tensions;
  fields["line_mm"] = py::array_t<double>(
      {std::ssize(lines_mm) / 6, std::ptrdiff_t{2}, std::ptrdiff_t{3}}, lines_mm.data());
  fields["line_chorda"] = line_chorda;
  fields["line_tension_n"] = line_tensions;
  return fields;
}

}  // namespace coapt
