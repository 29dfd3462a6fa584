// The command line of a program: commands, their options and help. CLI11 stands behind this header alone: a source
// that includes it takes seconds longer to compile.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace coapt {

/// What an argument must be besides its type.
struct Check {
  std::function<std::string(const std::string& argument)> problem;  ///< empty: none
  std::string accepted;                                             ///< in the help
};

/// The whole argument must be one number from `min` to `max`; NaN is none, and unsigned numbers do not wrap around.
Check number_from(int min, int max);
Check number_from(double min, double max);
Check number_from(std::uint64_t min, std::uint64_t max);

/// An option or an argument without a name; a copy is the same one.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(&option) {}

  Option& required();
  Option& check(const Check& check);
  Option& one_of(const std::vector<std::string>& accepted);
  Option& one_of(const std::vector<double>& accepted);
  Option& count(int min, int max);  ///< of arguments after one mention of a list's name
  Option& one_at_a_time();          ///< a list's name before each argument
  Option& split_at(char delimiter);
  Option& excludes(const std::string& name);
  Option& needs(const Option& other);
  Option& environment(const std::string& variable);  ///< taken where the option is not given

  Option& show_default();                          ///< in the help: the value that it has now
  Option& show_default(const std::string& text);   ///< the same in words
  Option& show_argument(const std::string& text);  ///< in place of the type, default and check
  Option& group(const std::string& heading);       ///< of the help

 private:
  CLI::Option* option_;
};

/// A command, or the program itself as the one above all; a copy is the same one. What its options are read into must
/// live as long as the CommandLine.
class Command {
 public:
  explicit Command(CLI::App& app) : app_(&app) {}

  Command add_command(const std::string& name, const std::string& what);
  /// Not in the help, and takes whatever follows its name.
  Command add_hidden_command(const std::string& name);
  void require_command();  ///< one of those below must be given

  /// @param names "--seed", "-o,--output", or without a dash "valve", in the order of the line.
  Option add_option(const std::string& names, std::string& value, const std::string& help);
  Option add_option(const std::string& names, int& value, const std::string& help);
  Option add_option(const std::string& names, double& value, const std::string& help);
  Option add_option(const std::string& names, std::uint64_t& value, const std::string& help);
  Option add_option(const std::string& names, std::optional<double>& value,
                    const std::string& help);
  Option add_option(const std::string& names, std::vector<std::string>& value,
                    const std::string& help);
  Option add_option(const std::string& names, std::vector<double>& value, const std::string& help);
  Option add_flag(const std::string& names, bool& value, const std::string& help);
  template <class T>
  Option add_choice(const std::string& names, T& value, const std::map<std::string, T>& choices,
                    const std::string& help);

  /// Below the options in the help.
  void footer(const std::string& text);
  /// `run` is called once the whole line is read, if the line has this command.
  void on_run(std::function<void()> run);

  bool has(const std::string& option) const;  ///< on the line that was read
  /// While running: ends parse() with a usage error if an option below `heading` was given along with `name`.
  void refuse_group(const std::string& name, const std::string& heading) const;

 private:
  Option add_choice(const std::string& names, const std::map<std::string, int>& choices,
                    std::function<void(int)> choose, const std::string& help);

  CLI::App* app_;
};

template <class T>
Option Command::add_choice(const std::string& names, T& value,
                           const std::map<std::string, T>& choices, const std::string& help) {
  std::map<std::string, int> numbers;
  for (const auto& [name, choice] : choices) numbers[name] = static_cast<int>(choice);
  return add_choice(
      names, numbers, [&value](int chosen) { value = static_cast<T>(chosen); }, help);
}

/// Owns a program's commands and reads the arguments of main().
class CommandLine {
 public:
  /// With --version, which prints about(), or build_json() where the program's --json is given, too.
  CommandLine(const std::string& program, const std::string& what);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  Command program();
  /// For programs that have no --json of their own.
  void add_json_of_version();
  /// Every command's help ends in this, those added so far.
  void end_helps_with(const std::string& notice);
  std::string help() const;

  /// Reads the line and runs the command that it names. The program's exit code if that was all: 0 after --help and
  /// --version, 2 after a usage error, which is printed.
  std::optional<int> parse(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace coapt
