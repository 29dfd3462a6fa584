#include "farm/ask/farm_closures.h"

#include <stdexcept>

#include "farm/work/orifice_work.h"

namespace coapt {
namespace {

template <class T>
T asked_or_thrown(Expected<T> answer) {
  if (!answer) throw std::runtime_error("closures of a farm: " + answer.errors().front().message);
  return *std::move(answer);
}

}  // namespace

CloseElsewhere closures_asked_of(const Asker& asker, const Valve& valve,
                                 const ClosureOptions& closure, const AskContext& context) {
  return [=](const std::vector<ConfigurationKey>& keys,
             const std::function<void(int, int)>& progress) {
    AskContext asking = context;
    asking.progress = [&progress](const AskProgress& now) {
      progress(static_cast<int>(now.done), static_cast<int>(now.items));
    };
    const std::string bytes =
        asked_or_thrown(asker(asked_or_thrown(orifice_request(valve, closure, keys)), asking));
    return asked_or_thrown(orifice_answers(bytes, keys.size()));
  };
}

}  // namespace coapt
