#include "farm/ask/ask.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <thread>

namespace coapt {
namespace {

constexpr std::chrono::milliseconds kAskedEvery(50);

Expected<std::string> compute_here(const WorkRequest& request, int threads,
                                   const AskContext& context) {
  const Expected<Work> work = open_work(request);
  if (!work) return work.errors();
  const auto is_cancelled = [&] { return context.cancelled != nullptr && *context.cancelled; };
  const std::jthread watcher([&](const std::stop_token& over) {
    while (!over.stop_requested() && !is_cancelled()) std::this_thread::sleep_for(kAskedEvery);
    if (is_cancelled()) *work->stop = true;
  });
  const auto started = std::chrono::steady_clock::now();
  AskProgress progress;
  progress.items = work->items;
  std::string bytes;
  try {
    while (progress.done < work->items && !is_cancelled()) {
      const auto count =
          static_cast<int>(std::min<std::int64_t>(work->task_items, work->items - progress.done));
      bytes += work->compute(progress.done, count, threads);
      progress.done += count;
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - started;
      progress.rate_per_s = static_cast<double>(progress.done) / took.count();
      progress.eta_s = static_cast<double>(work->items - progress.done) / progress.rate_per_s;
      if (context.progress) context.progress(progress);
    }
  } catch (const std::exception& error) {
    return Error{ErrorCode::InputOutput, "", error.what()};
  }
  if (progress.done < work->items) return Error{ErrorCode::InputOutput, "", "was interrupted"};
  return bytes;
}

}  // namespace

Asker ask_here(int threads) {
  return [threads](const WorkRequest& request, const AskContext& context) {
    return compute_here(request, threads, context);
  };
}

}  // namespace coapt
