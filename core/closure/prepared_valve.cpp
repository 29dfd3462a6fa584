#include "core/closure/prepared_valve.h"

#include <algorithm>
#include <utility>

#include "core/closure/relaxation_settings.h"
#include "core/valve/leaflets.h"
#include "core/valve/ruptures.h"

namespace coapt {
namespace {

// Where both come fast, a scallop that no chorda holds is caught below the other leaflet and seems competent; slower it flips into the
// atrium, as in hearts. Of 200 varied flail valves 19 cross 1 mm2 at a quarter of the speed, of those closed at this one 1, for a quarter
// more steps (docs/experiments.md).
constexpr double kUnheldSpeed = 0.35;

double longest_move_of(const Valve& valve) {
  const bool unheld = is_mitral(valve) && !holds_all_scallops(valve);
  return (unheld ? kUnheldSpeed : 1.0) * RelaxationSettings{}.longest_move_mm;
}

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
      longest_move_mm_(longest_move_of(valve)),
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
