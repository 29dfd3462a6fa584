// Resections first, because a place on a leaflet is one on what is left of it; then rings and what clips draw in, which move
// the anchors; then sutures, which move the tips; then chordae and edges. Within one kind no two steps
// touch the same thing (that is refused), and neochordae and edge-to-edge steps are sorted: so the
// order of the steps in the plan cannot matter.

#include "core/repair/apply_plan.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/repair/annuloplasty.h"
#include "core/repair/approximation.h"
#include "core/repair/chordal.h"
#include "core/repair/describe.h"
#include "core/repair/edge_to_edge.h"
#include "core/repair/leaflet_resection.h"
#include "core/valve/validate.h"

namespace coapt {
namespace {

std::string step_path(std::size_t i) { return "/steps/" + std::to_string(i); }

void refuse_second(const std::string& path, const std::string& what, std::size_t first,
                   ProblemList& problems) {
  problems.add(ErrorCode::ImpossibleStep, path,
               "is a second " + what + ", after that of step " + std::to_string(first + 1) +
                   " (counted from 1); only one is possible");
}

void resect(const RepairPlan& plan, const LeafletCoordinates& coordinates, Valve& valve,
            ProblemList& problems) {
  for (const Leaflet leaflet : {Leaflet::Anterior, Leaflet::Posterior}) {
    std::vector<std::size_t> cuts;
    for (std::size_t i = 0; i < plan.steps.size(); ++i)
      if (const auto* step = std::get_if<LeafletResection>(&plan.steps[i]))
        if (step->leaflet == leaflet) cuts.push_back(i);
    if (cuts.empty()) continue;
    for (std::size_t k = 1; k < cuts.size(); ++k)
      refuse_second(step_path(cuts[k]) + "/leaflet",
                    std::string("resection of the ") + to_string(leaflet) + " leaflet", cuts[0],
                    problems);
    const auto& step = std::get<LeafletResection>(plan.steps[cuts[0]]);
    if (check_resection(step, coordinates, valve, step_path(cuts[0]), problems))
      apply_resection(step, coordinates, valve);
  }
}

void place_ring(const RepairPlan& plan, Valve& valve, ProblemList& problems) {
  std::vector<std::size_t> rings;
  for (std::size_t i = 0; i < plan.steps.size(); ++i)
    if (std::holds_alternative<Annuloplasty>(plan.steps[i])) rings.push_back(i);
  if (rings.empty()) return;
  for (std::size_t k = 1; k < rings.size(); ++k)
    refuse_second(step_path(rings[k]), "ring", rings[0], problems);
  const auto& step = std::get<Annuloplasty>(plan.steps[rings[0]]);
  if (check_annuloplasty(step, valve, step_path(rings[0]), problems))
    apply_annuloplasty(step, valve);
}

void tie_sutures(const RepairPlan& plan, Valve& valve, ProblemList& problems) {
  std::map<Side, std::size_t> tied;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const auto* step = std::get_if<PapillaryApproximation>(&plan.steps[i]);
    if (step == nullptr) continue;
    const auto [first, is_first] = tied.emplace(step->side, i);
    if (!is_first)
      refuse_second(step_path(i) + "/side",
                    std::string("suture of the ") + to_string(step->side) + " muscle",
                    first->second, problems);
    else if (check_approximation(*step, valve, step_path(i), problems))
      apply_approximation(*step, valve);
  }
}

/// Treats the chordae and edges of one plan; every repair step has an overload here.
class ChordalPass {
 public:
  ChordalPass(const LeafletCoordinates& coordinates, Valve& valve, ProblemList& problems)
      : coordinates_(coordinates), valve_(valve), problems_(problems) {}

  void treat(const Annuloplasty&, std::size_t) {}
  void treat(const PapillaryApproximation&, std::size_t) {}
  void treat(const LeafletResection&, std::size_t) {}
  void treat(const EdgeToEdge& step, std::size_t i) {
    if (check_edge_to_edge(step, step_path(i), problems_)) edges_.push_back(step);
  }
  void treat(const Neochorda& step, std::size_t i) {
    if (check_neochorda(step, valve_, step_path(i), problems_)) neochordae_.push_back(step);
  }
  void treat(const ChordalLengthChange& step, std::size_t i) {
    if (claim(step.chorda, i) && check_length_change(step, valve_, step_path(i), problems_))
      apply_length_change(step, valve_);
  }
  void treat(const ChordalExcision& step, std::size_t i) {
    if (claim(step.chorda, i) && check_excision(step, valve_, step_path(i), problems_))
      apply_excision(step, valve_);
  }
  void treat(const ChordalTransfer& step, std::size_t i) {
    if (claim(step.chorda, i) && check_transfer(step, valve_, step_path(i), problems_))
      apply_transfer(step, coordinates_, valve_);
  }

  /// After all steps, so that none of them can name a neochorda of this plan.
  void append_neochordae() {
    std::sort(neochordae_.begin(), neochordae_.end(),
              [](const Neochorda& a, const Neochorda& b) { return text_key(a) < text_key(b); });
    for (const Neochorda& step : neochordae_) apply_neochorda(step, coordinates_, valve_);
  }
  void tie_edges() {
    std::sort(edges_.begin(), edges_.end(),
              [](const EdgeToEdge& a, const EdgeToEdge& b) { return text_key(a) < text_key(b); });
    for (const EdgeToEdge& step : edges_) apply_edge_to_edge(step, coordinates_, valve_);
  }

