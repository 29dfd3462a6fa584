// What a farm computes: a pure function from a request and an index to bytes.
//
// A request names a kind of work and carries all that decides its answers. Its items are counted from 0; any of them may be
// computed anywhere, in any order, more than once: the bytes are the same, which is what lets a farm compare them.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/valve/types.h"

namespace coapt {

/// What decides every answer, together with work_revision(): requests of the same bytes are the same work.
struct WorkRequest {
  std::string kind;  ///< "orifices", "plans", "members", "records", "imports"
  /// The first a JSON document, the others (valves) named by it; each stored once by its content.
  std::vector<std::string> parts;
};

/// Thrown by a computation that was stopped: it has no answer.
struct WorkStopped : std::runtime_error {
  WorkStopped() : std::runtime_error("the work was stopped") {}
};

/// A request that has been read.
struct Work {
  std::int64_t items = 0;
  int task_items =
      256;  ///< consecutive items that one worker takes at a time: about one or two seconds
  /// The answers of items [first, first + count), packed one after another. On `threads` threads, the same bytes for any number.
  /// From one thread at a time. Throws what cannot be computed (std::runtime_error), a bug or a broken machine.
  std::function<std::string(std::int64_t first, int count, int threads)> compute;
  /// What speaks against bytes as the answers of these items; empty: nothing. It looks at their form and the names in them, in
  /// milliseconds: whether they are right, only computing tells.
  std::function<std::string(std::int64_t first, int count, std::string_view bytes)> objection;
  /// Whether answers without objection look wrong by what can be computed again quickly; whoever asked then computes the whole task.
  /// Empty where nothing is quick. @pre objection() is empty
  std::function<bool(std::int64_t first, int count, std::string_view bytes)> doubt;
  /// Tasks that whoever asked computes again, drawn at random, before it believes the answers; 0 where one takes as long as what
  /// was asked for.
  int sampled_tasks = 2;
  /// Set from any thread, it ends a computation within a closure or two by WorkStopped.
  std::shared_ptr<std::atomic<bool>> stop = std::make_shared<std::atomic<bool>>(false);
};

/// Errors as JSON pointers into the first part.
Expected<Work> open_work(const WorkRequest& request);

/// open_work() for a worker that opens one work after another: those of one valve share the closures that others start from, up
/// to some 0.5 GB.
std::function<Expected<Work>(const WorkRequest&)> make_work_opener();

/// 64 hexadecimal digits: the SHA-256 of the kind and of the SHA-256 of each part.
std::string work_id(const WorkRequest& request);
/// The same from the SHA-256 of each part.
std::string work_id(const std::string& kind, const std::vector<std::string>& part_names);

/// Of this build: workers of another one refuse the work. version() and what else decides bits.
std::string work_revision();

}  // namespace coapt
