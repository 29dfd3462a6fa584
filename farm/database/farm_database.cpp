#include "farm/database/farm_database.h"

#include <sstream>
#include <utility>

#include "farm/database/schema.h"

namespace coapt {
namespace {

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
  return words;
}

/// As the arrays $2 and $3 of functions that take tasks.
std::vector<Argument> with_tasks(std::int64_t worker, const std::vector<TaskKey>& tasks) {
  std::vector<std::int64_t> runs, firsts;
  for (const TaskKey& task : tasks) {
    runs.push_back(task.run);
    firsts.push_back(task.first);
  }
  return {worker, sql_array(runs), sql_array(firsts)};
}

template <class T>
Errors errors_of(const Expected<T>& answer) {
  return answer ? Errors() : answer.errors();
}

Error wrong_version(const std::string& where, std::int64_t version) {
  return {ErrorCode::Unsupported, "",
          where + ": its farm has version " + std::to_string(version) +
              ", this program works with " + std::to_string(farm_schema_version()) +
              (version < farm_schema_version() ? "; run coapt-farm init to update it" : "")};
}

Error other_work(const std::string& where) {
  return {ErrorCode::Unsupported, "",
          where + ": holds other work under the requested name; it is not used"};
}

}  // namespace

Errors init_farm(Connection& connection, const std::string& team) {
  if (const Expected<Rows> version =
          connection.call("SELECT number::bigint FROM coapt_farm.schema_version");
      version && version->count() > 0 && version->number(0, 0) > farm_schema_version())
    return {wrong_version(connection.where(), version->number(0, 0))};
  if (Errors errors = connection.run(std::string(farm_schema())); !errors.empty()) return errors;
  if (team.empty()) return {};
  const std::string role = "coapt_team_" + team;
  const Expected<Rows> there =
      connection.call("SELECT count(*) FROM pg_roles WHERE rolname = $1", {role});
  if (!there) return there.errors();
  if (there->number(0, 0) > 0) return {};
  // Letters, digits and _ alone (farm/program/init.cpp), quoted lest the case is lost.
  return connection.run("CREATE ROLE \"" + role + "\" NOLOGIN");
}

Expected<FarmDatabase> FarmDatabase::open(const std::string& url) {
  Expected<Connection> connection = Connection::open(url);
  if (!connection) return connection.errors();
  FarmDatabase database(*std::move(connection));
  if (Errors errors = database.check_version(); !errors.empty()) return errors;
  return database;
}

Errors FarmDatabase::reopen() {
  if (connection_.is_open()) return {};
  if (Errors errors = connection_.reset(); !errors.empty()) return errors;
  return check_version();
}

Errors FarmDatabase::check_version() {
  const Expected<std::int64_t> version = number("SELECT coapt_farm.hello()", {});
  if (!version) return version.errors();
  if (*version != farm_schema_version()) return {wrong_version(where(), *version)};
  return {};
}

Expected<std::int64_t> FarmDatabase::add(const WorkRequest& request, const NewRun& run) {
  if (Errors errors = connection_.run("BEGIN"); !errors.empty()) return errors;
  const auto added = [&]() -> Expected<std::int64_t> {
    std::vector<std::string> names;
    for (const std::string& part : request.parts) {
      const Expected<std::string> name = text("SELECT coapt_farm.add_part($1)", {Bytes{part}});
      if (!name) return name.errors();
      names.push_back(*name);
    }
    const Expected<Rows> made = connection_.call(
        "SELECT the_run, the_work FROM coapt_farm.add_run($1, $2, $3, $4, $5, $6, $7, $8)",
        {run.revision, request.kind, sql_array(names), run.label, run.team, run.items,
         std::int64_t{run.task_items}, run.check_share});
    if (!made) return made.errors();
    if (made->bytes(0, 1) != work_id(request)) return other_work(where());
    if (Errors errors = connection_.run("COMMIT"); !errors.empty()) return errors;
    return made->number(0, 0);
  }();
  if (!added) static_cast<void>(connection_.run("ROLLBACK"));
  return added;
}

Expected<std::string> FarmDatabase::progress(std::int64_t run) {
  return text("SELECT coapt_farm.progress($1)", {run});
}

Expected<std::vector<AnsweredTask>> FarmDatabase::answers(std::int64_t run, std::int64_t from,
                                                          bool with_holes) {
  const Expected<Rows> rows =
      connection_.call("SELECT first, n, work_id, bytes FROM coapt_farm.result_chunk($1, $2, $3)",
                       {run, from, std::int64_t{with_holes}});
  if (!rows) return rows.errors();
  std::vector<AnsweredTask> tasks;
  for (int i = 0; i < rows->count(); ++i)
    tasks.push_back({rows->number(i, 0), static_cast<int>(rows->number(i, 1)), rows->bytes(i, 2),
                     rows->bytes(i, 3)});
  return tasks;
}

