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
     "Maximum number of closures for the search itself; ranking needs more. The search ends early "
     "if no plan is left to try."},
    {"front_share",
     &SearchOptions::front_share,
     {0.0, 1.0},
     "",
     "Extra closures for exploring trade-offs between leak, opening and reserve against "
     "progression, as a fraction of `evaluations`; skipped if plans are not opened or the search "
     "was stopped early."},
    {"seed", &SearchOptions::seed, kAny, "", "Random seed; the same seed gives the same plans."},
    {"threads",
     &SearchOptions::threads,
     {0.0, 1024.0},
     "",
     "Number of threads (0: all cores); does not change the result."},
    {"plans", &SearchOptions::plans, {1.0, 50.0}, "", "Number of ranked plans to report."},
    {"region_points",
     &SearchOptions::region_points,
     {1.0, 1089.0},
     "",
     "Number of points of the region of interest at which the first plan is closed; other ranked "
     "plans are closed at up to 65. In an evaluation it applies to every plan."},
    {"evidence", &SearchOptions::evidence, kAny, "",
     "Also close the reported plans with errors of single sutures and with further remodelling."},
    {"openings", &SearchOptions::openings, kAny, "",
     "Also open plans in diastole, once they are closed at more than one point, to measure opening "
     "area and mean gradient."},
    {"fine_levels",
     &SearchOptions::fine_levels,
     {0.0, 2.0},
     "",
     "Number of mesh refinements, each splitting a triangle into four, for the final check of each "
     "reported plan (0: none)."},
    {"model_draws",
     &SearchOptions::model_draws,
     {0.0, 200.0},
     "",
     "Number of variants of tissue and chordae in which each reported plan is closed as planned; "
     "they enter the probability that it leaks less than 5 mm2 (0: none)."},
    {"rank_by_price", &SearchOptions::rank_by_price, kAny, "",
     "Rank acceptable plans by cost instead of by equivalence classes headed by their simplest "
     "plan."},
    {"seconds",
     &SearchOptions::seconds,
     {0.0, kMost},
     " s",
     "Time limit in seconds (0: none); the last 40 % is reserved for ranking."},
    {"no_improvement",
     &SearchOptions::no_improvement,
     {0.0, kMost},
     "",
     "Stop the search after this many closures without a better plan (0: never)."},
    {"target_mm2",
     &SearchOptions::target_mm2,
     {-1.0, kMost},
     " mm2",
     "Stop the search once the leak of a plan (mean + sd over 17 points) is at or below this value "
     "(-1: never)."},
};

constexpr OptionRow<SearchRules> kRules[] = {
    {"most_neochordae",
     &SearchRules::most_neochordae,
     {0.0, 4.0},
     "",
     "Maximum number of neochordae in a plan."},
    {"own_ring", &SearchRules::own_ring, kAny, "",
     "Offer rings in the annulus's own shape, which no manufacturer sells."},
    {"chordal_length_change", &SearchRules::chordal_length_change, kAny, "",
     "Allow shortening of the marginal chordae beside a lesion."},
    {"chordal_excision", &SearchRules::chordal_excision, kAny, "",
     "Allow cutting of the anterior leaflet's strut chordae where the leaflets are tethered."},
    {"chordal_transfer", &SearchRules::chordal_transfer, kAny, "",
     "Allow transfer of chordae to a lesion."},
    {"leaflet_resection", &SearchRules::leaflet_resection, kAny, "",
     "Allow resection of the posterior leaflet where it prolapses."},
    {"edge_to_edge", &SearchRules::edge_to_edge, kAny, "",
     "Allow an edge-to-edge clip at a lesion."},
    {"suture_lattice_mm",
     &SearchRules::suture_lattice_mm,
     {0.1, 5.0},
     " mm",
     "Step between the lengths of a papillary suture that can be tied."},
    {"neochorda_lattice_mm",
     &SearchRules::neochorda_lattice_mm,
     {0.5, 5.0},
     " mm",
     "Step between the lengths of a neochorda, as premeasured loops are made."},
    {"most_movement_mm",
     &SearchRules::most_movement_mm,
     {3.0, 15.0},
     " mm",
     "Maximum relocation of a papillary muscle; more than 10 mm is unusual."},
};

constexpr OptionRow<CostWeights> kWeights[] = {
    {"leak", &CostWeights::leak, kPrice, "", "Cost per mm2 of leak (mean + sd_share x sd)."},
    {"sd_share", &CostWeights::sd_share, kPrice, "",
     "Number of standard deviations added to the mean leak."},
    {"incompetence", &CostWeights::incompetence, kPrice, "",
     "Additional cost per mm2 of that leak above 1 mm2."},
    {"margin", &CostWeights::margin, kPrice, "",
     "Cost of a plan that leaks at the smallest disturbance; zero if no disturbance makes it "
     "leak."},
    {"coaptation", &CostWeights::coaptation, kPrice, "",
     "Cost per mm of coaptation height of A2 with P2 below 8 mm."},
    {"gap", &CostWeights::gap, kPrice, "",
     "Cost per mm by which the gap between the leaflets exceeds their thickness."},
    {"movement", &CostWeights::movement, kPrice, "", "Cost per mm of papillary muscle relocation."},
    {"movement_above_10", &CostWeights::movement_above_10, kPrice, "",
     "Additional cost per mm of relocation above 10 mm."},
    {"undersizing", &CostWeights::undersizing, kPrice, "", "Cost per ring size of undersizing."},
    {"undersizing_above_4", &CostWeights::undersizing_above_4, kPrice, "",
     "Additional cost per size of undersizing above 4."},
    {"step", &CostWeights::step, kPrice, "", "Cost per step of the plan."},
    {"tension", &CostWeights::tension, kPrice, "",
     "Cost per newton by which the highest chordal tension exceeds that of the unrepaired valve."},
    {"gradient_above_3", &CostWeights::gradient_above_3, kPrice, "",
     "Cost per mmHg of mean diastolic gradient above 3 mmHg."},
    {"gradient_above_5", &CostWeights::gradient_above_5, kPrice, "",
     "Additional cost per mmHg of gradient above 5 mmHg."},
    {"durability", &CostWeights::durability, kPrice, "",
     "Cost per mm by which the reserve against progression of a reported plan falls short of 12 "
     "mm."},
    {"untrusted", &CostWeights::untrusted, kPrice, "",
     "Cost of closures that failed to converge or crossed, times their fraction."},
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
