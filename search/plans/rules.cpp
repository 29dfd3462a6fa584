#include "search/plans/rules.h"

#include <algorithm>

#include "core/repair/annuloplasty.h"
#include "core/repair/apply_plan.h"
#include "core/repair/rings.h"
#include "search/plans/search_option_table.h"

namespace coapt {
namespace {

/// Technique and kinds of a step, as rules call them.
struct StepWords {
  std::string technique;
  std::vector<std::string> kinds;
};

StepWords words_of(const Annuloplasty& step) { return {"annuloplasty", {shape_of(step)}}; }
StepWords words_of(const Neochorda& step) {
  return {"neochorda", {to_string(step.insertion.leaflet)}};
}
StepWords words_of(const ChordalLengthChange&) { return {"chordal_length_change", {}}; }
StepWords words_of(const ChordalExcision&) { return {"chordal_excision", {}}; }
StepWords words_of(const ChordalTransfer&) { return {"chordal_transfer", {}}; }
StepWords words_of(const EdgeToEdge& step) { return {"edge_to_edge", {to_string(step.device)}}; }
StepWords words_of(const LeafletResection& step) {
  return {"leaflet_resection", {to_string(step.shape), to_string(step.leaflet)}};
}
StepWords words_of(const PapillaryApproximation& step) {
  return {"papillary_approximation", {to_string(step.side), to_string(step.anchor)}};
}

std::vector<std::string> known_words(const SearchRules& rules) {
  std::vector<std::string> words = {"annuloplasty", std::string("annuloplasty:") + kOwnShape};
  for (const RingShape& shape : kRingShapes)
    words.push_back("annuloplasty:" + std::string(shape.name));
  for (const DesignedShape& shape : rules.shapes) words.push_back("annuloplasty:" + shape.name);
  for (const char* kind : {"", ":anterolateral", ":posteromedial", ":ipsilateral_trigone",
                           ":saddle_peak", ":annulus_point"})
    words.push_back(std::string("papillary_approximation") + kind);
  for (const char* word :
       {"neochorda", "neochorda:anterior", "neochorda:posterior", "chordal_length_change",
        "chordal_excision", "chordal_transfer", "edge_to_edge", "edge_to_edge:stitch",
        "edge_to_edge:clip", "edge_to_edge:cleft_suture", "leaflet_resection",
        "leaflet_resection:triangular", "leaflet_resection:quadrangular",
        "leaflet_resection:anterior", "leaflet_resection:posterior"})
    words.push_back(word);
  return words;
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

void check_shapes(const std::vector<DesignedShape>& shapes, ProblemList& problems) {
  if (shapes.size() > kMostShapes)
    problems.add(ErrorCode::OutOfRange, "/shapes",
                 "has " + std::to_string(shapes.size()) + " shapes, must have at most " +
                     std::to_string(kMostShapes));
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const std::string path = "/shapes/" + std::to_string(i);
    check_designed_shape(shapes[i], path, problems);
    for (std::size_t k = 0; k < i; ++k)
      if (shapes[k].name == shapes[i].name)
        problems.add(ErrorCode::BadReference, path + "/name",
                     "is '" + shapes[i].name + "', as that of another shape");
  }
}

}  // namespace

bool is_forbidden(const SearchRules& rules, const std::string& technique, const std::string& kind) {
  return std::any_of(rules.forbidden.begin(), rules.forbidden.end(), [&](const std::string& word) {
    return word == technique || word == technique + ":" + kind;
  });
}

Errors check_rules(const Valve& valve, const SearchRules& rules) {
  ProblemList problems;
  check_option_ranges(problems, rules);
  check_shapes(rules.shapes, problems);
  const std::vector<std::string> known = known_words(rules);
  for (std::size_t i = 0; i < rules.forbidden.size(); ++i)
    if (std::find(known.begin(), known.end(), rules.forbidden[i]) == known.end())
      problems.add(ErrorCode::BadReference, "/forbidden/" + std::to_string(i),
                   "is \"" + rules.forbidden[i] + "\", must be one of " + listed(known));
  const Expected<Valve> fixed = apply_plan(valve, rules.fixed);
  if (!fixed)
    for (const Error& error : fixed.errors())
      problems.add(error.code, "/fixed" + error.path, error.message);
  for (std::size_t i = 0; i < rules.fixed.steps.size(); ++i) {
    const StepWords words =
        std::visit([](const auto& step) { return words_of(step); }, rules.fixed.steps[i]);
    bool forbidden = is_forbidden(rules, words.technique, "");
    for (const std::string& kind : words.kinds)
      forbidden = forbidden || is_forbidden(rules, words.technique, kind);
    if (forbidden)
      problems.add(ErrorCode::ImpossibleStep, "/fixed/steps/" + std::to_string(i),
                   "is both fixed and forbidden");
  }
  return std::move(problems).take();
}

}  // namespace coapt
