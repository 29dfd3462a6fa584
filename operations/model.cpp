// How much of a valve's leak, as it is or repaired, tissue and chordae leave open. Answers coapt.model_study/2.
#include "io/json/model_study_json.h"
#include "io/json/named_file.h"
#include "io/picture/model_study_page.h"
#include "operations/model_draws.h"
#include "operations/table.h"

namespace coapt {
namespace {

constexpr int kMostDraws = 100'000;

struct ModelRequest {
  RepairRequest repair{};
  ModelStudyOptions study{};
  bool files = false;
};

Expected<OperationAnswer> study(const ModelRequest& asked, Context& context) {
  const Expected<ModelStudy> drawn = study_within(asked.repair, asked.study, {}, context);
  if (!drawn) return drawn.errors();
  const std::string& name = asked.repair.valve.name;
  Json answer = to_json(*drawn, name);
  if (asked.files) {
    answer["files"] = Json::array();
    for (const NamedFile& file : model_study_files(*drawn, name))
      answer["files"].push_back({{"name", file.name}, {"text", file.bytes}});
  }
  return OperationAnswer(std::move(answer));
}

}  // namespace

Expected<OperationTask> read_model(const Json& request, const Context& context) {
  const auto asked = std::make_shared<ModelRequest>();
  if (Errors errors =
          read_repair(request, context,
                      {{"draws", into(asked->study.draws, integer_in(1, kMostDraws)), false},
                       {"seed", into(asked->study.seed, read_unsigned), false},
                       {"files", into(asked->files, read_boolean), false}},
                      asked->repair);
      !errors.empty())
    return errors;
  return task_of(asked, draw_closures(asked->repair, asked->study.draws), study);
}

}  // namespace coapt
