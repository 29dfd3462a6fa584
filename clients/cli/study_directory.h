// Where a study works: its directory, the closures that the directory already holds, the progress bar.
#pragma once

#include <chrono>
#include <memory>
#include <mutex>
#include <string>

#include "io/command_line/progress_bar.h"
#include "io/store/closure_store.h"

namespace coapt {

/// Where a study's closures are made, and by how many.
struct StudyPlace {
  int threads = 0;    ///< of this process; 0: all cores
  std::string farm;   ///< the farm that closes them; empty: this process
  std::string label;  ///< what the farm calls the work
};

/// Closures are kept in DIRECTORY/closures.sqlite as they are made: a study that was killed, run
/// again, goes on from there.
class StudyDirectory {
 public:
  /// Makes the directory. Errors: it or the file of closures cannot be written.
  static Expected<std::unique_ptr<StudyDirectory>> open(const std::string& directory,
                                                        const StudyPlace& place);

  /// A table of this valve's orifices that knows what was closed before. Throws what a store says
  /// that cannot be read or written, or a farm (std::runtime_error): for main(). From any thread, and so may the tables be used.
  OrificeTable table(const Valve& valve, const ClosureOptions& closure = ClosureOptions{});
  /// What the progress bar says from here on.
  void begin(const std::string& stage);
  void show(int done, int planned, const std::string& what) const {
    bar_.show(done, planned, what);
  }
  /// Writes a file into the directory. Returns an exit code.
  int write(const std::string& name, const std::string& content) const;

  double seconds() const;
  /// How many valves a study of several is to have in hand: a farm is not to wait for one valve's last closure.
  int valves_at_once() const;

 private:
  StudyDirectory(const std::string& directory, const StudyPlace& place, ClosureStore store)
      : directory_(directory), place_(place), store_(std::move(store)) {}

  std::string directory_;
  StudyPlace place_;
  std::mutex mutex_;  // store, bar and stage
  ClosureStore store_;
  ProgressBar bar_;
  std::string stage_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace coapt
