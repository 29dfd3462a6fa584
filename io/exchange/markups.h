// 3D Slicer's markups (.mrk.json, schema 1.0.3): named points, lines and closed curves.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/valve/types.h"

namespace coapt {

enum class MarkupType { Fiducial, Line, Curve, ClosedCurve };

struct Markup {
  MarkupType type = MarkupType::Fiducial;
  std::string name;
  std::vector<std::string> labels;  ///< one for each point
  Points points_mm;                 ///< n x 3, LPS: control points
  bool straight = false;            ///< a curve that leads straight from each to the next
};

/// A closed curve as Slicer draws it: a periodic cubic spline through its control points, by their number. Of 60 points or more the
/// points themselves, which lose less than 0.05 % of its length. Errors without a path: fewer than 6 placed points.
Expected<Points> drawn_closed_curve(const Markup& curve);

enum class MarkupAxes { Valve, Patient };

/// In coordinate system LPS, all points "defined". The document says whose axes these are.
/// @param doubt doubt_about() the closure that they are of
std::string write_markups(const std::vector<Markup>& markups, MarkupAxes axes = MarkupAxes::Valve,
                          const std::string& doubt = "");

/// Markups of these types with the points that are defined, in LPS; others are passed over. Errors are JSON
/// pointers: no markups, unknown coordinate system, units other than millimetres, numbers beyond 1e5.
Expected<std::vector<Markup>> read_markups(std::string_view text);

const char* to_string(MarkupType type);

}  // namespace coapt
