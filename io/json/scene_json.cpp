#include "io/json/scene_json.h"

#include <algorithm>
#include <cmath>

#include "core/metrics/coaptation.h"
#include "core/metrics/loads.h"
#include "core/repair/leaflet_resection.h"
#include "core/valve/leaflet_coordinates.h"

namespace coapt {
namespace {

Json rounded(double value, double digits) {
  return std::isfinite(value) ? Json(std::round(value * digits) / digits) : nullptr;
}

Json mm(double value) { return rounded(value, 1e3); }
Json fine(double value) { return rounded(value, 1e4); }

Json point(const Vec3& p) { return {mm(p.x()), mm(p.y()), mm(p.z())}; }

Json direction(const Vec3& d) {
  return {rounded(d.x(), 1e6), rounded(d.y(), 1e6), rounded(d.z(), 1e6)};
}

Json flat(const Points& points) {
  Json list = Json::array();
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    for (Eigen::Index k = 0; k < 3; ++k) list.push_back(mm(points(i, k)));
  return list;
}

template <class T, class Write>
Json list_of(const T& entries, Write write) {
  Json list = Json::array();
  for (const auto& entry : entries) list.push_back(write(entry));
  return list;
}

Json faces_json(const Faces& faces) {
  Json list = Json::array();
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
    for (Eigen::Index k = 0; k < 3; ++k) list.push_back(faces(f, k));
  return list;
}

Json plane_json(const AnnulusFrame& plane) {
  return {{"origin_mm", point(plane.origin_mm)},
          {"x", direction(plane.x)},
          {"y", direction(plane.y)},
          {"normal", direction(plane.normal)}};
}

Json landmarks_json(const Landmarks& marks) {
  return {{"saddle_peak", marks.saddle_peak},
          {"mid_posterior", marks.mid_posterior},
          {"anterolateral_trigone", marks.anterolateral_trigone},
          {"posteromedial_trigone", marks.posteromedial_trigone},
          {"anterolateral_commissure", marks.anterolateral_commissure},
          {"posteromedial_commissure", marks.posteromedial_commissure}};
}

Json segment_json(const ChordaSegment& segment, const Vec3& end_mm, double tension_n) {
  Json json = {
      {"parent", segment.parent}, {"end_mm", point(end_mm)}, {"tension_n", fine(tension_n)}};
  if (!segment.inserts) return json;
  json["face"] = segment.insertion.face;
  json["weights"] = list_of(segment.insertion.weights, fine);
  return json;
}

Json chordae_json(const Valve& valve, const ClosureResult& closure) {
  Json list = Json::array();
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    const Chorda& chorda = valve.chordae[c];
    Json segments = Json::array();
    for (std::size_t s = 0; s < chorda.segments.size(); ++s)
      segments.push_back(segment_json(chorda.segments[s],
                                      closure.branch_points_mm[c].row(static_cast<Eigen::Index>(s)),
                                      closure.tension_n[c][s]));
    list.push_back({{"id", chorda.id},
                    {"kind", to_string(chorda.kind)},
                    {"head", chorda.head},
                    {"ruptured", chorda.ruptured},
                    {"segments", std::move(segments)}});
  }
  return list;
}

Json heads_json(const std::vector<PapillaryHead>& heads) {
  return list_of(heads, [](const PapillaryHead& head) -> Json {
    return {{"id", head.id},
            {"side", to_string(head.side)},
            {"rest_mm", point(head.rest_mm)},
            {"tip_mm", point(head.tip_mm)}};
  });
}

Json coordinates_json(const Valve& valve) {
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  return {{"around", list_of(coordinates.around, fine)},
          {"height", list_of(coordinates.height, fine)}};
}

Json strains_json(const Valve& valve, const Points& closed_mm) {
  const std::vector<FaceStrain> strains = face_strains(valve, closed_mm);
  return {{"circumferential",
           list_of(strains, [](const FaceStrain& s) { return fine(s.circumferential); })},
          {"radial", list_of(strains, [](const FaceStrain& s) { return fine(s.radial); })}};
}

Json leak_json(const Leak& leak) {
  return list_of(leak.openings, [](const LeakOpening& opening) -> Json {
    return {{"area_mm2", mm(opening.area_mm2)},
            {"points_mm", flat(opening.surface.points_mm)},
            {"faces", faces_json(opening.surface.faces)},
            {"outline", opening.surface.outline}};
  });
}

Json sections_json(const Valve& valve, const Points& closed_mm) {
  return list_of(
      fine_coaptation_sections(valve, closed_mm), [&](const CoaptationSection& section) -> Json {
        const SectionPlane plane = coaptation_plane(valve, section.along);
        return {
            {"along", fine(section.along)},
            {"point_mm", point(plane.point_mm)},
            {"normal", direction(plane.normal)},
            {"height_mm", mm(section.height_mm)},
            {"distance_mm", mm(section.distance_mm)},
            {"contact", section.contact},
            {"nearest_mm", std::isfinite(section.distance_mm) ? list_of(section.nearest_mm, point)
                                                              : Json(nullptr)}};
      });
}

Json sutures_json(const Valve& valve, const RepairPlan& plan) {
  Json list = Json::array();
  for (const RepairStep& step : plan.steps)
    if (const auto* suture = std::get_if<PapillaryApproximation>(&step))
      list.push_back({{"side", to_string(suture->side)},
                      {"tip_mm", point(papillary_tip_mm(valve, suture->side))},
                      {"anchor_mm", point(anchor_mm(valve, *suture))}});
  return list;
}

Json insertion_json(const Insertion& point) {
  return {{"face", point.face}, {"weights", list_of(point.weights, fine)}};
}

Json ties_json(const Valve& valve, const ClosureResult& closure) {
  Json list = Json::array();
  for (std::size_t i = 0; i < valve.ties.size(); ++i)
    list.push_back({{"id", valve.ties[i].id},
                    {"anterior", insertion_json(valve.ties[i].anterior)},
                    {"posterior", insertion_json(valve.ties[i].posterior)},
                    {"tension_n", fine(closure.tie_tension_n[i])}});
  return list;
}

Json seams_json(const Valve& valve, const RepairPlan& plan) {
  Json list = Json::array();
  for (const RepairStep& step : plan.steps)
    if (const auto* cut = std::get_if<LeafletResection>(&step))
      list.push_back(list_of(seam_of(*cut, leaflet_coordinates(valve), valve), insertion_json));
  return list;
}

/// `frames` of the states at most, evenly, the first and the last among them.
Json motion_json(const std::vector<Points>& states, int frames) {
  const int count = std::min(frames, static_cast<int>(std::ssize(states)));
  Json list = Json::array();
  for (int i = 0; i < count; ++i) {
    const double place = count == 1 ? 1.0 : static_cast<double>(i) / (count - 1);
    list.push_back(flat(states[static_cast<std::size_t>(
        std::lround(place * static_cast<double>(states.size() - 1)))]));
  }
  return list;
}

/// Where chordae are in the unstressed valve, without tension.
ClosureResult unloaded(const Valve& valve) {
  ClosureResult state;
  for (const Chorda& chorda : valve.chordae) {
    state.tension_n.emplace_back(chorda.segments.size(), 0.0);
    Points& ends = state.branch_points_mm.emplace_back(std::ssize(chorda.segments), 3);
    for (Eigen::Index s = 0; s < ends.rows(); ++s) {
      const auto& [face, weights] = chorda.segments[static_cast<std::size_t>(s)].insertion;
      ends.row(s) = chorda.segments[static_cast<std::size_t>(s)].branch_point_mm;
      if (!chorda.segments[static_cast<std::size_t>(s)].inserts) continue;
      ends.row(s).setZero();
      for (int k = 0; k < 3; ++k)
        ends.row(s) +=
            weights[static_cast<std::size_t>(k)] * valve.rest_mm.row(valve.faces(face, k));
    }
  }
  state.tie_tension_n.assign(valve.ties.size(), 0.0);
  return state;
}

/// All but what is measured of a closed state.
Json without_closed_state(const Valve& valve, const RepairPlan& plan,
                          const ClosureResult& closure) {
  return {{"schema", "coapt.scene/2"},
          {"plane", plane_json(annulus_frame(valve, AnnulusAxis::Commissures))},
          {"thickness_mm", valve.tissue.thickness_mm},
          {"rest_mm", flat(valve.rest_mm)},
          {"closed_mm", nullptr},
          {"faces", faces_json(valve.faces)},
          {"segments", list_of(valve.segments, [](Segment s) { return to_string(s); })},
          {"leaflet_coordinates", coordinates_json(valve)},
          {"annulus", valve.annulus},
          {"annulus_mm", flat(valve.annulus_mm)},
          {"landmarks", landmarks_json(valve.landmarks)},
          {"heads", heads_json(valve.heads)},
          {"chordae", chordae_json(valve, closure)},
          {"sutures", sutures_json(valve, plan)},
          {"ties", ties_json(valve, closure)},
          {"seams", seams_json(valve, plan)},
          {"strain", nullptr},
          {"leak", Json::array()},
          {"sections", Json::array()},
          {"motion_mm", Json::array()}};
}

}  // namespace

