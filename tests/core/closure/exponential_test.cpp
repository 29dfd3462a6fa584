#include "core/closure/exponential.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/closure/closure.h"
#include "tests/core/closure/kernel_pulls.h"
#include "tests/scenes/leaflet_valves.h"
#include "tests/scenes/sheets.h"

namespace coapt {
namespace {

constexpr ExponentialTissue kAnterior{1.0, 0.124, 4.568};

/// A flat square of 10 mm, 0.5 mm thick.
Valve exponential_square() {
  const std::vector<double> lines = {0.0, 4.0, 10.0};
  Valve valve = grid_sheet(lines, lines, [](int, int) { return false; });
  valve.leaflets = {{"square", 0.5, kAnterior}};
  valve.face_leaflet.assign(valve.faces.rows(), 0);
  valve.segments.clear();
  return valve;
}

double energy(const ClosureModel& model, const Points& x) {
  double sum = 0.0;
  for (const ExponentialSheet& sheet : model.exponential_sheets) sum += sheet_energy(sheet, x);
  return sum;
}

Points forces(const ClosureModel& model, const Points& x) {
  Points sum = Points::Zero(x.rows(), 3);
  for (const ExponentialSheet& sheet : model.exponential_sheets) add_sheet_forces(sheet, x, sum);
  return sum;
}

/// Force over unstressed section, MPa, of the square stretched by l1 along x and l2 along y: along x
/// and along y.
std::array<double, 2> nominal_stress(double l1, double l2) {
  const Valve valve = exponential_square();
  const ClosureModel model = make_closure_model(valve);
  Points x = model.rest_mm;
  x.col(0) *= l1;
  x.col(1) *= l2;
  const Points force = forces(model, x);
  const double volume = 0.5 * 100.0;
  return {-force.col(0).dot(model.rest_mm.col(0)) / volume,
          -force.col(1).dot(model.rest_mm.col(1)) / volume};
}

/// W' by the formula.
double first_slope(double over) {
  return 1e-3 * (0.5 * kAnterior.c0_kpa +
                 kAnterior.c1_kpa * kAnterior.c2 * over * std::exp(kAnterior.c2 * over * over));
}

Points stretched_and_sheared(const Points& rest, double stretch) {
  Points x = rest;
  for (Index i = 0; i < x.rows(); ++i) {
    const Vec3 p = rest.row(i);
    x.row(i) = Vec3(stretch * p.x() + 0.1 * p.y(), stretch * p.y() + 0.02 * p.x() * p.z(),
                    (1.1 * stretch + 0.01 * p.x()) * p.z() + std::sin(p.x() + 2.0 * p.y()));
  }
  return x;
}

TEST(Exponential, ForceIsMinusTheGradientOfTheEnergy) {
  const ClosureModel model = make_closure_model(three_leaflets());
  ASSERT_EQ(std::ssize(model.exponential_sheets), model.faces.rows());
  EXPECT_TRUE(model.springs.empty());
  for (const double stretch : {0.8, 1.0, 1.2, 1.6}) {  // the last beyond the tangent
    Points x = stretched_and_sheared(model.rest_mm, stretch);
    const Points force = forces(model, x);
    constexpr double kStep = 1e-6;
    for (Index i = 0; i < 3 * model.vertices; ++i) {
      const double at = x.data()[i];
      x.data()[i] = at + kStep;
      const double more = energy(model, x);
      x.data()[i] = at - kStep;
      const double less = energy(model, x);
      x.data()[i] = at;
      EXPECT_NEAR(force.data()[i], (less - more) / (2.0 * kStep),
                  1e-6 * (1.0 + std::abs(force.data()[i])))
          << stretch << ' ' << i;
    }
  }
}

TEST(Exponential, StripInTensionFollowsTheClosedForm) {
  for (const double l : {0.9, 1.001, 1.2, 1.5}) {
    const auto [along, across] = nominal_stress(l, 1.0 / std::sqrt(l));
    const double slope = first_slope(l * l + 2.0 / l - 3.0);
    EXPECT_NEAR(along, 2.0 * slope * (l - 1.0 / (l * l)), 1e-12) << l;
    EXPECT_NEAR(across, 0.0, 1e-12) << l;
  }
}

TEST(Exponential, StripIsThreeTimesC0StiffAtSmallStrain) {
  EXPECT_NEAR(nominal_stress(1.0001, 1.0 / std::sqrt(1.0001))[0] / 0.0001, 3e-3, 2e-6);
}

TEST(Exponential, EquibiaxialTensionFollowsTheClosedForm) {
  for (const double l : {0.95, 1.1, 1.25}) {
    const auto [along, across] = nominal_stress(l, l);
    const double over = 2.0 * l * l + std::pow(l, -4.0) - 3.0;
    EXPECT_NEAR(along, 2.0 * first_slope(over) * (l - std::pow(l, -5.0)), 1e-12) << l;
    EXPECT_NEAR(across, along, 1e-12) << l;
  }
}

TEST(Exponential, SlopeGoesOnAlongItsTangent) {
  const ExponentialLaw law = exponential_law(kAnterior);
  const double knee = std::sqrt(kSteepest / law.c2);
  const ExponentialSlope at = slope(law, knee), beyond = slope(law, knee + 0.5);
  EXPECT_NEAR(beyond.first, at.first + 0.5 * at.second, 1e-12);
  EXPECT_DOUBLE_EQ(beyond.second, at.second);
}

TEST(Exponential, RowSumsBoundTheStiffness) {
  const ClosureModel model = make_closure_model(three_leaflets());
  for (const double stretch : {1.0, 1.2, 1.5}) {
    const Points x = stretched_and_sheared(model.rest_mm, stretch);
    std::vector<double> rows(x.rows(), 0.0);
    for (const ExponentialSheet& sheet : model.exponential_sheets) {
      const auto sums = row_sums(sheet, x);
      for (std::size_t k = 0; k < 3; ++k) rows[sheet.sheet.node[k]] += sums[k];
    }
    for (int trial = 0; trial < 40; ++trial) {
      Points v = Points::Zero(x.rows(), 3);
      for (Index i = 0; i < 3 * model.vertices; ++i)
        v.data()[i] = std::sin(1.7 * static_cast<double>(i * (trial + 1)) + trial);
      constexpr double kStep = 1e-6;
      const Points change = forces(model, x - kStep * v) - forces(model, x + kStep * v);
      const double work = (v.array() * change.array()).sum() / (2.0 * kStep);
      double bound = 0.0;
      for (Index i = 0; i < x.rows(); ++i) bound += rows[i] * v.row(i).squaredNorm();
      EXPECT_LT(work, bound * (1.0 + 1e-6)) << stretch << ' ' << trial;
    }
  }
}

/// Without bending and pressure.
ClosureModel tissue_alone() {
  ClosureModel model = make_closure_model(three_leaflets());
  model.hinges.clear();
  model.pressure_mpa = 0.0;
  return model;
}

TEST(PullExponential, PullsLikeThePlainSheetsWithHalfTheirRowSums) {
  const ClosureModel model = tissue_alone();
  for (const double stretch : {0.8, 1.2, 1.6}) {
    const Points x = stretched_and_sheared(model.rest_mm, stretch);
    const auto force = pulls_of_faces<double>(model, x, kernels::best_instruction_set());
    const Points plain = forces(model, x);
    std::vector<double> rows(x.rows(), 0.0);
    for (const ExponentialSheet& sheet : model.exponential_sheets) {
      const auto sums = row_sums(sheet, x);
      for (std::size_t k = 0; k < 3; ++k) rows[sheet.sheet.node[k]] += sums[k];
    }
    const double most = plain.rowwise().norm().maxCoeff();
    for (std::size_t i = 0; i < force.size(); ++i) {
      const kernels::Quad<double>& quad = force[i];
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(quad.at[k], plain(i, k), 1e-11 * most) << i;
      EXPECT_NEAR(quad.at[3], 0.5 * rows[i], 1e-9 * rows[i]) << i;
    }
  }
}

template <class R>
void expect_same_bits_on_all_sets() {
  const ClosureModel model = tissue_alone();
  const Points x = stretched_and_sheared(model.rest_mm, 1.2);
  using kernels::InstructionSet;
  const auto expected = pulls_of_faces<R>(model, x, InstructionSet::Portable);
  for (const InstructionSet set :
       {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512}) {
    if (set > kernels::best_instruction_set()) continue;
    const auto force = pulls_of_faces<R>(model, x, set);
    for (std::size_t i = 0; i < force.size(); ++i)
      for (int k = 0; k < 4; ++k) EXPECT_EQ(force[i].at[k], expected[i].at[k]) << to_string(set);
  }
}

TEST(PullExponential, GivesTheSameBitsOnAllInstructionSets) {
  expect_same_bits_on_all_sets<float>();
  expect_same_bits_on_all_sets<double>();
}

template <class R>
double largest_error_of_exponentials() {
  double error = 0.0;
  for (double first = 0.0; first < 39.0; first += 0.37) {
    kernels::Lane<R> from, to;
    for (int i = 0; i < kernels::kLanes; ++i) from.at[i] = static_cast<R>(first + 0.0217 * i);
    kernels::kernels<R>(kernels::best_instruction_set()).exponentials(from, to);
    for (int i = 0; i < kernels::kLanes; ++i) {
      const double exact = std::exp(static_cast<double>(from.at[i]));
      error = std::max(error, std::abs(static_cast<double>(to.at[i]) / exact - 1.0));
    }
  }
  return error;
}

TEST(Exponentials, AreWithinAMillionthInFloatsAndAsGoodAsTheLibraryInDoubles) {
  EXPECT_LT(largest_error_of_exponentials<float>(), 1e-6);
  EXPECT_LT(largest_error_of_exponentials<double>(), 1e-14);
}

TEST(Exponential, ValveOfThreeLeafletsComesToRest) {
  Valve valve = three_leaflets();
  valve.pressure_kpa = 1.0;
  const ClosureResult closure = close_valve(valve);
  EXPECT_EQ(closure.status, ClosureStatus::Converged);
  EXPECT_LE(closure.residual, 0.05);
}

}  // namespace
}  // namespace coapt
