// The module for browsers that searches, too: alone, or as one of several workers that run the same search, each of which makes
// some items of each loop (search/parallel.h) and takes what closing and opening the others yields from whoever made it. What is
// taken is known by all that it depends on, so that an answer has the bits that it has with one worker, whoever leaves or lags.
#include <atomic>
#include <cstring>

#include "clients/engine/engine.h"
#include "clients/engine/shared_closures.h"
#include "io/json/progress_json.h"
#include "operations/plan_operations.h"
#include "search/plans/plan_search.h"

// Of whoever runs the module.
extern "C" {
/// Tells how far a search is: JSON, UTF-8.
[[clang::import_module("coapt"), clang::import_name("progress")]] void coapt_progress(
    const char* text, std::size_t size);
/// Whether the search is to end with what it has.
[[clang::import_module("coapt"), clang::import_name("ended")]] int coapt_ended();
/// How many workers run the same search.
[[clang::import_module("coapt"), clang::import_name("workers")]] int coapt_workers();
/// Looks up what was kept under a key of 16 bytes; returns its size, or -1.
[[clang::import_module("coapt"), clang::import_name("find")]] std::ptrdiff_t coapt_find(
    const void* key);
/// Copies what was found last.
[[clang::import_module("coapt"), clang::import_name("take_found")]] void coapt_take_found(
    void* into);
[[clang::import_module("coapt"), clang::import_name("keep")]] void coapt_keep(const void* key,
                                                                              const void* bytes,
                                                                              std::size_t size);
}

namespace coapt {
namespace {

std::atomic<bool> ended = false;

std::optional<std::string> found(const ClosureKey& key) {
  const std::ptrdiff_t size = coapt_find(key.data());
  if (size < 0) return std::nullopt;
  std::string bytes(static_cast<std::size_t>(size), '\0');
  coapt_take_found(bytes.data());
  return bytes;
}

void look() {
  if (coapt_ended() != 0) ended = true;
}

ClosedPlan closed_as(const Valve& valve, std::string_view bytes) {
  auto closure = std::make_shared<const ClosureResult>(closure_from(bytes));
  const Evaluation evaluation{closure->status, closure->crossing,
                              measure(valve, *closure, LeakBy::Estimate)};
  return {evaluation, std::move(closure)};
}

Evaluator evaluator(const ClosureOptions& options, bool is_shared) {
  return [options, is_shared, close = closing_evaluator(options)](const Valve& valve,
                                                                  const ClosureResult* neighbour) {
    look();
    if (!is_shared) return close(valve, neighbour);
    const ClosureKey key = closure_key(valve, options, neighbour);
    if (const std::optional<std::string> bytes = found(key)) return closed_as(valve, *bytes);
    ClosedPlan closed = close(valve, neighbour);
    const std::string bytes = bytes_of(*closed.closure);
    coapt_keep(key.data(), bytes.data(), bytes.size());
    return closed;
  };
}

PlanOpening shared_opening(const Valve& valve) {
  static_assert(std::is_trivially_copyable_v<PlanOpening>);
  const ClosureKey key = opening_key(valve);
  PlanOpening opening;
  if (const std::optional<std::string> bytes = found(key)) {
    std::memcpy(&opening, bytes->data(), sizeof opening);
  } else {
    opening = open_plan(valve);
    coapt_keep(key.data(), &opening, sizeof opening);
  }
  return opening;
}

Errors join_search(const Valve& /*valve*/, const SearchOptions& options, SearchContext& context) {
  ended = false;
  const bool is_shared = coapt_workers() > 1;
  context.cancelled = &ended;
  context.progress = [](const SearchProgress& progress) {
    const std::string text = to_json(progress).dump();
    coapt_progress(text.data(), text.size());
  };
  context.evaluate = evaluator(options.closure, is_shared);
  context.open = is_shared ? shared_opening : open_plan;
  return {};
}

[[maybe_unused]] const bool kSearches = (further = {plan_operations, join_search}, true);

}  // namespace
}  // namespace coapt

// NLopt's algorithms under the LGPL, which the module leaves out (cmake/packaging/wasm_libraries.sh): they answer that their
// arguments are invalid. Addresses are numbers of 32 bits there.
extern "C" {
constexpr int kInvalidArguments = -2;  // NLOPT_INVALID_ARGS
int luksan_plis(int, int, int, int, int, int, int, int, int) { return kInvalidArguments; }
int luksan_plip(int, int, int, int, int, int, int, int, int, int) { return kInvalidArguments; }
int luksan_pnet(int, int, int, int, int, int, int, int, int, int, int) { return kInvalidArguments; }
}
