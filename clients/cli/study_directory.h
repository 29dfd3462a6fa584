// Where a study works: its directory, the closures that the directory already holds, the progress bar.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "clients/cli/progress_bar.h"
#include "io/store/closure_store.h"

namespace coapt {

/// Closures are kept in DIRECTORY/closures.sqlite as they are made: a study that was killed, run
/// again, goes on from there.
class StudyDirectory {
 public:
  /// Makes the directory. Errors: it or the file of closures cannot be written.
  static Expected<std::unique_ptr<StudyDirectory>> open(const std::string& directory, int threads);

  /// A table of this valve's orifices that knows what was closed before. Throws what a store says
  /// that cannot be read or written (std::runtime_error): for main().
  OrificeTable table(const Valve& valve, const ClosureOptions& closure = ClosureOptions{});
  /// What the progress bar says from here on.
  void begin(const std::string& stage) { stage_ = stage; }
  void show(int done, int planned, const std::string& what) const {
    bar_.show(done, planned, what);
  }
  /// Writes a file into the directory. Returns an exit code.
  int write(const std::string& name, const std::string& content) const;

  double seconds() const;
  int threads() const { return threads_; }

 private:
  StudyDirectory(const std::string& directory, int threads, ClosureStore store)
      : directory_(directory), threads_(threads), store_(std::move(store)) {}

  std::string directory_;
  int threads_;
  ClosureStore store_;
  ProgressBar bar_;
  std::string stage_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace coapt
