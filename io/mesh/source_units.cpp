#include "io/mesh/source_units.h"

#include <Eigen/Geometry>

#include "core/valve/contour.h"
#include "core/valve/number_text.h"
#include "core/valve/problem_list.h"
#include "io/mesh/given_landmarks.h"

namespace coapt {
namespace {

constexpr double kMixed = 4.0;  // leaflets and tips lie within one diameter of the annulus
constexpr double kLongestInMetres = 0.5, kLongestInCentimetres = 15.0;  // of the leaflets' box

/// Diagonal of the box about the points.
double extent(const Points& points) {
  return (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
}

void check_extent(const std::string& path, const Points& part, double annulus_extent,
                  ProblemList& problems) {
  const double ratio = extent(part) / annulus_extent;
  if (ratio >= 1.0 / kMixed && ratio <= kMixed) return;
  problems.add(ErrorCode::BadGeometry, path,
               "spans " + significant(extent(part), 3) + " where the annulus spans " +
                   significant(annulus_extent, 3) +
                   "; must span 0.25 to 4 times as much: are the units mixed?");
}

}  // namespace

bool is_circumference_mm(double length) {
  return length >= kCircumferenceMm.min && length <= kCircumferenceMm.max;
}

double in_mm(LengthUnit unit) {
  if (unit == LengthUnit::Metre) return 1000.0;
  return unit == LengthUnit::Centimetre ? 10.0 : 1.0;
}

std::optional<LengthUnit> guessed_unit(const Points& annulus) {
  if (annulus.rows() < 3 || !annulus.allFinite()) return {};
  const double length = ArcLength(annulus).total_mm();
  const LengthUnit unit = length < 1.0    ? LengthUnit::Metre
                          : length < 20.0 ? LengthUnit::Centimetre
                                          : LengthUnit::Millimetre;
  if (!is_circumference_mm(in_mm(unit) * length)) return {};
  return unit;
}

LengthUnit unit_of(const ImportSource& source) {
  if (source.annulus_mm.rows() > 0)
    return guessed_unit(source.annulus_mm).value_or(LengthUnit::Millimetre);
  Eigen::AlignedBox3d box;
  for (const TriangleMesh& mesh : source.leaflets)
    if (mesh.vertices_mm.allFinite())
      for (const auto& vertex : mesh.vertices_mm.rowwise()) box.extend(vertex.transpose());
  if (box.isEmpty()) return LengthUnit::Millimetre;
  const double diagonal = box.diagonal().norm();
  return diagonal < kLongestInMetres        ? LengthUnit::Metre
         : diagonal < kLongestInCentimetres ? LengthUnit::Centimetre
                                            : LengthUnit::Millimetre;
}

void scale(ImportSource& source, double factor) {
  for (TriangleMesh& mesh : source.leaflets) mesh.vertices_mm *= factor;
  source.annulus_mm *= factor;
  source.pressed_annulus_mm *= factor;
  for (ImportedTip& tip : source.tips) tip.position_mm *= factor;
  for (ImportedTie& tie : source.ties) {
    tie.anterior_mm *= factor;
    tie.posterior_mm *= factor;
  }
  for_each_given(source.landmarks, [&](const Vec3& place) { return Vec3(factor * place); });
  for (ImportedChorda& chorda : source.chordae) {
    chorda.insertion_mm *= factor;
    chorda.tip_mm *= factor;
    if (chorda.pressed_tip_mm) *chorda.pressed_tip_mm *= factor;
    for (ImportedSegment& segment : chorda.segments) {
      segment.end_mm *= factor;
      if (segment.rest_length_mm) *segment.rest_length_mm *= factor;
    }
  }
}

Errors mixed_units(const ImportSource& source) {
  ProblemList problems;
  const double annulus_extent = extent(source.annulus_mm);
  for (std::size_t i = 0; i < source.leaflets.size(); ++i)
    check_extent("/leaflets/" + std::to_string(i) + "/vertices_mm", source.leaflets[i].vertices_mm,
                 annulus_extent, problems);
  Points chordae(2 * static_cast<Eigen::Index>(source.chordae.size()), 3);
  for (std::size_t i = 0; i < source.chordae.size(); ++i) {
    chordae.row(2 * static_cast<Eigen::Index>(i)) = source.chordae[i].insertion_mm;
    chordae.row(2 * static_cast<Eigen::Index>(i) + 1) = source.chordae[i].tip_mm;
  }
  if (chordae.rows() > 0) check_extent("/chordae", chordae, annulus_extent, problems);
  return std::move(problems).take();
}

}  // namespace coapt
