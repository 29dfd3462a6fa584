#include "core/closure/prepared_valve.h"

#include <algorithm>
#include <utility>

namespace coapt {
namespace {

ContactLaw contact_law(const Valve& valve, const ClosureOptions& options) {
  const double thickness = valve.tissue.thickness_mm;
  return {thickness, options.contact_pressure_mpa / (thickness * thickness), false,
          options.self_contact};
}

template <class Matrix>
bool same_numbers(const Matrix& a, const Matrix& b) {
  return a.rows() == b.rows() && a == b;
}

bool same_heads(const std::vector<PapillaryHead>& a, const std::vector<PapillaryHead>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const PapillaryHead& p, const PapillaryHead& q) {
                      return p.rest_mm == q.rest_mm && p.side == q.side;
                    });
}

ClosureModel loaded(ClosureModel model, std::vector<double> load_share) {
  model.load_share = std::move(load_share);
  return model;
}

}  // namespace

PreparedValve::PreparedValve(const Valve& valve, const ClosureOptions& options,
                             std::vector<double> load_share)
    : valve_(valve),
      membrane_(options.membrane),
      contact_(contact_law(valve, options)),
      model_(loaded(make_closure_model(valve, options.membrane), std::move(load_share))),
      layout_(lay_out<float>(model_, contact_, kernels::best_instruction_set())) {}

bool PreparedValve::serves(const Valve& valve, const ClosureOptions& options) const {
  return membrane_ == options.membrane && contact_ == contact_law(valve, options) &&
         same_numbers(valve_.rest_mm, valve.rest_mm) && same_numbers(valve_.faces, valve.faces) &&
         same_numbers(valve_.fibre, valve.fibre) && valve_.segments == valve.segments &&
         valve_.leaflets == valve.leaflets && valve_.face_leaflet == valve.face_leaflet &&
         valve_.annulus == valve.annulus && same_heads(valve_.heads, valve.heads) &&
         valve_.chordae == valve.chordae && valve_.ties == valve.ties &&
         valve_.tissue == valve.tissue && valve_.pressure_kpa == valve.pressure_kpa;
}

ClosureModel PreparedValve::model(const Valve& valve) const {
  ClosureModel model = model_;
  set_targets(valve, model);
  return model;
}

}  // namespace coapt
