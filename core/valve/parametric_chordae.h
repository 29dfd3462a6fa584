#pragma once

#include <functional>
#include <vector>

#include "core/valve/valve.h"

namespace coapt {

/// The structured skirt that chordae are attached to: vertex (row, station) = row * stations +
/// station.
struct SkirtGrid {
  int stations = 0, rows = 0;
  std::vector<double> around;  ///< per station, ascending from 0
};

/// A place of the leaflets in leaflet coordinates (leaflet_coordinates.h).
struct ChordaSite {
  double around = 0.0, height = 1.0;
};

/// A chorda of one muscle: one insertion, or a trunk that branches.
struct ChordaGroup {
  ChordaKind kind = ChordaKind::Marginal;
  int head = 0;  ///< 0 anterior, 1 middle, 2 posterior
  Segment
      segment;  ///< that holds its middle; named here, because cells end elsewhere on every mesh
  std::vector<ChordaSite> sites;
};

/// Of the posteromedial muscle; `around` of 0 is its commissure, positive anterior.
std::vector<ChordaGroup> parametric_groups();

/// The group of the other muscle that mirrors it.
ChordaGroup mirrored(ChordaGroup group);

using InsertionAt = std::function<Insertion(const ChordaSite&)>;

/// Adds a muscle's heads and chordae. Tips: m x 3 in the valve's frame, x < 0 belongs to the
/// anterolateral muscle; one tip a side becomes three heads 2.5 mm apart, more than one are taken
/// as they are.
void add_muscle(const Points& tips_mm, Side side, const std::vector<ChordaGroup>& groups,
                const InsertionAt& insertion_at, Valve& valve);

/// The groups of parametric_groups() and their mirror images, on a skirt.
void add_parametric_chordae(const SkirtGrid& grid, const Points& tips_mm, Valve& valve);

}  // namespace coapt
