// Rigid motions and mirror images of a valve: what a repair must commute with.
#pragma once

#include <Eigen/Geometry>
#include <utility>

#include "core/valve/valve.h"

namespace coapt {

struct Motion {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Vec3 shift_mm = Vec3::Zero();
  Vec3 operator()(const Vec3& point) const { return turn * point + shift_mm; }
};

inline Points moved(const Points& points, const Motion& motion) {
  Points result = points;
  for (Eigen::Index i = 0; i < points.rows(); ++i) result.row(i) = motion(points.row(i));
  return result;
}

inline Valve moved(const Valve& valve, const Motion& motion) {
  Valve result = valve;
  result.rest_mm = moved(valve.rest_mm, motion);
  result.annulus_mm = moved(valve.annulus_mm, motion);
  result.fibre = moved(valve.fibre, {motion.turn, Vec3::Zero()});
  for (PapillaryHead& head : result.heads) {
    head.rest_mm = motion(head.rest_mm);
    head.tip_mm = motion(head.tip_mm);
  }
  for (Chorda& chorda : result.chordae)
    for (ChordaSegment& segment : chorda.segments)
      if (!segment.inserts) segment.branch_point_mm = motion(segment.branch_point_mm);
  return result;
}

/// Reflected in x = 0: sides swap, faces and annulus run the other way round.
inline Valve mirrored(const Valve& valve) {
  Valve result = moved(valve, {Vec3(-1.0, 1.0, 1.0).asDiagonal(), Vec3::Zero()});
  result.faces.col(1).swap(result.faces.col(2));
  result.annulus.assign(valve.annulus.rbegin(), valve.annulus.rend());
  result.annulus_mm = Points(result.annulus_mm.colwise().reverse());
  Landmarks& marks = result.landmarks;
  std::swap(marks.anterolateral_trigone, marks.posteromedial_trigone);
  std::swap(marks.anterolateral_commissure, marks.posteromedial_commissure);
  for (PapillaryHead& head : result.heads)
    head.side = head.side == Side::Anterolateral ? Side::Posteromedial : Side::Anterolateral;
  for (Chorda& chorda : result.chordae)
    for (ChordaSegment& segment : chorda.segments)
      std::swap(segment.insertion.weights[1], segment.insertion.weights[2]);
  return result;
}

}  // namespace coapt
