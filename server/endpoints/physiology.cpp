#include "server/endpoints/physiology.h"

#include "io/json/physiology_json.h"
#include "server/repair_request.h"

namespace coapt {
namespace {

/// Field whose value is one of `choices` by its name.
template <class Choices, class Value>
JsonField choice_field(const char* name, const Choices& choices, std::optional<Value>& target) {
  const std::vector<Value> values(choices.begin(), choices.end());
  return {name, into(target, [values](const JsonPlace& place) { return read_name(place, values); }),
          false};
}

constexpr int kClosures = 17;  // and openings, of a study (search/studies)

}  // namespace

Answer PostPhysiology::operator()(const Request& request) const {
  PhysiologyOptions options;
  options.threads = valves.limits.request_threads;
  return answer_repair(
      valves, compute, request,
      {choice_field("kind", kValveKinds, options.kind),
       choice_field("species", kSpecies, options.species)},
      [&options](const RepairRequest& asked, RequestClosures& closures) {
        options.budget = closures.budget();
        const Physiology physiology = study_physiology(asked.repaired, options);
        return physiology.unfinished ? closures.refusal()
                                     : json_answer(200, to_json(physiology, asked.repaired));
      },
      kClosures);
}

}  // namespace coapt