Json unloaded_scene_to_json(const Valve& valve, const RepairPlan& plan) {
  return without_closed_state(valve, plan, unloaded(valve));
}

Json scene_to_json(const Scene& scene) {
  const auto& [valve, closure, leak, plan, frames] = scene;
  Json json = without_closed_state(valve, plan, closure);
  json["motion_mm"] = motion_json(closure.motion_mm, frames);
  if (!closure.closed_mm.allFinite()) return json;
  json["closed_mm"] = flat(closure.closed_mm);
  json["strain"] = strains_json(valve, closure.closed_mm);
  json["leak"] = leak_json(leak);
  json["sections"] = sections_json(valve, closure.closed_mm);
  return json;
}

Json opening_scene_to_json(const OpenedValve& opened, int frames) {
  const auto& [valve, closure, measure, leak] = opened;
  return {{"faces", faces_json(valve.faces)},
          {"open_mm", closure.closed_mm.allFinite() ? flat(closure.closed_mm) : nullptr},
          {"annulus_mm", flat(valve.annulus_mm)},
          {"heads", heads_json(valve.heads)},
          {"chordae", chordae_json(valve, closure)},
          {"leak", leak_json(leak)},
          {"motion_mm", motion_json(closure.motion_mm, frames)}};
}

}  // namespace coapt
