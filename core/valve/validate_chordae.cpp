#include <cmath>
#include <set>

#include "core/valve/validate_parts.h"

namespace coapt {
namespace {

constexpr std::size_t kMaxChordae = 2000;
constexpr std::size_t kMaxSegments = 2000;
constexpr Range kRestLengthMm = {0.05, 100.0};
constexpr Range kDiameterMm = {0.05, 5.0};
constexpr Range kZoneMm = {0.0, 10.0};
constexpr Range kChordaKpa = {1.0, 1e7};
constexpr Range kBranchPointMm = {-500.0, 500.0};

void check_measures(const ChordaSegment& segment, int faces, const std::string& path,
                    ProblemList& problems) {
  check_range(problems, path + "/rest_length_mm", segment.rest_length_mm, kRestLengthMm, " mm");
  check_range(problems, path + "/diameter_mm", segment.diameter_mm, kDiameterMm, " mm");
  check_range(problems, path + "/zone_mm", segment.zone_mm, kZoneMm, " mm");
  if (segment.modulus_kpa != 0.0)
    check_range(problems, path + "/modulus_kpa", segment.modulus_kpa, kChordaKpa, " kPa");
  if (segment.inserts) {
    check_insertion(segment.insertion, faces, path + "/insertion", problems);
    return;
  }
  for (int axis = 0; axis < 3; ++axis) {
    check_range(problems, at(path + "/branch_point_mm", axis), segment.branch_point_mm[axis],
                kBranchPointMm, " mm");
  }
}

// The segments are one tree that starts at the head and whose leaves, and only they, insert.
void check_tree(const std::vector<ChordaSegment>& segments, const std::string& path,
                ProblemList& problems) {
  const int count = static_cast<int>(segments.size());
  const auto parent_of = [&](int i) { return segments[i].parent; };
  const auto parent_path = [&](int i) { return at(path, i) + "/parent"; };
  bool references = true;
  for (int i = 0; i < count; ++i) {
    if (parent_of(i) >= -1 && parent_of(i) < count) continue;
    references = false;
    problems.add(ErrorCode::BadReference, parent_path(i),
                 "is " + std::to_string(parent_of(i)) +
                     ", must be -1 (the head) or the index of an earlier segment");
  }
  if (!references) return;
  std::vector<int> children(segments.size(), 0);
  int trunks = 0;
  for (int i = 0; i < count; ++i) {
    const int parent = parent_of(i);
    if (parent < 0) {
      if (++trunks > 1) {
        problems.add(ErrorCode::BadTopology, parent_path(i),
                     "makes a second trunk; a chorda has one segment with parent -1");
      }
      continue;
    }
    ++children[parent];
    if (segments[parent].inserts) {
      problems.add(
          ErrorCode::BadTopology, parent_path(i),
          "is a segment that ends in the leaflet; only branch points carry further segments");
    }
    if (parent < i) continue;
    int ancestor = parent;
    for (int step = 0; step < count && ancestor >= 0 && ancestor != i; ++step) {
      ancestor = parent_of(ancestor);
    }
    if (ancestor == i) {
      problems.add(ErrorCode::BadTopology, parent_path(i), "closes a cycle");
    } else if (ancestor >= 0) {
      problems.add(ErrorCode::BadTopology, parent_path(i), "leads into a cycle, not to the head");
    } else {
      problems.add(
          ErrorCode::BadTopology, parent_path(i),
          "is " + std::to_string(parent) + ", must be smaller than the segment's own index");
    }
  }
  for (int i = 0; i < count; ++i) {
    const ChordaSegment& segment = segments[i];
    int ancestor = i;
    for (int step = 0; step <= count && ancestor >= 0; ++step) ancestor = parent_of(ancestor);
    if (segment.inserts && ancestor >= 0) {
      problems.add(ErrorCode::BadTopology, at(path, i),
                   "inserts in the leaflet but is not reached from the papillary head");
    }
    if (!segment.inserts && children[i] == 0) {
      problems.add(ErrorCode::BadTopology, at(path, i),
                   "ends in a branch point that carries no further segment");
    }
  }
}

}  // namespace

void check_chordae(const Valve& valve, ProblemList& problems) {
  if (valve.chordae.size() > kMaxChordae) {
    problems.add(ErrorCode::OutOfRange, "/chordae", "has more than 2000 chordae");
    return;
  }
  const int faces = static_cast<int>(valve.faces.rows());
  std::set<std::string> ids;
  for (std::size_t i = 0; i < valve.chordae.size(); ++i) {
    const Chorda& chorda = valve.chordae[i];
    const std::string path = at("/chordae", i);
    if (chorda.id.empty()) {
      problems.add(ErrorCode::OutOfRange, path + "/id", "is empty");
    } else if (!ids.insert(chorda.id).second) {
      problems.add(ErrorCode::BadReference, path + "/id", "repeats the id of an earlier chorda");
    }
    const auto heads = std::ssize(valve.heads);
    if (heads > 0 && (chorda.head < 0 || chorda.head >= heads)) {
      problems.add(ErrorCode::BadReference, path + "/head",
                   "is " + std::to_string(chorda.head) +
                       ", must be the index of a papillary head, 0 to " +
                       std::to_string(heads - 1));
    }
    const std::string segments = path + "/segments";
    if (chorda.segments.empty() || chorda.segments.size() > kMaxSegments) {
      problems.add(
          ErrorCode::OutOfRange, segments,
          "has " + std::to_string(chorda.segments.size()) + " segments, must have 1 to 2000");
      continue;
    }
    for (std::size_t s = 0; s < chorda.segments.size(); ++s) {
      check_measures(chorda.segments[s], faces, at(segments, s), problems);
    }
    check_tree(chorda.segments, segments, problems);
  }
}

}  // namespace coapt
