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
/// Where sixteen things lie in their array: offsets in bytes.
struct alignas(64) IndexLane {
  int at[kLanes] = {};
};
/// x, y, z in mm; of forces N and the stiffness that goes with them in N/mm.
template <class R>
struct alignas(4 * sizeof(R)) Quad {
  R at[4] = {};
};

/// Of a node's quad.
template <class R>
constexpr int offset_of(int node) {
  return node * static_cast<int>(sizeof(Quad<R>));
}

/// One spring of each node of a block.
template <class R>
struct SpringSlot {
  IndexLane neighbour;     ///< the node itself where there is none
  Lane<R> rest_mm;         ///< rest length of the spring
  Lane<R> knee_mm;         ///< length where its stiffness changes
  Lane<R> pre_n_per_mm;    ///< stiffness below the knee
  Lane<R> extra_n_per_mm;  ///< what is added above
};

/// Sixteen nodes that move.
template <class R>
struct NodeBlock {
  Lane<R> free;  ///< 1, or 0 for padding
  Lane<R> velocity[3];
  Lane<R> stiffness;                  ///< of the last step, N/mm
  int first_corner = 0, corners = 0;  ///< of the faces around: IndexLanes of their quads
  int first_spring = 0, springs = 0;
};

/// A node's part of the end of a cable.
template <class R>
struct EndShare {
  int node = 0;  ///< offset
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
  Lane<R> least_mm4[2];    ///< of both faces
};

/// What sixteen hinges do to their faces.
template <class R>
struct HingePulls {
  Lane<R> moment_n_mm;
  Lane<R> stiffness_n;  ///< times the size of a node's gradient: half a row sum
};
/// Of a hinge's moment.
template <class R>
constexpr int pull_offset_of(int hinge) {
  return hinge / kLanes * static_cast<int>(sizeof(HingePulls<R>)) +
         hinge % kLanes * static_cast<int>(sizeof(R));
}

/// Sixteen faces.
template <class R>
struct FaceBlock {
  IndexLane node[3];
  IndexLane hinge
      [3];  ///< at the edges 01, 12 and 20: pull_offset_of(); of one at rest where there is none
  Lane<R> least_mm4;  ///< of the squared cross product of two sides, for bending
  Lane<R> load_mpa;   ///< a sixth of the pressure; 0 for padding
  // Of a membrane of triangles: f1 and f2 = first x (x1 - x0) + second x (x2 - x0).
  Lane<R> along[2], across[2];
  Lane<R> volume_mm3;  ///< 0 for padding
};

/// Exponential tissue of sixteen faces (exponential.h has the symbols).
template <class R>
struct ExponentialLane {
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
  R squeezed_mpa = 0, squeezed_area = 0, least_area2 = 0;
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
  Lane<R> low[3], high[3];                        ///< boxes, mm
  Lane<R> margin_mm;                              ///< of its nodes, at most
  Lane<R> reach_low[3], reach_high[3], reach_mm;  ///< boxes with thickness and margin, and these
  Lane<R> corner[3][3];                           ///< faces: [node][x, y, z], mm
  Lane<R> plane[4];                               ///< faces: unit normal and offset
  R least_margin_mm = 0;
  int count = 0;  ///< features that are not padding
};

/// One feature as the lanes of its cluster have it.
template <class R>
struct alignas(16) Feature {
  int node[3] = {};
  R area_mm2 = 0;  ///< rest area that its contact pressure acts on
};

/// Boxes of sixteen clusters.
template <class R>
struct ClusterBoxes {
  Lane<R> low[3], high[3], margin_mm;
};

/// Pairs are packed into blocks by their room to move, so that whole blocks touch or sleep.
constexpr int kPairBins = 4;

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
  const Feature<R>* each = nullptr;  ///< by number
  int count = 0;                     ///< clusters
};

