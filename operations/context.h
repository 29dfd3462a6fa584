// What an operation may spend, and who waits for its answer.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <limits>
#include <string>

#include "core/closed/closed_valve.h"
#include "core/metrics/shape_comparison.h"
#include "core/opened/opened_valve.h"

namespace coapt {

struct NamedFile;
struct SearchContext;
struct SearchOptions;
struct SearchResult;
struct ShapeFileOptions;

/// Of one request. There are no usual limits: whoever makes a Context says its own, or by name that there are none.
struct OperationLimits {
  static OperationLimits unlimited() { return {}; }

  int vertices = std::numeric_limits<int>::max();  ///< of a valve
  int chordae = std::numeric_limits<int>::max();   ///< of a valve
  double vertex_steps =
      std::numeric_limits<double>::infinity();               ///< steps times vertices of a closure
  double seconds = std::numeric_limits<double>::infinity();  ///< of computing
  int closures = std::numeric_limits<
      int>::max();  ///< of plans that are scored, of 650 triangles; fewer of larger valves
  std::ptrdiff_t voxels = std::numeric_limits<
      std::ptrdiff_t>::max();  ///< of the label maps of one answer, all together
  int threads = 0;             ///< 0: all cores. Does not change any answer

 private:
  OperationLimits() = default;
};

/// Closures of this valve, by OperationLimits::closures.
std::ptrdiff_t most_closures(const Valve& valve, const OperationLimits& limits);

/// Errors: a valve with more vertices or chordae; paths point into the valve.
Errors check_size(const Valve& valve, const OperationLimits& limits);

/// Closures and openings within the limits, as long as somebody waits. All that an operation computes goes by one of these, which
/// cannot be made without limits, so that none can be written that knows no budget.
struct Context {
  OperationLimits limits;
  /// A valve by the name that a request has in its place; empty: valves have no names here.
  std::function<Expected<Valve>(const std::string& name)> valve_named{};
  /// The closed surface in a file (operations/surface_file.h, or a process apart that does the same); empty: no file is read here.
  std::function<Expected<LeafletMesh>(const NamedFile&, const ShapeFileOptions&)> surface_of{};
  /// Whether nobody waits any more; empty: somebody does.
  std::function<bool()> abandoned{};
  /// Set: what goes on ends, and what there is by then is answered. May be null.
  const std::atomic<bool>* interrupted = nullptr;
  /// So many of so many are done; empty: nobody looks.
  std::function<void(int done, int planned)> progress{};
  /// How far a fit is from its surface before `progress` says so: rms in mm. Empty: nobody looks.
  std::function<void(double rms_mm)> distance{};
  /// What the answer is of, before it is given: for whoever draws it, too. Empty: nobody does.
  std::function<void(const ClosedValve&)> closed{};
  std::function<void(const OpenedValve&)> opened{};
  std::function<void(const Valve&, const SearchOptions&, const SearchResult&)> scored{};
  /// What a search of this valve is told beside its options: which closures are known, who looks. Empty: nothing.
  std::function<Errors(const Valve&, const SearchOptions&, SearchContext&)> searches{};

  std::chrono::steady_clock::time_point started = std::chrono::steady_clock::now();

  /// The time of the request begins now, not when this was made.
  void start() { started = std::chrono::steady_clock::now(); }

  /// Errors: refusal(), if the closure was not finished.
  Expected<ClosedValve> close(const Valve& valve, ClosureOptions options = {});
  /// Errors: open_valve()'s, or refusal().
  Expected<OpenedValve> open(const Valve& valve, OpeningOptions options = {});

  /// For what closes valves itself and ends without a result when it is spent: then with refusal(). Not to outlive this.
  ClosureBudget budget() const;
  /// Whether what has begun is to end, because its time is over or nobody waits; from then on. From many threads at once.
  bool cancelled() const;
  /// Busy where the request took too long, OutOfRange where a closure took too many steps.
  Error refusal() const;
};

}  // namespace coapt
