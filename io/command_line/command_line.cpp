#include "io/command_line/command_line.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <iostream>
#include <limits>
#include <sstream>
#include <type_traits>

#include "core/valve/nearest_name.h"
#include "core/valve/printable.h"
#include "io/command_line/exit_code.h"
#include "io/json/build.h"
#include "io/json/version.h"

namespace coapt {
namespace {

template <class T>
Check number_check(T min, T max) {
  std::ostringstream range;
  range.precision(std::numeric_limits<double>::digits10);
  range << "from " << min << " to " << max;
  const std::string kind = std::is_integral_v<T> ? "a whole number " : "a number ";
  const auto problem = [=, accepted = kind + range.str()](const std::string& text) -> std::string {
    T value = {};
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    const bool inside = error == std::errc() && rest == end && value >= min && value <= max;
    return inside ? "" : "is " + text + ", must be " + accepted;
  };
  return {problem, range.str()};
}

/// What the command that was given takes by name: its options and the commands below it.
std::vector<std::string> names_in(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  for (const CLI::App* below : command.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(below->get_name());
  return names;
}

/// Says of each word that no command took what it may have been meant to be.
void suggest(const CLI::App& program) {
  const CLI::App* command = &program;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  for (const std::string& word : program.remaining(true))
    if (const std::string meant = did_you_mean(word.substr(0, word.find('=')), names_in(*command));
        !meant.empty())
      std::cerr << program.get_name() << ": unknown: " << printable(word) << meant << '\n';
}

/// As CLI11's own, which quotes what was given as it is.
int exit_with(const CLI::App& program, const CLI::Error& error) {
  std::ostringstream lines;
  const int code = program.exit(error, std::cout, lines);
  std::cerr << printable_lines(lines.str());
  return code;
}

void end_with(CLI::App& command, const std::string& notice) {
  for (CLI::App* below : command.get_subcommands([](const CLI::App*) { return true; }))
    end_with(*below, notice);
  const std::string footer = command.get_footer();
  command.footer(footer + (footer.empty() ? "" : "\n\n") + notice);
}

}  // namespace

Check number_from(int min, int max) { return number_check(min, max); }
Check number_from(double min, double max) { return number_check(min, max); }
Check number_from(std::uint64_t min, std::uint64_t max) { return number_check(min, max); }

Option& Option::required() {
  option_->required();
  return *this;
}

Option& Option::check(const Check& check) {
  option_->check(CLI::Validator(
      [problem = check.problem](const std::string& argument) { return problem(argument); },
      check.accepted, ""));
  return *this;
}

Option& Option::one_of(const std::vector<std::string>& accepted) {
  option_->check(CLI::IsMember(accepted));
  return *this;
}

Option& Option::one_of(const std::vector<double>& accepted) {
  option_->check(CLI::IsMember(accepted));
  return *this;
}

Option& Option::count(int min, int max) {
  option_->expected(min, max);
  return *this;
}

Option& Option::one_at_a_time() {
  option_->allow_extra_args(false);
  return *this;
}

Option& Option::split_at(char delimiter) {
  option_->delimiter(delimiter);
  return *this;
}

Option& Option::excludes(const std::string& name) {
  option_->excludes(name);
  return *this;
}

Option& Option::needs(const Option& other) {
  option_->needs(other.option_);
  return *this;
}

Option& Option::environment(const std::string& variable) {
  option_->envname(variable);
  return *this;
}

Option& Option::show_default() {
  option_->capture_default_str();
  return *this;
}

Option& Option::show_default(const std::string& text) {
  option_->default_str(text);
  return *this;
}

Option& Option::show_argument(const std::string& text) {
  option_->option_text(text);
  return *this;
}

Option& Option::group(const std::string& heading) {
  option_->group(heading);
  return *this;
}

Command Command::add_command(const std::string& name, const std::string& what) {
  return Command(*app_->add_subcommand(name, what));
}

Command Command::add_hidden_command(const std::string& name) {
  CLI::App* const command = app_->add_subcommand(name)->group("")->prefix_command();
  command->set_help_flag();
  return Command(*command);
}

void Command::require_command() { app_->require_subcommand(1); }

Option Command::add_option(const std::string& names, std::string& value, const std::string& help) {
  return Option(*app_->add_option(names, value, help));
}

Option Command::add_option(const std::string& names, int& value, const std::string& help) {
  return Option(*app_->add_option(names, value, help));
}

Option Command::add_option(const std::string& names, double& value, const std::string& help) {
  return Option(*app_->add_option(names, value, help));
}

Option Command::add_option(const std::string& names, std::uint64_t& value,
                           const std::string& help) {
  return Option(*app_->add_option(names, value, help));
}

Option Command::add_option(const std::string& names, std::optional<double>& value,
                           const std::string& help) {
  return Option(*app_->add_option(names, value, help));
}

Option Command::add_option(const std::string& names, std::vector<std::string>& value,
                           const std::string& help) {
  return Option(*app_->add_option(names, value, help));
}

Option Command::add_option(const std::string& names, std::vector<double>& value,
                           const std::string& help) {
  return Option(*app_->add_option(names, value, help));
}

Option Command::add_flag(const std::string& names, bool& value, const std::string& help) {
  return Option(*app_->add_flag(names, value, help));
}

Option Command::add_choice(const std::string& names, const std::map<std::string, int>& choices,
                           std::function<void(int)> choose, const std::string& help) {
  return Option(*app_->add_option_function<int>(names, std::move(choose), help)
                     ->transform(CLI::CheckedTransformer(choices)));
}

void Command::footer(const std::string& text) { app_->footer(text); }

void Command::on_run(std::function<void()> run) { app_->callback(std::move(run)); }

bool Command::has(const std::string& option) const { return app_->count(option) > 0; }

void Command::refuse_group(const std::string& name, const std::string& heading) const {
  for (const CLI::Option* option : app_->get_options())
    if (option->get_group() == heading && option->count() > 0)
      throw CLI::ExcludesError(name, option->get_name());
}

CommandLine::CommandLine(const std::string& program, const std::string& what)
    : app_(std::make_unique<CLI::App>(what, program)) {
  app_->set_version_flag("--version", [program, app = app_.get()] {
    const CLI::Option* json = app->get_option_no_throw("--json");
    return json != nullptr && json->count() > 0 ? json_text(build_json(program), 2)
                                                : about(program);
  });
}

CommandLine::~CommandLine() = default;

void CommandLine::add_json_of_version() {
  const std::string help = "Print JSON";
  app_->add_flag("--json", help)->needs(app_->get_option("--version"));
}

Command CommandLine::program() { return Command(*app_); }

void CommandLine::end_helps_with(const std::string& notice) { end_with(*app_, notice); }

std::string CommandLine::help() const { return app_->help(); }

std::optional<int> CommandLine::parse(int argc, char** argv) {
  try {
    app_->parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::RequiredError& error) {
    // CLI11 says what is missing before what it does not know, such as a misspelt command.
    const std::vector<std::string> unknown = app_->remaining(true);
    if (!unknown.empty())
      std::cerr << app_->get_name() << ": unknown: " << printable(unknown.front())
                << did_you_mean(unknown.front(), names_in(*app_)) << '\n';
    exit_with(*app_, error);
    return exit_code::kBadInput;
  } catch (const CLI::ParseError& error) {
    const int code = exit_with(*app_, error);
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError)) suggest(*app_);
    return code == 0 ? 0 : exit_code::kBadInput;
  }
}

}  // namespace coapt
