#include "farm/program/status_text.h"

#include <map>
#include <vector>

#include "io/json/json.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr long kEndedRuns = 10;  ///< of which status tells

std::string duration(double seconds) {
  if (seconds < 120.0) return fixed(seconds, 0) + " s";
  if (seconds < 7200.0) return fixed(seconds / 60.0, 0) + " min";
  if (seconds < 172800.0) return fixed(seconds / 3600.0, 1) + " h";
  return fixed(seconds / 86400.0, 1) + " days";
}

std::string rate(double per_s) { return fixed(per_s, per_s < 10.0 ? 1 : 0) + "/s"; }

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(text.size() < width ? width - text.size() : 0, ' ');
}

/// What a stranger wrote: nothing of it reaches the terminal but letters.
std::string words_in(const Json& text) {
  return text.is_string() ? printable(text.get<std::string>()) : "";
}

std::string words_of_run(const Json& run) {
  std::string words =
      grouped(run["done"].get<std::int64_t>()) + " of " + grouped(run["items"].get<std::int64_t>());
  if (run["state"] != "open") return words;
  const double per_s = run["rate_per_s"].get<double>();
  if (per_s > 0.0) words += ", " + rate(per_s);
  if (!run["eta_s"].is_null()) words += ", " + duration(run["eta_s"].get<double>()) + " left";
  return words + ", " + counted(run["workers"].get<long>(), "worker");
}

void print_run(std::ostream& out, const Json& run) {
  const std::string label = words_in(run["label"]), team = words_in(run["team"]);
  out << "run " << run["run"] << "  " << padded(run["state"].get<std::string>(), 10)
      << padded(words_in(run["kind"]), 12) << words_of_run(run)
      << (label.empty() ? "" : "  " + label) << (team.empty() ? "" : "  (team " + team + ")")
      << '\n';
  if (run["waits_for_workers"] == true)
    out << "  waiting for a worker of revision " << words_in(run["revision"]) << '\n';
  if (run["tasks_disputed"] != 0)
    out << "  " << counted(run["tasks_disputed"].get<long>(), "task")
        << " returned different results and are computed again by other workers\n";
  for (const Json& hole : run["poison"])
    out << "  no result for items from " << hole["first"] << " (" << hole["items"]
        << "): " << words_in(hole["error"]) << '\n';
}

void print_worker(std::ostream& out, const Json& worker) {
  const bool barred = worker["barred"].get<bool>(), alive = worker["alive"].get<bool>();
  out << "worker " << padded(words_in(worker["name"]), 24)
      << padded(barred  ? "barred"
                : alive ? "alive"
                        : "gone",
                8)
      << grouped(worker["items"].get<std::int64_t>()) << " items, "
      << rate(worker["rate_per_s"].get<double>()) << ", seen "
      << duration(worker["seen_s"].get<double>()) << " ago, revision "
      << words_in(worker["revision"]) << '\n';
}

/// A label's value: printable, quotes and backslashes escaped.
std::string quoted(const Json& value) {
  std::string text = "\"";
  for (const char letter : value.is_string() ? words_in(value) : value.dump()) {
    if (letter == '"' || letter == '\\') text += '\\';
    text += letter;
  }
  return text + '"';
}

void describe_farm(std::ostream& out, const char* name, const char* type, const char* help) {
  out << "# HELP " << name << ' ' << help << "\n# TYPE " << name << ' ' << type << '\n';
}

void print_family(std::ostream& out, const Json& rows, const char* name, const char* type,
                  const char* help, const char* key, const std::vector<const char*>& labels) {
  describe_farm(out, name, type, help);
  for (const Json& row : rows) {
    out << name << '{';
    for (std::size_t i = 0; i < labels.size(); ++i)
      out << (i > 0 ? "," : "") << labels[i] << '=' << quoted(row[labels[i]]);
    out << "} " << row[key] << '\n';
  }
}

}  // namespace

