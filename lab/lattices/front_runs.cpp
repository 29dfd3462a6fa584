#include "lab/lattices/front_runs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <sstream>
#include <stdexcept>

#include "lab/lattices/program_lines.h"
#include "search/plans/front_search.h"
#include "search/random_share.h"

namespace coapt {
namespace {

constexpr double kOpeningUnit_mm2 = 500.0, kMostLeak_mm2 = 100.0;
constexpr std::array kShares = {0.90, 0.95, 0.99};
constexpr int kMostClosures = 3000;  // of ours: it stops long before
constexpr double kGridStep = 1.1;    // of closures, from 10
constexpr double kLongest = 1e5;

VolumeRise searched(const SolvedFront& front, std::uint64_t seed, int most_closures) {
  const Evaluator evaluate = [&](const Valve&, const ClosureResult*) {
    return ClosedPlan{front.before, nullptr};  // asked for the unrepaired valve alone
  };
  SearchMonitor monitor(0.0, nullptr);
  PlanEvaluationOptions options;
  options.threads = 1;
  options.known = front.closures;
  options.open = [](const Valve&) -> PlanOpening {
    throw std::logic_error("an opening that was not solved");
  };
  options.known_openings = front.openings;
  PlanEvaluations evaluations(evaluate, front.of.valve, std::move(options), monitor);
  const std::vector<PlanRecord*> plans = plans_of(*front.space, *front.flat, evaluations).plans;
  VolumeRise rise;
  std::vector<TradeOff> found;
  for (const auto& [plan, closures, openings] :
       search_front(evaluations, plans, {.closures = most_closures, .seed = seed})) {
    const std::optional<TradeOff> one = trade_off(*plan, kChosenBy);
    if (!one) continue;
    found.push_back(*one);
    const double share = dominated_volume(found) / front.volume;
    if (rise.empty() || share > rise.back().second)
      rise.emplace_back(closures + kOpeningClosures * openings, share);
  }
  return rise;
}

std::vector<int> shuffled(std::size_t plans, int budget, std::uint64_t seed) {
  std::vector<int> numbers(plans);
  std::iota(numbers.begin(), numbers.end(), 0);
  std::mt19937_64 engine(seed);
  for (std::size_t i = 0; i < plans; ++i)
    std::swap(numbers[i], numbers[i + static_cast<std::size_t>(random_share(engine) *
                                                               static_cast<double>(plans - i))]);
  numbers.resize(std::min(plans, static_cast<std::size_t>(budget)));
  return numbers;
}

std::vector<int> outside_run(const FrontTask& task, int budget, const std::string& outside) {
  std::string command = '\'' + outside + "' --front";
  for (const std::string& file : task.files) command += " '" + file + '\'';
  command += ' ' + task.method + ' ' + std::to_string(task.seed) + ' ' + std::to_string(budget);
  std::vector<int> numbers;
  int status = 0;
  for (const std::string& line : lines_of(command, &status))
    numbers.push_back(task.front->numbers[std::stoul(line)]);
  if (status != 0) throw std::runtime_error("failed: " + command);
  return numbers;
}

std::vector<std::string> methods_of(const std::vector<FrontRun>& runs) {
  std::vector<std::string> methods;
  for (const FrontRun& run : runs)
    if (std::find(methods.begin(), methods.end(), run.method) == methods.end())
      methods.push_back(run.method);
  return methods;
}

double share_within(const FrontRun& run, double closures) {
  double share = 0.0;
  for (const auto& [spent, found] : run.rise)
    if (spent <= closures) share = found;
  return share;
}

}  // namespace

bool is_chosen_on(const std::string& lattice) {
  return lattice == "functional" || lattice == "porcine-both";
}

std::vector<rivals::LatticeTable> objective_tables(const SolvedFront& front) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::vector<rivals::LatticeTable> tables(3);
  for (rivals::LatticeTable& table : tables) {
    table.name = front.of.name;
    for (const FlatVariable& variable : front.flat->variables())
      table.variables.push_back({variable.name, variable.ordered, variable.count});
    for (const int number : front.numbers) table.plans.push_back(std::max(0, number));
  }
  for (const int number : front.numbers) {
    std::array<double, 3> values = {kNone, kNone, kNone};
    if (number >= 0) {
      const PlanOutcome& outcome = front.outcomes[static_cast<std::size_t>(number)];
      TradeOff of = kWorstAccepted;
      if (outcome.trade_off) of = *outcome.trade_off;
      const double leak = std::isnan(outcome.leak_mm2) ? kMostLeak_mm2 : outcome.leak_mm2;
      const double above = std::clamp(leak, of.leak_mm2, kMostLeak_mm2) / kWorstAccepted.leak_mm2;
      values = {
          outcome.trade_off ? of.leak_mm2 / kWorstAccepted.leak_mm2 : 1.0 + 0.1 * std::log(above),
          1.0 - (of.opening_mm2 - kWorstAccepted.opening_mm2) / kOpeningUnit_mm2,
          1.0 - of.durability_mm / kFurthestCourse_mm};
    }
    for (std::size_t k = 0; k < values.size(); ++k) tables[k].costs.push_back(values[k]);
  }
  return tables;
}

