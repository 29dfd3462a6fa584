// What a verdict on a plan is worth: the same plans judged on the search's own mesh, on the refined one
// that its verdicts come from, and on a mesh of 5,200 triangles.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lab/verdicts/agreement.h"

namespace coapt {

struct VerdictStudyOptions {
  int plans = 20;  ///< random ones (drawn_plans.h) for each of the six valves, at most 50
  std::uint64_t seed = 1;
  int reference_triangles = 5200;
  /// Of the region of interest, for the order of plans on both meshes: a search takes 1,089; 1 is the
  /// plan as planned alone, so that orders differ by the mesh and nothing else.
  int nodes = 1;
  int threads = 0;  ///< 0: all cores
};

/// As planned. A closure that is not trusted is no competent one, and its leak is no number.
struct MeshVerdict {
  bool trusted = false;
  double leak_mm2 = 0.0;
  bool competent() const;
};

/// One plan on one valve. Places are those among the plans of that valve, from 1.
struct JudgedPlan {
  std::string valve;
  bool held_out = false;  ///< a valve by which neither model nor search was made
  int plan = 0;
  std::string ring;  ///< shape; empty: none
  int sutures = 0, neochordae = 0;
  MeshVerdict own, fine, reference;
  /// By the valve's own mesh alone, and with its finer closure as planned (0 without).
  int rank = 0, fine_rank = 0;
  int reference_rank = 0;  ///< as `coapt plan` would put them on the reference mesh
  double cost = 0.0, reference_cost = 0.0;
};

/// Six leaking valves: human-functional-mr, human-p2-prolapse, porcine-1 and, held out, human-normal and
/// two random anatomies; all but the first two 25 % dilated, with displaced tips. The reference mesh is the
/// valve made anew. The same for any number of threads. `progress`: meshes done and planned.
std::vector<JudgedPlan> study_verdicts(const VerdictStudyOptions& options,
                                       const std::function<void(int, int)>& progress = {});

/// Columns: valve, held_out, plan, ring, sutures, neochordae, own_trusted, own_leak_mm2, fine_trusted, fine_leak_mm2,
/// reference_trusted, reference_leak_mm2, rank, fine_rank, reference_rank, cost, reference_cost. Empty
/// where there is no number.
std::string verdicts_csv(const std::vector<JudgedPlan>& plans);

/// One way of ordering plans against one of the reference mesh; pairs of plans of the same valve.
struct OrderAgreement {
  std::string order, reference;
  std::string valves;  ///< "all", "held out"
  double tau = 0.0;
  double tau_apart = 0.0;  ///< leaks within 0.1 mm2 of each other count as tied; NaN for ranks
  double spearman = 0.0;   ///< mean over the valves
};

/// By leak as planned (own, fine) and by rank (rank, fine_rank), each against the leak and the rank on
/// the reference mesh.
std::vector<OrderAgreement> order_agreements(const std::vector<JudgedPlan>& plans);

struct VerdictAgreement {
  std::string mesh;    ///< "own", "fine"
  std::string valves;  ///< "all", "held out"
  VerdictCount count;
};
std::vector<VerdictAgreement> verdict_agreements(const std::vector<JudgedPlan>& plans);

}  // namespace coapt
