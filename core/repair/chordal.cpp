#include "core/repair/chordal.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/repair/limits.h"

namespace coapt {
namespace {

constexpr double kShortestTrunk_mm = 1.0;
constexpr double kNeochordaDiameter_mm = 1.0;
// A suture's bite holds as much of the leaflet as one fan of a natural chorda: a disc of 1.0 mm,
// counted in a human valve (docs/researcher/model.md), as a cone of the same rms radius.
constexpr double kBite_mm = 1.3;

template <class Items>
auto find_by_id(Items& items, const std::string& id) {
  return std::find_if(items.begin(), items.end(),
                      [&id](const auto& item) { return item.id == id; });
}

template <class Items>
std::string ids(const Items& items) {
  std::string list;
  for (const auto& item : items) list += (list.empty() ? "" : ", ") + item.id;
  return list;
}

bool check_point(const LeafletPoint& point, const std::string& path, ProblemList& problems) {
  const bool along = check_range(problems, path + "/along", point.along, kShare);
  return check_range(problems, path + "/height", point.height, kShare) && along;
}

/// Lists a problem unless the chorda is there and intact.
bool check_chorda(const std::string& id, const Valve& valve, const std::string& path,
                  ProblemList& problems) {
  const auto chorda = find_by_id(valve.chordae, id);
  if (chorda == valve.chordae.end()) {
    problems.add(ErrorCode::BadReference, path + "/chorda",
                 "is '" + id + "', this valve has: " + ids(valve.chordae));
    return false;
  }
  if (!chorda->ruptured) return true;
  problems.add(ErrorCode::ImpossibleStep, path + "/chorda",
               "is '" + id + "', which is ruptured; it must be an intact chorda");
  return false;
}

void move_branch_points(const Vec3& head, const Vec3& old_end, const Vec3& new_end,
                        Chorda& chorda) {
  const double reach = (old_end - head).norm();
  for (ChordaSegment& segment : chorda.segments) {
    if (segment.inserts) continue;
    const double share = std::clamp((segment.branch_point_mm - head).norm() / reach, 0.0, 1.0);
    segment.branch_point_mm += share * (new_end - old_end);
  }
}

}  // namespace

bool check_neochorda(const Neochorda& step, const Valve& valve, const std::string& path,
                     ProblemList& problems) {
  const bool head = find_by_id(valve.heads, step.head) != valve.heads.end();
  if (!head)
    problems.add(ErrorCode::BadReference, path + "/head",
                 "is '" + step.head + "', this valve has: " + ids(valve.heads));
  const bool point = check_point(step.insertion, path + "/insertion", problems);
  const bool length =
      check_range(problems, path + "/length_mm", step.length_mm, kNeochordaMm, " mm");
  return head && point && length;
}

bool check_length_change(const ChordalLengthChange& step, const Valve& valve,
                         const std::string& path, ProblemList& problems) {
  const bool range =
      check_range(problems, path + "/change_mm", step.change_mm, kLengthChangeMm, " mm");
  if (!check_chorda(step.chorda, valve, path, problems) || !range) return false;
  for (const ChordaSegment& segment : find_by_id(valve.chordae, step.chorda)->segments) {
    if (segment.parent >= 0 || segment.rest_length_mm + step.change_mm > kShortestTrunk_mm)
      continue;
    problems.add(ErrorCode::ImpossibleStep, path + "/change_mm",
                 "is " + shown(step.change_mm) + ", but the trunk of '" + step.chorda + "' is " +
                     shown(segment.rest_length_mm) + " mm long and more than 1 mm must be left");
    return false;
  }
  return true;
}

bool check_excision(const ChordalExcision& step, const Valve& valve, const std::string& path,
                    ProblemList& problems) {
  return check_chorda(step.chorda, valve, path, problems);
}

bool check_transfer(const ChordalTransfer& step, const Valve& valve, const std::string& path,
                    ProblemList& problems) {
  const bool point = check_point(step.insertion, path + "/insertion", problems);
  return check_chorda(step.chorda, valve, path, problems) && point;
}

std::string text_key(const Neochorda& step) {
  char numbers[128];
  std::snprintf(numbers, sizeof numbers, " %s %.17g %.17g %.17g", to_string(step.insertion.leaflet),
                step.insertion.along, step.insertion.height, step.length_mm);
  return step.head + numbers;
}

void apply_neochorda(const Neochorda& step, const LeafletCoordinates& coordinates, Valve& valve) {
  Chorda chorda;
  for (int number = 1; number == 1 || find_by_id(valve.chordae, chorda.id) != valve.chordae.end();
       ++number)
    chorda.id = "neochorda-" + std::to_string(number);
  chorda.kind = ChordaKind::Neochorda;
  chorda.head = static_cast<int>(find_by_id(valve.heads, step.head) - valve.heads.begin());
  ChordaSegment segment;
  segment.rest_length_mm = step.length_mm;
  segment.diameter_mm = kNeochordaDiameter_mm;
  segment.inserts = true;
  segment.insertion = locate(valve, coordinates, step.insertion);
  segment.zone_mm = kBite_mm;
  chorda.segments.push_back(segment);
  valve.chordae.push_back(chorda);
}

void apply_length_change(const ChordalLengthChange& step, Valve& valve) {
  for (ChordaSegment& segment : find_by_id(valve.chordae, step.chorda)->segments)
    if (segment.parent < 0) segment.rest_length_mm += step.change_mm;
}

void apply_excision(const ChordalExcision& step, Valve& valve) {
  find_by_id(valve.chordae, step.chorda)->ruptured = true;
}

void apply_transfer(const ChordalTransfer& step, const LeafletCoordinates& coordinates,
                    Valve& valve) {
  Chorda& chorda = *find_by_id(valve.chordae, step.chorda);
  const Insertion insertion = locate(valve, coordinates, step.insertion);
  Vec3 old_end = Vec3::Zero();
  int insertions = 0;
  for (ChordaSegment& segment : chorda.segments) {
    if (!segment.inserts) continue;
    old_end += position(segment.insertion, valve.faces, valve.rest_mm);
    ++insertions;
    segment.insertion = insertion;
    segment.zone_mm = kBite_mm;
  }
  move_branch_points(valve.heads[chorda.head].rest_mm, old_end / insertions,
                     position(insertion, valve.faces, valve.rest_mm), chorda);
}

}  // namespace coapt
