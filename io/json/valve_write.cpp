#include <algorithm>

#include "io/json/json.h"
#include "io/json/valve_json.h"

namespace coapt {
namespace {

template <class Row>
Json triple(const Row& row) {
  return {row[0], row[1], row[2]};
}

template <class Matrix>
Json rows(const Matrix& matrix) {
  Json list = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) list.push_back(triple(matrix.row(i)));
  return list;
}

Json tissue_json(const Tissue& tissue) {
  return {{"density_g_per_mm3", tissue.density_g_per_mm3},
          {"thickness_mm", tissue.thickness_mm},
          {"circumferential_pre_kpa", tissue.circumferential_pre_kpa},
          {"circumferential_post_kpa", tissue.circumferential_post_kpa},
          {"circumferential_transition", tissue.circumferential_transition},
          {"radial_pre_kpa", tissue.radial_pre_kpa},
          {"radial_post_kpa", tissue.radial_post_kpa},
          {"radial_transition", tissue.radial_transition},
          {"chordae_kpa", tissue.chordae_kpa},
          {"reference", to_string(tissue.reference)},
          {"circumferential_prestretch", tissue.circumferential_prestretch},
          {"radial_prestretch", tissue.radial_prestretch},
          {"bending_n_mm", tissue.bending_n_mm}};
}

Json landmarks_json(const Landmarks& marks) {
  return {{"anterolateral_trigone", marks.anterolateral_trigone},
          {"posteromedial_trigone", marks.posteromedial_trigone},
          {"saddle_peak", marks.saddle_peak},
          {"mid_posterior", marks.mid_posterior},
          {"anterolateral_commissure", marks.anterolateral_commissure},
          {"posteromedial_commissure", marks.posteromedial_commissure}};
}

Json insertion_json(const Insertion& insertion) {
  return {{"face", insertion.face}, {"weights", triple(insertion.weights)}};
}

Json tie_json(const Tie& tie) {
  return {{"id", tie.id},
          {"anterior", insertion_json(tie.anterior)},
          {"posterior", insertion_json(tie.posterior)},
          {"rest_length_mm", tie.rest_length_mm},
          {"zone_mm", tie.zone_mm},
          {"stiffness_n_per_mm", tie.stiffness_n_per_mm}};
}

Json segment_json(const ChordaSegment& segment) {
  Json json = {{"parent", segment.parent},
               {"rest_length_mm", segment.rest_length_mm},
               {"diameter_mm", segment.diameter_mm}};
  if (segment.modulus_kpa > 0.0) json["modulus_kpa"] = segment.modulus_kpa;
  if (segment.inserts) {
    json["insertion"] = insertion_json(segment.insertion);
    json["zone_mm"] = segment.zone_mm;
  } else {
    json["branch_point_mm"] = triple(segment.branch_point_mm);
  }
  return json;
}

Json chorda_json(const Chorda& chorda) {
  Json segments = Json::array();
  for (const ChordaSegment& segment : chorda.segments) segments.push_back(segment_json(segment));
  return {{"id", chorda.id},
          {"kind", to_string(chorda.kind)},
          {"head", chorda.head},
          {"ruptured", chorda.ruptured},
          {"segments", std::move(segments)}};
}

Json head_json(const PapillaryHead& head) {
  return {{"id", head.id},
          {"side", to_string(head.side)},
          {"rest_mm", triple(head.rest_mm)},
          {"tip_mm", triple(head.tip_mm)}};
}

Json plain_head_json(const PapillaryHead& head) {
  return {{"id", head.id}, {"rest_mm", triple(head.rest_mm)}, {"tip_mm", triple(head.tip_mm)}};
}

Json leaflet_json(const NamedLeaflet& leaflet) {
  return {{"name", leaflet.name},
          {"thickness_mm", leaflet.thickness_mm},
          {"c0_kpa", leaflet.tissue.c0_kpa},
          {"c1_kpa", leaflet.tissue.c1_kpa},
          {"c2", leaflet.tissue.c2}};
}

template <class T, class ToJson>
Json list(const std::vector<T>& values, ToJson to_json_of) {
  Json json = Json::array();
  for (const T& value : values) json.push_back(to_json_of(value));
  return json;
}

std::string line_per_entry(const Json& json) {
  if (json.empty()) return "[]";
  std::string text = "[";
  const char* separator = "\n    ";
  for (const Json& entry : json) {
    text += separator + json_text(entry);
    separator = ",\n    ";
  }
  return text + "\n  ]";
}

Json patient_frame_json(const PatientFrame& frame) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i)
    rows.push_back({frame.axes(i, 0), frame.axes(i, 1), frame.axes(i, 2), frame.origin_mm[i]});
  rows.push_back({0, 0, 0, 1});
  return rows;
}

