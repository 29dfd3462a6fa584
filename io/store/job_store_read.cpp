// What a JobStore reads. Lists pass the bodies over: those lie in tables of their own.
#include <sqlite3.h>

#include <limits>

#include "io/store/job_row.h"

namespace coapt {

Expected<std::optional<std::string>> JobStore::valve(const std::string& id) const {
  std::optional<std::string> document;
  Transaction reads = reading();
  reads.run("SELECT document FROM valves WHERE id = ?", {id},
            [&document](const Statement& row) { document = bytes_at(row, 0); });
  return reads.end_with(std::move(document));
}

Expected<std::optional<Job>> JobStore::job(const std::string& id) const {
  Transaction reads = reading();
  std::optional<Job> found = find_job(reads, "id", id);
  return reads.end_with(std::move(found));
}

Expected<std::optional<Job>> JobStore::job_of_key(const std::string& idempotency_key) const {
  Transaction reads = reading();
  std::optional<Job> found = find_job(reads, "idempotency_key", idempotency_key);
  return reads.end_with(std::move(found));
}

Expected<JobPage> JobStore::page(int size, std::int64_t before,
                                 std::optional<JobState> state) const {
  std::string sql = std::string("SELECT ") + kJobColumns + " FROM jobs WHERE number < ?";
  std::vector<SqlValue> values = {before == 0 ? std::numeric_limits<std::int64_t>::max() : before};
  if (state) {
    sql += " AND state = ?";
    values.emplace_back(to_string(*state));
  }
  values.emplace_back(std::int64_t{size} + 1);  // the last tells whether there are more

  JobPage page;
  Transaction reads = reading();
  reads.run(sql + " ORDER BY number DESC LIMIT ?", values,
            [&page](const Statement& row) { page.jobs.push_back(job_at(row)); });
  if (std::ssize(page.jobs) > size) {
    page.jobs.pop_back();
    page.next_before = page.jobs.back().number;
  }
  return reads.end_with(std::move(page));
}

Expected<std::vector<Job>> JobStore::unfinished() const {
  std::vector<Job> jobs;
  Transaction reads = reading();
  reads.run(std::string("SELECT ") + kJobColumns +
                " FROM jobs WHERE state IN ('QUEUED', 'RUNNING') ORDER BY number",
            {}, [&jobs](const Statement& row) { jobs.push_back(job_at(row)); });
  return reads.end_with(std::move(jobs));
}

Expected<std::int64_t> JobStore::count(JobState state) const {
  std::int64_t jobs = 0;
  Transaction reads = reading();
  reads.run("SELECT count(*) FROM jobs WHERE state = ?", {to_string(state)},
            [&jobs](const Statement& row) { jobs = sqlite3_column_int64(row.get(), 0); });
  return reads.end_with(jobs);
}

Expected<std::vector<JobEvent>> JobStore::events(const std::string& id, std::int64_t after,
                                                 int most) const {
  std::vector<JobEvent> events;
  Transaction reads = reading();
  reads.run(
      "SELECT number, kind, content FROM events WHERE job = (SELECT number FROM jobs WHERE id = ?) "
      "AND number > ? ORDER BY number LIMIT ?",
      {id, after, most}, [&events](const Statement& row) {
        events.push_back({sqlite3_column_int64(row.get(), 0), bytes_at(row, 1), bytes_at(row, 2)});
      });
  return reads.end_with(std::move(events));
}

Expected<std::optional<std::string>> JobStore::result(const std::string& id) const {
  std::optional<std::string> result;
  Transaction reads = reading();
  reads.run(
      "SELECT result FROM bodies WHERE job = (SELECT number FROM jobs WHERE id = ?) "
      "AND result IS NOT NULL",
      {id}, [&result](const Statement& row) { result = bytes_at(row, 0); });
  return reads.end_with(std::move(result));
}

Expected<std::vector<JobFileName>> JobStore::files(const std::string& id) const {
  std::vector<JobFileName> files;
  Transaction reads = reading();
  reads.run(
      "SELECT name, type, length(content) FROM files "
      "WHERE job = (SELECT number FROM jobs WHERE id = ?) ORDER BY number",
      {id}, [&files](const Statement& row) {
        files.push_back({bytes_at(row, 0), bytes_at(row, 1), sqlite3_column_int64(row.get(), 2)});
      });
  return reads.end_with(std::move(files));
}

Expected<std::optional<JobFile>> JobStore::file(const std::string& id,
                                                const std::string& name) const {
  std::optional<JobFile> file;
  Transaction reads = reading();
  reads.run(
      "SELECT name, type, content FROM files "
      "WHERE job = (SELECT number FROM jobs WHERE id = ?) AND name = ?",
      {id, name}, [&file](const Statement& row) {
        file = JobFile{bytes_at(row, 0), bytes_at(row, 1), bytes_at(row, 2)};
      });
  return reads.end_with(std::move(file));
}

Expected<std::optional<std::string>> JobStore::input(const std::string& id) const {
  std::optional<std::string> input;
  Transaction reads = reading();
  reads.run("SELECT content FROM inputs WHERE job = (SELECT number FROM jobs WHERE id = ?)", {id},
            [&input](const Statement& row) { input = bytes_at(row, 0); });
  return reads.end_with(std::move(input));
}

Expected<std::optional<std::string>> JobStore::state(const std::string& id) const {
  std::optional<std::string> state;
  Transaction reads = reading();
  reads.run(
      "SELECT state FROM inputs WHERE state IS NOT NULL AND "
      "job = (SELECT number FROM jobs WHERE id = ?)",
      {id}, [&state](const Statement& row) { state = bytes_at(row, 0); });
  return reads.end_with(std::move(state));
}

Expected<std::optional<std::string>> JobStore::material(const std::string& id) const {
  std::optional<std::string> material;
  Transaction reads = reading();
  reads.run("SELECT content FROM materials WHERE job = (SELECT number FROM jobs WHERE id = ?)",
            {id}, [&material](const Statement& row) { material = bytes_at(row, 0); });
  return reads.end_with(std::move(material));
}

}  // namespace coapt