std::vector<std::string> front_methods(const std::string& outside) {
  std::vector<std::string> methods = {"coapt", "random"};
  if (!outside.empty()) methods.insert(methods.end(), {"pagmo_nsga2", "pagmo_moead"});
  return methods;
}

FrontRun front_run(const FrontTask& task, int budget, const std::string& outside) {
  const SolvedFront& front = *task.front;
  FrontRun run{task.method, front.of.name, task.seed, {}};
  if (task.method == "coapt") {
    run.rise =
        searched(front, task.seed, std::min(kMostClosures, (kChosenBy + kDisease.count) * budget));
  } else {
    run.rise = volume_rise(front, task.method == "random"
                                      ? shuffled(front.outcomes.size(), budget, task.seed)
                                      : outside_run(task, budget, outside));
  }
  return run;
}

double closures_to_share(const FrontRun& run, double share) {
  for (const auto& [closures, found] : run.rise)
    if (found >= share) return closures;
  return std::numeric_limits<double>::infinity();
}

std::string front_csv(const std::vector<SolvedFront>& fronts, const std::vector<FrontRun>& runs) {
  std::ostringstream csv;
  csv << "lattice,held_out,method,plans,accepted,share,closures,reached,runs\n";
  for (const SolvedFront& front : fronts) {
    const auto accepted =
        std::count_if(front.outcomes.begin(), front.outcomes.end(),
                      [](const PlanOutcome& one) { return one.trade_off.has_value(); });
    for (const std::string& method : methods_of(runs))
      for (const double share : kShares) {
        std::vector<double> closures;
        for (const FrontRun& run : runs)
          if (run.method == method && run.lattice == front.of.name)
            closures.push_back(closures_to_share(run, share));
        const auto reached = std::count_if(closures.begin(), closures.end(),
                                           [](double value) { return std::isfinite(value); });
        std::sort(closures.begin(), closures.end());
        csv << front.of.name << ',' << !is_chosen_on(front.of.name) << ',' << method << ','
            << front.outcomes.size() << ',' << accepted << ',' << share << ','
            << closures[closures.size() / 2] << ',' << reached << ',' << closures.size() << '\n';
      }
  }
  return csv.str();
}

std::string front_rise_csv(const std::vector<FrontRun>& runs) {
  std::ostringstream csv;
  csv << "held_out,method,closures,share\n";
  for (const bool held_out : {false, true})
    for (const std::string& method : methods_of(runs))
      for (double closures = 10.0; closures < kLongest; closures *= kGridStep) {
        double sum = 0.0;
        int count = 0;
        for (const FrontRun& run : runs)
          if (run.method == method && is_chosen_on(run.lattice) != held_out) {
            sum += share_within(run, closures);
            ++count;
          }
        if (count > 0)
          csv << held_out << ',' << method << ',' << std::lround(closures) << ',' << sum / count
              << '\n';
      }
  return csv.str();
}

}  // namespace coapt
