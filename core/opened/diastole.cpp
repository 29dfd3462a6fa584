#include "core/opened/diastole.h"

#include <cmath>

#include "core/valve/annulus_frame.h"
#include "core/valve/validate.h"

namespace coapt {

Expected<Valve> in_diastole(const Valve& valve) {
  Valve open = valve;
  const AnnulusFrame frame = annulus_frame(valve, AnnulusAxis::SaddlePeak);
  const double wider = 1.0 / std::sqrt(1.0 - valve.systole.annular_contraction);
  for (auto vertex : open.annulus_mm.rowwise()) {
    Vec3 place = into_frame(frame, vertex);
    place.head<2>() *= wider;
    vertex = out_of_frame(frame, place).transpose();
  }
  const Vec3 apart =
      papillary_tip_mm(valve, Side::Posteromedial) - papillary_tip_mm(valve, Side::Anterolateral);
  const Vec3 way = 0.5 * (1.0 / (1.0 - valve.systole.tip_approach) - 1.0) * apart;
  for (PapillaryHead& head : open.heads)
    head.tip_mm += head.side == Side::Posteromedial ? way : -way;
  if (Errors errors = validate(open); !errors.empty()) return errors;
  return open;
}

}  // namespace coapt
