#include "search/information.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "search/random_share.h"

namespace coapt {
namespace {

constexpr int kRepeats = 4;            // measurements of each draw
constexpr double kDrawsPerTerm = 2.0;  // below so many effective draws a polynomial says nothing
constexpr double kLeakShare = 0.25, kLeastLeakSd_mm2 = 1.0;
constexpr double kGapSd_mm = 0.5, kTentingSd_mm2 = 20.0;  // of an echo, assumed
constexpr double kShapeHeightSd_mm = 0.3,
                 kShapeAreaSd_mm2 = 5.0;  // of a surface that coapt fit takes, assumed
constexpr double kTissueSd =
    0.05;  // of a range, as a share: a test of the leaflet's tissue, assumed

/// A figure that is measured, and the standard deviation with which.
struct FigureSeen {
  std::function<double(const InformedDraw&)> value;
  std::function<double(double)> sd;
};

struct Measurement {
  const char* name;
  std::vector<FigureSeen> figures;
};

FigureSeen observed(ObservedFigure figure, double sd) {
  return {[at = static_cast<std::size_t>(figure)](const InformedDraw& draw) {
            return draw.figures.value[at];
          },
          [sd](double) { return sd; }};
}

FigureSeen shape(std::size_t at, double sd) {
  return {[at](const InformedDraw& draw) { return draw.closed_shape[at]; },
          [sd](double) { return sd; }};
}

/// By index of model_parameters().
FigureSeen tissue(std::size_t at) {
  return {[at](const InformedDraw& draw) { return draw.shares[at]; },
          [](double) { return kTissueSd; }};
}

std::vector<Measurement> measurements() {
  const FigureSeen leak = {observed(ObservedFigure::Leak, 0.0).value,
                           [](double mm2) { return std::max(kLeastLeakSd_mm2, kLeakShare * mm2); }};
  const FigureSeen gap = observed(ObservedFigure::WidestGap, kGapSd_mm);
  const FigureSeen tenting = observed(ObservedFigure::TentingArea, kTentingSd_mm2);
  return {{"regurgitant area to 25 %", {leak}},
          {"widest gap to 0.5 mm", {gap}},
          {"tenting area to 20 mm2", {tenting}},
          {"regurgitant area, widest gap and tenting area", {leak, gap, tenting}},
          {"closed shape (coapt fit)",
           {shape(0, kShapeHeightSd_mm), shape(1, kShapeAreaSd_mm2), shape(2, kShapeHeightSd_mm)}},
          {"tissue test: moduli above the transition and transitions",
           {tissue(4), tissue(5), tissue(6)}},
          {"leaflet thickness", {tissue(2)}},
          {"lengths of chordae", {tissue(8)}}};
}

/// 1, and all products of at most two of the row's numbers.
Eigen::RowVectorXd terms_of(const Eigen::RowVectorXd& x) {
  const Eigen::Index n = x.size();
  Eigen::RowVectorXd terms(1 + n + n * (n + 1) / 2);
  terms(0) = 1.0;
  terms.segment(1, n) = x;
  Eigen::Index at = 1 + n;
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = i; j < n; ++j) terms(at++) = x(i) * x(j);
  return terms;
}

/// Draws that count, with their leaks and weights.
struct Sample {
  std::vector<const InformedDraw*> draws;
  Eigen::VectorXd leak_mm2, weight;
  double variance() const {
    const double mean = weight.dot(leak_mm2);
    return weight.dot((leak_mm2.array() - mean).square().matrix());
  }
};

Sample sample_of(const std::vector<InformedDraw>& draws) {
  Sample sample;
  double sum = 0.0;
  for (const InformedDraw& draw : draws) {
    sample.draws.push_back(&draw);
    sum += draw.weight;
  }
  const auto n = std::ssize(sample.draws);
  sample.leak_mm2.resize(n);
  sample.weight.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const InformedDraw& draw = *sample.draws[static_cast<std::size_t>(i)];
    sample.leak_mm2(i) = draw.leak_mm2;
    sample.weight(i) = draw.weight / sum;
  }
  return sample;
}

/// A figure of each draw, with the error of measuring it.
struct SeenDraws {
  Eigen::ArrayXd value, sd, seen;
};

std::vector<SeenDraws> measured(const Sample& sample, const Measurement& by,
                                std::mt19937_64& engine) {
  const auto n = std::ssize(sample.draws);
  std::vector<SeenDraws> all(by.figures.size());
  for (SeenDraws& figure : all) figure = {Eigen::ArrayXd(n), Eigen::ArrayXd(n), Eigen::ArrayXd(n)};
  for (Eigen::Index i = 0; i < n; ++i)
    for (std::size_t k = 0; k < all.size(); ++k) {
      all[k].value(i) = by.figures[k].value(*sample.draws[static_cast<std::size_t>(i)]);
      all[k].sd(i) = by.figures[k].sd(all[k].value(i));
      all[k].seen(i) = all[k].value(i) + all[k].sd(i) * normal_share(engine);
    }
  return all;
}

