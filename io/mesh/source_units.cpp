#include "io/mesh/source_units.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cctype>

#include "core/valve/contour.h"
#include "core/valve/number_text.h"
#include "core/valve/problem_list.h"
#include "io/mesh/given_landmarks.h"

namespace coapt {
namespace {

constexpr double kMixed = 4.0;  // leaflets and tips lie within one diameter of the annulus
// Where no unit makes a usual length of it.
constexpr double kLongestInMetres = 0.5, kLongestInCentimetres = 20.0;
constexpr Range kUsualExtentMm = {30.0, 110.0};  // of the leaflets' box
constexpr Range kPossibleExtentMm = {10.0, 350.0};
constexpr Range kAlike = {0.5, 2.0};  // leaflets' over annulus's extent; 1.0 to 1.2 in presets
constexpr std::array kUnits = {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Inch,
                               LengthUnit::Metre};

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
                   "; must span 0.25 to 4 times as much, so check for mixed units");
}

}  // namespace

bool is_circumference_mm(double length) {
  return length >= kCircumferenceMm.min && length <= kCircumferenceMm.max;
}

double in_mm(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::Millimetre:
      return 1.0;
    case LengthUnit::Centimetre:
      return 10.0;
    case LengthUnit::Inch:
      return 25.4;
    case LengthUnit::Metre:
      return 1000.0;
  }
  return 1.0;
}

std::optional<LengthUnit> unit_named(std::string_view name) {
  constexpr std::array<std::array<std::string_view, 3>, 4> kWords = {
      {{"mm", "millimetre", "millimeter"},
       {"cm", "centimetre", "centimeter"},
       {"in", "inch", "inche"},
       {"m", "metre", "meter"}}};
  std::string plain;
  for (const unsigned char letter : name) plain += static_cast<char>(std::tolower(letter));
  const std::string_view one =
      std::string_view(plain).substr(0, plain.size() - (plain.ends_with('s') ? 1 : 0));
  for (std::size_t i = 0; i < kWords.size(); ++i)
    if (std::find(kWords[i].begin(), kWords[i].end(), one) != kWords[i].end()) return kUnits[i];
  return {};
}

