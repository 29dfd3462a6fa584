// Backward Euler of an overdamped flow, one Newton iteration a step: (K + mu D) dx = f, Levenberg 1944
// and pseudo-transient continuation (Kelley and Keyes 1998). D is each node's own row sum of K
// (Gershgorin), so that mu = 1 is about an explicit step and mu = 0 is Newton's. In D tissue counts as
// beyond its knee and every chorda as taut: 103 steps instead of 170 for human-normal, and without it
// chordae five times as stiff never settle.
//
// K is positive semidefinite by construction: a spring under compression keeps its axial stiffness and
// loses its geometric one, contact has its normal stiffness alone, and the pressure, which follows the
// faces and has no symmetric tangent, is left out. That costs quadratic convergence and keeps the
// Cholesky factorisation from failing; where tissue is slack the pressure decides and steps get shorter
// than a full tangent would allow.
//
// A step is cut to the longest move (contact would be jumped over) and then to where the work of the
// forces along it vanishes (a secant, because pressure has no energy to descend). mu falls while full
// steps succeed and grows when they are cut by the work.

#include "lab/comparators/newton.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "core/closure/crossing.h"
#include "core/closure/residual.h"
#include "lab/comparators/spring_law.h"

namespace coapt::comparators {
namespace {

constexpr int kTravelIterations = 40;
constexpr double kMostMu = 1.0, kLeastMu = 1e-3;
constexpr double kEase = 0.6, kStiffen = 3.0;  // of mu, after a full step and after a cut one
constexpr double kLeastStep = 0.1;             // share of dx that a cut leaves
constexpr double kLeastDiagonal_n_per_mm = 1e-6;

/// A block of stiffness between nodes a and b: their weights' product times the block.
struct Element {
  std::vector<NodeShare> nodes;
  Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
  double stiffness_n_per_mm = 0.0;  // largest eigenvalue of the block
};

/// A line element of length |between| under `pull`.
Element line(std::vector<NodeShare> nodes, const Vec3& between, const Pull& pull) {
  const double length = between.norm();
  const Vec3 n = between / length;
  const double across = std::max(0.0, pull.tension_n) / length;
  const Eigen::Matrix3d along = n * n.transpose();
  return {std::move(nodes),
          pull.stiffness_n_per_mm * along + across * (Eigen::Matrix3d::Identity() - along),
          std::max(pull.stiffness_n_per_mm, across)};
}

class Newton {
 public:
  Newton(const ClosureModel& model, const NewtonSettings& settings)
      : model_(model), contact_(settings.contact), unknown_(model.fixed.size(), -1) {
    for (std::size_t i = 0; i < model.fixed.size(); ++i)
      if (!model.fixed[i]) unknown_[i] = 3 * unknowns_++;
    unknowns_ *= 3;
  }

  Points forces(const Points& x) {
    Points force = Points::Zero(x.rows(), 3);
    add_elastic_forces(model_, x, force);
    add_pressure_forces(model_, x, force);
    contact_.add_forces(model_, x, force);
    return force;
  }

  /// |N| x 3, 0 for fixed nodes; not a number if the matrix could not be factorised.
  Points direction(const Points& x, const Points& force, double mu) {
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd diagonal = Eigen::VectorXd::Constant(unknowns_, kLeastDiagonal_n_per_mm);
    for (const Element& e : elements(x)) add(e, mu, entries, diagonal);
    for (int i = 0; i < unknowns_; ++i) entries.emplace_back(i, i, diagonal[i]);
    Eigen::SparseMatrix<double> matrix(unknowns_, unknowns_);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
    if (factor.info() != Eigen::Success)
      return Points::Constant(x.rows(), 3, std::numeric_limits<double>::quiet_NaN());
    Eigen::VectorXd right(unknowns_);
    for (std::size_t i = 0; i < unknown_.size(); ++i)
      if (unknown_[i] >= 0)
        right.segment<3>(unknown_[i]) = force.row(static_cast<Eigen::Index>(i)).transpose();
    const Eigen::VectorXd found = factor.solve(right);
    Points dx = Points::Zero(x.rows(), 3);
    for (std::size_t i = 0; i < unknown_.size(); ++i)
      if (unknown_[i] >= 0)
        dx.row(static_cast<Eigen::Index>(i)) = found.segment<3>(unknown_[i]).transpose();
    return dx;
  }

