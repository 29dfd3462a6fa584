// Loads, strains, rings, opening and clips of a valve beside what was measured in hearts. Answers coapt.physiology/1.
#include "io/json/physiology_json.h"
#include "operations/repair_request.h"
#include "operations/table.h"

namespace coapt {
namespace {

constexpr std::ptrdiff_t kClosuresOfAStudy = 17;  // and openings (search/studies)

struct PhysiologyRequest {
  RepairRequest repair{};
  PhysiologyOptions study{};
};

/// Field whose value is one of `choices` by its name.
template <class Choices, class Value>
JsonField choice_field(const char* name, const Choices& choices, std::optional<Value>& target) {
  const std::vector<Value> values(choices.begin(), choices.end());
  return {name, into(target, [values](const JsonPlace& place) { return read_name(place, values); }),
          false};
}

Expected<OperationAnswer> studied(const PhysiologyRequest& asked, Context& context) {
  PhysiologyOptions study = asked.study;
  study.threads = context.limits.threads;
  study.budget = context.budget();
  study.progress = context.progress;
  const Physiology physiology = study_physiology(asked.repair.repaired, study);
  if (physiology.unfinished) return context.refusal();
  return OperationAnswer(to_json(physiology, asked.repair.repaired));
}

}  // namespace

Expected<OperationTask> read_physiology(const Json& request, const Context& context) {
  const auto asked = std::make_shared<PhysiologyRequest>();
  if (Errors errors = read_repair(request, context,
                                  {choice_field("kind", kValveKinds, asked->study.kind),
                                   choice_field("species", kSpecies, asked->study.species)},
                                  asked->repair);
      !errors.empty())
    return errors;
  return task_of(asked, kClosuresOfAStudy, studied);
}

}  // namespace coapt
