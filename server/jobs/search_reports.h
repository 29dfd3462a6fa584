// Reports on a search, drawn when they are asked for: a job keeps their words and the closed shapes alone
// (io/picture/report_material.h), a thirtieth of the reports. A report has the same bytes whenever it is asked for.
//
// Drawing takes a tenth of a second a picture, so that few reports are drawn at once, on turns of their own: closures that
// clients wait for keep theirs. What a report has drawn is given and forgotten; only its size is remembered, for the list
// of files.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "io/json/plans_json.h"
#include "io/store/job_store.h"
#include "server/answer.h"
#include "server/compute.h"
#include "server/limits.h"
#include "server/route.h"

namespace coapt {

/// Of JobEnd::material. @pre the search kept its closures
std::string search_material(const SearchResult& result, const SearchRequest& request);
/// The same of material that was written elsewhere (io/picture/report_material.h).
std::string packed_material(const std::string& material);

class SearchReports {
 public:
  static constexpr std::size_t kSizes = 10'000;  ///< remembered

  /// @param turns reports drawn at once; by default half the cores
  explicit SearchReports(int turns = static_cast<int>(std::thread::hardware_concurrency()) / 2,
                         std::chrono::milliseconds patience = std::chrono::seconds(20))
      : drawing_(turns, patience, std::chrono::seconds(10)) {}

  /// "report.html", "plan-RANK.html"; none if the search keeps no such report. @param client that asks
  std::optional<Answer> report(const JobStore& store, const Job& job, const std::string& name,
                               const std::string& client);

  /// Those that can be asked for, with their sizes; the refusal if these are not known within the time of a request: asked
  /// again it goes on from there.
  std::variant<std::vector<JobFileName>, Answer> list(const JobStore& store, const Job& job,
                                                      const ServiceLimits& limits,
                                                      const Request& request);

 private:
  std::optional<std::int64_t> size_of(const std::string& path);
  void remember(const std::string& path, std::size_t bytes);

  Compute drawing_;
  std::mutex mutex_;
  std::map<std::string, std::int64_t> sizes_;  ///< by job and name
};

}  // namespace coapt
