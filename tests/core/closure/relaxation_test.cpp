#include "core/closure/relaxation.h"

#include <gtest/gtest.h>

#include <set>

#include "core/closure/closure.h"
#include "core/closure/contact_pairs.h"
#include "core/closure/relaxation_model.h"
#include "tests/core/closure/kernel_pulls.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

using kernels::InstructionSet;
using kernels::Quad;

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> sets = {InstructionSet::Portable};
  for (const InstructionSet set :
       {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512})
    if (kernels::best_instruction_set() >= set) sets.push_back(set);
  return sets;
}

/// The same points in the order of the kernels.
std::vector<Quad<double>> kernel_points(const RelaxationModel<double>& laid, const Points& x) {
  std::vector<Quad<double>> points(laid.nodes);
  for (std::size_t i = 0; i < laid.node_of.size(); ++i)
    for (int k = 0; k < 3; ++k) points[laid.node_of[i]].at[k] = x(i, k);
  return points;
}

/// A valve that is half closed, so that it touches itself in many places.
Points half_closed(const ClosureModel& model) {
  RelaxationSettings settings;
  settings.max_steps = 120;
  return relax<double>(model, settings).x_mm;
}

/// A preset's model with either membrane.
std::vector<ClosureModel> models(const std::string& preset, int triangles = 200) {
  const Valve& valve = shared_preset(preset, triangles);
  return {make_closure_model(valve, Membrane::Springs),
          make_closure_model(valve, Membrane::Continuum)};
}

TEST(Relaxation, GivesTheSameBitsOnEveryInstructionSet) {
  for (const ClosureModel& model : models("human-functional-mr"))
    for (const bool edges : {false, true}) {
      RelaxationSettings settings;
      settings.contact.edges = edges;
      settings.instructions = InstructionSet::Baseline;
      const ClosureRun single = relax<float>(model, settings);
      const ClosureRun twice = relax<double>(model, settings);
      for (const InstructionSet set : instruction_sets()) {
        settings.instructions = set;
        const ClosureRun a = relax<float>(model, settings), b = relax<double>(model, settings);
        EXPECT_EQ(a.x_mm, single.x_mm) << to_string(set);
        EXPECT_EQ(a.steps, single.steps) << to_string(set);
        EXPECT_EQ(b.x_mm, twice.x_mm) << to_string(set);
      }
    }
}

void expect_to_stay_where_thesis_came_to_rest(Membrane membrane) {
  const Valve& valve = small_preset("human-normal");
  ClosureOptions options;
  options.method = Method::Thesis;
  options.membrane = membrane;
  options.residual_tolerance = 1e-5;
  const ClosureResult thesis = close_valve(valve, options);
  ASSERT_EQ(thesis.status, ClosureStatus::Converged);
  const ClosureModel model = make_closure_model(valve, membrane);
  ClosureRun at_rest;
  Points& start = at_rest.x_mm = model.target_mm;
  start.topRows(model.vertices) = thesis.closed_mm;
  int next = model.vertices;
  for (std::size_t c = 0; c < valve.chordae.size(); ++c)
    for (std::size_t s = 0; s < valve.chordae[c].segments.size(); ++s)
      if (!valve.chordae[c].segments[s].inserts)
        start.row(next++) = thesis.branch_points_mm[c].row(s);
  RelaxationSettings settings;
  settings.residual_tolerance = 1e-5;
  settings.way_tolerance_mm = 1e-4;
  settings.contact.edges = thesis.attempts.size() > 1;
  const ClosureRun run = relax<double>(model, settings, &at_rest);
  ASSERT_EQ(run.status, ClosureStatus::Converged);
  EXPECT_LT((run.x_mm - start).rowwise().norm().maxCoeff(), 2e-3);
}

TEST(Relaxation, StaysWhereTheThesisMethodCameToRest) {
  for (const Membrane membrane : {Membrane::Springs, Membrane::Continuum})
    expect_to_stay_where_thesis_came_to_rest(membrane);
}

TEST(Relaxation, ThatIsAtRestHasForcesInBalance) {
  // Folds that are a few vertices wide, as on smaller meshes, creep for long.
  for (const ClosureModel& model : models("human-normal", 650)) {
    RelaxationSettings settings;
    settings.residual_tolerance = 2e-7;
    settings.way_tolerance_mm = 1e-5;
    settings.guards = false;  // the plain contact below has edges everywhere or nowhere
    const ClosureRun run = relax<double>(model, settings);
    ASSERT_EQ(run.status, ClosureStatus::Converged);
    // By the plain functions of the model, not by the kernels.
    Points force = Points::Zero(run.x_mm.rows(), 3);
    add_elastic_forces(model, run.x_mm, force);
    add_pressure_forces(model, run.x_mm, force);
    Contact(settings.contact).add_forces(model, run.x_mm, force);
    for (Eigen::Index i = 0; i < force.rows(); ++i) {
      if (!model.fixed[i]) {
        EXPECT_LT(force.row(i).norm(), 1e-6) << i;
      }
    }
  }
}

