// Jobs and what they have come to, with valves (stored_valves.h) and kept plans (kept_plans.h): the server's memory, in one
// SQLite file.
//
// What has returned without an error outlives the process and a loss of power (every commit is forced to
// the disk), which costs milliseconds: nothing here is called for each closure. Reading goes through a
// connection of its own and never waits for writing. All times are of the system's clock and only for
// people to read: nothing is ordered by them or depends on them. Strings are bytes, zeros included, and
// come back as they were.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/valve/types.h"
#include "io/store/file_lock.h"
#include "io/store/transaction.h"

namespace coapt {

enum class JobState { Queued, Running, Succeeded, Failed, Cancelled };
const char* to_string(JobState state);  ///< "QUEUED", ...
bool has_ended(JobState state);

struct JobFile {
  std::string name;  ///< "report.html"
  std::string type;  ///< "text/html; charset=utf-8"
  std::string content;
};
struct JobFileName {
  std::string name, type;
  std::int64_t bytes = 0;
};

struct JobEvent {
  std::int64_t number = 0;  ///< from 1 in each job
  std::string kind;         ///< "state", "progress"
  std::string content;      ///< JSON
};

struct NewJob {
  std::string id;                    ///< unguessable, the caller's
  std::string kind;                  ///< "plans", "study"
  std::string valve;                 ///< id of a stored valve
  std::string request;               ///< JSON
  std::string idempotency_key = {};  ///< empty: none
  std::string input = {};            ///< what it works from, however large; empty: none
};

struct Job {
  std::int64_t number = 0;  ///< in the order of submission, never given again
  std::string id, kind, valve;
  std::string request;  ///< of job() and submit(); lists leave it empty
  JobState state = JobState::Queued;
  bool cancel_requested = false;
  std::int64_t created_ms = 0;   ///< since 1970, like those below
  std::int64_t started_ms = 0;   ///< first; 0: not yet
  std::int64_t finished_ms = 0;  ///< 0: not yet
  double seconds = 0.0;          ///< of running, over all attempts
  int stalled = 0;        ///< attempts in a row that were killed without having kept anything new
  std::int64_t kept = 0;  ///< closures known when it was last started
  std::string progress;   ///< JSON, the last that was stored; empty: none yet
  std::string summary;    ///< JSON, of an ended job, small; empty: none
};

/// How a job ended.
struct JobEnd {
  JobState state = JobState::Succeeded;   ///< an ended one
  double seconds = 0.0;                   ///< of running, over all attempts
  std::string progress = {};              ///< JSON; empty: the last that was stored stays
  std::string summary = {}, result = {};  ///< JSON; result may be large, empty: none
  std::vector<JobFile> files = {};        ///< all of different names
  std::string material = {};  ///< of files that are made when they are asked for; empty: none
};

struct JobPage {
  std::vector<Job> jobs;         ///< newest first
  std::int64_t next_before = 0;  ///< 0: there are no more
};

/// What stays of what nobody removes.
struct Retention {
  int jobs = 1000;      ///< ended ones, the newest
  double days = 0.0;    ///< since a job ended, or closures were used; 0: without limit
  int valves = 10'000;  ///< at most; those that a job or a kept plan refers to stay all the same
  /// Of searches, and as many of studies; those of jobs that have not ended stay all the same. Some 100 bytes each.
  int closures = 5'000'000;
};

/// From any thread. A failure is Busy if another process has the file locked for too long, NoSpace if
/// disk, quota or size of the file has no room (then nothing has changed, and it may be tried again), else
/// InputOutput; BadReference where it is said. A full file size is NoSpace only if SIGXFSZ is ignored.
class JobStore {
 public:
  /// Makes the file if it is missing or empty. What is not a store of this schema is Unsupported, and
  /// not a byte of it changed. Busy if another server has it open: PATH-lock, beside it, is locked. This
  /// call and those below wait up to `lock_timeout_ms` for other processes.
  static Expected<JobStore> open(const std::string& path, int lock_timeout_ms = 2000);

  struct Submitted {
    Job job;
    bool is_new = true;
  };
  /// A job, QUEUED, with its valve in one commit. Of an idempotency key that is taken: the job that has
  /// it, and nothing else is kept.
  Expected<Submitted> submit(const NewJob& job, const std::string& valve_document,
                             std::int64_t now_ms);
  Expected<std::optional<Job>> job(const std::string& id) const;
  /// The job that was submitted with an idempotency key.
  Expected<std::optional<Job>> job_of_key(const std::string& idempotency_key) const;
  /// @param size from 1 @param before only jobs with smaller numbers; 0: all @param state none: all
  Expected<JobPage> page(int size, std::int64_t before, std::optional<JobState> state) const;
  /// QUEUED and RUNNING, in the order of submission: what a server that starts has to do.
  Expected<std::vector<Job>> unfinished() const;
  Expected<std::int64_t> count(JobState state) const;

  /// QUEUED or RUNNING -> RUNNING. BadReference if there is none or it has ended.
  /// @param kept closures known now; `stalled` is counted from it, and returned
  Expected<int> start(const std::string& id, std::int64_t kept, std::int64_t now_ms);
  /// RUNNING -> QUEUED: to go on later. In any other state it stays as it is, likewise below.
  /// BadReference if there is none, likewise below. Empty progress: the last that was stored stays.
  Errors suspend(const std::string& id, double seconds, const std::string& progress);
  Errors request_cancel(const std::string& id);
  /// What a job works from, and where it was when it last said so: both are forgotten when it ends.
  Expected<std::optional<std::string>> input(const std::string& id) const;
  Errors keep_state(const std::string& id, const std::string& state);
  Expected<std::optional<std::string>> state(const std::string& id) const;
  /// State, summary, result, files, in one commit. An ended job stays as it is.
  Errors finish(const std::string& id, const JobEnd& end, std::int64_t now_ms);
  /// With all that belongs to it but its valve. False if there is none. BadReference while it has not
  /// ended.
  Expected<bool> remove(const std::string& id);

  /// Removes the jobs and valves that are not to stay, the oldest first.
  Errors retain(const Retention& retention, std::int64_t now_ms);

  /// Appends; its number. Every change of state is appended with the change itself: kind "state", content
  /// {"state": "RUNNING"}. "progress" of a job that has not ended becomes the job's progress and
  /// seconds, too, so that a killed job knows what it has spent.
  Expected<std::int64_t> add_event(const std::string& id, const std::string& kind,
                                   const std::string& content, double seconds);
  /// Those after number `after`, oldest first, at most `most`; of no job: none.
  Expected<std::vector<JobEvent>> events(const std::string& id, std::int64_t after, int most) const;
  Expected<std::optional<std::string>> result(const std::string& id) const;
  /// In the order in which they were given.
  Expected<std::vector<JobFileName>> files(const std::string& id) const;
  Expected<std::optional<JobFile>> file(const std::string& id, const std::string& name) const;
  Expected<std::optional<std::string>> material(const std::string& id) const;

  /// Whether something can be written now: a page, as it is, forced to the disk.
  Errors check_writable();

  /// For what else lies in the file. @param problem for messages: "a plan cannot be kept"
  Transaction writing(const char* problem) const;
  Transaction reading() const;

 private:
  JobStore(FileLock lock, StoreDatabase writer, StoreDatabase reader);

  FileLock lock_;  // released last
  std::unique_ptr<StoreConnection> writer_, reader_;
};

}  // namespace coapt
