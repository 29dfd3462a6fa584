#include "core/valve/validate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numbers>
#include <set>
#include <string>
#include <utility>

#include "core/valve/validate_parts.h"

namespace coapt {
namespace {

// Wide enough for any tissue and for parameter studies, narrow enough to catch a wrong unit.
constexpr Range kPressureKpa = {0.0, 100.0};
constexpr Range kTakenShare = {0.0, 0.6};  // of a diastolic area or distance
constexpr Range kDensity = {1e-4, 1e-2};
constexpr Range kThicknessMm = {0.05, 10.0};
constexpr Range kModulusKpa = {0.01, 1e6};
constexpr Range kTransitionStrain = {0.0, 2.0};
constexpr Range kChordaeKpa = {1.0, 1e7};
constexpr Range kPrestretch = {1.0, 2.0};
constexpr Range kBendingNmm = {0.0, 10.0};
constexpr Range kPatientMm = {-10000.0, 10000.0};  // of images, from the scanner's own origin
constexpr Range kExponentialKpa = {0.0, 1e4};
constexpr Range kExponent = {0.01, 1000.0};
constexpr Index kMaxLeaflets = 10;
constexpr std::size_t kMaxHeads = 100;
// Pairs of a vertex and a face within contact of each other; more take minutes and gigabytes.
constexpr double kMaxContactPairs = 2e7;
constexpr double kContactReach = 1.3;     // in thicknesses
constexpr double kFibreTolerance = 1e-3;  // accepts four decimals in a file

void check_tissue(const Tissue& tissue, ProblemList& problems) {
  const std::string path = "/tissue/";
  const auto check = [&](const char* name, double number, Range range, const char* unit) {
    check_range(problems, path + name, number, range, unit);
  };
  check("density_g_per_mm3", tissue.density_g_per_mm3, kDensity, " g/mm3");
  check("thickness_mm", tissue.thickness_mm, kThicknessMm, " mm");
  check("circumferential_pre_kpa", tissue.circumferential_pre_kpa, kModulusKpa, " kPa");
  check("circumferential_post_kpa", tissue.circumferential_post_kpa, kModulusKpa, " kPa");
  check("circumferential_transition", tissue.circumferential_transition, kTransitionStrain, "");
  check("radial_pre_kpa", tissue.radial_pre_kpa, kModulusKpa, " kPa");
  check("radial_post_kpa", tissue.radial_post_kpa, kModulusKpa, " kPa");
  check("radial_transition", tissue.radial_transition, kTransitionStrain, "");
  check("chordae_kpa", tissue.chordae_kpa, kChordaeKpa, " kPa");
  check("circumferential_prestretch", tissue.circumferential_prestretch, kPrestretch, "");
  check("radial_prestretch", tissue.radial_prestretch, kPrestretch, "");
  check("bending_n_mm", tissue.bending_n_mm, kBendingNmm, " N mm");
}

/// A mesh may not be so fine that the thickness spans too many of its faces.
void check_contact(const Valve& valve, ProblemList& problems) {
  double area_mm2 = 0.0;
  for (int face = 0; face < valve.faces.rows(); ++face) {
    const Vec3 a = valve.rest_mm.row(valve.faces(face, 0));
    const Vec3 b = valve.rest_mm.row(valve.faces(face, 1));
    const Vec3 c = valve.rest_mm.row(valve.faces(face, 2));
    area_mm2 += 0.5 * (b - a).cross(c - a).norm();
  }
  const auto pairs =
      static_cast<double>(valve.rest_mm.rows()) * static_cast<double>(valve.faces.rows());
  const double most_mm =
      std::sqrt(kMaxContactPairs * area_mm2 / (std::numbers::pi * pairs)) / kContactReach;
  if (valve.tissue.thickness_mm > most_mm)
    problems.add(ErrorCode::OutOfRange, "/tissue/thickness_mm",
                 "is " + shown(valve.tissue.thickness_mm) + " mm, must be at most " +
                     shown(most_mm) +
                     " mm on a mesh as fine as this: more than 20,000,000 pairs would touch");
}

void check_below_annulus(const Vec3& point, const std::string& path, ProblemList& problems) {
  bool finite = true;
  for (int axis = 0; axis < 3; ++axis) {
    finite &= check_range(problems, at(path, axis), point[axis], kCoordinateMm, " mm");
  }
  if (finite && point.z() >= 0.0) {
    problems.add(ErrorCode::BadGeometry, path + "/2",
                 "is " + shown(point.z()) +
                     ", must be below 0: z points to the atrium, and the "
                     "papillary muscles lie on the other side of the annulus");
  }
}

// Both leaflets in three parts; without one of them nothing can be measured between the two.
void check_segments(const Valve& valve, ProblemList& problems) {
  std::string missing;
  for (const Segment segment :
       {Segment::A1, Segment::A2, Segment::A3, Segment::P1, Segment::P2, Segment::P3}) {
    const auto& all = valve.segments;
    if (std::find(all.begin(), all.end(), segment) == all.end())
      missing += std::string(" ") + to_string(segment);
  }
  if (missing.empty()) return;
  problems.add(ErrorCode::BadTopology, "/segments",
               "has no face of" + missing + "; each of A1, A2, A3, P1, P2, P3 must have one");
}

// Each with faces, and each face with a leaflet.
void check_leaflets(const Valve& valve, ProblemList& problems) {
  const auto count = std::ssize(valve.leaflets);
  if (count > kMaxLeaflets)
    problems.add(ErrorCode::OutOfRange, "/leaflets", "has more than 10 leaflets");
  std::set<std::string> names;
  for (Index i = 0; i < count; ++i) {
    const NamedLeaflet& leaflet = valve.leaflets[i];
    const std::string here = at("/leaflets", i);
    if (leaflet.name.empty() || !names.insert(leaflet.name).second)
      problems.add(ErrorCode::BadReference, here + "/name",
                   "is empty or repeats that of an earlier leaflet");
    check_range(problems, here + "/thickness_mm", leaflet.thickness_mm, kThicknessMm, " mm");
    check_range(problems, here + "/c0_kpa", leaflet.tissue.c0_kpa, kModulusKpa, " kPa");
    check_range(problems, here + "/c1_kpa", leaflet.tissue.c1_kpa, kExponentialKpa, " kPa");
    check_range(problems, here + "/c2", leaflet.tissue.c2, kExponent);
  }
  if (std::ssize(valve.face_leaflet) != valve.faces.rows()) {
    problems.add(ErrorCode::OutOfRange, "/face_leaflets",
                 "has " + std::to_string(valve.face_leaflet.size()) +
                     " entries, must have one for each of the " +
                     std::to_string(valve.faces.rows()) + " faces");
    return;
  }
  std::vector<bool> used(valve.leaflets.size(), false);
  for (Index f = 0; f < std::ssize(valve.face_leaflet); ++f) {
    const int leaflet = valve.face_leaflet[f];
    if (leaflet >= 0 && leaflet < count) {
      used[leaflet] = true;
      continue;
    }
    problems.add(ErrorCode::BadReference, at("/face_leaflets", f),
                 "is " + std::to_string(leaflet) + ", must be the index of a leaflet, 0 to " +
                     std::to_string(count - 1));
  }
  for (Index i = 0; i < count; ++i)
    if (!used[i]) problems.add(ErrorCode::BadTopology, at("/leaflets", i), "has no face");
}

void check_fibre(const Valve& valve, const MeshCheck& mesh, ProblemList& problems) {
  const auto faces = valve.faces.rows();
  const auto one_per_face = [&](const char* path, std::ptrdiff_t rows) {
    if (rows == faces) return true;
    problems.add(ErrorCode::OutOfRange, path,
                 "has " + std::to_string(rows) + " entries, must have one for each of the " +
                     std::to_string(faces) + " faces");
    return false;
  };
  if (faces == 0) return;
  if (!is_mitral(valve)) {
    check_leaflets(valve, problems);
  } else if (one_per_face("/segments", std::ssize(valve.segments))) {
    check_segments(valve, problems);
  }
  if (!one_per_face("/fibre", valve.fibre.rows())) return;
  for (int face = 0; face < faces; ++face) {
    const Vec3 fibre = valve.fibre.row(face);
    if (!(std::abs(fibre.norm() - 1.0) <= kFibreTolerance)) {
      problems.add(ErrorCode::OutOfRange, at("/fibre", face),
                   "has length " + shown(fibre.norm()) + ", must be 1 within 0.001");
      continue;
    }
    if (!mesh.vertices_usable || !mesh.faces_usable) continue;
    const Vec3 a = valve.rest_mm.row(valve.faces(face, 0));
    const Vec3 b = valve.rest_mm.row(valve.faces(face, 1));
    const Vec3 c = valve.rest_mm.row(valve.faces(face, 2));
    const double off_plane = std::abs(fibre.dot((b - a).cross(c - a).normalized()));
    if (!(off_plane <= kFibreTolerance)) {
      problems.add(
          ErrorCode::BadGeometry, at("/fibre", face),
          "leaves the plane of its face by " + shown(off_plane) + ", at most 0.001 is accepted");
    }
  }
}

void check_heads(const Valve& valve, ProblemList& problems) {
  const std::string path = "/papillary_heads";
  if (valve.heads.size() > kMaxHeads) {
    problems.add(ErrorCode::OutOfRange, path, "has more than 100 heads");
    return;
  }
  std::set<std::string> ids;
  bool anterolateral = false;
  bool posteromedial = false;
  for (std::size_t i = 0; i < valve.heads.size(); ++i) {
    const PapillaryHead& head = valve.heads[i];
    const std::string here = at(path, i);
    if (head.id.empty()) {
      problems.add(ErrorCode::OutOfRange, here + "/id", "is empty");
    } else if (!ids.insert(head.id).second) {
      problems.add(ErrorCode::BadReference, here + "/id", "repeats the id of an earlier head");
    }
    anterolateral |= head.side == Side::Anterolateral;
    posteromedial |= head.side == Side::Posteromedial;
    check_below_annulus(head.rest_mm, here + "/rest_mm", problems);
    check_below_annulus(head.tip_mm, here + "/tip_mm", problems);
  }
  if (is_mitral(valve) && (!anterolateral || !posteromedial)) {
    problems.add(ErrorCode::OutOfRange, path, "must hold at least one head of each side");
  }
}

/// A rotation, and an origin where images have their coordinates.
void check_patient(const Valve& valve, ProblemList& problems) {
  if (!valve.patient) return;
  constexpr double kRotation = 1e-6;
  const Eigen::Matrix3d& axes = valve.patient->axes;
  const double off = (axes * axes.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(off <= kRotation) || !(axes.determinant() > 0.0))
    problems.add(ErrorCode::BadGeometry, "/patient_frame",
                 "must turn without mirroring or scaling: the upper left 3 x 3 numbers a rotation "
                 "within 1e-6");
  for (int axis = 0; axis < 3; ++axis)
    check_range(problems, at(at("/patient_frame", axis), 3), valve.patient->origin_mm[axis],
                kPatientMm, " mm");
}

void check_drawn(const Valve& valve, ProblemList& problems) {
  if (valve.drawn_chordae)
    check_range(problems, "/drawn_chordae/seed", valve.drawn_chordae->seed, {0, 2147483647});
}

void check_observed(const Valve& valve, ProblemList& problems) {
  std::array<bool, kObservedFigures> taken{};
  for (const Observation& seen : valve.observed) {
    const ObservedRow& row = row_of(seen.figure);
    const std::string path = std::string("/observed/") + row.name,
                      unit = std::string(" ") + row.unit;
    check_range(problems, path + "/value", seen.value, {row.least, row.most}, unit.c_str());
    check_range(problems, path + "/sd", seen.sd, {row.least_sd, row.most_sd}, unit.c_str());
    if (std::exchange(taken[static_cast<std::size_t>(seen.figure)], true))
      problems.add(ErrorCode::BadReference, path, "is given twice, must be given once");
  }
}

}  // namespace

ProblemList problems_in(const Valve& valve) {
  ProblemList problems;
  check_range(problems, "/pressure_kpa", valve.pressure_kpa, kPressureKpa, " kPa");
  check_range(problems, "/systole/annular_contraction", valve.systole.annular_contraction,
              kTakenShare);
  check_range(problems, "/systole/tip_approach", valve.systole.tip_approach, kTakenShare);
  check_tissue(valve.tissue, problems);
  const MeshCheck mesh = check_mesh(valve, problems);
  if (mesh.surface) check_contact(valve, problems);
  check_fibre(valve, mesh, problems);
  check_annulus(valve, mesh, problems);
  check_heads(valve, problems);
  check_chordae(valve, problems);
  check_ties(valve, problems);
  check_patient(valve, problems);
  check_drawn(valve, problems);
  check_fitted(valve, problems);
  check_observed(valve, problems);
  return problems;
}

Errors validate(const Valve& valve) { return problems_in(valve).take(); }

}  // namespace coapt
