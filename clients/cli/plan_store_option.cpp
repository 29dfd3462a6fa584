#include "clients/cli/plan_store_option.h"

#include <stdexcept>

#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/json/subject.h"

namespace coapt {

void add_store_option(Command command, std::string& path) {
  command
      .add_option("--store", path,
                  "Store every closure in this file (SQLite) and reuse those already stored")
      .check({refuse_standard_output, "FILE"});
}

int report_store_errors(const std::string& command, const Errors& errors) {
  report_errors(command, errors);
  return errors.front().code == ErrorCode::Unsupported ? exit_code::kBadInput : exit_code::kFailure;
}

Expected<std::shared_ptr<PlanStore>> use_store(const std::string& path, const Valve& valve,
                                               const ClosureOptions& closure,
                                               SearchContext& context) {
  if (path.empty()) return std::shared_ptr<PlanStore>();
  Expected<PlanStore> opened = PlanStore::open(path);
  if (!opened) return opened.errors();
  const auto store = std::make_shared<PlanStore>(std::move(*opened));
  const std::string subject = plan_subject_of(valve, closure);
  Expected<KnownPlans> known = store->read(subject);
  if (!known) return known.errors();
  context.known = std::move(*known);
  context.keep = [store, subject](const std::string& key, int disturbance, const PlanClosure& one) {
    if (const Errors errors = store->keep(subject, key, disturbance, one); !errors.empty())
      throw std::runtime_error(errors.front().message);
  };
  return store;
}

}  // namespace coapt
