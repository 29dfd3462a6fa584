#include "clients/engine/live.h"

#include <utility>

#include "clients/engine/requests.h"
#include "io/json/scene_json.h"

namespace coapt {
namespace {

template <class Matrix>
void put(std::vector<float>& list, const Matrix& numbers) {
  for (Index i = 0; i < numbers.rows(); ++i)
    for (Index k = 0; k < numbers.cols(); ++k) list.push_back(static_cast<float>(numbers(i, k)));
}

void put_hook(std::vector<float>& list, const LiveValve& valve, int hook) {
  const std::optional<Hook>& held = valve.hook(hook);
  list.push_back(held ? 1.0f : 0.0f);
  const Vec3 none = Vec3::Zero();
  put(list, held ? valve.spot_mm(hook) : none);
  put(list, held ? held->hand_mm : none);
  put(list, valve.force_n(hook));
}

/// Valves may close under more than a live one takes.
std::optional<EngineAnswer> refused_pressure(const Valve& valve) {
  ProblemList problems;
  check_range(problems, "/valve/pressure_kpa", valve.pressure_kpa, kLiveSystoles_kpa, " kPa");
  if (problems.empty()) return std::nullopt;
  return problem(422, std::move(problems).take());
}

}  // namespace

EngineAnswer LiveEngine::start(std::string_view body) {
  RepairRequest asked;
  std::optional<double> pressure_mmhg;
  const auto read = [](const JsonPlace& place) {
    return read_number_in(place, kLivePressures_mmhg, " mmHg");
  };
  if (auto refusal =
          read_request(body, asked, {{"pressure_mmhg", into(pressure_mmhg, read), false}}))
    return *std::move(refusal);
  if (auto refusal = refused_pressure(asked.repaired)) return *std::move(refusal);
  moving_.emplace(asked.repaired,
                  pressure_mmhg.value_or(kMmhgPerKpa * asked.repaired.pressure_kpa));
  return started(asked);
}

EngineAnswer LiveEngine::change(std::string_view body) {
  RepairRequest asked;
  if (auto refusal = read_request(body, asked, {})) return *std::move(refusal);
  if (auto refusal = refused_pressure(asked.repaired)) return *std::move(refusal);
  moving_->change(asked.repaired);
  return started(asked);
}

EngineAnswer LiveEngine::started(const RepairRequest& asked) {
  heads_ = std::ssize(asked.repaired.heads);
  knots_ = std::ssize(asked.repaired.ties);
  vertices_ = static_cast<int>(asked.repaired.rest_mm.rows());
  Json cables = Json::array();
  for (const LiveCable& cable : moving_->cables()) cables.push_back({cable.chorda, cable.segment});
  cables_ = static_cast<int>(cables.size());
  Json hooks = Json::array();
  for (int hook = 0; hook < kHooks; ++hook) hooks.push_back(moving_->hook(hook).has_value());
  return json_answer(200, {{"scene", unloaded_scene_to_json(asked.repaired, asked.plan)},
                           {"systole_mmhg", kMmhgPerKpa * asked.repaired.pressure_kpa},
                           {"cables", std::move(cables)},
                           {"hooks", std::move(hooks)}});
}

const std::vector<float>& LiveEngine::take_picture() {
  const LiveValve& valve = *moving_;
  picture_ = {static_cast<float>(valve.pressure_mmhg()), valve.at_rest() ? 1.0f : 0.0f,
              valve.beats() ? 1.0f : 0.0f, static_cast<float>(valve.returns()),
              static_cast<float>(valve.longest_move_mm())};
  for (int hook = 0; hook < kHooks; ++hook) put_hook(picture_, valve, hook);
  const Points& nodes = valve.vertices_mm();
  put(picture_, nodes.topRows(nodes.rows() - heads_ - knots_));
  put(picture_, nodes.bottomRows(heads_));
  for (const LiveCable& cable : valve.cables()) {
    picture_.push_back(static_cast<float>(cable.tension_n));
    picture_.push_back(static_cast<float>(cable.strain));
  }
  return picture_;
}

}  // namespace coapt
