// Which measurement of a valve would say most of its leak, as it is or repaired. Answers coapt.information/1.
#include "io/json/model_study_json.h"
#include "operations/model_draws.h"
#include "operations/table.h"
#include "search/studies/model_study.h"

namespace coapt {
namespace {

constexpr int kMostDraws = 100'000;

struct InformationRequest {
  RepairRequest repair{};
  ModelStudyOptions study{};
};

Expected<OperationAnswer> inform(const InformationRequest& asked, Context& context) {
  const Expected<ModelStudy> drawn = study_within(asked.repair, asked.study, {}, context);
  if (!drawn) return drawn.errors();
  return OperationAnswer(to_json(*drawn, information_rows(*drawn), asked.repair.valve.name));
}

}  // namespace

Expected<OperationTask> read_information(const Json& request, const Context& context) {
  const auto asked = std::make_shared<InformationRequest>();
  if (Errors errors =
          read_repair(request, context,
                      {{"draws", into(asked->study.draws, integer_in(1, kMostDraws)), false},
                       {"seed", into(asked->study.seed, read_unsigned), false}},
                      asked->repair);
      !errors.empty())
    return errors;
  if (Errors errors = check_draws(asked->repair, asked->study.draws, context); !errors.empty())
    return errors;
  return task_of(asked, draw_closures(asked->repair, asked->study.draws), inform);
}

}  // namespace coapt
