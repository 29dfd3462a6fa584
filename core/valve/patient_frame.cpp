#include "core/valve/patient_frame.h"

namespace coapt {

Points to_patient(const PatientFrame& frame, const Points& points_mm) {
  return (points_mm * frame.axes.transpose()).rowwise() + frame.origin_mm.transpose();
}

Vec3 to_patient(const PatientFrame& frame, const Vec3& point_mm) {
  return frame.axes * point_mm + frame.origin_mm;
}

Points from_patient(const PatientFrame& frame, const Points& points_mm) {
  return (points_mm.rowwise() - frame.origin_mm.transpose()) * frame.axes;
}

Valve in_patient_frame(Valve valve) {
  if (!valve.patient) return valve;
  const PatientFrame frame = *valve.patient;
  valve.rest_mm = to_patient(frame, valve.rest_mm);
  valve.annulus_mm = to_patient(frame, valve.annulus_mm);
  valve.fibre = (valve.fibre * frame.axes.transpose()).eval();
  for (PapillaryHead& head : valve.heads) {
    head.rest_mm = to_patient(frame, head.rest_mm);
    head.tip_mm = to_patient(frame, head.tip_mm);
  }
  for (Chorda& chorda : valve.chordae)
    for (ChordaSegment& segment : chorda.segments)
      if (!segment.inserts) segment.branch_point_mm = to_patient(frame, segment.branch_point_mm);
  valve.patient = PatientFrame{};
  return valve;
}

bool lies_in_patient_frame(const Valve& valve) {
  return valve.patient && valve.patient->axes.isIdentity(0.0) &&
         valve.patient->origin_mm.isZero(0.0);
}

}  // namespace coapt
