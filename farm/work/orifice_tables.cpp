#include "farm/work/orifice_tables.h"

#include <algorithm>

namespace coapt {
namespace {

// Of all tables together: some 0.5 GB, of valves of 648 triangles.
constexpr int kMostClosures = 40'000;

int closures_of(SharedTable& shared) {
  const std::lock_guard<std::mutex> lock(shared.mutex);
  return shared.table == nullptr ? 0 : shared.table->closures();
}

}  // namespace

std::shared_ptr<SharedTable> OrificeTables::of(const std::string& subject) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = std::find_if(newest_.begin(), newest_.end(),
                                  [&](const auto& entry) { return entry.first == subject; });
  if (found == newest_.end())
    newest_.emplace_front(subject, std::make_shared<SharedTable>());
  else
    newest_.splice(newest_.begin(), newest_, found);
  int closures = 0;
  for (auto entry = newest_.begin(); entry != newest_.end();) {
    closures += closures_of(*entry->second);
    entry = entry != newest_.begin() && closures > kMostClosures ? newest_.erase(entry)
                                                                 : std::next(entry);
  }
  return newest_.front().second;
}

}  // namespace coapt
