// The valve: an unstressed skirt of triangles, the annulus and papillary tips under pressure, and
// the chordae as branching trees.
//
// Frame of reference (everywhere in coapt, millimetres, right-handed): origin at the annulus
// centroid, x to the posteromedial commissure, y anterior (to the saddle peak), z to the atrium.
// Seen from the atrium (looking along -z) anterior is up, the anterolateral side is left. Dilation
// and rings move the annulus, not the frame: its centroid may lie up to 15 mm from the origin.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/valve/leaflets.h"
#include "core/valve/observed.h"
#include "core/valve/types.h"

namespace coapt {

enum class Segment { A1, A2, A3, P1, P2, P3, AC, PC };  ///< AC, PC: the two commissures
enum class Leaflet { Anterior, Posterior };
enum class Side { Anterolateral, Posteromedial };
enum class ChordaKind { Marginal, Strut, Basal, Neochorda };

/// The shape that transition strains are counted from. Excised: free of stress, as the thesis's
/// table 2.1. InVivo: as the leaflet hangs in the unpressurised heart, already stretched, so that
/// less is left until the transition.
enum class TissueReference { Excised, InVivo };

/// Thesis table 2.1. The density there is misprinted as kg/mm3; 1060 kg/m3 is meant.
struct Tissue {
  double density_g_per_mm3 = 1.06e-3;
  double thickness_mm = 1.0;
  double circumferential_pre_kpa = 11.0;     ///< modulus below the transition strain
  double circumferential_post_kpa = 2300.0;  ///< modulus above it
  double circumferential_transition = 0.13;  ///< strain
  double radial_pre_kpa = 3.3;
  double radial_post_kpa = 760.0;
  double radial_transition = 0.33;
  /// Of Valve::rest_mm. InVivo: the law is entered at the prestretches below.
  TissueReference reference = TissueReference::Excised;
  /// Length in the unpressurised heart over the excised one. The defaults leave 5 % along and 12 %
  /// across the fibres of the transition strains: what ovine anterior leaflets reach at the peak of
  /// systole (5.0 and 7.8 %, PMC3111015) and a little more.
  double circumferential_prestretch = 1.13 / 1.05;
  double radial_prestretch = 1.33 / 1.12;
  /// Flexural rigidity D = E t^3 / (12 (1 - nu^2)). Porcine aortic cusps in flexure: 0.017 to 0.07 at
  /// 1 mm (Merryman 2006, J Biomech 39:88); no source for mitral leaflets. 0: a membrane, whose folds
  /// depend on the mesh.
  double bending_n_mm = 0.03;
  double chordae_kpa = 40000.0;

  bool operator==(const Tissue&) const = default;
};

/// Vertex indices, all of them on the annulus loop.
struct Landmarks {
  int anterolateral_trigone = 0;
  int posteromedial_trigone = 0;
  int saddle_peak = 0;
  int mid_posterior = 0;
  int anterolateral_commissure = 0;
  int posteromedial_commissure = 0;
};

/// A head of a papillary muscle, where chordae start.
struct PapillaryHead {
  std::string id;  ///< unique, for instance "AL1"
  Side side = Side::Anterolateral;
  Vec3 rest_mm = Vec3::Zero();  ///< in the unpressurised valve
  Vec3 tip_mm = Vec3::Zero();   ///< under pressure; fixed during closure
};

/// A point of the leaflet surface: barycentric weights (>= 0, sum 1) on the vertices of one face.
struct Insertion {
  int face = 0;
  std::array<double, 3> weights = {1.0, 0.0, 0.0};

  bool operator==(const Insertion&) const = default;
};

/// One straight piece of a chorda. It starts at the papillary head (parent -1) or at the branch
/// point that ends segment `parent`, and ends in the leaflet or in a branch point.
struct ChordaSegment {
  int parent = -1;  ///< index into Chorda::segments, always smaller than its own
  double rest_length_mm = 0.0;
  double diameter_mm = 1.0;
  /// Of the disc of the leaflet that it pulls at, if it inserts (insertion_zone.h). Chordae of
  /// parametric valves stand for several: together they hold the share of the leaflet that is
  /// counted in a human valve (docs/researcher/model.md).
  double zone_mm = 2.0;
  double modulus_kpa = 0.0;             ///< 0: Tissue::chordae_kpa
  bool inserts = false;                 ///< ends in the leaflet (else in a branch point)
  Insertion insertion;                  ///< where, if it inserts
  Vec3 branch_point_mm = Vec3::Zero();  ///< the branch point in the unpressurised valve, if not

  bool operator==(const ChordaSegment&) const = default;
};

/// A tree of segments from one papillary head to one or more insertions. Carries tension only.
struct Chorda {
  std::string id;  ///< unique, for instance "AL1-P2-marginal-1"
  ChordaKind kind = ChordaKind::Marginal;
  int head = 0;           ///< index into Valve::heads
  bool ruptured = false;  ///< carries nothing
  std::vector<ChordaSegment> segments;

