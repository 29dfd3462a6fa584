#include "io/exchange/valve_markups.h"

#include <algorithm>

#include "core/metrics/annulus.h"
#include "core/repair/describe.h"
#include "core/valve/problem_list.h"

namespace coapt {
namespace {

constexpr const char* kLandmarkLabels[] = {"A", "P", "AL", "PM", "ALC", "PMC"};

Points annulus_of(const Valve& valve, const ValveShape& shape) {
  return shape.vertices_mm(valve.annulus, Eigen::all);
}

std::vector<std::string> numbered(const std::string& name, Eigen::Index count) {
  std::vector<std::string> labels;
  for (Eigen::Index i = 1; i <= count; ++i) labels.push_back(name + '-' + std::to_string(i));
  return labels;
}

Markup line(const std::string& name, const Vec3& from, const Vec3& to) {
  Points ends(2, 3);
  ends << from.transpose(), to.transpose();
  return {MarkupType::Line, name, {"papillary", "end"}, std::move(ends)};
}

std::string name_of(const OwnRing& ring) {
  return "ring: the annulus's own shape, " + undersizing_words(ring);
}
std::string name_of(const CatalogueRing& ring) {
  return "ring: " + ring.shape + ", size " + shown(ring.size_mm) + " mm";
}
std::string name_of(const DesignedRing& ring) {
  return "ring: " + ring.shape.name + ", size " + shown(ring.size_mm) + " mm";
}

Vec3 mean_head(const Valve& valve, const ValveShape& shape, Side side) {
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (std::size_t h = 0; h < valve.heads.size(); ++h) {
    if (valve.heads[h].side != side) continue;
    sum += shape.heads_mm.row(static_cast<Eigen::Index>(h));
    ++count;
  }
  return sum / count;
}

}  // namespace

std::array<int, 6> landmark_vertices(const Valve& valve) {
  const AnnulusFrame plane = annulus_frame(valve, AnnulusAxis::Commissures);
  const auto along = [&](int vertex) {
    return project(plane, annulus_position_mm(valve, vertex)).x();
  };
  const auto [lateral, medial] =
      std::minmax_element(valve.annulus.begin(), valve.annulus.end(),
                          [&](int a, int b) { return along(a) < along(b); });
  const Landmarks& marks = valve.landmarks;
  return {marks.saddle_peak,
          marks.mid_posterior,
          *lateral,
          *medial,
          marks.anterolateral_commissure,
          marks.posteromedial_commissure};
}

Markup annulus_markup(const Valve& valve, const ValveShape& shape) {
  return {MarkupType::ClosedCurve, "annulus", numbered("annulus", std::ssize(valve.annulus)),
          annulus_of(valve, shape)};
}

Markup papillary_markup(const Valve& valve, const ValveShape& shape) {
  std::vector<std::string> labels;
  for (const PapillaryHead& head : valve.heads) labels.push_back(head.id);
  return {MarkupType::Fiducial, "papillary muscle tips", std::move(labels), shape.heads_mm};
}

std::vector<Markup> pressed_markups(const Valve& valve) {
  ValveShape pressed = unstressed_shape(valve);
  const ValveShape rest = pressed;
  pressed.vertices_mm(valve.annulus, Eigen::all) = valve.annulus_mm;
  for (std::size_t h = 0; h < valve.heads.size(); ++h)
    pressed.heads_mm.row(static_cast<Eigen::Index>(h)) = valve.heads[h].tip_mm;
  std::vector<Markup> markups;
  if (pressed.vertices_mm != rest.vertices_mm) markups.push_back(annulus_markup(valve, pressed));
  if (pressed.heads_mm != rest.heads_mm) markups.push_back(papillary_markup(valve, pressed));
  for (Markup& markup : markups) markup.name += " under pressure";
  return markups;
}

Markup landmark_markup(const Valve& valve, const ValveShape& shape) {
  const auto vertices = landmark_vertices(valve);
  return {MarkupType::Fiducial,
          "landmarks",
          {std::begin(kLandmarkLabels), std::end(kLandmarkLabels)},
          shape.vertices_mm(vertices, Eigen::all)};
}

std::vector<Markup> repair_markups(const ClosedValve& exported, const ValveShape& shape) {
  const Valve& valve = exported.valve;
  std::vector<Markup> markups;
  for (const RepairStep& step : exported.plan.steps) {
    if (const auto* annuloplasty = std::get_if<Annuloplasty>(&step))
      markups.push_back(
          {MarkupType::ClosedCurve,
           std::visit([](const auto& ring) { return name_of(ring); }, annuloplasty->ring),
           numbered("ring", std::ssize(valve.annulus)), annulus_of(valve, shape)});
    if (const auto* suture = std::get_if<PapillaryApproximation>(&step))
      markups.push_back(line(std::string("suture: ") + to_string(suture->side) + " papillary to " +
                                 to_string(suture->anchor),
                             mean_head(valve, shape, suture->side), anchor_mm(valve, *suture)));
  }
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    const Chorda& chorda = valve.chordae[c];
    if (chorda.kind != ChordaKind::Neochorda || chorda.ruptured) continue;
    for (std::size_t s = 0; s < chorda.segments.size(); ++s)
      markups.push_back(line(chorda.id, segment_start(shape, chorda, c, s),
                             shape.chorda_ends_mm[c].row(static_cast<Eigen::Index>(s))));
  }
  for (const Tie& tie : valve.ties) {
    markups.push_back(line(std::string(kTieMarkup) + tie.id,
                           position(tie.anterior, valve.faces, shape.vertices_mm),
                           position(tie.posterior, valve.faces, shape.vertices_mm)));
    markups.back().labels = {"anterior", "posterior"};
  }
  for (const std::vector<Insertion>& seam : exported.repair.seams) {
    Points points_mm(std::ssize(seam), 3);
    for (std::size_t i = 0; i < seam.size(); ++i)
      points_mm.row(static_cast<Eigen::Index>(i)) =
          position(seam[i], valve.faces, shape.vertices_mm);
    markups.push_back({MarkupType::Curve, "seam: of a resection",
                       numbered("seam", points_mm.rows()), std::move(points_mm)});
  }
  return markups;
}

std::vector<Markup> valve_markups(const ClosedValve& exported, const ValveShape& shape) {
  std::vector<Markup> markups = {annulus_markup(exported.valve, shape),
                                 papillary_markup(exported.valve, shape),
                                 landmark_markup(exported.valve, shape)};
  for (Markup& markup : repair_markups(exported, shape)) markups.push_back(std::move(markup));
  return markups;
}

}  // namespace coapt
