#include "core/repair/edge_to_edge.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/repair/limits.h"
#include "core/valve/annulus_frame.h"
#include "core/valve/leaflet_point.h"
#include "core/valve/remodel.h"

namespace coapt {
namespace {

/// How far `along` changes over a millimetre of the leaflet's free edge.
double along_per_mm(const Valve& valve, const LeafletCoordinates& coordinates, Leaflet leaflet,
                    double along) {
  constexpr double kStep = 0.02;
  const Vec3 before = rest_position_mm(valve, coordinates, {leaflet, along - kStep, 1.0}),
             after = rest_position_mm(valve, coordinates, {leaflet, along + kStep, 1.0});
  return 2.0 * kStep / (after - before).norm();
}

/// Share of the leaflet's height that the clip's arms reach up from the edge.
double grasp_share(const Valve& valve, const LeafletCoordinates& coordinates, Leaflet leaflet,
                   const EdgeToEdge& clip) {
  constexpr double kMostGrasp = 0.8;
  const double height_mm = (rest_position_mm(valve, coordinates, {leaflet, clip.along, 1.0}) -
                            rest_position_mm(valve, coordinates, {leaflet, clip.along, 0.0}))
                               .norm();
  return std::min(kMostGrasp, clip.grasp_mm / height_mm);
}

/// Places on the posterior free edge after each `step_mm` along it, `count` of them.
std::vector<Insertion> along_edge(const Valve& valve, const LeafletCoordinates& coordinates,
                                  double along, double onwards, double step_mm, int count) {
  constexpr double kStep = 0.002;
  const auto at = [&](double place) {
    return rest_position_mm(valve, coordinates, {Leaflet::Posterior, place, 1.0});
  };
  std::vector<Insertion> places;
  Vec3 last = at(along);
  double walked_mm = 0.0;
  for (int i = 1; i <= count; ++i) {
    while (walked_mm < step_mm * i && along > kStep && along < 1.0 - kStep) {
      along += onwards * kStep;
      const Vec3 next = at(along);
      walked_mm += (next - last).norm();
      last = next;
    }
    places.push_back(locate(valve, coordinates, {Leaflet::Posterior, along, 1.0}));
  }
  return places;
}

int next_number(const Valve& valve) {
  int number = 1;
  while (std::any_of(valve.ties.begin(), valve.ties.end(), [&](const Tie& tie) {
    return tie.id.starts_with("edge-to-edge-" + std::to_string(number) + '-');
  }))
    ++number;
  return number;
}

}  // namespace

bool check_edge_to_edge(const EdgeToEdge& step, const std::string& path, ProblemList& problems) {
  bool possible = check_range(problems, path + "/along", step.along, kEdgeAlong);
  const auto check = [&](const char* name, double number, Range range, const char* unit) {
    possible = check_range(problems, path + name, number, range, unit) && possible;
  };
  check("/width_mm", step.width_mm, kEdgeWidthMm, " mm");
  if (step.device != EdgeDevice::Clip) return possible;
  check("/grasp_mm", step.grasp_mm, kGraspMm, " mm");
  check("/rows", step.rows, kClipRows, "");
  check("/annulus_drawn_in_percent", step.annulus_drawn_in_percent, kDrawnInPercent, " %");
  return possible;
}

std::string text_key(const EdgeToEdge& step) {
  char numbers[160];
  std::snprintf(numbers, sizeof numbers, " %.17g %.17g %.17g %d %.17g", step.along, step.width_mm,
                step.grasp_mm, step.rows, step.annulus_drawn_in_percent);
  return to_string(step.device) + std::string(numbers);
}

void draw_annulus_in(const RepairPlan& plan, Valve& valve) {
  double percent = 0.0;
  for (const RepairStep& step : plan.steps) {
    if (std::holds_alternative<Annuloplasty>(step)) return;
    const auto* edges = std::get_if<EdgeToEdge>(&step);
    if (edges != nullptr && edges->device == EdgeDevice::Clip)
      percent = std::max(percent, edges->annulus_drawn_in_percent);
  }
  if (percent > 0.0) grow_annulus(-0.01 * percent * ap_diameter_mm(valve), valve);
}

EdgeToEdge commissural_closure(const Valve& valve, const LeafletCoordinates& coordinates, Side side,
                               double width_mm) {
  const bool first = side == Side::Anterolateral;
  const double beside = first ? kEdgeAlong.min : kEdgeAlong.max;
  const double half = 0.5 * width_mm *
                      std::max(along_per_mm(valve, coordinates, Leaflet::Anterior, beside),
                               along_per_mm(valve, coordinates, Leaflet::Posterior, beside));
  return {EdgeDevice::Stitch, std::clamp(first ? half : 1.0 - half, kEdgeAlong.min, kEdgeAlong.max),
          width_mm};
}

void apply_edge_to_edge(const EdgeToEdge& step, const LeafletCoordinates& coordinates,
                        Valve& valve) {
  const std::string id = "edge-to-edge-" + std::to_string(next_number(valve)) + '-';
  const auto tie = [&](int number, const Insertion& anterior, const Insertion& posterior) {
    Tie made;
    made.id = id + std::to_string(number);
    made.anterior = anterior;
    made.posterior = posterior;
    made.rest_length_mm = valve.tissue.thickness_mm;
    valve.ties.push_back(std::move(made));
  };
  if (step.device == EdgeDevice::CleftSuture) {
    const int ties = std::max(1, static_cast<int>(std::lround(step.width_mm / kTieSpacing_mm)));
    const auto edge = [&](double onwards) {
      return along_edge(valve, coordinates, step.along, onwards, step.width_mm / ties, ties);
    };
    const std::vector<Insertion> before = edge(-1.0), after = edge(1.0);
    for (int i = 0; i < ties; ++i) tie(i + 1, before[i], after[i]);
    return;
  }
  const int count = 1 + static_cast<int>(std::lround(step.width_mm / kTieSpacing_mm));
  const int rows = step.device == EdgeDevice::Clip ? step.rows : 1;
  const auto insertion = [&](Leaflet leaflet, double off_mm, int row) {
    const double along =
        step.along + off_mm * along_per_mm(valve, coordinates, leaflet, step.along);
    const double up =
        row == 0 ? 0.0 : row * grasp_share(valve, coordinates, leaflet, step) / (rows - 1);
    return locate(valve, coordinates, {leaflet, std::clamp(along, 0.0, 1.0), 1.0 - up});
  };
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < count; ++i) {
      const double off_mm = step.width_mm * (static_cast<double>(i) / (count - 1) - 0.5);
      tie(row * count + i + 1, insertion(Leaflet::Anterior, off_mm, row),
          insertion(Leaflet::Posterior, off_mm, row));
    }
}

}  // namespace coapt
