#include "search/plans/plan_space.h"

#include <algorithm>
#include <random>
#include <set>
#include <tuple>

#include "core/repair/apply_plan.h"
#include "core/repair/describe.h"
#include "core/repair/rings.h"
#include "core/valve/ruptures.h"
#include "tests/scenes/small_preset.h"
#include "tests/search/plans/search_scene.h"

namespace coapt {
namespace {

constexpr std::size_t kRings = 5;  // none, own, three of the catalogue

// 24.9 mm from their trigones: not displaced.
Valve near_tips() {
  Valve valve = fitting_valve();
  for (PapillaryHead& head : valve.heads) head.tip_mm.z() += 4.0;
  return valve;
}

Valve with_rupture() {
  Valve valve = near_tips();
  valve.chordae[0].ruptured = true;
  return valve;
}

/// Of types, with segments that prolapse, the first most.
Diagnosis diagnosis_of(std::vector<CarpentierType> types,
                       const std::vector<Segment>& lesions = {}) {
  Diagnosis diagnosis;
  diagnosis.competent = types.empty();
  diagnosis.types = std::move(types);
  for (std::size_t s = 0; s < kScallops.size(); ++s) {
    SegmentDiagnosis& segment = diagnosis.segments[s];
    segment.segment = kScallops[s];
    const auto found = std::find(lesions.begin(), lesions.end(), kScallops[s]);
    if (found == lesions.end()) continue;
    segment.finding = SegmentFinding::Prolapse;
    segment.override_mm = 9.0 - static_cast<double>(found - lesions.begin());
  }
  return diagnosis;
}

std::set<std::string> rings_of(const PlanSpace& space) {
  std::set<std::string> rings;
  for (const Branch& branch : space.branches()) rings.insert(branch.choice.ring);
  return rings;
}

bool has_suture(const PlanSpace& space) {
  return std::any_of(space.branches().begin(), space.branches().end(), [](const Branch& branch) {
    return branch.choice.anterolateral || branch.choice.posteromedial;
  });
}

PlanSpace space_of(const Valve& valve, const SearchRules& rules = {}) {
  return PlanSpace(valve, rules, {});
}

SearchRules forbidding(std::vector<std::string> words) {
  SearchRules rules;
  rules.forbidden = std::move(words);
  return rules;
}

SearchRules most_neochordae(int most) {
  SearchRules rules;
  rules.most_neochordae = most;
  return rules;
}

bool is_cut(const PlanSpace& space, const std::string& what, const std::string& why) {
  return std::any_of(space.cut().begin(), space.cut().end(), [&](const CutBranches& cut) {
    return cut.what == what && cut.why.find(why) != std::string::npos;
  });
}

const Parameter* parameter_of(const Branch& branch, ParameterOf of) {
  for (const Parameter& p : branch.parameters)
    if (p.of == of) return &p;
  return nullptr;
}

int steps(const Choice& c) {
  return (c.ring.empty() ? 0 : 1) + (c.anterolateral ? 1 : 0) + (c.posteromedial ? 1 : 0) +
         c.neochordae + (c.chordal == ChordalChoice::None ? 0 : 1) +
         (c.leaflet == LeafletChoice::None ? 0 : 1);
}

TEST(PlanSpace, IsNotMadeOfRulesThatAreWrongAndIsEmptyIfTheyLeaveNoPlan) {
  SearchRules wrong;
  wrong.forbidden = {"neochorda", "leeches"};
  const Errors refused = check_plan_space(small_valve(), wrong);
  ASSERT_EQ(refused.size(), 1u);
  EXPECT_EQ(refused[0].path, "/forbidden/1");
  const SearchRules closed = forbidding({"annuloplasty", "papillary_approximation"});
  EXPECT_TRUE(check_plan_space(small_valve(), closed).empty());
  const PlanSpace empty(small_valve(), closed, diagnosis_of({CarpentierType::IIIb}));
  EXPECT_TRUE(empty.branches().empty());
  EXPECT_TRUE(is_cut(empty, "ring of the annulus's own shape", "forbidden"));
  EXPECT_TRUE(is_cut(empty, "suture of the anterolateral muscle", "forbidden"));
  EXPECT_TRUE(check_plan_space(small_valve(), {}).empty());
}

TEST(PlanSpace, SuturesAreOfferedToDisplacedMusclesOnly) {
  // None or three anchors a side; not nothing.
  EXPECT_EQ(space_of(small_valve()).branches().size(), kRings * 4u * 4u - 1u);
  EXPECT_EQ(space_of(near_tips()).branches().size(), kRings - 1u);
  EXPECT_TRUE(is_cut(space_of(near_tips()), "suture of the anterolateral muscle", "not displaced"));
  Valve one_side = near_tips();
  one_side.heads[0].tip_mm.z() -= 4.0;
  EXPECT_EQ(space_of(one_side).branches().size(), kRings * 4u - 1u);
}

TEST(PlanSpace, ARingOfWhichNoSizeSuitsTheAnnulusIsCut) {
  Valve narrow = near_tips();
  narrow.annulus_mm.col(0) *= 22.0 / 36.0;
  EXPECT_EQ(space_of(narrow).branches().size(), 1u);
  for (const RingShape& shape : kRingShapes)
    EXPECT_TRUE(is_cut(space_of(narrow), std::string(shape.name) + " ring", "22.0 mm"));
}

TEST(PlanSpace, DesignedShapesAreOfferedBesideTheCatalogue) {
  SearchRules rules;
  rules.shapes = {{"mine", {.p3_inset = 0.05}}};
  EXPECT_EQ(space_of(near_tips(), rules).branches().size(), kRings);
  rules.forbidden = {"annuloplasty:mine"};
  EXPECT_EQ(space_of(near_tips(), rules).branches().size(), kRings - 1u);
  rules.shapes.push_back(rules.shapes[0]);
  ASSERT_EQ(check_rules(near_tips(), rules).size(), 1u);
  EXPECT_EQ(check_rules(near_tips(), rules)[0].path, "/shapes/1/name");
}

TEST(PlanSpace, RupturedChordaeBringUpToFourNeochordae) {
  EXPECT_EQ(space_of(with_rupture()).branches().size(), kRings * 5u - 1u);
  EXPECT_TRUE(is_cut(space_of(small_valve()), "neochordae", "no marginal chorda is ruptured"));
  EXPECT_EQ(space_of(with_rupture(), most_neochordae(1)).branches().size(), kRings * 2u - 1u);
  const PlanSpace none = space_of(with_rupture(), most_neochordae(0));
  EXPECT_EQ(none.branches().size(), kRings - 1u);
  EXPECT_TRUE(is_cut(none, "neochordae", "not allowed by the rules"));
  const PlanSpace forbidden = space_of(with_rupture(), forbidding({"neochorda:posterior"}));
  EXPECT_EQ(forbidden.branches().size(), kRings - 1u);
  EXPECT_EQ(space_of(with_rupture(), forbidding({"neochorda:anterior"})).branches().size(),
            kRings * 5u - 1u);
}

TEST(PlanSpace, ChordalStepsAreOfferedOnRequest) {
  SearchRules rules;
  rules.chordal_length_change = rules.chordal_transfer = true;
  EXPECT_EQ(space_of(near_tips(), rules).branches().size(), kRings - 1u) << "there is no lesion";
  // Chorda 1 is a strut of the anterior leaflet.
  rules.chordal_excision = true;
  EXPECT_EQ(space_of(near_tips(), rules).branches().size(), kRings * 2u - 1u);
  rules.forbidden = {"chordal_excision"};
  EXPECT_EQ(space_of(near_tips(), rules).branches().size(), kRings - 1u);
}

TEST(PlanSpace, EveryOperationThatIsClosedIsSaid) {
  const auto says = [](const SearchRules& rules, const Diagnosis& diagnosis, const char* why) {
    const PlanSpace space(small_valve(), rules, diagnosis);
    for (const char* what : {"shortening of chordae", "transfer of a chorda", "resection", "clip"})
      EXPECT_TRUE(is_cut(space, what, why)) << what << ": " << why;
  };
  SearchRules rules;
  const Diagnosis tethered = diagnosis_of({CarpentierType::IIIb});
  says(rules, tethered, "available on request");
  rules.chordal_length_change = rules.chordal_excision = rules.chordal_transfer =
      rules.leaflet_resection = rules.edge_to_edge = true;
  says(rules, tethered, "no segment prolapses");
  rules.forbidden = {"chordal_length_change", "chordal_excision", "chordal_transfer",
                     "leaflet_resection", "edge_to_edge"};
  says(rules, tethered, "forbidden");
  EXPECT_TRUE(
      is_cut(PlanSpace(small_valve(), rules, tethered), "cutting of strut chordae", "forbidden"));
}

TEST(Indication, StrutChordaeAreCutForTetheringAlone) {
  SearchRules rules;
  rules.chordal_excision = true;
  const auto cuts = [&](CarpentierType type) {
    const PlanSpace space(small_valve(), rules, diagnosis_of({type}, {Segment::P2}));
    return std::any_of(space.branches().begin(), space.branches().end(), [](const Branch& branch) {
      return branch.choice.chordal == ChordalChoice::CutStruts;
    });
  };
  EXPECT_TRUE(cuts(CarpentierType::IIIb));
  EXPECT_FALSE(cuts(CarpentierType::II));
  EXPECT_TRUE(is_cut(PlanSpace(small_valve(), rules, diagnosis_of({CarpentierType::II})),
                     "cutting of strut chordae", "not tethered"));
}

TEST(PlanSpace, ResectionAndAClipAreOfferedOnRequestWhereChordaeAreRuptured) {
  const Valve& flail = shared_preset("human-p2-prolapse", 150);
  SearchRules rules;
  rules.most_neochordae = 0;
  rules.forbidden = {"papillary_approximation", "annuloplasty:generic-etlogix-like",
                     "annuloplasty:generic-geoform-like"};
  const auto leaflet_branches = [&](const Valve& valve) {
    std::multiset<LeafletChoice> choices;
    const PlanSpace space = space_of(valve, rules);
    for (const Branch& branch : space.branches()) {
      choices.insert(branch.choice.leaflet);
      const bool leaflet = branch.choice.leaflet != LeafletChoice::None;
      EXPECT_EQ(parameter_of(branch, ParameterOf::LeafletWidth) != nullptr, leaflet);
      EXPECT_EQ(std::ssize(space.plan(branch, start_of(branch)).steps), steps(branch.choice));
    }
    return choices;
  };
  const std::size_t plain = leaflet_branches(flail).size();
  EXPECT_EQ(plain, 2u) << "two rings";
  rules.leaflet_resection = rules.edge_to_edge = true;
  const auto of_normal = leaflet_branches(shared_preset("human-normal", 150));
  EXPECT_EQ(of_normal.count(LeafletChoice::None), of_normal.size());
  auto choices = leaflet_branches(flail);
  EXPECT_EQ(choices.count(LeafletChoice::None), plain);
  // And without a ring.
  EXPECT_EQ(choices.count(LeafletChoice::Triangular), plain + 1);
  EXPECT_EQ(choices.count(LeafletChoice::Quadrangular), plain + 1);
  EXPECT_EQ(choices.count(LeafletChoice::Clip), plain + 1);
  rules.forbidden.insert(rules.forbidden.end(),
                         {"leaflet_resection:quadrangular", "edge_to_edge:clip"});
  choices = leaflet_branches(flail);
  EXPECT_EQ(choices.count(LeafletChoice::Triangular), plain + 1);
  EXPECT_EQ(choices.size(), 2 * plain + 1);
}

TEST(PlanSpace, FewestStepsComeFirstAndNoBranchComesTwice) {
  for (const Valve& valve : {small_valve(), with_rupture()}) {
    const PlanSpace space = space_of(valve);
    std::set<std::string> keys;
    for (std::size_t i = 0; i < space.branches().size(); ++i) {
      const Branch& branch = space.branches()[i];
      EXPECT_GE(steps(branch.choice), i == 0 ? 1 : steps(space.branches()[i - 1].choice));
      const RepairPlan plan = space.plan(branch, start_of(branch));
      EXPECT_EQ(std::ssize(plan.steps), steps(branch.choice));
      keys.insert(plan_key(plan));
    }
    EXPECT_EQ(keys.size(), space.branches().size());
  }
}

TEST(PlanSpace, AFunctionalValveStartsTwoSizesBelowAndAFlailOneAtItsOwnSize) {
  const auto start = [](const Valve& valve, const std::string& shape) {
    const PlanSpace space = space_of(valve);
    for (const Branch& branch : space.branches())
      if (branch.choice.ring == shape)
        return std::get<Annuloplasty>(space.plan(branch, start_of(branch)).steps[0]).ring;
    return decltype(Annuloplasty::ring){CatalogueRing{"none"}};
  };
  EXPECT_EQ(std::get<OwnRing>(start(near_tips(), "own")).sizes_below, 2);
  EXPECT_EQ(std::get<CatalogueRing>(start(near_tips(), "generic-classic")).size_mm, 32.0);  // of 36
  EXPECT_EQ(std::get<OwnRing>(start(with_rupture(), "own")).sizes_below, 1);
  EXPECT_EQ(std::get<CatalogueRing>(start(with_rupture(), "generic-classic")).size_mm, 36.0);
}

TEST(PlanSpace, RingsGoToFourSizesBelow) {
  const PlanSpace space = space_of(near_tips());
  for (const Branch& branch : space.branches()) {
    const Parameter& sizes = *parameter_of(branch, ParameterOf::RingSize);
    const bool own = branch.choice.ring == "own";
    const bool wide = branch.choice.ring == "generic-geoform-like";
    // On eight vertices a ring of 28 mm takes a little more than its four sizes of the 36 mm.
    EXPECT_EQ(sizes.lower, own ? 1.0 : wide ? 32.0 : 30.0);
    EXPECT_EQ(sizes.count, wide ? 1 : 4);  // 1 to 4; 32 mm, of 1.12 each; 30 to 36 mm
    EXPECT_EQ(sizes.step, own ? 1.0 : 2.0);
  }
}

TEST(PlanSpace, SuturesMoveTheMuscleByThreeToTenMillimetresInHalves) {
  const PlanSpace space = space_of(small_valve(), forbidding({"annuloplasty"}));
  const Branch& branch = space.branches().at(0);
  ASSERT_EQ(branch.parameters.size(), 1u);
  EXPECT_EQ(branch.parameters[0].count, 15);
  const auto length = [&](int at) {
    return std::get<PapillaryApproximation>(space.plan(branch, {at}).steps[0]).suture_length_mm;
  };
  // The tip is 28.6 mm from its trigone.
  EXPECT_EQ(length(0), 25.5);
  EXPECT_EQ(length(14), 18.5);
  EXPECT_EQ(length(branch.parameters[0].start), 23.5);
}

TEST(PlanSpace, UnderARingTheSutureIsAsMuchShorterAsTheAnchorIsNearer) {
  const PlanSpace space = space_of(small_valve());
  for (const Branch& branch : space.branches()) {
    if (branch.choice.ring != "own" || !branch.choice.posteromedial || branch.choice.anterolateral)
      continue;
    LatticePoint at = start_of(branch);
    for (at[0] = 0; at[0] < 4; ++at[0]) {
      const Valve repaired = *apply_plan(small_valve(), space.plan(branch, at));
      EXPECT_NEAR(scene::moved_mm(repaired, Side::Posteromedial), 5.0, 0.25 + 1e-9);
    }
  }
}

TEST(PlanSpace, CornersAndPointsBetweenAreAllPossible) {
  std::mt19937_64 engine(1);
  for (const Valve& valve : {small_valve(), with_rupture()}) {
    const PlanSpace space = space_of(valve);
    for (const Branch& branch : space.branches()) {
      const std::int64_t count = point_count(branch);
      for (const auto number : {std::int64_t{0}, count - 1, count / 2,
                                static_cast<std::int64_t>(engine() % std::uint64_t(count))})
        EXPECT_TRUE(apply_plan(valve, space.plan(branch, point_at(branch, number))));
    }
  }
}

TEST(PlanSpace, EveryPointHasItsOwnNumber) {
  Branch branch;
  branch.parameters = {{ParameterOf::RingSize, 0, 1.0, 1.0, 4, 1},
                       {ParameterOf::Shortening, 0, 1.0, 1.0, 6, 1},
                       {ParameterOf::Movement, 0, 2.0, 0.5, 3, 0}};
  EXPECT_EQ(point_count(branch), 4 * 6 * 3);
  std::set<LatticePoint> points;
  for (int number = 0; number < 4 * 6 * 3; ++number) points.insert(point_at(branch, number));
  EXPECT_EQ(points.size(), 4u * 6u * 3u);
  EXPECT_EQ(*points.rbegin(), (LatticePoint{3, 5, 2}));
}

TEST(PlanSpace, WhatIsFixedIsNotDecidedAgain) {
  SearchRules rules;
  rules.fixed = scene::both(scene::own_ring(1), scene::suture(Side::Posteromedial, 24.0));
  const PlanSpace space = space_of(small_valve(), rules);
  // Nothing more, or one of three sutures of the other muscle.
  EXPECT_EQ(space.branches().size(), 4u);
  EXPECT_TRUE(is_cut(space, "other rings", "fixed"));
  EXPECT_TRUE(is_cut(space, "suture of the posteromedial muscle", "fixed"));
  EXPECT_EQ(plan_key(space.plan(space.branches()[0], {})), plan_key(rules.fixed));
  for (const Branch& branch : space.branches())
    EXPECT_EQ(plan_key({{space.plan(branch, start_of(branch)).steps[0]}}),
              plan_key(scene::own_ring(1)));
}

TEST(PlanSpace, WhatIsForbiddenIsNoBranch) {
  const auto count = [](std::vector<std::string> words) {
    return space_of(small_valve(), forbidding(std::move(words))).branches().size();
  };
  EXPECT_EQ(count({"annuloplasty"}), 4u * 4u - 1u);
  EXPECT_EQ(count({"annuloplasty:own"}), (kRings - 1u) * 4u * 4u - 1u);
  EXPECT_EQ(count({"papillary_approximation"}), kRings - 1u);
  EXPECT_EQ(count({"papillary_approximation:anterolateral"}), kRings * 4u - 1u);
  EXPECT_EQ(count({"papillary_approximation:saddle_peak"}), kRings * 3u * 3u - 1u);
  EXPECT_EQ(count({"annuloplasty", "papillary_approximation"}), 0u);
}

TEST(PlanSpace, AValveThatTakesNoMoreChordaeGetsNone) {
  Valve valve = with_rupture();
  for (int i = 3; i <= 1999; ++i) {
    valve.chordae.push_back(valve.chordae[1]);
    valve.chordae.back().id = std::to_string(i);
  }
  const PlanSpace space = space_of(valve);
  for (const Branch& branch : space.branches()) EXPECT_LE(branch.choice.neochordae, 2);
}

TEST(Indication, ACompetentValveNeedsNoOperation) {
  Diagnosis diagnosis = diagnosis_of({});
  const PlanSpace space(small_valve(), {}, diagnosis);
  ASSERT_EQ(space.branches().size(), 1u);
  const Branch& nothing = space.branches()[0];
  EXPECT_EQ(steps(nothing.choice), 0);
  EXPECT_TRUE(space.plan(nothing, start_of(nothing)).steps.empty());
  EXPECT_TRUE(is_cut(space, "all repairs", "competent"));
  diagnosis.competent_sure = false;
  diagnosis.types = {CarpentierType::I};
  EXPECT_GT(PlanSpace(small_valve(), {}, diagnosis).branches().size(), 1u) << "it offers both";
  SearchRules fixed;
  fixed.fixed = scene::own_ring(1);
  EXPECT_GT(PlanSpace(small_valve(), fixed, diagnosis_of({})).branches().size(), 0u)
      << "what was decided is done";
}

TEST(Indication, OnlyTetheredLeafletsGetSuturesAndShortRings) {
  const PlanSpace tethered(small_valve(), {}, diagnosis_of({CarpentierType::IIIb}));
  EXPECT_EQ(rings_of(tethered), (std::set<std::string>{"generic-classic", "generic-etlogix-like",
                                                       "generic-geoform-like"}));
  EXPECT_TRUE(has_suture(tethered));
  for (const CarpentierType type : {CarpentierType::I, CarpentierType::II}) {
    const PlanSpace others(small_valve(), {}, diagnosis_of({type}, {Segment::P2}));
    EXPECT_EQ(rings_of(others), (std::set<std::string>{"generic-classic"}));
    EXPECT_FALSE(has_suture(others));
    EXPECT_TRUE(is_cut(others, "suture of the posteromedial muscle", "not tethered"));
  }
  Diagnosis mixed = diagnosis_of({CarpentierType::II, CarpentierType::IIIb}, {Segment::P2});
  const PlanSpace both(small_valve(), {}, mixed);
  EXPECT_EQ(rings_of(both), (std::set<std::string>{"generic-classic"}));
  EXPECT_TRUE(has_suture(both));
  EXPECT_TRUE(is_cut(both, "generic-geoform-like ring", "prolapses"));
  mixed.type_sure = false;
  EXPECT_TRUE(rings_of(PlanSpace(small_valve(), {}, mixed)).contains("generic-geoform-like"));
  Diagnosis unsure = diagnosis_of({CarpentierType::I});
  unsure.not_ruled_out = CarpentierType::IIIb;
  EXPECT_TRUE(has_suture(PlanSpace(small_valve(), {}, unsure)));
}

TEST(Indication, TheOwnShapeIsOfferedOnRequest) {
  SearchRules rules;
  rules.own_ring = true;
  EXPECT_TRUE(
      rings_of(PlanSpace(small_valve(), rules, diagnosis_of({CarpentierType::I}))).contains("own"));
}

TEST(Indication, NeochordaeGoToEveryLeafletThatProlapses) {
  const Valve& valve = shared_preset("human-normal", 200);
  SearchRules rules;
  rules.leaflet_resection = true;
  const PlanSpace one(valve, rules, diagnosis_of({CarpentierType::II}, {Segment::P2}));
  std::set<int> counts;
  for (const Branch& branch : one.branches()) {
    counts.insert(branch.choice.neochordae);
    EXPECT_EQ(branch.choice.neochordae == 0, branch.choice.leaflet != LeafletChoice::None)
        << "what prolapses is mended, once";
  }
  EXPECT_EQ(counts, (std::set{0, 1, 2, 3, 4})) << "none beside a resection";
  const PlanSpace two(valve, rules, diagnosis_of({CarpentierType::II}, {Segment::A2, Segment::P1}));
  for (const Branch& branch : two.branches()) {
    std::vector<Neochorda> neochordae;
    for (const RepairStep& step : two.plan(branch, start_of(branch)).steps)
      if (const auto* neochorda = std::get_if<Neochorda>(&step)) neochordae.push_back(*neochorda);
    ASSERT_EQ(neochordae.size() % 2, 0u);
    ASSERT_FALSE(neochordae.empty());
    EXPECT_EQ(neochordae[0].insertion.leaflet, Leaflet::Anterior) << "the highest first";
    if (branch.choice.leaflet != LeafletChoice::None) {
      for (const Neochorda& neochorda : neochordae)
        EXPECT_EQ(neochorda.insertion.leaflet, Leaflet::Anterior)
            << "the posterior leaflet is resected";
      continue;
    }
    EXPECT_EQ(neochordae[1].insertion.leaflet, Leaflet::Posterior);
    EXPECT_LT(neochordae[1].insertion.along, 0.4) << "P1";
  }
}

TEST(Indication, SegmentsThatAreNotNeighboursAreLesionsOfTheirOwn) {
  const Valve& valve = shared_preset("human-normal", 200);
  const Diagnosis apart = diagnosis_of({CarpentierType::II}, {Segment::P3, Segment::P1});
  const PlanSpace space(valve, {}, apart);
  const Branch& simplest = space.branches().front();
  ASSERT_EQ(simplest.choice.neochordae, 2);
  std::vector<std::string> held;
  for (const RepairStep& step : space.plan(simplest, start_of(simplest)).steps)
    if (const auto* neochorda = std::get_if<Neochorda>(&step)) {
      const std::string words = describe(valve, {{*neochorda}}).front();
      held.push_back(words.substr(words.rfind(' ') + 1));
    }
  EXPECT_EQ(held, (std::vector<std::string>{"P3", "P1"})) << "none at P2, the highest first";
  SearchRules one;
  one.most_neochordae = 1;
  EXPECT_TRUE(is_cut(PlanSpace(valve, one, apart), "neochordae", "2 lesions"));
  // Of three neochordae at two lesions beside a resection, two go to the higher one.
  SearchRules resected;
  resected.leaflet_resection = true;
  const PlanSpace three(
      valve, resected, diagnosis_of({CarpentierType::II}, {Segment::A2, Segment::P1, Segment::P3}));
  const auto branch =
      std::find_if(three.branches().begin(), three.branches().end(),
                   [](const Branch& b) { return b.choice.leaflet == LeafletChoice::Triangular; });
  ASSERT_NE(branch, three.branches().end());
  std::multiset<Leaflet> leaflets;
  for (const RepairStep& step : three.plan(*branch, start_of(*branch)).steps)
    if (const auto* neochorda = std::get_if<Neochorda>(&step))
      leaflets.insert(neochorda->insertion.leaflet);
  EXPECT_EQ(leaflets, (std::multiset{Leaflet::Anterior, Leaflet::Anterior, Leaflet::Posterior}));
}

TEST(PlanSpace, ACommissuralLesionIsHeldOnBothLeafletsFromItsOwnMuscle) {
  const Valve& valve = shared_preset("human-normal", 200);
  for (const auto& [anterior, posterior, side] :
       {std::tuple(Segment::A1, Segment::P1, Side::Anterolateral),
        std::tuple(Segment::A3, Segment::P3, Side::Posteromedial)}) {
    const PlanSpace space(valve, {}, diagnosis_of({CarpentierType::II}, {posterior, anterior}));
    ASSERT_FALSE(space.branches().empty());
    const auto held_on_both =
        std::find_if(space.branches().begin(), space.branches().end(),
                     [](const Branch& b) { return b.choice.leaflet == LeafletChoice::None; });
    ASSERT_NE(held_on_both, space.branches().end());
    ASSERT_EQ(held_on_both->choice.neochordae, 2);
    const RepairPlan plan = space.plan(*held_on_both, start_of(*held_on_both));
    std::set<std::string> held;
    for (const RepairStep& step : plan.steps) {
      const auto* const neochorda = std::get_if<Neochorda>(&step);
      if (neochorda == nullptr) continue;
      EXPECT_EQ(neochorda->head.substr(0, 2), side == Side::Anterolateral ? "AL" : "PM");
      held.insert(describe(valve, {{step}})
                      .front()
                      .substr(describe(valve, {{step}}).front().rfind(' ') + 1));
    }
    EXPECT_EQ(held, (std::set<std::string>{to_string(anterior), to_string(posterior)}));
  }
}

TEST(Indication, CleftsThatLeakAreSuturedInEveryRepair) {
  const Valve& valve = shared_preset("human-normal", 200);
  Diagnosis diagnosis = diagnosis_of({CarpentierType::I});
  diagnosis.clefts = {{Segment::P1, Segment::P2, 0.35, 6.0, 0.5, 16.0},
                      {Segment::P2, Segment::P3, 0.65, 6.4, 0.5, 11.0}};
  const auto sutures_of = [](const RepairPlan& plan) {
    std::vector<EdgeToEdge> sutures;
    for (const RepairStep& step : plan.steps)
      if (const auto* suture = std::get_if<EdgeToEdge>(&step)) sutures.push_back(*suture);
    return sutures;
  };
  const PlanSpace space(valve, {}, diagnosis);
  ASSERT_FALSE(space.branches().empty());
  for (const Branch& branch : space.branches()) {
    const auto sutures = sutures_of(space.plan(branch, start_of(branch)));
    ASSERT_EQ(sutures.size(), 2u);
    EXPECT_EQ(sutures[0].device, EdgeDevice::CleftSuture);
    EXPECT_EQ(sutures[0].along, 0.35);
    EXPECT_EQ(sutures[1].width_mm, 8.0) << "a step beyond the deepest root, at first";
  }
  SearchRules rules;
  rules.forbidden = {"edge_to_edge:cleft_suture"};
  const PlanSpace forbidden(valve, rules, diagnosis);
  EXPECT_TRUE(is_cut(forbidden, "suture of clefts", "forbidden"));
  for (const Branch& branch : forbidden.branches())
    EXPECT_TRUE(sutures_of(forbidden.plan(branch, start_of(branch))).empty());
  // A valve that may be competent may also be left as it is.
  diagnosis.competent_sure = false;
  const PlanSpace unsure(valve, {}, diagnosis);
  EXPECT_TRUE(unsure.plan(unsure.branches().front(), {}).steps.empty());
}

TEST(Indication, ACommissureOfWhichBothScallopsProlapseMayBeClosed) {
  const Valve& valve = shared_preset("human-normal", 200);
  const auto closures = [&](const PlanSpace& space) {
    std::vector<RepairPlan> plans;
    for (const Branch& branch : space.branches())
      if (branch.choice.leaflet == LeafletChoice::CommissuralClosure)
        plans.push_back(space.plan(branch, start_of(branch)));
    return plans;
  };
  const auto space_of = [&](const std::vector<Segment>& prolapsing, const SearchRules& rules = {}) {
    return PlanSpace(valve, rules, diagnosis_of({CarpentierType::II}, prolapsing));
  };
  const auto steps_of = [](const RepairPlan& plan) {
    std::string kinds;
    for (const RepairStep& step : plan.steps)
      kinds += std::holds_alternative<Annuloplasty>(step) ? 'r'
               : std::holds_alternative<EdgeToEdge>(step) ? 'e'
               : std::holds_alternative<Neochorda>(step)  ? 'n'
                                                          : '?';
    return kinds;
  };
  const PlanSpace medial = space_of({Segment::P3, Segment::A3});
  EXPECT_EQ(medial.branches().front().choice.leaflet, LeafletChoice::CommissuralClosure)
      << "one stitch in place of two neochordae";
  ASSERT_FALSE(closures(medial).empty());
  for (const RepairPlan& plan : closures(medial)) {
    EXPECT_EQ(steps_of(plan), "re");
    const auto& stitch = std::get<EdgeToEdge>(plan.steps.back());
    EXPECT_EQ(stitch.device, EdgeDevice::Stitch);
    EXPECT_GT(stitch.along, 0.8) << "A3 to P3";
  }
  const PlanSpace both = space_of({Segment::A1, Segment::P1, Segment::A3, Segment::P3});
  for (const RepairPlan& plan : closures(both)) EXPECT_EQ(steps_of(plan), "ree");
  EXPECT_FALSE(closures(both).empty());
  const PlanSpace more = space_of({Segment::A1, Segment::P1, Segment::A3});
  for (const RepairPlan& plan : closures(more))
    EXPECT_EQ(steps_of(plan), "rnnne") << "neochordae at A3 alone";
  EXPECT_FALSE(closures(more).empty());
  // A lesion that reaches past the commissure is not closed with it.
  EXPECT_TRUE(closures(space_of({Segment::A1, Segment::P1, Segment::P2})).empty());
  EXPECT_TRUE(closures(space_of({Segment::A1})).empty());
  SearchRules rules;
  rules.forbidden = {"edge_to_edge:stitch"};
  const PlanSpace forbidden = space_of({Segment::A1, Segment::P1}, rules);
  EXPECT_TRUE(closures(forbidden).empty());
  EXPECT_TRUE(is_cut(forbidden, "closure of a commissure", "forbidden"));
}

}  // namespace
}  // namespace coapt
