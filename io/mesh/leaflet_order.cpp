#include "io/mesh/leaflet_order.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/metrics/surface_tree.h"
#include "core/valve/contour.h"
#include "core/valve/number_text.h"
#include "core/valve/principal_axes.h"
#include "io/mesh/import_sheets.h"

namespace coapt {
namespace {

constexpr Eigen::Index kAnnulusArcs = 180;    // looked at along the annulus
constexpr Eigen::Index kMostVertices = 2000;  // of a sheet, whose height is looked at
constexpr double kAnteriorShare = 0.36, kShareDeviation = 0.07, kMostOfShare = 8.0;
constexpr double kHeightRatio = 0.4, kHeightDeviation = 0.35, kMostOfHeight = 2.0;
constexpr double kRise_mm = 1.5, kRiseDeviation_mm = 2.0, kMostOfRise = 1.5;
constexpr double kSure = 0.95;        // from here on nobody needs to look
constexpr double kContradicts = 0.4;  // below it a claim is doubted

/// Logarithm of the ratio of two normal distributions about `mean` and `other`.
double log_ratio(double value, double mean, double other, double deviation, double most) {
  const auto square = [](double x) { return x * x; };
  const double ratio = (square(value - other) - square(value - mean)) / (2.0 * square(deviation));
  return std::clamp(ratio, -most, most);
}

double tallest_mm(const TriangleMesh& sheet, const Points& annulus_mm) {
  const Eigen::Index stride = 1 + sheet.vertices_mm.rows() / kMostVertices;
  double height = 0.0;
  for (Eigen::Index v = 0; v < sheet.vertices_mm.rows(); v += stride)
    height = std::max(
        height, (annulus_mm.rowwise() - sheet.vertices_mm.row(v)).rowwise().norm().minCoeff());
  return height;
}

/// To the atrium: away from where the sheets hang. Zero where they lie in the annulus's plane.
Vec3 atrial_normal(const std::vector<TriangleMesh>& leaflets, const Points& annulus_mm) {
  const Eigen::RowVector3d centre = annulus_mm.colwise().mean();
  const Vec3 normal = principal_axes(annulus_mm.rowwise() - centre).col(0);
  double hanging_mm = 0.0;
  for (const TriangleMesh& sheet : leaflets)
    hanging_mm += 0.5 * normal.dot(Vec3((sheet.vertices_mm.colwise().mean() - centre)));
  if (std::abs(hanging_mm) < kLeastHanging_mm) return Vec3::Zero();
  return hanging_mm > 0.0 ? Vec3(-normal) : normal;
}

std::string sheet_words(const LeafletSigns& signs, std::size_t sheet) {
  return " has " + std::to_string(std::lround(100.0 * signs.share[sheet])) +
         " % of the annulus and is " + significant(signs.height_mm[sheet], 2) + " mm high";
}

std::string both_readings(const LeafletSigns& signs, const LeafletOrder& order, std::size_t first) {
  return order.called[first] + sheet_words(signs, first) + ", " + order.called[1 - first] +
         sheet_words(signs, 1 - first) + "; an anterior leaflet has 27 to 45 % of the annulus";
}

const char* words_of(LeafletClaim claim) {
  switch (claim) {
    case LeafletClaim::Given:
      return "as given";
    case LeafletClaim::Named:
      return "by name";
    case LeafletClaim::Guessed:
      return "by their shape";
  }
  return "";
}

}  // namespace

LeafletSigns leaflet_signs(const std::vector<TriangleMesh>& leaflets, const Points& annulus_mm) {
  const ArcLength arc(annulus_mm);
  LeafletSigns signs;
  Points line(kAnnulusArcs, 3);
  const SurfaceTree first(leaflets[0].vertices_mm, leaflets[0].faces),
      second(leaflets[1].vertices_mm, leaflets[1].faces);
  std::vector<std::size_t> nearest;
  for (Eigen::Index i = 0; i < kAnnulusArcs; ++i) {
    const Vec3 at =
        arc.at(arc.total_mm() * static_cast<double>(i) / static_cast<double>(kAnnulusArcs));
    line.row(i) = at;
    nearest.push_back(first.nearest(at).distance_mm <= second.nearest(at).distance_mm ? 0 : 1);
  }
  const Vec3 up = atrial_normal(leaflets, line);
  std::array<double, 2> level_mm = {0.0, 0.0};
  for (std::size_t sheet = 0; sheet < 2; ++sheet) {
    const auto count = std::count(nearest.begin(), nearest.end(), sheet);
    signs.share[sheet] = static_cast<double>(count) / static_cast<double>(kAnnulusArcs);
    signs.height_mm[sheet] = tallest_mm(leaflets[sheet], line);
    // The middle of the stretch: the point of it that is the farthest from the others.
    double away = -1.0;
    for (Eigen::Index i = 0; i < kAnnulusArcs; ++i) {
      if (nearest[static_cast<std::size_t>(i)] != sheet) continue;
      Eigen::Index steps = 0;
      while (2 * steps < kAnnulusArcs &&
             nearest[static_cast<std::size_t>((i + steps) % kAnnulusArcs)] == sheet &&
             nearest[static_cast<std::size_t>((i + kAnnulusArcs - steps) % kAnnulusArcs)] == sheet)
        ++steps;
      if (static_cast<double>(steps) <= away) continue;
      away = static_cast<double>(steps);
      level_mm[sheet] = up.dot(Vec3(line.row(i)));
    }
  }
  signs.rise_mm = level_mm[0] - level_mm[1];
  const double log_height =
      std::log(std::max(signs.height_mm[0], 0.1) / std::max(signs.height_mm[1], 0.1));
  const double sum =
      log_ratio(signs.share[0], kAnteriorShare, 1.0 - kAnteriorShare, kShareDeviation,
                kMostOfShare) +
      log_ratio(log_height, kHeightRatio, -kHeightRatio, kHeightDeviation, kMostOfHeight) +
      log_ratio(signs.rise_mm, kRise_mm, -kRise_mm, kRiseDeviation_mm, kMostOfRise);
  signs.first_is_anterior = 1.0 / (1.0 + std::exp(-sum));
  return signs;
}

Expected<SettledOrder> settle_leaflet_order(ImportSource& source, bool trust_labels) {
  SettledOrder settled;
  if (source.leaflets.size() != 2 || source.annulus_mm.rows() < 3 ||
      !source.annulus_mm.allFinite() || !is_sound(source.leaflets) ||
      !(ArcLength(source.annulus_mm).total_mm() > 0.0))
    return settled;
  const LeafletSigns signs = leaflet_signs(source.leaflets, source.annulus_mm);
  const LeafletOrder& order = source.order;
  const bool guessed = order.claim == LeafletClaim::Guessed;
  settled.swapped = guessed && !trust_labels && signs.first_is_anterior < 0.5;
  const std::size_t anterior = settled.swapped ? 1 : 0;
  const double confidence =
      settled.swapped ? 1.0 - signs.first_is_anterior : signs.first_is_anterior;
  const bool wrong = confidence < kContradicts;
  const std::string readings = both_readings(signs, order, anterior);
  if (!guessed && wrong && signs.share[0] >= kRefusedShare && !trust_labels)
    return Error{ErrorCode::BadGeometry, "/leaflets/0",
                 "is designated as the anterior leaflet but has the shape of the posterior one: " +
                     readings + "; " + order.swap +
                     ", or confirm the designation with --trust-labels"};
  settled.decisions.push_back(
      {"leaflets",
       order.called[anterior] + " is the anterior leaflet, " + order.called[1 - anterior] +
           " the posterior one",
       std::string(guessed && trust_labels ? "by their order" : words_of(order.claim)) +
           (order.numbered[anterior].empty() || wrong ? "" : ", " + order.numbered[anterior]) +
           (wrong ? ", contrary to their shape: " : ": ") + readings,
       wrong || (settled.swapped && !order.numbered[0].empty()) || (guessed && confidence < kSure),
       confidence});
  if (!settled.swapped) return settled;
  std::swap(source.leaflets[0], source.leaflets[1]);
  for (SourcePart& of : source.parts) {
    if (of.part == "anterior")
      of.part = "posterior";
    else if (of.part == "posterior")
      of.part = "anterior";
  }
  return settled;
}

}  // namespace coapt