/// Forces to 1e-11 N, stiffness half the row sums.
void expect_pulls(const ClosureModel& model, const Points& x, const std::vector<double>& rows) {
  Points plain = Points::Zero(x.rows(), 3);
  add_elastic_forces(model, x, plain);
  ASSERT_GT(plain.rowwise().norm().maxCoeff(), 0.001);
  const auto pulls = pulls_of_faces<double>(model, x, kernels::best_instruction_set());
  for (std::size_t i = 0; i < pulls.size(); ++i) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(pulls[i].at[k], plain(i, k), 1e-11) << i;
    EXPECT_NEAR(pulls[i].at[3], 0.5 * rows[i], 1e-10 * rows[i]) << i;
  }
}

/// By node: the row sums of the elements around it, added up.
template <class Element, class RowSums>
std::vector<double> added_rows(const std::vector<Element>& elements, const Points& x,
                               const RowSums& row_sums_of) {
  std::vector<double> rows(x.rows(), 0.0);
  for (const Element& element : elements) {
    const auto sums = row_sums_of(element);
    for (std::size_t k = 0; k < sums.size(); ++k) rows[element.node[k]] += sums[k];
  }
  return rows;
}

/// Half closed, without chordae and pressure.
ClosureModel leaflets_alone(Points& x) {
  ClosureModel model = make_closure_model(small_preset("human-normal"), Membrane::Continuum);
  x = half_closed(model);
  model.cables.clear();
  model.pressure_mpa = 0.0;
  return model;
}

TEST(PullFaces, PullLikeThePlainSheetsWithHalfTheirRowSums) {
  Points x;
  ClosureModel model = leaflets_alone(x);
  model.hinges.clear();
  expect_pulls(model, x, added_rows(model.sheets, x, [&](const Sheet& sheet) {
                 return row_sums(model.law, sheet, x);
               }));
}

TEST(PullFaces, BendLikeThePlainHingesWithHalfTheirRowSums) {
  Points x;
  ClosureModel model = leaflets_alone(x);
  model.sheets.clear();
  expect_pulls(model, x,
               added_rows(model.hinges, x, [&](const Hinge& hinge) { return row_sums(hinge, x); }));
}

TEST(PullFaces, PressLikeThePlainPressure) {
  Points x;
  ClosureModel model = leaflets_alone(x);
  model.sheets.clear();
  model.hinges.clear();
  model.pressure_mpa = 0.016;
  Points plain = Points::Zero(x.rows(), 3);
  add_pressure_forces(model, x, plain);
  const auto pulls = pulls_of_faces<double>(model, x, kernels::best_instruction_set());
  for (std::size_t i = 0; i < pulls.size(); ++i)
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(pulls[i].at[k], plain(i, k), 1e-12) << i;
}

TEST(ContactPairs, PushLikeThePlainContact) {
  const ClosureModel model = make_closure_model(small_preset("porcine-5"));
  const Points x = half_closed(model);
  const RelaxationModel<double> laid = make_relaxation_model<double>(model);
  const std::vector<Quad<double>> at = kernel_points(laid, x);
  std::vector<Quad<double>> force(at.size());
  const kernels::Kernels<double>& table = kernels::kernels<double>(kernels::best_instruction_set());
  for (const bool edges : {false, true}) {
    ContactLaw law;
    law.edges = edges;
    Points plain = Points::Zero(x.rows(), 3);
    Contact(law).add_forces(model, x, plain);
    ASSERT_GT(plain.rowwise().norm().maxCoeff(), 0.01);
    std::fill(force.begin(), force.end(), Quad<double>{});
    for (const PairKind kind : {PairKind::VertexFace, PairKind::EdgeEdge}) {
      if (kind == PairKind::EdgeEdge && !edges) continue;
      ContactPairs<double> pairs(model, laid.node_of, law, kind, table, model.edges);
      std::vector<Quad<double>> listed = at;
      for (Quad<double>& quad : listed) quad.at[3] = 0.3;  // margin
      pairs.list(listed);
      pairs.push(at, 0.0, force);
    }
    for (std::size_t i = 0; i < laid.node_of.size(); ++i)
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(force[laid.node_of[i]].at[k], plain(i, k), 1e-9) << i;
  }
}

TEST(ClusterOrder, IsAPermutationWhoseSixteensLieTogether) {
  Points grid(256, 3);
  for (int i = 0; i < 256; ++i) grid.row(i) << i % 16, i / 16, 0.0;
  const std::vector<int> order = cluster_order(grid);
  EXPECT_EQ(std::set<int>(order.begin(), order.end()).size(), 256u);
  for (std::size_t first = 0; first < 256; first += 16) {
    Vec3 low = Vec3::Constant(1e9), high = -low;
    for (std::size_t i = first; i < first + 16; ++i) {
      low = low.cwiseMin(grid.row(order[i]).transpose());
      high = high.cwiseMax(grid.row(order[i]).transpose());
    }
    EXPECT_LE((high - low).maxCoeff(), 3.0);
  }
}

}  // namespace
}  // namespace coapt
