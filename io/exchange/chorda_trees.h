// Loose straight lines put together to chordae.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/valve/problem_list.h"
#include "io/mesh/import_valve.h"

namespace coapt {

/// A line from the papillary side to the leaflet side.
struct TracedLine {
  std::string file, place;  ///< where it was read: "Chords_mesh.vtk", "/lines/3"
  Vec3 start_mm = Vec3::Zero(), end_mm = Vec3::Zero();
  std::optional<double> rest_length_mm;
  double diameter_mm = 1.0;
  ChordaKind kind = ChordaKind::Marginal;
};

struct LabelledTip {
  Vec3 position_mm = Vec3::Zero();
  std::string label;
  std::optional<Vec3> pressed_mm;  ///< where it is under pressure, if that is told
};

/// Those whose label says the side.
std::vector<ImportedTip> imported_tips(const std::vector<LabelledTip>& tips);

/// Lines hang together where one begins within 1e-4 mm of where another ends. A line that begins at no other's
/// end is a chorda's trunk, and its beginning a papillary tip. Its side: of the label of the nearest tip within
/// 1 mm; without labels, by the leaflets: posteromedial is (to the anterior sheet) x (from tips to annulus). Problems: lines in a ring, a line that hangs on two
/// others, lines without length, sides that cannot be told.
/// @param source with its leaflets and annulus
std::vector<ImportedChorda> chorda_trees(const std::vector<TracedLine>& lines,
                                         const std::vector<LabelledTip>& tips,
                                         const ImportSource& source, ProblemList& problems);

}  // namespace coapt
