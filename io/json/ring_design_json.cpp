#include "io/json/ring_design_json.h"

#include "io/json/result_json.h"
#include "io/json/ring_json.h"
#include "io/json/version.h"

namespace coapt {
namespace {

Json figures_json(const RingFigures& figures) {
  return {{"below_5_percent", figures.below_percent},
          {"leak_mm2", figures.leak_mm2},
          {"gradient_mmhg", figures.gradient_mmhg},
          {"stenotic_percent", figures.stenotic_percent},
          {"undersized_percent", figures.undersized_percent},
          {"durability_mm", figures.durability_mm},
          {"tenting_mm", figures.tenting_mm},
          {"suture_max_n", figures.suture_max_n},
          {"suture_normal_n", figures.suture_normal_n},
          {"size_mm", figures.size_mm}};
}

Json gain_json(const MeanInterval& gain) {
  return {{"mean", gain.mean}, {"low", gain.low}, {"high", gain.high}};
}

Json ring_candidate_json(const RingCandidate& candidate) {
  Json json;
  if (const auto* shape = std::get_if<DesignedShape>(&candidate.shape))
    json["ring"] = to_json(*shape);
  else
    json["shape"] = std::get<std::string>(candidate.shape);
  json["width_over_transverse"] = candidate.width_over_transverse;
  return json;
}

Json contrast_json(const RingContrast& contrast) {
  return {{"first", contrast.first},
          {"second", contrast.second},
          {"aetiology", contrast.aetiology},
          {"members", contrast.members},
          {"of_first", figures_json(contrast.of_first)},
          {"of_second", figures_json(contrast.of_second)},
          {"below_5_percent", gain_json(contrast.below_percent)},
          {"leak_mm2", gain_json(contrast.leak_mm2)},
          {"suture_max_n", gain_json(contrast.suture_max_n)},
          {"suture_normal_n", gain_json(contrast.suture_normal_n)}};
}

Json claims_json(const RingClaims& claims) {
  Json contrasts = Json::array(), sizes = Json::array();
  for (const RingContrast& contrast : claims.contrasts)
    contrasts.push_back(contrast_json(contrast));
  for (const RingSizeFigures& size : claims.sizes) sizes.push_back(figures_json(size.figures));
  return {{"contrasts", std::move(contrasts)},
          {"sizes", std::move(sizes)},
          {"sizes_aetiology", claims.sizes_aetiology},
          {"sizes_members", claims.sizes_members},
          {"tenting_before_mm", claims.tenting_before_mm}};
}

Json provenance_json(const RingDesignResult& result, const RingDesignSource& source) {
  const RingVerdict& all = result.verdicts.front();
  Json json = {{"population", source.population}};
  if (!source.aetiology.empty()) json["aetiology"] = source.aetiology;
  json.update({{"objective",
                "fraction of closures that leak 5 mm2 or more over members and disturbances, with "
                "stenosis, undersizing, mean leak, suture force and durability"},
               {"evaluations", source.evaluations},
               {"seed", source.seed},
               {"gain_held_out", all.below_percent.mean},
               {"gain_low", all.below_percent.low},
               {"gain_high", all.below_percent.high},
               {"against", ring_candidate_json(result.search.generic.candidate)},
               {"version", version()},
               {"revision", revision_json()}});
  return json;
}

}  // namespace

Json ring_document(const RingDesignResult& result, const RingDesignSource& source) {
  return to_json(result.search.design, provenance_json(result, source));
}

Json to_json(const RingDesignResult& result, const RingDesignSource& source) {
  const RingVerdict& all = result.verdicts.front();
  Json verdicts = Json::array(), rivals = Json::array();
  for (const RingVerdict& verdict : result.verdicts)
    verdicts.push_back({{"aetiology", verdict.aetiology},
                        {"members", verdict.members},
                        {"design", figures_json(verdict.design)},
                        {"generic", figures_json(verdict.generic)},
                        {"below_5_gain", gain_json(verdict.below_percent)},
                        {"leak_gain_mm2", gain_json(verdict.leak_mm2)}});
  for (const RatedRing& rival : result.search.rivals) {
    Json json = ring_candidate_json(rival.candidate);
    json["cost"] = rival.cost;
    rivals.push_back(std::move(json));
  }
  return result_document("coapt.ring_design/1",
                         {{"design", ring_document(result, source)},
                          {"generic", ring_candidate_json(result.search.generic.candidate)},
                          {"gain_held_out", all.below_percent.mean},
                          {"gain_low", all.below_percent.low},
                          {"gain_high", all.below_percent.high},
                          {"leak_gain_mm2", all.leak_mm2.mean},
                          {"leak_gain_low_mm2", all.leak_mm2.low},
                          {"leak_gain_high_mm2", all.leak_mm2.high},
                          {"searched_members", result.searched_members},
                          {"held_out_members", result.held_out_members},
                          {"untrusted_members", result.untrusted_members},
                          {"searched_disturbances", result.searched_disturbances},
                          {"held_out_disturbances", result.held_out_disturbances},
                          {"designs", result.search.designs},
                          {"evaluations", result.search.evaluations},
                          {"verdicts", std::move(verdicts)},
                          {"claims", claims_json(result.claims)},
                          {"rivals", std::move(rivals)}});
}

}  // namespace coapt