 private:
  std::vector<Element> elements(const Points& x) {
    std::vector<Element> all;
    for (const Spring& s : model_.springs) {
      const Vec3 d = (x.row(s.b) - x.row(s.a)).transpose();
      all.push_back(line({{s.a, -1.0}, {s.b, 1.0}}, d, pull_of(s, d.norm())));
      all.back().stiffness_n_per_mm = std::max(s.pre_n_per_mm, s.post_n_per_mm);
    }
    for (const Cable& c : model_.cables) {
      const Vec3 d = end_position(c, x) - Vec3(x.row(c.start));
      std::vector<NodeShare> nodes = c.end;
      nodes.push_back({c.start, -1.0});
      all.push_back(line(std::move(nodes), d, pull_of(c, d.norm())));
      all.back().stiffness_n_per_mm = c.stiffness_n_per_mm;
    }
    for (const Touch& t : contact_.touches(model_, x)) {
      const double stiffness = 2.0 * t.force_n_per_mm2 * t.gap_mm;
      Element touch{{}, stiffness * t.direction * t.direction.transpose(), stiffness};
      for (std::size_t k = 0; k < 4; ++k) touch.nodes.push_back({t.nodes[k], t.weights[k]});
      all.push_back(std::move(touch));
    }
    return all;
  }

  void add(const Element& e, double mu, std::vector<Eigen::Triplet<double>>& entries,
           Eigen::VectorXd& diagonal) const {
    double sum = 0.0;
    for (const NodeShare& a : e.nodes) sum += std::abs(a.weight);
    for (const NodeShare& a : e.nodes) {
      const int row = unknown_[static_cast<std::size_t>(a.node)];
      if (row < 0) continue;
      diagonal.segment<3>(row).array() += mu * std::abs(a.weight) * sum * e.stiffness_n_per_mm;
      for (const NodeShare& b : e.nodes) {
        const int column = unknown_[static_cast<std::size_t>(b.node)];
        if (column < 0 || column > row) continue;
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            entries.emplace_back(row + i, column + j, a.weight * b.weight * e.block(i, j));
      }
    }
  }

  const ClosureModel& model_;
  Contact contact_;
  std::vector<int> unknown_;  // |N|, first of three, -1: fixed
  int unknowns_ = 0;
};

double work(const Points& force, const Points& dx) { return force.cwiseProduct(dx).sum(); }

}  // namespace

ClosureRun run_newton(const ClosureModel& model, const NewtonSettings& settings) {
  Newton newton(model, settings);
  ClosureRun run;
  Points& x = run.x_mm = model.rest_mm;
  double mu = kMostMu;
  while (run.steps < settings.max_steps) {
    ++run.steps;
    const double travelled = std::min(1.0, static_cast<double>(run.steps) / kTravelIterations);
    for (Eigen::Index i = 0; i < x.rows(); ++i)
      if (model.fixed[static_cast<std::size_t>(i)])
        x.row(i) =
            model.rest_mm.row(i) + travelled * (model.target_mm.row(i) - model.rest_mm.row(i));
    const Points force = newton.forces(x);
    run.residual = residual(model, x, force);
    if (travelled == 1.0 && run.residual <= settings.residual_tolerance) {
      run.status = ClosureStatus::Converged;
      break;
    }
    Points dx = newton.direction(x, force, mu / settings.pseudo_time);
    if (has_diverged(x) || has_diverged(dx)) {
      run.status = ClosureStatus::Diverged;
      break;
    }
    const double longest = dx.rowwise().norm().maxCoeff();
    const bool far = longest > settings.longest_move_mm;
    if (far) dx *= settings.longest_move_mm / longest;
    const double before = work(force, dx), after = work(newton.forces(x + dx), dx);
    if (after < -0.5 * before) {
      x += std::max(kLeastStep, before / (before - after)) * dx;
      mu = std::min(kMostMu, kStiffen * mu);
    } else {
      x += dx;
      if (!far) mu = std::max(kLeastMu, kEase * mu);
    }
  }
  if (run.status != ClosureStatus::Diverged)
    run.crossing_pairs = static_cast<int>(crossing_pairs(model.faces, x).size());
  if (run.status == ClosureStatus::Converged) run.samples_mm.push_back(x.topRows(model.vertices));
  return run;
}

}  // namespace coapt::comparators
