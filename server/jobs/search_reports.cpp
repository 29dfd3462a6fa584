#include "server/jobs/search_reports.h"

#include <charconv>
#include <chrono>

#include "io/picture/report_material.h"
#include "server/answers.h"
#include "server/jobs/closure_keeping.h"
#include "server/negotiation.h"
#include "server/turns.h"

namespace coapt {
namespace {

constexpr int kLevel = 6;                                      // of gzip: 0.7 MB take 20 ms
constexpr std::size_t kMostMaterial = std::size_t{256} << 20;  // bytes; 50 plans have some 10 MB

// What drawing one takes (docs/engineer/service.md).
constexpr double kReport_s = 1.0, kPlanReport_s = 0.5;

constexpr std::string_view kAll = "report.html", kOne = "plan-", kEnd = ".html";

std::string name_of(std::size_t page) {
  if (page == 0) return std::string(kAll);
  return std::string(kOne) + std::to_string(page) + std::string(kEnd);
}

/// The page that has this name, however many there are.
std::optional<std::size_t> page_named(const std::string& name) {
  if (name == kAll) return 0;
  if (!name.starts_with(kOne)) return std::nullopt;
  std::size_t page = 0;
  std::from_chars(name.data() + kOne.size(), name.data() + name.size(), page);
  return page > 0 && name == name_of(page) ? std::optional(page) : std::nullopt;
}

/// What a job keeps of its reports; empty if there is nothing.
Expected<std::string> material_of(const JobStore& store, const Job& job) {
  const Expected<std::optional<std::string>> kept = store.material(job.id);
  if (!kept) return kept.errors();
  if (!*kept) return std::string();
  std::optional<std::string> material = gunzip(**kept, kMostMaterial);
  if (!material) return Error{ErrorCode::InputOutput, "", "the reports of this search are damaged"};
  return *std::move(material);
}

std::string path_of(const Job& job, const std::string& name) { return job.id + '/' + name; }

}  // namespace

std::string search_material(const SearchResult& result, const SearchRequest& request) {
  return packed_material(write_report_material(report_material(result, request)));
}

std::string packed_material(const std::string& material) { return gzip(material, kLevel); }

std::optional<Answer> SearchReports::report(const JobStore& store, const Job& job,
                                            const std::string& name, const std::string& client) {
  const std::optional<std::size_t> page = page_named(name);
  if (!page || job.kind != "plans") return std::nullopt;
  const Expected<std::string> material = material_of(store, job);
  if (!material) return store_problem(material.errors());
  if (material->empty()) return std::nullopt;
  const Expected<std::size_t> pages = report_pages(*material);
  if (!pages) return problem(500, pages.errors());
  if (*page >= *pages) return std::nullopt;
  const Expected<Valve> valve = valve_of(store, job);
  if (!valve) return store_problem(valve.errors());
  Compute::Turn turn(drawing_, {page == 0 ? kReport_s : kPlanReport_s, client});
  if (!turn) return no_turn(turn);
  Expected<std::string> html = report_page(*material, *page, *valve);
  if (!html) return problem(500, html.errors());
  remember(path_of(job, name), html->size());
  return Answer{200, Content{kHtmlType, *std::move(html)}};
}

std::variant<std::vector<JobFileName>, Answer> SearchReports::list(const JobStore& store,
                                                                   const Job& job,
                                                                   const ServiceLimits& limits,
                                                                   const Request& request) {
  std::vector<JobFileName> files;
  const Expected<std::string> material = material_of(store, job);
  if (!material) return store_problem(material.errors());
  if (material->empty()) return files;
  const Expected<std::size_t> pages = report_pages(*material);
  if (!pages) return problem(500, pages.errors());
  const auto started = std::chrono::steady_clock::now();
  for (std::size_t page = 0; page < *pages; ++page) {
    const std::string name = name_of(page);
    std::optional<std::int64_t> size = size_of(path_of(job, name));
    if (!size) {
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - started;
      if (seconds.count() > limits.request_seconds || (request.abandoned && request.abandoned()))
        return retry_later(503,
                           "the reports of this search are still being generated; try again later");
      const std::optional<Answer> made = report(store, job, name, request.client);
      if (!made || made->status != 200) return made.value_or(not_found("file"));
      size = static_cast<std::int64_t>(std::get<Content>(made->body).bytes.size());
    }
    files.push_back({name, kHtmlType, *size});
  }
  return files;
}

std::optional<std::int64_t> SearchReports::size_of(const std::string& path) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto known = sizes_.find(path);
  return known == sizes_.end() ? std::nullopt : std::optional(known->second);
}

void SearchReports::remember(const std::string& path, std::size_t bytes) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (sizes_.size() >= kSizes) sizes_.clear();
  sizes_.insert_or_assign(path, static_cast<std::int64_t>(bytes));
}

}  // namespace coapt