Expected<RunRequest> FarmDatabase::request(std::int64_t run) {
  const Expected<Rows> rows = connection_.call(
      "SELECT work_id, revision, kind, parts FROM coapt_farm.request_of($1)", {run});
  if (!rows) return rows.errors();
  RunRequest asked{rows->bytes(0, 0), rows->bytes(0, 1), {rows->bytes(0, 2), {}}};
  for (const std::string& name : words_of(rows->bytes(0, 3))) {
    Expected<std::string> part = text("SELECT coapt_farm.part_of($1, $2)", {run, name});
    if (!part) return part.errors();
    asked.request.parts.push_back(*std::move(part));
  }
  if (work_id(asked.request) != asked.work) return other_work(where());
  return asked;
}

Expected<std::string> FarmDatabase::doubt(std::int64_t run, std::int64_t first,
                                          const std::string& why) {
  return text("SELECT coapt_farm.doubt($1, $2, $3)", {run, first, why});
}

Expected<std::optional<DisputedTask>> FarmDatabase::disputed(std::int64_t run) {
  const Expected<Rows> rows =
      connection_.call("SELECT first, n FROM coapt_farm.disputed($1)", {run});
  if (!rows) return rows.errors();
  if (rows->count() == 0) return std::optional<DisputedTask>();
  return std::optional(DisputedTask{rows->number(0, 0), static_cast<int>(rows->number(0, 1))});
}

Errors FarmDatabase::judge(std::int64_t run, std::int64_t first, const std::string& bytes) {
  return errors_of(
      connection_.call("SELECT coapt_farm.judge($1, $2, $3)", {run, first, Bytes{bytes}}));
}

Expected<std::string> FarmDatabase::status() { return text("SELECT coapt_farm.status()", {}); }

Expected<std::string> FarmDatabase::cancel(std::int64_t run) {
  return text("SELECT coapt_farm.cancel($1)", {run});
}

Errors FarmDatabase::forget(std::int64_t run) {
  return errors_of(connection_.call("SELECT coapt_farm.forget($1)", {run}));
}

Expected<std::int64_t> FarmDatabase::join(const WorkerName& worker) {
  return number(
      "SELECT coapt_farm.join_farm($1, $2, $3, $4, $5)",
      {worker.name, worker.host, std::int64_t{worker.pid}, worker.revision, worker.lease_s});
}

Errors FarmDatabase::leave(std::int64_t worker) {
  return errors_of(connection_.call("SELECT coapt_farm.leave_farm($1)", {worker}));
}

Expected<std::vector<ClaimedTask>> FarmDatabase::claim(std::int64_t worker, int most) {
  const Expected<Rows> rows =
      connection_.call("SELECT * FROM coapt_farm.claim($1, $2)", {worker, std::int64_t{most}});
  if (!rows) return rows.errors();
  std::vector<ClaimedTask> tasks;
  for (int i = 0; i < rows->count(); ++i)
    tasks.push_back({{rows->number(i, 0), rows->number(i, 1)},
                     static_cast<int>(rows->number(i, 2)),
                     rows->bytes(i, 3),
                     words_of(rows->bytes(i, 4))});
  return tasks;
}

Expected<std::string> FarmDatabase::read_part(std::int64_t worker, std::int64_t run,
                                              const std::string& part) {
  return text("SELECT coapt_farm.read_part($1, $2, $3)", {worker, run, part});
}

Errors FarmDatabase::renew(std::int64_t worker, const std::vector<TaskKey>& tasks) {
  return errors_of(
      connection_.call("SELECT coapt_farm.renew($1, $2, $3)", with_tasks(worker, tasks)));
}

Errors FarmDatabase::give_back(std::int64_t worker, const std::vector<TaskKey>& tasks) {
  return errors_of(
      connection_.call("SELECT coapt_farm.give_back($1, $2, $3)", with_tasks(worker, tasks)));
}

Expected<std::string> FarmDatabase::finish(std::int64_t worker, TaskKey task,
                                           const std::string& work, double seconds,
                                           const std::string& bytes) {
  return text("SELECT coapt_farm.finish($1, $2, $3, $4, $5, $6)",
              {worker, task.run, task.first, work, seconds, Bytes{bytes}});
}

Errors FarmDatabase::fail(std::int64_t worker, TaskKey task, const std::string& error) {
  return errors_of(connection_.call("SELECT coapt_farm.fail($1, $2, $3, $4)",
                                    {worker, task.run, task.first, error}));
}

Expected<std::string> FarmDatabase::waiting(std::int64_t worker) {
  return text("SELECT coapt_farm.waiting($1)", {worker});
}

Expected<std::string> FarmDatabase::text(const std::string& sql,
                                         const std::vector<Argument>& arguments) {
  const Expected<Rows> rows = connection_.call(sql, arguments);
  if (!rows) return rows.errors();
  return rows->bytes(0, 0);
}

Expected<std::int64_t> FarmDatabase::number(const std::string& sql,
                                            const std::vector<Argument>& arguments) {
  const Expected<Rows> rows = connection_.call(sql, arguments);
  if (!rows) return rows.errors();
  return rows->number(0, 0);
}

}  // namespace coapt