  bool operator==(const Chorda&) const = default;
};

/// A suture or clip that holds two points of the leaflets together: tension only, at discs of radius `zone_mm` of either.
struct Tie {
  std::string id;  ///< unique
  Insertion anterior, posterior;
  double rest_length_mm = 1.0;
  double zone_mm = 1.3;             ///< as a neochorda's (docs/researcher/model.md)
  double stiffness_n_per_mm = 5.0;  ///< assumed: stiff enough to give 0.2 mm at 1 N

  bool operator==(const Tie&) const = default;
};

/// What systole does to annulus and papillary tips, whose places under pressure a valve has: core/opened/diastole.h goes back
/// to diastole. Defaults: health.
struct SystolicMotion {
  /// Share of the annulus's diastolic area that contraction takes away, [0, 0.6]. 9.7 % in 18 controls of the source that the
  /// annuli of degenerative valves are from, too (Cardiovasc Ultrasound 2016, s12947-016-0073-4). A ring holds the annulus: 0.
  double annular_contraction = 0.10;
  /// Share of the tips' diastolic distance from each other, [0, 0.6]. Assumed to be that of the ventricle's diameter, on whose
  /// wall the muscles stand: 0.25 to 0.43 in health (fractional shortening, ASE 2005).
  double tip_approach = 0.30;

  bool operator==(const SystolicMotion&) const = default;
};

/// Where a valve's own frame lies in the images of the patient (LPS, mm): a point is at axes x + origin.
struct PatientFrame {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< a rotation
  Vec3 origin_mm = Vec3::Zero();

  bool operator==(const PatientFrame&) const = default;
};

/// Chordae that nobody has seen (core/presets/synthetic_chordae.h).
struct DrawnChordae {
  int seed = 0;             ///< [0, 2147483647]; 0: the mean anatomy
  bool tips_given = false;  ///< the papillary tips were seen; else they are drawn, too

  bool operator==(const DrawnChordae&) const = default;
};

/// What a fit to a closed surface left uncertain (search/fit/fitted_draw.h).
struct FittedValues {
  std::vector<std::string> parameters;  ///< unique names, as fit_parameters() gives them
  /// Of what may be added to each: mm or 1; of a slack or the stiffness, to a factor of 1 on lengths or moduli as they are.
  Eigen::MatrixXd covariance;
};

/// Face normals (counter-clockwise winding) point to the atrial surface of the leaflets, and each
/// annulus edge appears in its face in the direction of the annulus loop.
struct Valve {
  std::string name;
  std::vector<std::string> provenance;  ///< sources, licences and every change, in order
  Points rest_mm;                       ///< |V| x 3, unstressed shape
  Faces faces;                          ///< |F| x 3, vertex indices
  std::vector<Segment> segments;        ///< |F|; empty if `leaflets` is not
  /// Of a valve that is not mitral; it has neither segments nor landmarks, and Tissue::thickness_mm
  /// is the distance of mid-surfaces at which its leaflets touch.
  std::vector<NamedLeaflet> leaflets;
  std::vector<int> face_leaflet;  ///< |F| into `leaflets`, or empty
  Points fibre;                   ///< |F| x 3, unit circumferential direction in the face's plane
  /// |A| vertices, a boundary loop, counter-clockwise seen from the atrium.
  std::vector<int> annulus;
  Points annulus_mm;  ///< |A| x 3, where the annulus sits under pressure
  Landmarks landmarks;
  std::vector<PapillaryHead> heads;
  std::vector<Chorda> chordae;
  std::vector<Tie> ties;  ///< of a mitral valve
  Tissue tissue;
  double pressure_kpa = 16.0;                 ///< transvalvular, peak systolic (120 mmHg)
  SystolicMotion systole;                     ///< of a mitral valve
  std::optional<DrawnChordae> drawn_chordae;  ///< none: they were seen, or belong to the model
  std::optional<FittedValues> fitted;         ///< none: it was not fitted, or exactly
  std::vector<Observation> observed;          ///< of its closed state; at most one of a figure
  std::optional<PatientFrame> patient;  ///< none: it was not made from images, or nobody knows
};

/// Along and across the fibres, of Valve::rest_mm over its shape free of stress; 1 if that is given.
std::array<double, 2> prestretch(const Tissue& tissue);

const char* to_string(TissueReference reference);
const char* to_string(Segment segment);
const char* to_string(Leaflet leaflet);
const char* to_string(Side side);
const char* to_string(ChordaKind kind);

/// Mean position under pressure of the heads of one side.
Vec3 papillary_tip_mm(const Valve& valve, Side side);

/// Position of an insertion on `points` (|V| x 3).
Vec3 position(const Insertion& insertion, const Faces& faces, const Points& points);

/// Position under pressure of annulus vertex `vertex` (an index into Valve::rest_mm).
/// @pre the vertex is on the annulus.
Vec3 annulus_position_mm(const Valve& valve, int vertex);

}  // namespace coapt
