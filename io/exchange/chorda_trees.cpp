#include "io/exchange/chorda_trees.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "io/mesh/papillary_side.h"

namespace coapt {
namespace {

constexpr double kSamePoint_mm = 1e-4;
constexpr double kSameTip_mm = 1.0;
constexpr double kShortest_mm = 1e-3;

/// Points by the cells of a grid, so that the same point is found without looking at all.
class PointIndex {
 public:
  void add(const Vec3& point, std::size_t line) { cells_[cell(point)].push_back({point, line}); }

  std::vector<std::size_t> at(const Vec3& point) const {
    std::vector<std::size_t> lines;
    for (const double dx : {-kSamePoint_mm, kSamePoint_mm})
      for (const double dy : {-kSamePoint_mm, kSamePoint_mm})
        for (const double dz : {-kSamePoint_mm, kSamePoint_mm}) {
          const auto found = cells_.find(cell(point + Vec3(dx, dy, dz)));
          if (found == cells_.end()) continue;
          for (const auto& [other, line] : found->second)
            if ((other - point).norm() <= kSamePoint_mm &&
                std::find(lines.begin(), lines.end(), line) == lines.end())
              lines.push_back(line);
        }
    return lines;
  }

 private:
  using Cell = std::array<long long, 3>;
  static Cell cell(const Vec3& point) {
    constexpr double kCell_mm = 1e-2;
    return {std::llround(point.x() / kCell_mm), std::llround(point.y() / kCell_mm),
            std::llround(point.z() / kCell_mm)};
  }
  std::map<Cell, std::vector<std::pair<Vec3, std::size_t>>> cells_;
};

void add(const TracedLine& line, ErrorCode code, const std::string& message,
         ProblemList& problems) {
  problems.add(code, line.file + line.place, message);
}

/// The line that each hangs on, or -1.
std::vector<int> parents_of(const std::vector<TracedLine>& lines, ProblemList& problems) {
  PointIndex ends;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if ((lines[i].end_mm - lines[i].start_mm).norm() < kShortest_mm)
      add(lines[i], ErrorCode::BadGeometry, "is shorter than 0.001 mm", problems);
    ends.add(lines[i].end_mm, i);
  }
  std::vector<int> parents;
  for (const TracedLine& line : lines) {
    const std::vector<std::size_t> found = ends.at(line.start_mm);
    if (found.size() > 1)
      add(line, ErrorCode::BadTopology,
          "begins where " + std::to_string(found.size()) + " others end; must be one", problems);
    parents.push_back(found.empty() ? -1 : static_cast<int>(found.front()));
  }
  return parents;
}

/// The labelled tip within reach, or null.
const LabelledTip* nearest_tip(const Vec3& tip_mm, const std::vector<LabelledTip>& tips) {
  const auto nearest =
      std::min_element(tips.begin(), tips.end(), [&](const LabelledTip& a, const LabelledTip& b) {
        return (a.position_mm - tip_mm).norm() < (b.position_mm - tip_mm).norm();
      });
  if (nearest == tips.end() || (nearest->position_mm - tip_mm).norm() > kSameTip_mm) return nullptr;
  return &*nearest;
}

/// The posteromedial direction, as far as two sheets tell; of the length 0 if they do not.
Vec3 posteromedial(const ImportSource& source, const Vec3& mean_tip_mm) {
  if (source.leaflets.size() != 2) return Vec3::Zero();
  const Vec3 centre = source.annulus_mm.colwise().mean();
  const Vec3 anterior = (source.leaflets[0].vertices_mm.colwise().mean() -
                         source.leaflets[1].vertices_mm.colwise().mean());
  return anterior.cross(centre - mean_tip_mm);
}

/// The lines of a tree, each after the one it hangs on.
std::vector<std::size_t> tree_of(std::size_t trunk,
                                 const std::vector<std::vector<std::size_t>>& children) {
  std::vector<std::size_t> tree = {trunk};
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const auto& next = children[tree[i]];
    tree.insert(tree.end(), next.begin(), next.end());
  }
  return tree;
}

ImportedChorda chorda_of(const std::vector<TracedLine>& lines, const std::vector<int>& parents,
                         const std::vector<std::vector<std::size_t>>& children,
                         const std::vector<std::size_t>& tree) {
  ImportedChorda chorda;
  chorda.id = std::to_string(tree.front() + 1);
  chorda.kind = lines[tree.front()].kind;
  chorda.tip_mm = lines[tree.front()].start_mm;
  std::map<std::size_t, int> place;
  int inserting = 0;
  for (const std::size_t line : tree) {
    place[line] = static_cast<int>(chorda.segments.size());
    ImportedSegment& segment = chorda.segments.emplace_back();
    segment.parent = parents[line] < 0 ? -1 : place.at(static_cast<std::size_t>(parents[line]));
    segment.end_mm = lines[line].end_mm;
    segment.inserts = children[line].empty();
    segment.rest_length_mm = lines[line].rest_length_mm;
    segment.diameter_mm = lines[line].diameter_mm;
    if (!segment.inserts) continue;
    chorda.insertion_mm += segment.end_mm;
    ++inserting;
  }
  chorda.insertion_mm /= inserting;
  return chorda;
}

}  // namespace

std::vector<ImportedTip> imported_tips(const std::vector<LabelledTip>& tips) {
  std::vector<ImportedTip> imported;
  for (const LabelledTip& tip : tips)
    if (const std::optional<Side> side = papillary_side(tip.label))
      imported.push_back({*side, tip.position_mm});
  return imported;
}

std::vector<ImportedChorda> chorda_trees(const std::vector<TracedLine>& lines,
                                         const std::vector<LabelledTip>& tips,
                                         const ImportSource& source, ProblemList& problems) {
  const std::vector<int> parents = parents_of(lines, problems);
  std::vector<std::vector<std::size_t>> children(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (parents[i] >= 0) children[static_cast<std::size_t>(parents[i])].push_back(i);

  std::vector<ImportedChorda> chordae;
  std::vector<std::size_t> trunks;
  std::vector<bool> reached(lines.size(), false);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (parents[i] >= 0) continue;
    const std::vector<std::size_t> tree = tree_of(i, children);
    for (const std::size_t line : tree) reached[line] = true;
    chordae.push_back(chorda_of(lines, parents, children, tree));
    trunks.push_back(i);
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (!reached[i])
      add(lines[i], ErrorCode::BadTopology, "lies in a loop of lines; must lead from a tip",
          problems);

  Vec3 mean_tip = Vec3::Zero();
  for (const ImportedChorda& chorda : chordae)
    mean_tip += chorda.tip_mm / static_cast<double>(chordae.size());
  const Vec3 medial = posteromedial(source, mean_tip);
  for (std::size_t i = 0; i < chordae.size(); ++i) {
    const LabelledTip* tip = nearest_tip(chordae[i].tip_mm, tips);
    const std::optional<Side> labelled = tip ? papillary_side(tip->label) : std::nullopt;
    if (tip) chordae[i].pressed_tip_mm = tip->pressed_mm;
    if (!labelled && medial.norm() == 0.0)
      add(lines[trunks[i]], ErrorCode::MissingField,
          "begins at a tip of unknown side; label the papillary tips AL or PM (a list named "
          "papillary, .mrk.json), or provide an anterior and a posterior leaflet",
          problems);
    const bool is_medial = (chordae[i].tip_mm - mean_tip).dot(medial) > 0.0;
    chordae[i].side = labelled.value_or(is_medial ? Side::Posteromedial : Side::Anterolateral);
  }
  return chordae;
}

}  // namespace coapt
