#include "io/exchange/placed_valve.h"

#include "core/valve/patient_frame.h"

namespace coapt {

ClosedValve in_patient_frame(const ClosedValve& closed) {
  if (!closed.valve.patient) return closed;
  const PatientFrame frame = *closed.valve.patient;
  const auto place = [&frame](auto& points_mm) { points_mm = to_patient(frame, points_mm); };
  ClosedValve placed = closed;
  placed.valve = in_patient_frame(closed.valve);
  place(placed.closure.closed_mm);
  for (Points& sample_mm : placed.closure.samples_mm) place(sample_mm);
  for (Points& state_mm : placed.closure.motion_mm) place(state_mm);
  for (Points& ends_mm : placed.closure.branch_points_mm) place(ends_mm);
  for (LeakOpening& opening : placed.measure.leak.openings) {
    place(opening.centroid_mm);
    place(opening.surface.points_mm);
    opening.normal = frame.axes * opening.normal;
  }
  for (CoaptationSection& section : placed.measure.coaptation.sections)
    for (Vec3& nearest_mm : section.nearest_mm) place(nearest_mm);
  if (placed.repair.annulus_before_mm.rows() > 0) place(placed.repair.annulus_before_mm);
  for (SutureMark& suture : placed.repair.sutures) {
    place(suture.tip_before_mm);
    place(suture.tip_mm);
    place(suture.anchor_mm);
  }
  return placed;
}

}  // namespace coapt
