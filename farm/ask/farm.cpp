#include "farm/ask/farm.h"

#include <unistd.h>

#include <filesystem>

#include "farm/ask/ask.h"
#include "farm/ask/child_process.h"
#include "farm/work/work_file.h"
#include "io/json/json.h"
#include "io/json/result_json.h"

namespace coapt {
namespace {

constexpr const char* kFarmProgram = "coapt-farm";
// Exit codes of coapt-farm.
constexpr int kUsage = 2, kHoles = 4, kInterrupted = 130;
constexpr std::size_t kMostWords = 2000;  // of what it says besides lines of JSON

/// What the child says on its standard error.
struct FarmTalk {
  Errors errors;
  std::string words;
};

void hear(std::string_view line, FarmTalk& talk, const AskContext& context) {
  const Json said = Json::parse(line, nullptr, /*allow_exceptions=*/false);
  if (said.is_object() && said.contains("error")) {
    for (Error& error : errors_from_json(Json::array({said["error"]})))
      talk.errors.push_back(std::move(error));
  } else if (said.is_object() && said.contains("done")) {
    const auto number = [&said](const char* name, double otherwise) {
      const auto found = said.find(name);
      return found != said.end() && found->is_number() ? found->get<double>() : otherwise;
    };
    AskProgress progress;
    progress.done = static_cast<std::int64_t>(number("done", 0.0));
    progress.items = static_cast<std::int64_t>(number("items", 0.0));
    progress.workers = static_cast<int>(number("workers", 0.0));
    progress.rate_per_s = number("rate_per_s", 0.0);
    progress.eta_s = number("eta_s", progress.eta_s);
    if (context.progress) context.progress(progress);
  } else if (talk.words.size() < kMostWords && !line.empty()) {
    talk.words += (talk.words.empty() ? "" : "; ") + std::string(line);
  }
}

/// Why there is no answer; what the farm said itself first.
Errors reason_of(int status, FarmTalk talk, bool cancelled) {
  if (cancelled || status == kInterrupted)
    return {{ErrorCode::InputOutput, "",
             "was interrupted; the farm keeps the work, so repeat the request to resume it"}};
  if (!talk.errors.empty()) return std::move(talk.errors);
  std::string why = "coapt-farm ended with status " + std::to_string(status);
  if (status == kHoles) why = "the farm could not complete the run (see coapt-farm status)";
  if (!talk.words.empty()) why += ": " + talk.words;
  return {{status == kUsage ? ErrorCode::Unsupported : ErrorCode::InputOutput, "", why}};
}

Expected<std::string> compute_there(const Farm& farm, const WorkRequest& request,
                                    const AskContext& context) {
  const std::string bytes = write_work(request);
  FarmTalk talk;
  ChildCall call;
  call.program = farm.program;
  call.arguments = {"add", "-", "--wait", "--progress-json"};
  if (!context.label.empty())
    call.arguments.insert(call.arguments.end(), {"--label", context.label});
  call.environment = {{"COAPT_FARM", farm.url}};  // it may hold a password
  call.input = bytes;
  call.error_line = [&](std::string_view line) { hear(line, talk, context); };
  call.stop = context.cancelled;
  Expected<ChildEnd> end = run_child(call);
  if (!end) return end.errors();
  if (end->status == 0) return std::move(end->output);
  const bool cancelled = context.cancelled != nullptr && *context.cancelled;
  return reason_of(end->status, std::move(talk), cancelled);
}

}  // namespace

Farm farm_at(const std::string& url) {
  std::error_code failed;
  const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe", failed);
  const std::string beside = failed ? "" : (here.parent_path() / kFarmProgram).string();
  if (!beside.empty() && access(beside.c_str(), X_OK) == 0) return {url, beside};
  return {url, kFarmProgram};
}

Asker ask_farm(const Farm& farm) {
  return [farm](const WorkRequest& request, const AskContext& context) {
    return compute_there(farm, request, context);
  };
}

}  // namespace coapt
