#include "core/valve/refine.h"

#include <algorithm>
#include <map>

#include "core/valve/subdivide.h"
#include "core/valve/validate.h"

namespace coapt {
namespace {

void refine_annulus(const Valve& valve, const Subdivision& fine, Valve& refined) {
  std::map<std::array<int, 2>, int> middle_of;
  for (std::size_t i = 0; i < fine.edges.size(); ++i)
    middle_of[fine.edges[i]] = fine.vertices + static_cast<int>(i);
  const Index size = std::ssize(valve.annulus);
  refined.annulus.clear();
  refined.annulus_mm.resize(2 * size, 3);
  for (Index i = 0; i < size; ++i) {
    const Index next = (i + 1) % size;
    const auto [low, high] = std::minmax(valve.annulus[i], valve.annulus[next]);
    refined.annulus.push_back(valve.annulus[i]);
    refined.annulus.push_back(middle_of.at({low, high}));
    refined.annulus_mm.row(2 * i) = valve.annulus_mm.row(i);
    refined.annulus_mm.row(2 * i + 1) =
        0.5 * (valve.annulus_mm.row(i) + valve.annulus_mm.row(next));
  }
}

template <class T>
std::vector<T> four_times(const std::vector<T>& of_faces) {
  std::vector<T> all;
  for (const T& one : of_faces) all.insert(all.end(), 4, one);
  return all;
}

/// What each face has, four times over.
void refine_tissue(const Valve& valve, Valve& refined) {
  refined.segments = four_times(valve.segments);
  refined.face_leaflet = four_times(valve.face_leaflet);
  refined.fibre.resize(4 * valve.faces.rows(), 3);
  for (Index face = 0; face < valve.faces.rows(); ++face)
    for (Index part = 0; part < 4; ++part)
      refined.fibre.row(4 * face + part) = valve.fibre.row(face);
}

std::string in_words(const Valve& valve, const Valve& refined) {
  return "refined from " + std::to_string(valve.faces.rows()) + " to " +
         std::to_string(refined.faces.rows()) + " triangles, at the midpoints of the edges";
}

}  // namespace

Expected<Valve> refine(const Valve& valve) {
  const Subdivision fine = subdivide(valve.faces, static_cast<int>(valve.rest_mm.rows()));
  Valve refined = valve;
  refined.faces = fine.faces;
  refined.rest_mm = with_midpoints(valve.rest_mm, fine);
  refine_annulus(valve, fine, refined);
  refine_tissue(valve, refined);
  for (Chorda& chorda : refined.chordae)
    for (ChordaSegment& segment : chorda.segments)
      if (segment.inserts) segment.insertion = subdivided(segment.insertion);
  for (Tie& tie : refined.ties) {
    tie.anterior = subdivided(tie.anterior);
    tie.posterior = subdivided(tie.posterior);
  }
  if (Errors errors = validate(refined); !errors.empty()) return errors;
  refined.provenance.push_back(in_words(valve, refined));
  return refined;
}

}  // namespace coapt
