#include "io/json/diagnosis_json.h"

#include "core/closed/diagnosis_sentence.h"
#include "io/json/version.h"

namespace coapt {
namespace {

Json to_json(const SegmentDiagnosis& segment) {
  return {{"name", to_string(segment.segment)},
          {"finding", to_string(segment.finding)},
          {"sure", segment.sure},
          {"edge_mm", segment.edge_mm},
          {"highest_mm", segment.highest_mm},
          {"override_mm", segment.override_mm},
          {"width_mm", segment.width_mm},
          {"ruptured_chordae", segment.ruptured}};
}

Json to_json(const Cleft& cleft) {
  return {{"between", {to_string(cleft.first), to_string(cleft.second)}},
          {"along", cleft.along},
          {"depth_mm", cleft.depth_mm},
          {"share_of_height", cleft.share},
          {"leak_mm2", cleft.leak_mm2}};
}

Json thresholds() {
  constexpr const char* kMade = "generated valves, one half judged by the other";
  const auto row = [](const char* figure, double threshold, const char* unit, const char* source) {
    return Json{{"figure", figure}, {"threshold", threshold}, {"unit", unit}, {"source", source}};
  };
  return Json::array(
      {row("leak_mm2", kMildLeak_mm2, "mm2", "thesis 4.2.3"),
       row("override_mm", kProlapse_mm, "mm", kMade),
       row("override_mm of a segment with ruptured chordae", kFlail_mm, "mm", "assumed"),
       row("tethering", kTethered, "1", kMade),
       row("tethering beside a prolapse", kTetheredBesides, "1", "assumed"),
       row("tip_to_trigone_mm beside a prolapse", kFarTip_mm, "mm", "57 cadavers, mean + 2 sd"),
       row("ap_mm", kDilatedAp_mm, "mm", "ESC/EACTS guidelines on valvular heart disease 2012"),
       row("ap_mm over transverse_mm", kRoundAnnulus, "1",
           "healthy 0.75 ± 0.07 (PMC7368231, table 3), mean + 2 sd"),
       row("share_of_height of a cleft", kDeepCleft, "1", "assumed"),
       row("opening_area_mm2", kCannotOpen_mm2, "mm2",
           "severe stenosis, ASE/EACVI recommendations 2009"),
       row("opening_area_mm2 over the annulus", kCannotOpenShare, "1",
           "healthy valves open to half of it")});
}

}  // namespace

Json to_json(const std::optional<Diagnosis>& diagnosis, const Estimate& leak) {
  if (!diagnosis) return {};
  const Diagnosis& of = *diagnosis;
  Json types = Json::array(), segments = Json::array(), clefts = Json::array();
  for (const CarpentierType type : of.types) types.push_back(to_string(type));
  for (const SegmentDiagnosis& segment : of.segments) segments.push_back(to_json(segment));
  for (const Cleft& cleft : of.clefts) clefts.push_back(to_json(cleft));
  return {
      {"competent", of.competent},
      {"competent_sure", is_competence_sure(of, leak)},
      {"leak_mm2", of.leak_mm2},
      {"leak_error_mm2", of.leak_error_mm2},
      {"type", types.empty() ? Json() : types.front()},
      {"types", types},
      {"type_sure", of.type_sure},
      {"not_ruled_out", of.not_ruled_out ? Json(to_string(*of.not_ruled_out)) : Json()},
      {"segments", std::move(segments)},
      {"clefts", std::move(clefts)},
      {"tip_to_trigone_mm",
       {{"anterolateral", of.tip_to_trigone_mm[0]}, {"posteromedial", of.tip_to_trigone_mm[1]}}},
      {"tenting_height_mm", of.tenting_height_mm},
      {"tethering", of.tethering},
      {"tethered_side", of.tethered_side ? Json(to_string(*of.tethered_side)) : Json()},
      {"annulus",
       {{"ap_mm", of.ap_mm}, {"transverse_mm", of.transverse_mm}, {"dilated", of.annulus_dilated}}},
      {"thresholds", thresholds()},
      {"sentence", sentence_of(of, leak)},
      {"summary", summary_of(of)}};
}

Json diagnosis_document(const Diagnosis& diagnosis, const Valve& valve) {
  Json rest = {{"valve", valve.name}};
  rest.update(to_json(std::optional(diagnosis)));
  return result_document("coapt.diagnosis/1", std::move(rest));
}

}  // namespace coapt
