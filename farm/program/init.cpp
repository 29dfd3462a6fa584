#include <algorithm>
#include <iostream>
#include <memory>

#include "farm/program/commands.h"
#include "farm/program/farm_option.h"
#include "io/command_line/exit_code.h"

namespace coapt {
namespace {

struct InitArguments {
  FarmOption farm;
  std::string team;
  bool json = false;
};

/// Names of roles end after 63 bytes; the prefix has 11.
std::string team_problem(const std::string& team) {
  const auto is_plain = [](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || letter == '_';
  };
  const bool accepted =
      !team.empty() && team.size() <= 40 && std::all_of(team.begin(), team.end(), is_plain);
  return accepted ? "" : "is " + team + ", must be 1 to 40 of a to z, 0 to 9 and _";
}

int init(const InitArguments& arguments) {
  Expected<Connection> connection = Connection::open(arguments.farm.url);
  if (!connection) return report_farm_errors(connection.errors());
  if (const Errors errors = init_farm(*connection, arguments.team); !errors.empty())
    return report_farm_errors(errors);
  if (arguments.json)
    std::cout << "{\"database\": true, \"team\": \"" << arguments.team << "\"}\n";
  else
    std::cout << connection->where() << ": the farm is ready"
              << (arguments.team.empty()
                      ? ""
                      : "; grant the role to logins of the team: GRANT coapt_team_" +
                            arguments.team + " TO ...")
              << '\n';
  return exit_code::kOk;
}

}  // namespace

void add_init(Command parent, int& status) {
  const auto arguments = std::make_shared<InitArguments>();
  Command command = parent.add_command("init", "Create a farm in a database");
  add_farm_option(command, arguments->farm);
  command
      .add_option("--team", arguments->team,
                  "Also create the role of a team, whose runs are reserved for its members")
      .check({team_problem, "NAME"});
  command.add_flag("--json", arguments->json, "Print JSON");
  command.footer(
      "Creates tables, functions and the roles coapt_coordinator, coapt_worker and coapt_reader; "
      "may be\nrun again. The login needs the privilege to create schemas and roles "
      "(CREATEROLE).\n\n"
      "Examples:\n"
      "  coapt-farm init --db 'postgresql:///farm?host=/run/postgresql'\n"
      "  coapt-farm init --db postgresql://boss@db.example/farm --team cardiology");
  command.on_run([arguments, &status] { status = init(*arguments); });
}

}  // namespace coapt