/// Where pairs are kept until they are packed into blocks: `room` of each, a multiple of sixteen.
template <class R>
struct PairBuffer {
  int *first = nullptr, *second = nullptr;  ///< numbers of the features
  R *thickness_mm = nullptr, *margin_mm = nullptr;
  int* binned[kPairBins] = {};  ///< which pairs, by their room to move
  int room = 0;
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
  PairBuffer<R> buffer;             ///< of list_pairs
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
  HingePulls<R>* pulls = nullptr;  ///< [block]
};

/// What holds a face against stretching, besides springs.
enum class FaceLaw { None, Continuum, Exponential };

template <class R>
struct FaceInput {
  const FaceBlock<R>* blocks = nullptr;
  int block_count = 0;
  FaceLaw law = FaceLaw::None;
  SheetModuli<R> continuum;
  R lookahead_mm = 0;  ///< fibres that nodes could straighten by moving so far count as straight
  const ExponentialLane<R>* exponential = nullptr;
  R least_area_stretch2 = 0;  ///< kLeastAreaStretch2 of exponential.h
  const HingePulls<R>* hinges = nullptr;
  const Quad<R>* x = nullptr;
  /// Force on each corner: [block][corner][lane], and one that stays 0 behind them.
  Quad<R>* corners = nullptr;
};

template <class R>
struct StepInput {
  const Quad<R>* x = nullptr;        ///< where all nodes are
  Quad<R>* next = nullptr;           ///< where the moving ones will be
  Quad<R>* force = nullptr;          ///< of contact and cables, N, with their stiffness; set to 0
  const Quad<R>* corners = nullptr;  ///< of faces, see FaceInput
  const Quad<R>* listed = nullptr;   ///< where nodes were when pairs were listed, and their margins
  NodeBlock<R>* blocks = nullptr;
  Quad<R>* sums = nullptr;  ///< null, or where all force on each moving node and its stiffness go
  const IndexLane* corner_slots = nullptr;
  const SpringSlot<R>* spring_slots = nullptr;
  int block_count = 0;
  R keep = 0;             ///< share of the velocity that is kept
  R longest_move_mm = 0;  ///< of any node
  R mass_share = 0;       ///< mass = this x sum of stiffness; infinite: forces move nothing
  R lookahead_mm = 0;     ///< a spring this near to its knee counts as stiff
};

struct StepSums {
  double force2_n2 = 0.0;  ///< sum over moving nodes
  double longest_move2_mm2 = 0.0;
  // Largest squares of shares of a node's margin: of this step, of all since the pairs were listed.
  double step_share2 = 0.0, listed_share2 = 0.0;
};

/// The same functions for one instruction set. All give the same bits.
template <class R>
struct Kernels {
  StepSums (*advance)(const StepInput<R>&);
  void (*pull_cables)(const CableInput<R>&);
  void (*turn_hinges)(const HingeInput<R>&);
  void (*pull_faces)(const FaceInput<R>&);
  /// `used`: share of the margins that nodes may have used up since the pairs were listed.
  void (*push_faces)(PairBlock<R>*, int blocks, R used, const Quad<R>* x, Quad<R>* force);
  void (*push_edges)(PairBlock<R>*, int blocks, R used, const Quad<R>* x, Quad<R>* force);
  /// `thickness`: of the pairs that are looked for, mm.
  void (*box)(const Features<R>&, bool planes, R thickness, const Quad<R>* listed);
  /// Fills blocks as long as there is room; the number of blocks that are needed, or -1 - the room that the
  /// buffer needs if it is too small.
  int (*list_pairs)(const PairSearch<R>&, PairBlock<R>* blocks, int room);
  /// Numbers of the features of each pair, likewise.
  int (*number_pairs)(const PairSearch<R>&, int* first, int* second, int room);
  /// Pairs (f, g) of in.second, each once, whose boxes meet and of which nodes of either that are
  /// not nodes of the other lie on both sides of the other's plane, likewise. Nearer than the
  /// thickness to it is on both sides.
  int (*straddling_faces)(const PairSearch<R>&, int* first, int* second, int room);
  /// exp of sixteen numbers from 0 to 40, for tests.
  void (*exponentials)(const Lane<R>& from, Lane<R>& to);
};

}  // namespace coapt::kernels