Json fitted_json(const FittedValues& fitted) {
  Json covariance = Json::array();
  for (Eigen::Index i = 0; i < fitted.covariance.rows(); ++i) {
    covariance.push_back(Json::array());
    for (Eigen::Index j = 0; j < fitted.covariance.cols(); ++j)
      covariance.back().push_back(fitted.covariance(i, j));
  }
  return {{"parameters", fitted.parameters}, {"covariance", std::move(covariance)}};
}

Json mitral_json(const Valve& valve) {
  return {{"schema", "coapt.valve/1"},
          {"name", valve.name},
          {"provenance", valve.provenance},
          {"pressure_kpa", valve.pressure_kpa},
          {"tissue", tissue_json(valve.tissue)},
          {"vertices_mm", rows(valve.rest_mm)},
          {"faces", rows(valve.faces)},
          {"segments", list(valve.segments, [](Segment segment) { return to_string(segment); })},
          {"fibre", rows(valve.fibre)},
          {"annulus", {{"vertices", valve.annulus}, {"positions_mm", rows(valve.annulus_mm)}}},
          {"landmarks", landmarks_json(valve.landmarks)},
          {"papillary_heads", list(valve.heads, head_json)},
          {"chordae", list(valve.chordae, chorda_json)}};
}

Json leaflet_valve_json(const Valve& valve) {
  return {{"schema", "coapt.valve/2"},
          {"name", valve.name},
          {"provenance", valve.provenance},
          {"pressure_kpa", valve.pressure_kpa},
          {"tissue",
           {{"density_g_per_mm3", valve.tissue.density_g_per_mm3},
            {"contact_thickness_mm", valve.tissue.thickness_mm},
            {"chordae_kpa", valve.tissue.chordae_kpa},
            {"bending_n_mm", valve.tissue.bending_n_mm}}},
          {"leaflets", list(valve.leaflets, leaflet_json)},
          {"vertices_mm", rows(valve.rest_mm)},
          {"faces", rows(valve.faces)},
          {"face_leaflets", valve.face_leaflet},
          {"fibre", rows(valve.fibre)},
          {"annulus", {{"vertices", valve.annulus}, {"positions_mm", rows(valve.annulus_mm)}}},
          {"papillary_heads", list(valve.heads, plain_head_json)},
          {"chordae", list(valve.chordae, chorda_json)}};
}

}  // namespace

Json to_json(const std::vector<Observation>& observed) {
  Json json = Json::object();
  for (const Observation& seen : observed) {
    Json& one = json[row_of(seen.figure).name];
    one = {{"value", seen.value}, {"sd", seen.sd}};
    if (!seen.source.empty()) one["source"] = seen.source;
  }
  return json;
}

std::string write_valve(const Valve& valve) {
  Json json = is_mitral(valve) ? mitral_json(valve) : leaflet_valve_json(valve);
  if (valve.systole != SystolicMotion{})
    json["systole"] = {{"annular_contraction", valve.systole.annular_contraction},
                       {"tip_approach", valve.systole.tip_approach}};
  if (!valve.ties.empty()) json["ties"] = list(valve.ties, tie_json);
  if (valve.drawn_chordae)
    json["drawn_chordae"] = {{"seed", valve.drawn_chordae->seed},
                             {"tips_given", valve.drawn_chordae->tips_given}};
  if (!valve.observed.empty()) json["observed"] = to_json(valve.observed);
  if (valve.fitted) json["fit"] = fitted_json(*valve.fitted);
  if (valve.patient) json["patient_frame"] = patient_frame_json(*valve.patient);
  std::string text = "{";
  const char* separator = "\n  ";
  for (const auto& [name, value] : json.items()) {
    const bool tall = value.is_array() && name != "segments" && name != "face_leaflets";
    text += separator + json_text(name) + ": " + (tall ? line_per_entry(value) : json_text(value));
    separator = ",\n  ";
  }
  return text + "\n}\n";
}

std::string write_tissue_file(const TissueFile& file) {
  const Json json = {{"schema", "coapt.tissue/1"},
                     {"pressure_kpa", file.pressure_kpa},
                     {"tissue", tissue_json(file.tissue)}};
  return json.dump(2) + '\n';
}

}  // namespace coapt
