// What the kernels work on: plain arrays in blocks of sixteen lanes, laid out once per valve.
//
// Node numbers here are the kernels' own (relaxation_model.h has the permutation): free leaflet
// vertices, branch points, fixed nodes, each group padded to whole blocks. Only plain types: the
// kernels are compiled once per instruction set, and an inline function of a library that they
// shared with the rest of the program could be linked in the wrong flavour.
#pragma once

namespace coapt::kernels {

constexpr int kLanes = 16;

/// Blocks of sixteen that hold `count` things.
constexpr int blocks_for(unsigned long count) {
  return static_cast<int>((count + kLanes - 1) / kLanes);
}

template <class R>
struct alignas(64) Lane {
  R at[kLanes] = {};
};
struct alignas(64) IndexLane {
  int at[kLanes] = {};
};
/// x, y, z in mm and, where forces are summed, the stiffness that goes with them in N/mm.
template <class R>
struct alignas(4 * sizeof(R)) Quad {
  R at[4] = {};
};

/// One neighbour of each node of a block: the spring to it, and the face between it and the
/// neighbour before it.
template <class R>
struct FanSlot {
  IndexLane neighbour;     ///< the node itself where there is none
  Lane<R> rest_mm;         ///< rest length of the spring
  Lane<R> knee_mm;         ///< length where its stiffness changes
  Lane<R> pre_n_per_mm;    ///< stiffness below the knee
  Lane<R> extra_n_per_mm;  ///< what is added above
  Lane<R> load_mpa;        ///< a sixth of the pressure if that face exists, else 0
};

/// Sixteen nodes that move.
template <class R>
struct NodeBlock {
  Lane<R> free;  ///< 1, or 0 for padding
  Lane<R> velocity[3];
  Lane<R> stiffness;  ///< of the last step, N/mm
  int first_slot = 0, slots = 0;
};

/// A node's part of the end of a cable.
template <class R>
struct EndShare {
  int node = 0;
  R weight = 0;
};

/// Sixteen cables: each start is pulled towards the weighted mean of the nodes of its end.
template <class R>
struct CableBlock {
  IndexLane start;
  int first_share[kLanes + 1] = {};  ///< of the end of each; one more behind the last
  Lane<R> rest_mm;
  Lane<R> stiffness_n_per_mm;  ///< 0 for padding
};

/// Sixteen hinges (hinges.h has the symbols).
template <class R>
struct HingeBlock {
  IndexLane node[4];
  Lane<R> stiffness_n_mm;  ///< 0 for padding
  Lane<R> rest;            ///< t(a0)
  Lane<R> least_mm4;
};

/// Sixteen faces of the continuum membrane (continuum.h has the symbols).
template <class R>
struct SheetBlock {
  IndexLane node[3];
  Lane<R> along[2], across[2];  ///< f1 and f2 = first x (x1 - x0) + second x (x2 - x0)
  Lane<R> volume_mm3;           ///< 0 for padding
};

/// Sixteen faces of exponential tissue (exponential.h has the symbols).
template <class R>
struct ExponentialBlock {
  IndexLane node[3];
  Lane<R> along[2], across[2];  ///< as in SheetBlock
  Lane<R> volume_mm3;           ///< 0 for padding
  Lane<R> c0_mpa, c1_mpa, c2;
  Lane<R> steepest;  ///< I1 - 3 from where W' goes on along its tangent
};

template <class R>
struct SheetFibres {
  R straight = 1;
  R mpa = 0;
};

/// Their law.
template <class R>
struct SheetModuli {
  R along_mpa = 0, across_mpa = 0, coupling_mpa = 0, shear_mpa = 0;
  SheetFibres<R> along, across, diagonal;
};

/// Sixteen pairs that may touch: vertex and face, or edge and edge.
template <class R>
struct PairBlock {
  IndexLane node[4];
  Lane<R> thickness_mm;     ///< negative for padding
  Lane<R> force_n_per_mm2;  ///< contact force = this x (thickness - distance)^2
  Lane<R> per_margin_mm;    ///< 1 / margin of the pair
  R asleep_until = 0;       ///< no pair can touch before that share of the margins is used up
};

/// Sixteen features (vertices, edges or faces) next to each other on the leaflets.
template <class R>
struct Cluster {
  IndexLane node[3];  ///< vertices repeat their node, edges their second; padding repeats the last
  Lane<R> area_mm2;   ///< rest area that its contact pressure acts on
  Lane<R> low[3], high[3];  ///< boxes, mm
  Lane<R> margin_mm;        ///< of its nodes, at most
  Lane<R> plane[4];         ///< faces: unit normal and offset
  int count = 0;            ///< features that are not padding
};

/// Boxes of sixteen clusters.
template <class R>
struct ClusterBoxes {
  Lane<R> low[3], high[3], margin_mm;
};

/// A feature and the features of a cluster that are near it already at rest.
template <class R>
struct NearAtRest {
  int cluster = 0;       ///< of the others
  int lane = 0;          ///< of the feature in its own
  Lane<R> thickness_mm;  ///< of the pair; negative: they share a node, no contact
};

/// The features of one kind. Their number is 16 x cluster + lane.
template <class R>
struct Features {
  Cluster<R>* clusters = nullptr;
  ClusterBoxes<R>* boxes = nullptr;  ///< one per sixteen clusters
  int count = 0;                     ///< clusters
};

/// Which pairs of features are looked for: those nearer than their thickness and margin, which is
/// that of the faster of the two.
template <class R>
struct PairSearch {
  Features<R> first, second;
  bool faces = false;                   ///< vertices and faces, else edges with edges
  const int* near_begin = nullptr;      ///< [first cluster], one more at the end
  const NearAtRest<R>* near = nullptr;  ///< of each, in ascending order of other cluster, then lane
  R thickness_mm = 0, stiffness_n_per_mm4 = 0;
  const Quad<R>* listed = nullptr;  ///< positions and, as fourth, margin of all nodes
  int* near_clusters = nullptr;     ///< scratch, one per second cluster
};

template <class R>
struct SheetInput {
  const SheetBlock<R>* blocks = nullptr;
  int block_count = 0;
  SheetModuli<R> law;
  R lookahead_mm = 0;  ///< fibres that nodes could straighten by moving so far count as straight
  const Quad<R>* x = nullptr;
  Quad<R>* force = nullptr;  ///< added to
};

template <class R>
struct CableInput {
  const CableBlock<R>* blocks = nullptr;
  int block_count = 0;
  const EndShare<R>* shares = nullptr;
  const Quad<R>* x = nullptr;
  Quad<R>* force = nullptr;  ///< added to
};

template <class R>
struct HingeInput {
  const HingeBlock<R>* blocks = nullptr;
  int block_count = 0;
  const Quad<R>* x = nullptr;
  Quad<R>* force = nullptr;  ///< added to
};

template <class R>
struct ExponentialInput {
  const ExponentialBlock<R>* blocks = nullptr;
  int block_count = 0;
  R least_area_stretch2 = 0;  ///< kLeastAreaStretch2
  const Quad<R>* x = nullptr;
  Quad<R>* force = nullptr;  ///< added to
};

template <class R>
struct StepInput {
  const Quad<R>* x = nullptr;  ///< where all nodes are
  Quad<R>* next = nullptr;     ///< where the moving ones will be
  Quad<R>* force = nullptr;    ///< of contact, cables and sheets, N, with their stiffness; set to 0
  const Quad<R>* listed = nullptr;  ///< where nodes were when pairs were listed, and their margins
  NodeBlock<R>* blocks = nullptr;
  const FanSlot<R>* slots = nullptr;
  int block_count = 0;
  R keep = 0;             ///< share of the velocity that is kept
  R longest_move_mm = 0;  ///< of any node
  R mass_share = 0;       ///< mass = this x sum of stiffness
  R lookahead_mm = 0;     ///< a spring this near to its knee counts as stiff
};

struct StepSums {
  double force2_n2 = 0.0;  ///< sum over moving nodes
  double pressure2_n2 = 0.0;
  double longest_move2_mm2 = 0.0;
  // Largest squares of shares of a node's margin: of this step, of all since the pairs were listed.
  double step_share2 = 0.0, listed_share2 = 0.0;
};

/// The same functions for one instruction set. All give the same bits.
template <class R>
struct Kernels {
  StepSums (*advance)(const StepInput<R>&);
  void (*pull_cables)(const CableInput<R>&);
  void (*pull_sheets)(const SheetInput<R>&);
  void (*turn_hinges)(const HingeInput<R>&);
  /// `used`: share of the margins that nodes may have used up since the pairs were listed.
  void (*push_faces)(PairBlock<R>*, int blocks, R used, const Quad<R>* x, Quad<R>* force);
  void (*push_edges)(PairBlock<R>*, int blocks, R used, const Quad<R>* x, Quad<R>* force);
  void (*box)(const Features<R>&, bool planes, const Quad<R>* listed);
  /// Fills blocks as long as there is room; the number of blocks that are needed.
  int (*list_pairs)(const PairSearch<R>&, PairBlock<R>* blocks, int room);
  /// Numbers of the features of each pair, likewise.
  int (*number_pairs)(const PairSearch<R>&, int* first, int* second, int room);
  /// Pairs (f, g) of in.second, whose boxes meet and of which nodes of f that are not nodes of g
  /// lie on both sides of the plane of g, likewise. Nearer than the thickness to it is on both
  /// sides.
  int (*straddling_faces)(const PairSearch<R>&, int* first, int* second, int room);
  void (*pull_exponential)(const ExponentialInput<R>&);
  /// exp of sixteen numbers from 0 to 40, for tests.
  void (*exponentials)(const Lane<R>& from, Lane<R>& to);
};

}  // namespace coapt::kernels