 private:
  bool claim(const std::string& chorda, std::size_t i) {
    const auto [first, is_first] = claimed_.emplace(chorda, i);
    if (!is_first)
      refuse_second(step_path(i) + "/chorda", "step on chorda '" + chorda + "'", first->second,
                    problems_);
    return is_first;
  }

  const LeafletCoordinates& coordinates_;
  Valve& valve_;
  ProblemList& problems_;
  std::map<std::string, std::size_t> claimed_;
  std::vector<Neochorda> neochordae_;
  std::vector<EdgeToEdge> edges_;
};

bool is_in(const std::string& path, const char* list, std::size_t index) {
  return path.starts_with(std::string(list) + '/' + std::to_string(index) + '/');
}

bool is_of_chorda(const std::string& path, const std::string& id, const Valve& valve) {
  for (std::size_t c = 0; c < valve.chordae.size(); ++c)
    if (valve.chordae[c].id == id && is_in(path, "/chordae", c)) return true;
  return false;
}

// Whether a step changes what lies at `path` in the repaired valve.
bool changes(const Annuloplasty&, const std::string& path, const Valve&) {
  return path.starts_with("/annulus") || path.starts_with("/landmarks");
}
bool changes(const PapillaryApproximation& step, const std::string& path, const Valve& valve) {
  for (std::size_t h = 0; h < valve.heads.size(); ++h)
    if (valve.heads[h].side == step.side && is_in(path, "/papillary_heads", h)) return true;
  return false;
}
bool changes(const Neochorda&, const std::string& path, const Valve&) { return path == "/chordae"; }
bool changes(const EdgeToEdge&, const std::string& path, const Valve&) {
  return path.starts_with("/ties") || path.starts_with("/annulus");
}
bool changes(const LeafletResection&, const std::string& path, const Valve&) {
  return path.starts_with("/vertices_mm") || path.starts_with("/faces") ||
         path.starts_with("/fibre") || path.starts_with("/annulus") ||
         path.starts_with("/landmarks") || path.starts_with("/chordae");
}
bool changes(const ChordalLengthChange& step, const std::string& path, const Valve& valve) {
  return is_of_chorda(path, step.chorda, valve);
}
bool changes(const ChordalExcision& step, const std::string& path, const Valve& valve) {
  return is_of_chorda(path, step.chorda, valve);
}
bool changes(const ChordalTransfer& step, const std::string& path, const Valve& valve) {
  return is_of_chorda(path, step.chorda, valve);
}

/// What is wrong with the repaired valve, laid to the first step that can have done it ("" if none
/// can: then the valve was none before).
Errors check_result(const Valve& repaired, const RepairPlan& plan) {
  ProblemList problems;
  for (const Error& error : validate(repaired)) {
    std::string step;
    for (std::size_t i = 0; i < plan.steps.size() && step.empty(); ++i)
      if (std::visit([&](const auto& s) { return changes(s, error.path, repaired); },
                     plan.steps[i]))
        step = step_path(i);
    problems.add(ErrorCode::ImpossibleStep, step,
                 "leaves no valid valve: " + error.path + ' ' + error.message);
  }
  return std::move(problems).take();
}

bool needs_coordinates(const RepairPlan& plan) {
  return std::any_of(plan.steps.begin(), plan.steps.end(), [](const RepairStep& step) {
    return std::holds_alternative<Neochorda>(step) ||
           std::holds_alternative<ChordalTransfer>(step) ||
           std::holds_alternative<EdgeToEdge>(step) ||
           std::holds_alternative<LeafletResection>(step);
  });
}

}  // namespace

Expected<Valve> apply_plan(const Valve& valve, const RepairPlan& plan) {
  // Leaflet coordinates belong to the anatomy: of the valve before its repair.
  return apply_plan(valve, plan,
                    needs_coordinates(plan) ? leaflet_coordinates(valve) : LeafletCoordinates{});
}

Expected<Valve> apply_plan(const Valve& valve, const RepairPlan& plan,
                           const LeafletCoordinates& coordinates) {
  Valve repaired = valve;
  if (!plan.steps.empty()) repaired.observed.clear();  // of the valve before its repair
  ProblemList problems;
  resect(plan, coordinates, repaired, problems);
  place_ring(plan, repaired, problems);
  if (problems.empty()) draw_annulus_in(plan, repaired);
  tie_sutures(plan, repaired, problems);
  ChordalPass chordae(coordinates, repaired, problems);
  for (std::size_t i = 0; i < plan.steps.size(); ++i)
    std::visit([&](const auto& step) { chordae.treat(step, i); }, plan.steps[i]);
  chordae.append_neochordae();
  chordae.tie_edges();
  if (!problems.empty()) return std::move(problems).take();
  if (Errors errors = check_result(repaired, plan); !errors.empty()) return errors;
  std::vector<std::string> lines = describe(valve, plan, &coordinates);
  std::sort(lines.begin(), lines.end());
  for (const std::string& line : lines) repaired.provenance.push_back("repaired: " + line);
  return repaired;
}

}  // namespace coapt
