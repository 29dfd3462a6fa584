#include <chrono>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/farm_option.h"
#include "clients/cli/population_directory.h"
#include "clients/cli/run_options.h"
#include "farm/work/population_work.h"
#include "io/command_line/command_line.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/command_line/interrupt.h"
#include "io/command_line/progress_bar.h"
#include "io/json/population_json.h"
#include "io/json/population_prior_json.h"
#include "io/json/result_json.h"
#include "io/json/valve_json.h"
#include "io/picture/population_page.h"
#include "io/picture/text.h"
#include "search/training/seeds.h"

namespace coapt {
namespace {

struct PopulationMakeArguments {
  int count = 100, threads = 0;
  std::uint64_t seed = 1;
  std::string prior, farm, directory = "population";
  bool json = false;
};

struct PopulationValveArguments {
  std::string directory, output;
  int index = 0;
  bool healthy = false;
};

/// The members by index, drawn here or by a farm.
Errors make_members(const PopulationMakeArguments& arguments, const std::atomic<bool>& interrupted,
                    Population& population) {
  const ProgressBar bar;
  AskContext context{.label = "population " + arguments.directory, .cancelled = &interrupted};
  context.progress = [&](const AskProgress& now) { bar.show(now.done, now.items, "valves"); };
  const Expected<std::string> bytes = asker_of(arguments.farm, arguments.threads)(
      members_request(population.prior, population.seed, arguments.count), context);
  if (!bytes) return bytes.errors();
  Expected<std::vector<PopulationMember>> members = member_answers(*bytes);
  if (!members) return members.errors();
  population.members = *std::move(members);
  return {};
}

void print_population(const Population& population, const std::string& directory, double seconds) {
  long anatomies = 0, lesions = 0;
  for (const PopulationMember& member : population.members) {
    anatomies += member.draws.anatomies;
    lesions += member.draws.lesions;
  }
  std::cout << counted(std::ssize(population.members), "valve") << " of " << grouped(anatomies)
            << " anatomies and " << grouped(lesions) << " diseases drawn, " << fixed(seconds, 0)
            << " s\n";
  for (const AetiologyPrior& aetiology : population.prior.aetiologies) {
    long members = 0;
    double leak = 0.0;
    for (const PopulationMember& member : population.members) {
      if (member.aetiology != aetiology.aetiology) continue;
      ++members;
      leak += member.leak_mm2;
    }
    std::cout << "  " << to_string(aetiology.aetiology) << ": " << members << ", mean leak "
              << fixed(leak / static_cast<double>(members), 1) << " mm2\n";
  }
  std::cout << printable(assumed_words(population.prior)) << "\nWritten to " << printable(directory)
            << "/index.html\n";
}

int run_make(const PopulationMakeArguments& arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  Population population{adult_prior(), arguments.seed, {}};
  if (!arguments.prior.empty()) {
    const Expected<std::string> text = read_input(arguments.prior);
    if (!text) return report_errors(arguments.prior, text.errors());
    const Expected<PopulationPrior> prior = read_prior(*text);
    if (!prior) return report_errors(arguments.prior, prior.errors());
    population.prior = *prior;
  }
  if (const Errors errors = make_directory(arguments.directory); !errors.empty()) {
    report_errors("population make", errors);
    return exit_code::kFailure;
  }
  const auto start = std::chrono::steady_clock::now();
  const Errors errors = make_members(arguments, interrupted, population);
  if (interrupted) return exit_code::kInterrupted;
  if (!errors.empty()) return report_errors("population make", errors);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const std::string json = json_text(to_json(population)) + "\n";
  for (const auto& [name, content] : {std::pair<std::string, std::string>{"population.json", json},
                                      {"members.csv", members_csv(population)},
                                      {"index.html", population_page(population)}})
    if (const int error = write_output(arguments.directory + "/" + name, content)) return error;
  if (arguments.json) {
    std::cout << json;
  } else {
    print_population(population, arguments.directory, seconds);
  }
  return exit_code::kOk;
}

int run_valve(const PopulationValveArguments& arguments) {
  const Expected<Population> population = read_population_directory(arguments.directory);
  if (!population) return report_errors(arguments.directory, population.errors());
  if (arguments.index >= std::ssize(population->members))
    return report_errors(
        arguments.directory,
        {{ErrorCode::OutOfRange, "",
          "has no member " + std::to_string(arguments.index) + ", accepted: 0 to " +
              std::to_string(std::ssize(population->members) - 1)}});
  const PopulationMember& member = population->members[static_cast<std::size_t>(arguments.index)];
  const Expected<Valve> valve = arguments.healthy ? make_healthy_valve(member) : make_valve(member);
  if (!valve) return report_errors(arguments.directory, valve.errors());
  return write_output(arguments.output, write_valve(*valve));
}

void add_population_make(Command parent, int& status) {
  const auto arguments = std::make_shared<PopulationMakeArguments>();
  Command command = parent.add_command(
      "make", "Draw competent valves from published distributions and apply disease to them");
  command.add_option("-n,--number", arguments->count, "Number of valves")
      .check(number_from(1, 100000))
      .show_default();
  command.add_option("--seed", arguments->seed, "Random seed")
      .check(number_from(std::uint64_t{0}, kLargestSeed))
      .show_default();
  command.add_option("--prior", arguments->prior,
                     "Distributions (coapt.population_prior/1), - for standard input (default: "
                     "adults, examples/populations/adult.json)");
  command.add_option("-o,--output", arguments->directory, "Directory for JSON, CSV and index.html")
      .show_default();
  add_threads_option(command, arguments->threads);
  add_farm_option(command, arguments->farm, "Draw the valves");
  command.add_flag("--json", arguments->json, "Print the population (coapt.population/1)");
  command.footer(
      "A draw is accepted if the valve leaks at most 5 mm2 before disease and more after it; "
      "rejected\ndraws are counted. index.html compares the drawn values with their sources.\n\n"
      "Example:\n"
      "  coapt population make -n 200 --seed 7 -o adults");
  command.on_run([arguments, &status] { status = run_make(*arguments); });
}

void add_population_valve(Command parent, int& status) {
  const auto arguments = std::make_shared<PopulationValveArguments>();
  Command command = parent.add_command("valve", "Write one valve of a population as a valve file");
  command
      .add_option("population", arguments->directory, "Directory written by coapt population make")
      .required();
  command.add_option("index", arguments->index, "Index of the valve, starting at 0")
      .required()
      .check(number_from(0, 99999));
  command.add_flag("--healthy", arguments->healthy, "Write the valve before disease");
  command.add_option("-o,--output", arguments->output, "File to write, - for standard output")
      .required();
  command.footer(
      "Example:\n"
      "  coapt population valve adults 12 -o valve-12.json");
  command.on_run([arguments, &status] { status = run_valve(*arguments); });
}

}  // namespace

void add_population(Command parent, int& status) {
  Command population =
      parent.add_command("population", "Draw valves from published distributions of anatomy");
  population.require_command();
  add_population_make(population, status);
  add_population_valve(population, status);
}

}  // namespace coapt
