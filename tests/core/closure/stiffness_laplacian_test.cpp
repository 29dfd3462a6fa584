#include "core/closure/stiffness_laplacian.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "core/closure/closure.h"
#include "core/closure/relaxation.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

using kernels::kLanes;
using kernels::Quad;

constexpr double kElse_n_per_mm = 0.5;  // of contact and chordae, at each node

/// Some stiffness for each corner, the same each time.
std::vector<Quad<float>> corner_stiffness(const RelaxationModel<float>& laid) {
  std::vector<Quad<float>> corners(3 * kLanes * laid.faces.size() + 1);
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    corners[i].at[3] = 1.0f + 0.25f * static_cast<float>(i % 7);
  return corners;
}

/// What each node has of its corners, and of all else.
std::vector<Quad<float>> node_stiffness(const RelaxationModel<float>& laid,
                                        const std::vector<Quad<float>>& corners) {
  std::vector<Quad<float>> nodes(laid.blocks.size() * kLanes);
  for (Quad<float>& node : nodes) node.at[3] = static_cast<float>(kElse_n_per_mm);
  for (std::size_t b = 0; b < laid.faces.size(); ++b)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const auto node = laid.faces[b].node[k].at[lane] / sizeof(Quad<float>);
        if (laid.faces[b].least_mm4.at[lane] > 0.0f && node < nodes.size())
          nodes[node].at[3] += corners[(3 * b + k) * kLanes + lane].at[3];
      }
  return nodes;
}

/// The Laplacian by its definition, a row a node; those that do not move have ones.
Eigen::MatrixXd dense(const RelaxationModel<float>& laid, const std::vector<Quad<float>>& corners) {
  const auto nodes = static_cast<Index>(laid.blocks.size() * kLanes);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(nodes, nodes);
  const auto moves = [&](Index node) {
    return node < nodes && laid.blocks[node / kLanes].free.at[node % kLanes] > 0.0f;
  };
  for (Index node = 0; node < nodes; ++node)
    matrix(node, node) = moves(node) ? kElse_n_per_mm : 1.0;
  for (std::size_t b = 0; b < laid.faces.size(); ++b)
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      if (!(laid.faces[b].least_mm4.at[lane] > 0.0f)) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto node = [&](std::size_t at) {
          return static_cast<Index>(laid.faces[b].node[at % 3].at[lane] / sizeof(Quad<float>));
        };
        const auto stiffness = [&](std::size_t at) {
          return static_cast<double>(corners[(3 * b + at % 3) * kLanes + lane].at[3]);
        };
        const double ends = stiffness(k) + stiffness(k + 1);
        const double weight = std::max(0.25 * (ends - stiffness(k + 2)), 0.05 * ends);
        const Index from = node(k), to = node(k + 1);
        if (moves(from)) matrix(from, from) += weight;
        if (moves(to)) matrix(to, to) += weight;
        if (moves(from) && moves(to)) matrix(from, to) -= weight, matrix(to, from) -= weight;
      }
    }
  return matrix;
}

TEST(StiffnessLaplacian, MovesByWhatBalancesTheForces) {
  const ClosureModel model = make_closure_model(shared_preset("human-functional-mr", 200));
  const RelaxationModel<float> laid = make_relaxation_model<float>(model);
  const std::vector<Quad<float>> corners = corner_stiffness(laid);
  std::vector<Quad<float>> nodes = node_stiffness(laid, corners);
  Eigen::MatrixXd force = Eigen::MatrixXd::Zero(std::ssize(nodes), 3);
  for (Index i = 0; i < force.rows(); ++i)
    if (laid.blocks[i / kLanes].free.at[i % kLanes] > 0.0f)
      for (int k = 0; k < 3; ++k)
        force(i, k) = nodes[i].at[k] = 0.1f * static_cast<float>((i + 3 * k) % 5) - 0.2f;
  StiffnessLaplacian<float> laplacian(laid);
  laplacian.refresh(corners, nodes);
  laplacian.solve(nodes);
  const Eigen::MatrixXd moves = dense(laid, corners).ldlt().solve(force);
  for (Index i = 0; i < force.rows(); ++i) {
    if (laid.blocks[i / kLanes].free.at[i % kLanes] == 0.0f) continue;
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(static_cast<double>(nodes[i].at[k]), moves(i, k), 1e-4) << i;
  }
}

TEST(StiffnessLaplacian, BringsAFineMeshToTheSameRestInFewerSteps) {
  const ClosureModel model = make_closure_model(shared_preset("human-functional-mr", 1400));
  RelaxationSettings settings;
  const ClosureRun alone = relax<float>(model, settings);
  settings.preconditioned = true;
  settings.damping = 0.06;
  const ClosureRun together = relax<float>(model, settings);
  ASSERT_EQ(alone.status, ClosureStatus::Converged);
  ASSERT_EQ(together.status, ClosureStatus::Converged);
  EXPECT_LT(together.steps, 0.8 * alone.steps);
  EXPECT_LT((together.x_mm - alone.x_mm).norm() / std::sqrt(static_cast<double>(model.vertices)),
            0.05);
}

TEST(StiffnessLaplacian, GivesTheSameBitsOnEveryInstructionSet) {
  const ClosureModel model = make_closure_model(shared_preset("human-functional-mr", 200));
  RelaxationSettings settings;
  settings.preconditioned = true;
  settings.damping = 0.06;
  settings.instructions = kernels::InstructionSet::Baseline;
  const ClosureRun one = relax<float>(model, settings), exact = relax<double>(model, settings);
  settings.instructions = kernels::InstructionSet::Portable;
  EXPECT_EQ(relax<float>(model, settings).x_mm, one.x_mm);
  settings.instructions = kernels::best_instruction_set();
  EXPECT_EQ(relax<float>(model, settings).x_mm, one.x_mm);
  EXPECT_EQ(relax<double>(model, settings).x_mm, exact.x_mm);
}

}  // namespace
}  // namespace coapt