/// Figures as seen, each of mean 0 and deviation 1 over the draws.
Eigen::MatrixXd standardised(const Sample& sample, const std::vector<SeenDraws>& figures) {
  Eigen::MatrixXd x(std::ssize(sample.draws), std::ssize(figures));
  for (Eigen::Index k = 0; k < x.cols(); ++k) {
    x.col(k) = figures[static_cast<std::size_t>(k)].seen;
    const double mean = sample.weight.dot(x.col(k));
    x.col(k).array() -= mean;
    const double sd = std::sqrt(sample.weight.dot(x.col(k).cwiseAbs2()));
    if (sd > 0.0) x.col(k) /= sd;
  }
  return x;
}

/// Weighted mean square of what the others miss of each draw by their mean, weighed as they would be if it had been seen so
/// (search/conditioning.h). Of few that agree the mean errs, too: by the n-th part of the variance of n.
double left_by_weights(const Sample& sample, const std::vector<SeenDraws>& figures) {
  double missed = 0.0;
  for (Eigen::Index i = 0; i < std::ssize(sample.draws); ++i) {
    Eigen::ArrayXd square = Eigen::ArrayXd::Zero(sample.leak_mm2.size());
    for (const SeenDraws& figure : figures)
      square += ((figure.value - figure.seen(i)) / figure.sd(i)).square();
    square(i) = std::numeric_limits<double>::infinity();
    const Eigen::ArrayXd agrees =
        sample.weight.array() * (-0.5 * (square - square.minCoeff())).exp();
    const double sum = agrees.sum(), n = sum * sum / agrees.square().sum();
    const double mean = (agrees * sample.leak_mm2.array()).sum() / sum;
    missed += sample.weight(i) * std::pow(sample.leak_mm2(i) - mean, 2) * n / (n + 1.0);
  }
  return missed;
}

/// Weighted mean square of what the polynomial of the other draws misses of each.
double left_by_polynomial(const Sample& sample, const Eigen::MatrixXd& x) {
  const Eigen::Index n = x.rows();
  Eigen::MatrixXd design(n, terms_of(x.row(0)).size());
  for (Eigen::Index i = 0; i < n; ++i) design.row(i) = terms_of(x.row(i));
  const Eigen::MatrixXd weighed = sample.weight.asDiagonal() * design;
  const auto normal = (design.transpose() * weighed).ldlt();
  const Eigen::VectorXd fitted = design * normal.solve(weighed.transpose() * sample.leak_mm2);
  const Eigen::MatrixXd inverse = normal.solve(design.transpose());
  double missed = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double leverage = weighed.row(i).dot(inverse.col(i));
    missed += sample.weight(i) *
              std::pow((sample.leak_mm2(i) - fitted(i)) / std::max(1e-3, 1.0 - leverage), 2);
  }
  return missed;
}

}  // namespace

ShapeFigures shape_figures(const ValveMeasure& measure) {
  return {measure.tenting_height_mm, measure.tenting_area_mm2, measure.coaptation.height_mean_mm};
}

std::vector<InformationRow> information_rows(const std::vector<InformedDraw>& draws,
                                             double effective) {
  const Sample sample = sample_of(draws);
  const double variance = sample.draws.empty() ? 0.0 : sample.variance();
  std::vector<InformationRow> rows;
  std::mt19937_64 engine(1);
  for (const Measurement& measurement : measurements()) {
    const auto figures = static_cast<double>(measurement.figures.size());
    const double terms = 1.0 + figures + 0.5 * figures * (figures + 1.0);
    InformationRow row{measurement.name, std::numeric_limits<double>::quiet_NaN(),
                       std::numeric_limits<double>::quiet_NaN()};
    if (variance > 0.0 && effective >= kDrawsPerTerm * terms) {
      double by_weights = 0.0, by_polynomial = 0.0;
      for (int repeat = 0; repeat < kRepeats; ++repeat) {
        const std::vector<SeenDraws> seen = measured(sample, measurement, engine);
        by_weights += left_by_weights(sample, seen) / kRepeats;
        by_polynomial += left_by_polynomial(sample, standardised(sample, seen)) / kRepeats;
      }
      const double left = std::min(by_weights, by_polynomial);
      row.share_removed = std::clamp(1.0 - left / variance, 0.0, 1.0);
      row.remaining_mm2 = std::sqrt(variance * (1.0 - row.share_removed));
    }
    rows.push_back(std::move(row));
  }
  std::stable_sort(rows.begin(), rows.end(), [](const InformationRow& a, const InformationRow& b) {
    return std::isnan(b.share_removed) ? !std::isnan(a.share_removed)
                                       : a.share_removed > b.share_removed;
  });
  return rows;
}

}  // namespace coapt
