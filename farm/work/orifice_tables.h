// Tables of orifices that outlive a work: a study asks for one batch after another of the same valve, and most closures
// start from others, which are not to be made again for each.
#pragma once

#include <atomic>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "search/studies/orifice_table.h"

namespace coapt {

struct SharedTable {
  std::mutex mutex;  ///< held by who computes: its table closes for one work at a time
  const std::atomic<bool>* stop = nullptr;  ///< of that work
  std::unique_ptr<OrificeTable> table;      ///< null: none yet
};

/// Those used last. From any thread.
class OrificeTables {
 public:
  /// @param subject what is closed, as subject_of() names it
  std::shared_ptr<SharedTable> of(const std::string& subject);

 private:
  std::mutex mutex_;
  std::list<std::pair<std::string, std::shared_ptr<SharedTable>>> newest_;  // first
};

}  // namespace coapt