std::string progress_words(const Json& progress) {
  std::string words = "items";
  const double per_s = progress["rate_per_s"].get<double>();
  if (per_s > 0.0) words += ", " + rate(per_s);
  if (!progress["eta_s"].is_null())
    words += ", " + duration(progress["eta_s"].get<double>()) + " left";
  return words + ", " + counted(progress["workers"].get<long>(), "worker");
}

void print_farm(std::ostream& out, const Json& status) {
  if (status["runs"].empty()) out << "no runs\n";
  long ended = 0;
  for (const Json& run : status["runs"]) {  // the newest first
    const bool has_ended = run["state"] == "done" || run["state"] == "cancelled";
    if (!has_ended || ++ended <= kEndedRuns) print_run(out, run);
  }
  if (ended > kEndedRuns)
    out << counted(ended - kEndedRuns, "earlier run") << " done or cancelled (--json: all)\n";
  for (const Json& worker : status["workers"]) print_worker(out, worker);
  std::size_t told = 0;
  for (const Json& fault : status["faults"]) {
    if (fault["what"] == "lost" || ++told > 10) continue;
    out << "fault in run " << fault["run"] << ", items from " << fault["first"] << ", worker "
        << words_in(fault["worker"]) << ": " << words_in(fault["what"]) << ", "
        << words_in(fault["detail"]) << '\n';
  }
}

void print_prometheus(std::ostream& out, const Json& status) {
  const Json& runs = status["runs"];
  const std::vector<const char*> of_run = {"run", "label", "state"};
  print_family(out, runs, "coapt_farm_run_items", "gauge", "Items of a run.", "items", of_run);
  print_family(out, runs, "coapt_farm_run_items_done", "gauge", "Items with an accepted result.",
               "done", of_run);
  print_family(out, runs, "coapt_farm_run_rate", "gauge", "Items per second in the last minute.",
               "rate_per_s", of_run);
  print_family(out, runs, "coapt_farm_run_tasks_open", "gauge", "Unassigned tasks.", "tasks_open",
               of_run);
  print_family(out, runs, "coapt_farm_run_tasks_claimed", "gauge", "Assigned tasks.",
               "tasks_claimed", of_run);
  print_family(out, runs, "coapt_farm_run_tasks_poison", "gauge", "Abandoned tasks.",
               "tasks_poison", of_run);
  print_family(out, runs, "coapt_farm_run_tasks_disputed", "gauge",
               "Tasks with conflicting results.", "tasks_disputed", of_run);
  print_family(out, runs, "coapt_farm_run_workers", "gauge", "Live workers eligible for a run.",
               "workers", of_run);
  std::map<std::string, int> workers = {{"alive", 0}, {"barred", 0}, {"gone", 0}};
  for (const Json& worker : status["workers"])
    ++workers[worker["barred"] == true ? "barred" : worker["alive"] == true ? "alive" : "gone"];
  describe_farm(out, "coapt_farm_workers", "gauge", "Workers of the last day.");
  for (const auto& [state, count] : workers)
    out << "coapt_farm_workers{state=\"" << state << "\"} " << count << '\n';
  const std::vector<const char*> of_worker = {"name", "pid"};
  print_family(out, status["workers"], "coapt_farm_worker_items_total", "counter",
               "Items completed by a worker.", "items", of_worker);
  print_family(out, status["workers"], "coapt_farm_worker_computing_seconds_total", "counter",
               "Computing time of a worker.", "seconds", of_worker);
  describe_farm(out, "coapt_farm_faults_total", "counter",
                "Expired leases (lost), failures, conflicting results, barred workers.");
  if (status["faults_total"].is_object())
    for (const auto& [what, count] : status["faults_total"].items())
      out << "coapt_farm_faults_total{what=" << quoted(what) << "} " << count << '\n';
  describe_farm(out, "coapt_farm_database_bytes", "gauge", "Size of the database.");
  out << "coapt_farm_database_bytes " << status["database_bytes"] << '\n';
}

}  // namespace coapt