namespace {

/// The unit in which a length is one that is usual, and whether no other is.
UnitReading unit_reading(double length, const Range& usual, const std::string& what) {
  std::vector<LengthUnit> fitting;
  for (const LengthUnit unit : kUnits)
    if (const double mm = in_mm(unit) * length; mm >= usual.min && mm <= usual.max)
      fitting.push_back(unit);
  UnitReading found;
  if (!fitting.empty())
    found.unit = fitting[0];
  else
    found.unit = length < kLongestInMetres        ? LengthUnit::Metre
                 : length < kLongestInCentimetres ? LengthUnit::Centimetre
                                                  : LengthUnit::Millimetre;
  found.reason = "by " + what;
  // Hardly any imaging program writes inches.
  found.look = fitting.size() != 1 || found.unit == LengthUnit::Inch;
  if (!found.look) return found;
  const auto in = [&](LengthUnit unit) {
    return significant(in_mm(unit) * length, 3) + " mm if in " + to_string(unit);
  };
  found.reason += ", " + in(found.unit);
  for (const LengthUnit other : kUnits)
    if (const double mm = in_mm(other) * length;
        other != found.unit && mm >= 0.3 * usual.min && mm <= 2.0 * usual.max)
      found.reason += ", " + in(other);
  found.reason += "; use --units to change it";
  found.confidence = fitting.empty() ? 0.5 : 0.8;
  return found;
}

/// Diagonal of the box about all leaflets; 0 without any.
double leaflets_extent(const ImportSource& source) {
  Eigen::AlignedBox3d box;
  for (const TriangleMesh& mesh : source.leaflets)
    if (mesh.vertices_mm.allFinite())
      for (const auto& vertex : mesh.vertices_mm.rowwise()) box.extend(vertex.transpose());
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

}  // namespace

UnitReading unit_of(const ImportSource& source) {
  if (source.unit) return {*source.unit, "stated in the files", false, 1.0};
  if (source.annulus_mm.rows() > 0) {
    if (source.annulus_mm.rows() < 3 || !source.annulus_mm.allFinite()) return {};
    return unit_reading(ArcLength(source.annulus_mm).total_mm(), kUsualCircumferenceMm,
                        "the annulus's circumference");
  }
  const double size = leaflets_extent(source);
  if (!(size > 0.0)) return {};
  return unit_reading(size, kUsualExtentMm, "the leaflets' size");
}

void take_annulus_unit(ImportSource& source, LengthUnit unit) {
  ProblemList apart;
  if (!source.unit && source.annulus_mm.rows() > 0)
    check_extent("", source.annulus_mm, leaflets_extent(source), apart);
  if (!source.unit && apart.empty())
    source.unit = unit;
  else
    source.annulus_mm *= in_mm(unit);
}

Errors impossible_size(const ImportSource& source, LengthUnit unit) {
  const double size_mm = in_mm(unit) * leaflets_extent(source);
  if (source.annulus_mm.rows() > 0 || !(size_mm > 0.0) ||
      (size_mm >= kPossibleExtentMm.min && size_mm <= kPossibleExtentMm.max))
    return {};
  return {{ErrorCode::BadGeometry, "/leaflets",
           "span " + significant(size_mm, 3) + " mm if in " + to_string(unit) +
               ", must span 10 to 350 mm; check the scale (--units)"}};
}

namespace {

void stretch(Vec3& point, const Vec3& factors) { point = factors.cwiseProduct(point); }

void stretch(GivenLandmarks& landmarks, const Vec3& factors) {
  for_each_given(landmarks, [&](const Vec3& place) { return Vec3(factors.cwiseProduct(place)); });
}

void stretch(ImportedChorda& chorda, const Vec3& factors) {
  stretch(chorda.insertion_mm, factors);
  stretch(chorda.tip_mm, factors);
  if (chorda.pressed_tip_mm) stretch(*chorda.pressed_tip_mm, factors);
  for (ImportedSegment& segment : chorda.segments) stretch(segment.end_mm, factors);
}

/// Every coordinate, axis by axis.
void stretch(ImportSource& source, const Vec3& factors) {
  const auto points = [&](Points& of) { of *= factors.asDiagonal(); };
  for (TriangleMesh& mesh : source.leaflets) points(mesh.vertices_mm);
  points(source.annulus_mm);
  points(source.pressed_annulus_mm);
  source.annulus_band_mm *= std::abs(factors.z());
  for (ImportedTip& tip : source.tips) stretch(tip.position_mm, factors);
  for (ImportedTip& place : source.sided) stretch(place.position_mm, factors);
  for (ImportedWitness& place : source.witnesses) stretch(place.position_mm, factors);
  for (ImportedTie& tie : source.ties) {
    stretch(tie.anterior_mm, factors);
    stretch(tie.posterior_mm, factors);
  }
  stretch(source.landmarks, factors);
  for (ImportedChorda& chorda : source.chordae) stretch(chorda, factors);
}

}  // namespace

void scale(ImportSource& source, double factor) {
  stretch(source, Vec3::Constant(factor));
  for (ImportedChorda& chorda : source.chordae)
    for (ImportedSegment& segment : chorda.segments)
      if (segment.rest_length_mm) *segment.rest_length_mm *= factor;
}

void take_metres(ImportSource& source) {
  const double annulus = source.annulus_mm.rows() > 0 ? extent(source.annulus_mm) : 0.0;
  if (source.leaflets.empty() || !(annulus > 0.0)) return;
  const UnitReading read = unit_of(source);
  const double factor = in_mm(LengthUnit::Metre) / in_mm(read.unit);
  const double ratio = factor * leaflets_extent(source) / annulus;
  if (read.unit == LengthUnit::Metre || !(ratio >= kAlike.min && ratio <= kAlike.max)) return;
  for (TriangleMesh& mesh : source.leaflets) mesh.vertices_mm *= factor;
  for (ImportedTip& place : source.sided) place.position_mm *= factor;
  source.decisions.push_back(
      {"units", std::string("leaflets in m, converted to ") + to_string(read.unit),
       "glTF is in metres by its specification, and only then do the leaflets match the size of "
       "the annulus"});
}

std::vector<ImportDecision> take_part_units(ImportSource& source, LengthUnit unit) {
  std::vector<ImportDecision> decisions;
  const auto take = [&](const char* part, const std::optional<LengthUnit>& stated,
                        const auto& stretch_part) {
    if (!stated || *stated == unit) return;
    stretch_part(Vec3::Constant(in_mm(*stated) / in_mm(unit)));
    decisions.push_back(
        {"units",
         std::string(part) + " in " + to_string(*stated) + ", converted to " + to_string(unit),
         "stated by the names of the columns"});
  };
  take("chordae", source.chordae_unit, [&](const Vec3& factors) {
    for (ImportedChorda& chorda : source.chordae) stretch(chorda, factors);
  });
  take("papillary tips", source.tips_unit, [&](const Vec3& factors) {
    for (ImportedTip& tip : source.tips) stretch(tip.position_mm, factors);
  });
  take("landmarks", source.landmarks_unit,
       [&](const Vec3& factors) { stretch(source.landmarks, factors); });
  return decisions;
}

void unmirror(ImportSource& source) {
  stretch(source, {-1.0, 1.0, 1.0});
  for (TriangleMesh& mesh : source.leaflets) mesh.faces.col(1).swap(mesh.faces.col(2));
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
