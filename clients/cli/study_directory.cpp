#include "clients/cli/study_directory.h"

#include <filesystem>
#include <stdexcept>

#include "farm/ask/farm.h"
#include "farm/ask/farm_closures.h"
#include "io/command_line/files.h"
#include "io/json/subject.h"

namespace coapt {
namespace {

constexpr int kValvesAtOnce = 16;

[[noreturn]] void fail(const Errors& errors) { throw std::runtime_error(errors.front().message); }

}  // namespace

Expected<std::unique_ptr<StudyDirectory>> StudyDirectory::open(const std::string& directory,
                                                               const StudyPlace& place) {
  if (Errors errors = make_directory(directory); !errors.empty()) return errors;
  Expected<ClosureStore> store =
      ClosureStore::open((std::filesystem::path(directory) / "closures.sqlite").string());
  if (!store) return store.errors();
  return std::unique_ptr<StudyDirectory>(new StudyDirectory(directory, place, std::move(*store)));
}

OrificeTable StudyDirectory::table(const Valve& valve, const ClosureOptions& closure) {
  OrificeTableOptions options;
  options.closure = closure;
  options.threads = place_.threads;
  if (!place_.farm.empty())
    options.close_elsewhere =
        closures_asked_of(ask_farm(farm_at(place_.farm)), valve, closure, {.label = place_.label});
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::string subject = subject_of(valve, options.closure);
  Expected<KnownOrifices> known = store_.read(subject);
  if (!known) fail(known.errors());
  options.known = std::move(*known);
  options.keep = [this, subject](const ConfigurationKey& key, const OrificeSample& sample) {
    const std::lock_guard<std::mutex> held(mutex_);
    if (const Errors errors = store_.keep(subject, key, sample); !errors.empty()) fail(errors);
  };
  options.progress = [this](int done, int planned) {
    const std::lock_guard<std::mutex> held(mutex_);
    if (done % 16 == 0 || done == planned) bar_.show(done, planned, "closures: " + stage_);
  };
  return OrificeTable(valve, std::move(options));
}

void StudyDirectory::begin(const std::string& stage) {
  const std::lock_guard<std::mutex> lock(mutex_);
  stage_ = stage;
}

int StudyDirectory::valves_at_once() const { return place_.farm.empty() ? 1 : kValvesAtOnce; }

int StudyDirectory::write(const std::string& name, const std::string& content) const {
  return write_output((std::filesystem::path(directory_) / name).string(), content);
}

double StudyDirectory::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
}

}  // namespace coapt
