// A valve from leaflet meshes, chordae and an annulus: the sheets are cut by half-planes through
// the annulus axis, which resamples them to a structured skirt and closes the commissures.
//
// Before, faults of the meshes are named and mended (sheet_repair.h), thick shells become sheets (mid_surface.h), the annulus
// is found where none was traced (find_annulus.h), and it is judged whether the leaflets were imaged closed (imaged_state.h).
//
// Assumed: sheets and annulus are star-shaped about that axis, sheets begin within 3 mm of the annulus,
// coordinates are right-handed, in one unit of length; any frame. The papillary tips orient the valve (import_frame.h). The imaged state is taken as unstressed, and its annulus
// and tips as those under pressure, unless those are given, too.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/closure/closure_options.h"
#include "core/valve/valve.h"
#include "io/mesh/mesh_file.h"

namespace coapt {

/// One straight piece of a tree that was traced.
struct ImportedSegment {
  int parent = -1;  ///< index into ImportedChorda::segments, smaller than its own; -1: the tip
  Vec3 end_mm = Vec3::Zero();
  bool inserts = true;                   ///< ends in the leaflet (else in a branch point)
  std::optional<double> rest_length_mm;  ///< none: as long as it is, times ImportOptions::slack
  double diameter_mm = 1.0;
};

/// A straight chorda as it was traced. Marginal means: at the free edge if it ends within 3 mm of
/// it; else it becomes a strut (anterior leaflet) or basal chorda.
struct ImportedChorda {
  std::string id;  ///< unique
  Side side = Side::Anterolateral;
  ChordaKind kind = ChordaKind::Marginal;  ///< no neochordae
  Vec3 insertion_mm = Vec3::Zero();
  Vec3 tip_mm = Vec3::Zero();
  std::optional<Vec3> pressed_tip_mm = {};  ///< under pressure; none: where it is
  /// Its tree, if that was traced: kept, with its insertions moved to the leaflet, instead of the branches that
  /// ImportOptions describes. insertion_mm is then the mean of where it inserts.
  std::vector<ImportedSegment> segments = {};
};

/// A papillary tip that was seen without its chordae.
struct ImportedTip {
  Side side = Side::Anterolateral;
  Vec3 position_mm = Vec3::Zero();
};

/// What lies on a side of the annulus that its name says: a chamber of the left heart or a papillary muscle.
enum class AnnulusSide { Atrium, Ventricle };
struct ImportedWitness {
  AnnulusSide side = AnnulusSide::Atrium;
  Vec3 position_mm = Vec3::Zero();  ///< its middle
};

/// A tie of an edge-to-edge repair, as long as the leaflets are thick.
struct ImportedTie {
  std::string id;  ///< unique
  Vec3 anterior_mm = Vec3::Zero(), posterior_mm = Vec3::Zero();
};

/// Places that a person saw, which otherwise are found: each moves to the annulus.
struct GivenLandmarks {
  std::optional<Vec3> anterolateral_commissure_mm = {}, posteromedial_commissure_mm = {};
  std::optional<Vec3> saddle_peak_mm = {}, mid_posterior_mm = {};
};

/// What the numbers of a source are.
enum class LengthUnit { Millimetre, Centimetre, Inch, Metre };
const char* to_string(LengthUnit unit);  ///< mm, cm, in, m

/// One thing that an import decided.
struct ImportDecision {
  std::string subject;      ///< "units", "frame", "mesh", ...
  std::string value;        ///< what was taken or made
  std::string reason;       ///< why, or by what rule; empty where that is the value itself
  bool look = false;        ///< a person should check it against the images
  double confidence = 1.0;  ///< 0 to 1, of what is judged from several readings; else 1
};

/// As the valve's provenance says it: "subject: value; reason".
std::string sentence(const ImportDecision& of);

/// Who says which sheet is the anterior one.
enum class LeafletClaim {
  Given,   ///< the user
  Named,   ///< names in or of the files
  Guessed  ///< nobody: the order of files, or label numbers
};

/// What two sheets are said to be: the first the anterior, the second the posterior leaflet.
struct LeafletOrder {
  LeafletClaim claim = LeafletClaim::Given;
  std::array<std::string, 2> called = {"the first mesh", "the second mesh"};
  std::array<std::string, 2> numbered =
      {};  ///< by what convention: of this order, of the other one; may be empty
  std::string swap = "give the meshes in the other order";  ///< how a user says the opposite
};

/// A label of a label map, or a part of one file of several, and what it was taken as.
struct SourcePart {
  int number = 1;         ///< as the user says it
  std::string part = {};  ///< "anterior", "posterior", "annulus"; empty: not used
};

/// What a source says of the directions of its axes in the patient.
enum class SourceAxes {
  Assumed,  ///< nothing, and its format has right-handed ones: LPS
  Stated,   ///< they are the patient's
  Unknown   ///< nothing, and they may be left-handed: those of voxels
};

inline constexpr Eigen::Index kMostFaces = 1'000'000;  ///< of a leaflet's mesh

struct ImportSource {
  std::string name;
  std::vector<std::string> provenance;
  std::vector<TriangleMesh>
      leaflets;  ///< the anterior, then the posterior one, or one skirt: sheets or thick shells
  LeafletOrder order = {};             ///< of two
  std::vector<SourcePart> parts = {};  ///< of labels or parts of a file, what they are said to be
  Points annulus_mm;                   ///< closed loop, n x 3, either direction; empty: found
  Points pressed_annulus_mm;  ///< where its points are under pressure, n x 3; empty: where they are
  /// Half the width of the label that the annulus is the middle line of, where the leaflets begin at that label's rim; else 0.
  double annulus_band_mm = 0.0;
  std::vector<ImportedChorda> chordae;
  std::vector<ImportedTip> tips;                ///< taken only where chordae are drawn
  std::vector<ImportedTie> ties = {};           ///< of leaflets that hang open
  std::vector<ImportedTip> sided = {};          ///< middles of parts whose names say their side
  std::vector<ImportedWitness> witnesses = {};  ///< labels that are no part of the valve
  SourceAxes axes = SourceAxes::Assumed;
  GivenLandmarks landmarks = {};
  std::vector<ImportDecision> decisions;  ///< that reading it took, before those of the import
  std::optional<Tissue> tissue;           ///< else thesis table 2.1, by ImportOptions::reference
  std::optional<double> pressure_kpa;     ///< else 16
  std::optional<LengthUnit> unit;         ///< that the files state; none: guessed
  /// What tables beside the leaflets state of themselves alone; none: as `unit`.
  std::optional<LengthUnit> chordae_unit = {}, tips_unit = {}, landmarks_unit = {};
};

struct ImportOptions {
  int triangles = 720;      ///< aimed at, [100, 100000]
  int branches = 3;         ///< insertions per marginal chorda, 1 to 5
  double branch_at = 0.75;  ///< share of the way from tip to insertion, [0.05, 0.95]
  double slack = 1.0;       ///< chordae lengths over straight distances, [0.8, 1.5]
  TissueReference reference = TissueReference::Excised;  ///< what the sheets are
  /// The sheets are the closed leaflets under pressure, of which the part in coaptation was not seen: the open ones are
  /// derived (hanging_profile.h). Two sheets, without chordae. None: judged from how much of the annulus they cover.
  std::optional<bool> closed = {};
  double hidden_mm = 3.0;  ///< height in coaptation, [0, 15]; of preset human-normal 2.7
  /// Of a source without chordae: they are drawn from anatomy (core/presets/synthetic_chordae.h), and the
  /// papillary tips, too, where there are none on both sides. Branches and slack are the draw's.
  std::optional<int> chordae_seed = {};
  std::optional<LengthUnit>
      units;  ///< of the source; none: guessed from the annulus's circumference, or from the leaflets
  /// Of the valve's tissue; none: that of Tissue, whatever thick leaflets measure, because segmentation thickens.
  std::optional<double> thickness_mm = {};
  bool thickness_measured = false;  ///< the mean of thick leaflets, instead of thickness_mm
  bool trust_labels = false;  ///< leaflets are what they are said to be, whatever they look like
  bool flip =
      false;  ///< the atrium is on the other side of the annulus than it looks; no tips may say it
  bool mirrored = false;  ///< the files show a mirror image: their x is turned round
  /// Of the closure that chordae are drawn by; `cancelled` is asked in all long loops and, once true, must stay so.
  ClosureBudget budget{};
};

/// Of a leaflet that came as a shell.
struct MeasuredThickness {
  std::size_t leaflet = 0;          ///< of ImportSource::leaflets
  std::vector<double> vertices_mm;  ///< at the vertices of its mid-surface
  double mean_mm = 0.0, p10_mm = 0.0, p90_mm = 0.0;
};

/// What was given, in millimetres and in the frame of the valve made of it.
struct ImportInput {
  std::vector<TriangleMesh> leaflets;
  Points annulus_mm;
  std::vector<ImportedChorda> chordae;
  std::vector<ImportedTip> tips;
  bool closed = false;  ///< the leaflets: the valve's hang open
};

struct ImportedValve {
  Valve valve;
  std::vector<ImportDecision> decisions;  ///< in the order of the provenance that they end
  ImportInput input;
  LengthUnit unit = LengthUnit::Millimetre;  ///< that the source's numbers were taken as
  std::vector<SourcePart> parts;             ///< ImportSource::parts as they were taken
  std::vector<MeasuredThickness> thickness;  ///< of leaflets that came as shells
};

/// A valve that passes validate(). Every change made is appended to its provenance. Errors point
/// into ImportSource ("/leaflets/0/faces") or ImportOptions ("/triangles"); Busy if it was cancelled. Its members are named after
/// millimetres, which they become once the units are known.
Expected<ImportedValve> import_with_decisions(ImportSource source, const ImportOptions& options);

/// The same without the list.
Expected<Valve> import_valve(ImportSource source, const ImportOptions& options);

}  // namespace coapt
