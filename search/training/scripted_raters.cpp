#include "search/training/scripted_raters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/closure/closure.h"
#include "search/random_share.h"

namespace coapt {
namespace {

constexpr int kNeighbours = 2;  // vertices of the free edge on either side of a middle
using SegmentPlaces = Eigen::Matrix<double, kSegments, 3>;

/// Mean places of the free edge around the middle of each segment.
SegmentPlaces edge_places(const FreeEdge& edge, const Points& at_mm) {
  SegmentPlaces places;
  for (std::size_t s = 0; s < kSegments; ++s) {
    // The nearest ones of the edge in the middle's own state are the same in every state of one mesh: by index.
    const auto middle =
        std::find(edge.vertices.begin(), edge.vertices.end(), edge.middle_vertex[s]);
    const auto at = middle - edge.vertices.begin();
    const auto count = std::ssize(edge.vertices);
    Vec3 sum = Vec3::Zero();
    for (int k = -kNeighbours; k <= kNeighbours; ++k)
      sum += at_mm.row(edge.vertices[static_cast<std::size_t>((at + k + count) % count)]);
    places.row(static_cast<Index>(s)) = sum.transpose() / (2 * kNeighbours + 1);
  }
  return places;
}

template <class Matrix>
double cosine(const Matrix& one, const Matrix& other) {
  const double lengths = one.norm() * other.norm();
  return lengths > 0.0 ? one.cwiseProduct(other).sum() / lengths : 0.0;
}

template <class Matrix>
std::size_t most_alike(const Matrix& seen, const std::array<Matrix, kChoices>& choices) {
  std::size_t best = 0;
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kChoices; ++i)
    if (const double alike = cosine(seen, choices[i]); alike > largest) {
      largest = alike;
      best = i;
    }
  return best;
}

template <class Matrix>
void blur(Matrix& seen, double error_mm, std::mt19937_64& engine) {
  for (Index i = 0; i < seen.rows(); ++i)
    for (Index k = 0; k < seen.cols(); ++k) seen(i, k) += error_mm * normal_share(engine);
}

}  // namespace

KnownValve known_valve(const Valve& valve) {
  KnownValve known{*free_edge(valve), flaccid_mm(valve), close_valve(valve).closed_mm, {}};
  known.heights_mm = pulled_heights_mm(valve, known.edge);
  return known;
}

std::size_t choose_by_looking(const ExamACase& made, const KnownValve& known, const Eyes& eyes,
                              std::mt19937_64& engine) {
  SegmentPlaces seen = edge_places(known.edge, made.choices[made.answer].flaccid_mm) -
                       edge_places(known.edge, known.flaccid_mm);
  blur(seen, eyes.error_mm, engine);
  std::array<SegmentPlaces, kChoices> closed;
  for (std::size_t i = 0; i < kChoices; ++i)
    closed[i] = edge_places(known.edge, made.choices[i].closed.closure.closed_mm) -
                edge_places(known.edge, known.closed_mm);
  return most_alike(seen, closed);
}

std::size_t choose_by_pulling(const ExamACase& made, const KnownValve& known, double error_mm,
                              std::mt19937_64& engine) {
  using Heights = Eigen::Matrix<double, kSegments, 1>;
  const SegmentHeights pulled =
      pulled_heights_mm(made.choices[made.answer].closed.valve, known.edge);
  Heights felt = Heights::Map(pulled.data()) - Heights::Map(known.heights_mm.data());
  blur(felt, error_mm, engine);
  std::array<Heights, kChoices> closed;
  for (std::size_t i = 0; i < kChoices; ++i)
    closed[i] = edge_places(known.edge, made.choices[i].closed.closure.closed_mm).col(2) -
                edge_places(known.edge, known.closed_mm).col(2);
  return most_alike(felt, closed);
}

std::array<Mobility, kSegments> judge_by_looking(const ExamBCase& made, const KnownValve& known,
                                                 const Eyes& eyes, std::mt19937_64& engine) {
  Eigen::Matrix<double, kSegments, 1> higher = edge_places(known.edge, made.flaccid_mm).col(2) -
                                               edge_places(known.edge, known.flaccid_mm).col(2);
  blur(higher, eyes.error_mm, engine);
  // A third of the segments each: the lowest, those between, the highest.
  std::array<std::size_t, kSegments> order{};
  for (std::size_t s = 0; s < kSegments; ++s) order[s] = s;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return higher[static_cast<Index>(a)] < higher[static_cast<Index>(b)];
  });
  std::array<Mobility, kSegments> judged{};
  for (std::size_t rank = 0; rank < kSegments; ++rank)
    judged[order[rank]] = static_cast<Mobility>(3 * rank / kSegments);
  return judged;
}

std::array<Mobility, kSegments> judge_by_pulling(const ExamBCase& made, double error_mm,
                                                 double limit_mm, std::mt19937_64& engine) {
  std::array<Mobility, kSegments> judged{};
  for (std::size_t s = 0; s < kSegments; ++s)
    judged[s] = mobility_of(
        made.truths[s].height_mm - made.truths[s].normal_mm + error_mm * normal_share(engine),
        limit_mm);
  return judged;
}

}  // namespace coapt
