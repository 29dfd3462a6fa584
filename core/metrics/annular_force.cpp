#include "core/metrics/annular_force.h"

#include <algorithm>
#include <cmath>

#include "core/closure/model.h"
#include "core/metrics/annulus.h"

namespace coapt {
namespace {

/// Where the model's nodes are when the valve is closed; knots of ties where the ties' ends let them be.
Points closed_nodes(const Valve& valve, const ClosureModel& model, const ClosureResult& closure) {
  Points x = model.target_mm;
  x.topRows(model.vertices) = closure.closed_mm;
  int node = model.vertices;
  for (std::size_t c = 0; c < valve.chordae.size(); ++c)
    for (std::size_t s = 0; s < valve.chordae[c].segments.size(); ++s)
      if (!valve.chordae[c].segments[s].inserts)
        x.row(node++) = closure.branch_points_mm[c].row(static_cast<Index>(s));
  for (std::size_t t = 0; t < valve.ties.size(); ++t) x.row(node + static_cast<Index>(t)).setZero();
  for (const Cable& cable : model.cables)
    if (cable.chorda < 0) x.row(cable.start) += 0.5 * end_position(cable, x).transpose();
  return x;
}

}  // namespace

SupportForces support_forces(const Valve& valve, const ClosureResult& closure) {
  const ClosureModel model = make_closure_model(valve, closure.membrane);
  const Points x = closed_nodes(valve, model, closure);
  Points pressure = Points::Zero(x.rows(), 3);
  add_pressure_forces(model, x, pressure);
  Points force = pressure;
  add_elastic_forces(model, x, force);
  SupportForces forces;
  for (const int vertex : valve.annulus) forces.annulus_n.emplace_back(force.row(vertex));
  forces.papillary_n = force.bottomRows(std::ssize(valve.heads)).colwise().sum();
  forces.pressure_n = pressure.colwise().sum();
  return forces;
}

std::vector<Vec3> suture_pulls_n(const Valve& valve, const std::vector<Vec3>& annulus_n,
                                 int count) {
  const std::size_t size = valve.annulus.size();
  const auto peak = static_cast<std::size_t>(
      std::find(valve.annulus.begin(), valve.annulus.end(), valve.landmarks.saddle_peak) -
      valve.annulus.begin());
  std::vector<double> arc_mm = {0.0};  // at each vertex from the saddle peak on, then the total
  for (std::size_t k = 0; k < size; ++k) {
    const std::size_t i = (peak + k) % size, j = (i + 1) % size;
    const Vec3 step =
        valve.annulus_mm.row(static_cast<Index>(j)) - valve.annulus_mm.row(static_cast<Index>(i));
    arc_mm.push_back(arc_mm.back() + step.norm());
  }
  std::vector<Vec3> pulls_n(static_cast<std::size_t>(count), Vec3::Zero());
  for (std::size_t k = 0; k < size; ++k) {
    // Between two sutures a vertex is borne by both, the nearer one more.
    const double place = count * arc_mm[k] / arc_mm.back();
    const auto before = static_cast<std::size_t>(place) % pulls_n.size();
    const double share = place - std::floor(place);
    const Vec3& pull = annulus_n[(peak + k) % size];
    pulls_n[before] += (1.0 - share) * pull;
    pulls_n[(before + 1) % pulls_n.size()] += share * pull;
  }
  return pulls_n;
}

SutureLoad suture_load(const Valve& valve, const ClosureResult& closure, int count) {
  const Vec3 normal = annulus_frame(valve, AnnulusAxis::Commissures).normal;
  SutureLoad load;
  for (const Vec3& pull : suture_pulls_n(valve, support_forces(valve, closure).annulus_n, count)) {
    load.max_n = std::max(load.max_n, pull.norm());
    load.mean_n += pull.norm() / count;
    load.out_of_plane_n = std::max(load.out_of_plane_n, std::abs(pull.dot(normal)));
  }
  return load;
}

}  // namespace coapt
