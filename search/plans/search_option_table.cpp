#include "search/plans/search_option_table.h"

#include <string>
#include <type_traits>

namespace coapt {
namespace {

constexpr double kMost = 1e6;
constexpr Range kPrice = {0.0, kMost};
constexpr Range kAny = {};

constexpr OptionRow<SearchOptions> kOptions[] = {
    {"evaluations",
     &SearchOptions::evaluations,
     {1.0, kMost},
     "",
     "Closures for the search itself; ranking takes more. Fewer if nothing is left to try."},
    {"front_share",
     &SearchOptions::front_share,
     {0.0, 1.0},
     "",
     "More closures, as a share of `evaluations`, for plans that trade leak, opening and "
     "durability otherwise than the "
     "best; none where plans are not opened or the search was stopped early."},
    {"seed", &SearchOptions::seed, kAny, "", "Same seed, same plans."},
    {"threads",
     &SearchOptions::threads,
     {0.0, 1024.0},
     "",
     "0: all cores. Does not change the result."},
    {"plans", &SearchOptions::plans, {1.0, 50.0}, "", "How many ranked plans to report."},
    {"region_points",
     &SearchOptions::region_points,
     {1.0, 1089.0},
     "",
     "Nodes of the region of interest, of the first plan; the others have 65 at most. Of plans of "
     "one's own: of each."},
    {"evidence", &SearchOptions::evidence, kAny, "",
     "Close the reported plans also under errors of single sutures and further remodelling."},
    {"openings", &SearchOptions::openings, kAny, "",
     "Open plans in diastole, too, once they are closed at more than one node: opening area and "
     "mean gradient."},
    {"fine_levels",
     &SearchOptions::fine_levels,
     {0.0, 2.0},
     "",
     "Times that the mesh is refined, each triangle into four, for the verdict on each reported "
     "plan; 0: its own mesh."},
    {"model_draws",
     &SearchOptions::model_draws,
     {0.0, 200.0},
     "",
     "Draws of the model's own values (tissue, chordae), under which each reported plan is closed "
     "as planned: how likely it is to leak mildly counts them; 0: none."},
    {"rank_by_price", &SearchOptions::rank_by_price, kAny, "",
     "Acceptable plans in the order of their cost, instead of classes that their simplest plans "
     "head."},
    {"seconds",
     &SearchOptions::seconds,
     {0.0, kMost},
     " s",
     "Stop earlier when this much time is gone, the last 40 % of it spent on ranking; 0: no "
     "limit."},
    {"no_improvement",
     &SearchOptions::no_improvement,
     {0.0, kMost},
     "",
     "Stop searching after so many closures without a better plan; 0: never."},
    {"target_mm2",
     &SearchOptions::target_mm2,
     {-1.0, kMost},
     " mm2",
     "Stop searching when mean + sd of a plan's leak over 17 nodes is not above this; -1: never."},
};

constexpr OptionRow<SearchRules> kRules[] = {
    {"most_neochordae",
     &SearchRules::most_neochordae,
     {0.0, 4.0},
     "",
     "Neochordae that a plan has at most."},
    {"own_ring", &SearchRules::own_ring, kAny, "",
     "Offers rings of the valve's own shape, which no maker has."},
    {"chordal_length_change", &SearchRules::chordal_length_change, kAny, "",
     "Allows shortening the marginal chordae beside a lesion."},
    {"chordal_excision", &SearchRules::chordal_excision, kAny, "",
     "Allows cutting the anterior leaflet's strut chordae."},
    {"chordal_transfer", &SearchRules::chordal_transfer, kAny, "", "Allows transfer to a lesion."},
    {"leaflet_resection", &SearchRules::leaflet_resection, kAny, "",
     "Allows resection of the posterior leaflet where it prolapses."},
    {"edge_to_edge", &SearchRules::edge_to_edge, kAny, "", "Allows a clip at a lesion."},
    {"suture_lattice_mm", &SearchRules::suture_lattice_mm, {0.1, 5.0}, " mm", "What can be tied."},
    {"neochorda_lattice_mm",
     &SearchRules::neochorda_lattice_mm,
     {0.5, 5.0},
     " mm",
     "Step between the lengths of a neochorda, as loops are made."},
    {"most_movement_mm",
     &SearchRules::most_movement_mm,
     {3.0, 15.0},
     " mm",
     "Of a papillary muscle: more than 10 is unusual."},
};

constexpr OptionRow<CostWeights> kWeights[] = {
    {"leak", &CostWeights::leak, kPrice, "", "Per mm2 of mean + sd_share x sd."},
    {"sd_share", &CostWeights::sd_share, kPrice, "", "Sds that count beside the mean."},
    {"incompetence", &CostWeights::incompetence, kPrice, "", "More, per mm2 of that above 1."},
    {"margin", &CostWeights::margin, kPrice, "",
     "For a plan that leaks at once; none if no disturbance makes it leak."},
    {"coaptation", &CostWeights::coaptation, kPrice, "",
     "Per mm that A2 with P2 falls short of 8."},
    {"gap", &CostWeights::gap, kPrice, "",
     "Per mm by which leaflets are further apart than they are thick."},
    {"movement", &CostWeights::movement, kPrice, "", "Per mm of papillary movement."},
    {"movement_above_10", &CostWeights::movement_above_10, kPrice, "",
     "More, per mm above what is usual."},
    {"undersizing", &CostWeights::undersizing, kPrice, "", "Per ring size."},
    {"undersizing_above_4", &CostWeights::undersizing_above_4, kPrice, "",
     "More, per size above what practice accepts."},
    {"step", &CostWeights::step, kPrice, "", "Per step."},
    {"tension", &CostWeights::tension, kPrice, "",
     "Per newton of highest chordal tension above the unrepaired valve's."},
    {"gradient_above_3", &CostWeights::gradient_above_3, kPrice, "",
     "Per mmHg of mean gradient in diastole above 3."},
    {"gradient_above_5", &CostWeights::gradient_above_5, kPrice, "", "More, per mmHg above 5."},
    {"durability", &CostWeights::durability, kPrice, "",
     "Per mm of further disease that a reported plan does not last, of 12."},
    {"untrusted", &CostWeights::untrusted, kPrice, "",
     "For closures that did not converge or crossed, by their share."},
};
static_assert(sizeof(CostWeights) == std::size(kWeights) * sizeof(double), "a row for each");

template <class Options>
void check_rows(ProblemList& problems, const std::string& path,
                std::span<const OptionRow<Options>> rows, const Options& options) {
  for (const OptionRow<Options>& row : rows)
    std::visit(
        [&]<class Value>(Value Options::*member) {
          if constexpr (std::is_same_v<Value, int> || std::is_same_v<Value, double>)
            check_range(problems, path + "/" + row.name, options.*member, row.range, row.unit);
        },
        row.member);
}

}  // namespace

std::span<const OptionRow<SearchOptions>> search_option_rows() { return kOptions; }
std::span<const OptionRow<SearchRules>> search_rule_rows() { return kRules; }
std::span<const OptionRow<CostWeights>> cost_weight_rows() { return kWeights; }

void check_option_ranges(ProblemList& problems, const SearchOptions& options) {
  check_rows(problems, "", search_option_rows(), options);
  check_rows(problems, "/weights", cost_weight_rows(), options.weights);
}

void check_option_ranges(ProblemList& problems, const SearchRules& rules) {
  check_rows(problems, "", search_rule_rows(), rules);
}

}  // namespace coapt
