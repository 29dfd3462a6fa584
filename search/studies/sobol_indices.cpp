#include "search/studies/sobol_indices.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace coapt {
namespace {

/// Legendre polynomials on [0, 1] of unit variance, degrees 1 and 2.
double linear(double share) { return std::sqrt(3.0) * (2.0 * share - 1.0); }
double quadratic(double share) {
  const double x = 2.0 * share - 1.0;
  return std::sqrt(5.0) * 0.5 * (3.0 * x * x - 1.0);
}

/// A term is the product of its factors' polynomials; second < 0: of one factor alone.
struct Term {
  int first = 0, second = -1, degree = 1;
  double at(const std::vector<double>& shares) const {
    const double x = shares[first];
    if (second >= 0) return linear(x) * linear(shares[second]);
    return degree == 1 ? linear(x) : quadratic(x);
  }
};

enum class Terms { Linear, Squares, Products };

std::vector<Term> terms_of(int factors, Terms terms) {
  std::vector<Term> all;
  for (int i = 0; i < factors; ++i) {
    all.push_back({i, -1, 1});
    if (terms != Terms::Linear) all.push_back({i, -1, 2});
    for (int j = i + 1; terms == Terms::Products && j < factors; ++j) all.push_back({i, j, 1});
  }
  return all;
}

struct Polynomial {
  std::vector<Term> terms;
  Eigen::VectorXd weight;        // of the constant, then of the terms
  double predicted_share = 0.0;  // Q2
};

Polynomial fit(const std::vector<std::vector<double>>& shares, const Eigen::VectorXd& value,
               const std::vector<Term>& terms) {
  const Eigen::Index rows = value.size();
  const Eigen::Index columns = std::ssize(terms) + 1;
  Eigen::MatrixXd design(rows, columns);
  for (Eigen::Index r = 0; r < rows; ++r) {
    design(r, 0) = 1.0;
    for (Eigen::Index k = 0; k < std::ssize(terms); ++k) design(r, k + 1) = terms[k].at(shares[r]);
  }
  const auto normal = (design.transpose() * design).ldlt();
  const Eigen::VectorXd weight = normal.solve(design.transpose() * value);
  const Eigen::MatrixXd inverse = normal.solve(Eigen::MatrixXd::Identity(columns, columns));
  double missed = 0.0;
  for (Eigen::Index r = 0; r < rows; ++r) {
    const double leverage = design.row(r) * inverse * design.row(r).transpose();
    missed += std::pow((value(r) - design.row(r).dot(weight)) / std::max(1e-9, 1.0 - leverage), 2);
  }
  return {terms, weight, 1.0 - missed / (value.array() - value.mean()).square().sum()};
}

}  // namespace

SobolIndices sobol_indices(const std::vector<std::vector<double>>& shares,
                           const std::vector<double>& values) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::size_t factors = shares.empty() ? 0 : shares.front().size();
  const std::vector<double> unknown(factors, nan);
  SobolIndices indices{unknown, unknown, unknown, nan};
  const Eigen::VectorXd value =
      Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values));
  if (factors == 0 || !(value.maxCoeff() > value.minCoeff())) return indices;
  Polynomial best;
  for (const Terms set : {Terms::Linear, Terms::Squares, Terms::Products}) {
    const std::vector<Term> terms = terms_of(static_cast<int>(factors), set);
    if (shares.size() <= terms.size() + 1) continue;
    const Polynomial polynomial = fit(shares, value, terms);
    if (best.terms.empty() || polynomial.predicted_share > best.predicted_share) best = polynomial;
  }
  if (best.terms.empty()) return indices;
  indices = {std::vector<double>(factors), std::vector<double>(factors),
             std::vector<double>(factors), best.predicted_share};
  const double variance = best.weight.tail(best.weight.size() - 1).squaredNorm();
  for (Eigen::Index k = 0; k < std::ssize(best.terms); ++k) {
    const Term& term = best.terms[k];
    const double weight = best.weight(k + 1);
    indices.total[term.first] += weight * weight / variance;
    if (term.second >= 0) {
      indices.total[term.second] += weight * weight / variance;
      continue;
    }
    indices.first[term.first] += weight * weight / variance;
    if (term.degree == 1) indices.effect[term.first] = weight * (linear(1.0) - linear(0.0));
  }
  return indices;
}

}  // namespace coapt
