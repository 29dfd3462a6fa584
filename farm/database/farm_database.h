// What a farm's database does, one function of coapt_farm a call (farm/database/schema).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "farm/database/connection.h"
#include "farm/work/work.h"

namespace coapt {

/// Makes the farm's schema and roles, or brings its functions up to date; with `team`, the role of a team, too. Errors: the
/// schema is of a later version, or the login may not make roles.
Errors init_farm(Connection& connection, const std::string& team);

struct NewRun {
  std::string revision;
  std::string label;
  std::string team;  ///< empty: any worker may answer
  std::int64_t items = 0;
  int task_items = 256;
  double check_share = 1.0 / 64.0;  ///< of tasks that two workers compute
};

struct WorkerName {
  std::string name, host;
  int pid = 0;
  std::string revision;
  double lease_s = 60.0;  ///< after so long without a sign of life a worker is dead
};

/// Items [first, first + count) of a run.
struct TaskKey {
  std::int64_t run = 0;
  std::int64_t first = 0;
};

struct ClaimedTask {
  TaskKey key;
  int count = 0;
  std::string kind;
  std::vector<std::string> parts;  ///< names for read_part()
};

/// Rows of a run's answers.
struct AnsweredTask {
  std::int64_t first = 0;
  int count = 0;
  std::string work;  ///< that it answers: its work_id()
  std::string bytes;
};

struct DisputedTask {
  std::int64_t first = 0;
  int count = 0;
};

/// What a run asks for.
struct RunRequest {
  std::string work, revision;  ///< as the database has them
  WorkRequest request;
};

/// Errors of all calls as Connection's; from one thread at a time.
class FarmDatabase {
 public:
  /// Unsupported if the database has no farm of this version.
  static Expected<FarmDatabase> open(const std::string& url);
  /// After errors that may pass: opens the connection again if it is broken.
  Errors reopen();
  const std::string& where() const { return connection_.where(); }

  /// The run of this work, which may have been there before. One transaction. Unsupported if the database takes it for other work.
  Expected<std::int64_t> add(const WorkRequest& request, const NewRun& run);
  /// JSON {"state", "done", "items", "workers", "rate_per_s", "eta_s", "tasks_poison", "poison", ...}.
  Expected<std::string> progress(std::int64_t run);
  /// Some tasks from item `from` on, in order, some 4 MB; none: that was all. OutOfRange unless the run is done, or done with
  /// holes and `with_holes`.
  Expected<std::vector<AnsweredTask>> answers(std::int64_t run, std::int64_t from, bool with_holes);
  Expected<RunRequest> request(std::int64_t run);
  /// The answer to the task at `first` is not right: it is open again, as all else that its worker alone answered. Whose it was.
  Expected<std::string> doubt(std::int64_t run, std::int64_t first, const std::string& why);
  /// A task that workers of several logins answered in different ways, if nobody else could settle it.
  Expected<std::optional<DisputedTask>> disputed(std::int64_t run);
  /// Settles it by the right answer; who gave another answers the run no more.
  Errors judge(std::int64_t run, std::int64_t first, const std::string& bytes);
  Expected<std::string> status();                  ///< JSON coapt.farm/1
  Expected<std::string> cancel(std::int64_t run);  ///< the state it is in now
  Errors forget(std::int64_t run);

  /// The worker's number.
  Expected<std::int64_t> join(const WorkerName& worker);
  Errors leave(std::int64_t worker);
  Expected<std::vector<ClaimedTask>> claim(std::int64_t worker, int most);
  Expected<std::string> read_part(std::int64_t worker, std::int64_t run, const std::string& part);
  Errors renew(std::int64_t worker, const std::vector<TaskKey>& tasks);
  Errors give_back(std::int64_t worker, const std::vector<TaskKey>& tasks);
  /// "kept", "same" as an answer before, "differs" from one, "unclaimed": the task is not this worker's, or "unknown": the run is
  /// gone, or other work. What was taken is on the disk. @param work work_id() of what was computed.
  Expected<std::string> finish(std::int64_t worker, TaskKey task, const std::string& work,
                               double seconds, const std::string& bytes);
  Errors fail(std::int64_t worker, TaskKey task, const std::string& error);
  /// JSON {"mine": open runs that the worker may answer, "others": [{"revision", "runs"}]}.
  Expected<std::string> waiting(std::int64_t worker);

 private:
  explicit FarmDatabase(Connection connection) : connection_(std::move(connection)) {}
  Expected<std::string> text(const std::string& sql, const std::vector<Argument>& arguments);
  Expected<std::int64_t> number(const std::string& sql, const std::vector<Argument>& arguments);
  Errors check_version();

  Connection connection_;
};

}  // namespace coapt
