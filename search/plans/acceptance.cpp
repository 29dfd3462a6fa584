#include "search/plans/acceptance.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "search/plans/plan_order.h"
#include "search/random_share.h"

namespace coapt {
namespace {

constexpr int kResamples = 100;  // of each draw

}  // namespace

Acceptance acceptance_of(const PlanEvaluations& evaluations, const PlanRecord& plan, int nodes,
                         const FineClosures& fine, const ModelClosures& model) {
  const auto closed_finely = fine.plans.find(&plan);
  const bool finely = closed_finely != fine.plans.end() && trusted(closed_finely->second) &&
                      trusted(plan.closures.at(0));
  const double fine_change =
      finely ? closed_finely->second.leak_mm2 - plan.closures.at(0).leak_mm2 : 0.0;
  const int triangles =
      finely ? fine.mesh.triangles : static_cast<int>(evaluations.valve().faces.rows());
  const int draws = model.plans.contains(&plan) ? static_cast<int>(model.before.size()) : 0;
  const bool by_hand = !plan.plan.steps.empty();
  Acceptance mild = Acceptance::Zero(nodes, std::max(1, draws));
  for (int draw = 0; draw < mild.cols(); ++draw) {
    const DrawnChange change =
        draws > 0 ? change_in_draw(evaluations, plan, model, draw) : DrawnChange{};
    if (!change.trusted) continue;
    for (int node = 0; node < nodes; ++node)
      if (const PlanClosure& closure = plan.closures.at(by_hand ? node : 0); trusted(closure))
        mild(node, draw) =
            probability_mild(closure.leak_mm2 + fine_change + change.leak_mm2, triangles);
  }
  return mild;
}

double probability_ahead(const Acceptance& a, const Acceptance& b) {
  const auto nodes = static_cast<int>(a.rows());
  std::mt19937_64 engine(1);
  double ahead = 0.0;
  for (int resample = 0; resample < kResamples; ++resample) {
    Eigen::ArrayXi drawn(nodes);
    for (int& node : drawn)
      node = static_cast<int>(random_share(engine) * static_cast<double>(nodes));
    drawn(0) = 0;  // as planned, always
    for (int draw = 0; draw < a.cols(); ++draw) {
      const double mild_a = a(drawn, draw).mean(), mild_b = b(drawn, draw).mean();
      const bool a_is = mild_a >= kAcceptable, b_is = mild_b >= kAcceptable;
      ahead += a_is && b_is ? 0.5 : a_is || (!b_is && mild_a > mild_b) ? 1.0 : 0.0;
    }
  }
  return (ahead + 1.0) / (static_cast<double>(kResamples * a.cols()) + 2.0);
}

}  // namespace coapt
