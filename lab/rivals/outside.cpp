// coapt-rivals: the rivals that may not be in a process of coapt. pagmo, because any AVX code beside
// Debian's libpagmo corrupts the heap (Eigen aligns differently); dlib, which comes with BLAS; COBYLA
// of NLopt, because it can hang. A run that is silent for a minute is killed by a signal, and what it
// found until then is written.
//
//     coapt-rivals LATTICE_FILE METHOD SEED BUDGET     prints method,seed,evaluations,cost, and at the
//                                                      end method,seed,evaluations,end
//     coapt-rivals --list                              prints the methods
//     coapt-rivals --front FILE ... METHOD SEED BUDGET a file for each objective, METHOD pagmo_nsga2 or pagmo_moead: prints
//                                                      the combination of each plan asked for, in order
#if defined(__AVX__) || defined(__SANITIZE_ADDRESS__)
#error "Eigen would allocate unlike Debian's libpagmo: no -march=native, -mavx, -fsanitize=address"
#endif

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "lab/rivals/dlib_rival.h"
#include "lab/rivals/nlopt_rivals.h"
#include "lab/rivals/pagmo_fronts.h"
#include "lab/rivals/pagmo_rivals.h"
#include "lab/rivals/rivals.h"

namespace coapt::rivals {
namespace {

constexpr const char* kCobyla = "cobyla";
constexpr unsigned kLongestSilence_s = 60;  ///< the slowest call of all, of dlib, is a second

std::vector<std::string> names() {
  std::vector<std::string> all = pagmo_rival_names();
  all.insert(all.end(), {kDlibRival, kCobyla});
  return all;
}

void search(const std::string& method, const RivalProblem& problem, const SharesCost& cost) {
  const SharesCost watched = [&](const std::vector<double>& shares) {
    alarm(kLongestSilence_s);
    return cost(shares);
  };
  if (method == kDlibRival) return search_by_dlib(problem, watched);
  if (method == kCobyla) return search_by_nlopt(method, problem, watched);
  search_by_pagmo(method, problem, watched);
}

template <class T>
std::optional<T> whole_number(std::string_view text, T most) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value > most) return std::nullopt;
  return value;
}

int fail(const std::string& message) {
  std::fprintf(stderr, "coapt-rivals: %s\n", message.c_str());
  return 2;
}

Expected<LatticeTable> lattice_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) return Error{ErrorCode::InputOutput, "", path + ": cannot be read"};
  Expected<LatticeTable> table = read_lattice(text);
  if (!table) return Error{table.errors()[0].code, "", path + ": " + table.errors()[0].message};
  return table;
}

/// SEED and BUDGET.
template <class Settings>
std::optional<std::string> read_numbers(std::span<char* const> two, Settings& settings) {
  const auto seed = whole_number<std::uint64_t>(two[0], std::numeric_limits<std::uint64_t>::max());
  if (!seed) return "SEED is 0 to 2^64 - 1";
  const auto budget = whole_number<unsigned>(two[1], unsigned{kMostCombinations});
  if (!budget) return "BUDGET is 0 to " + std::to_string(kMostCombinations);
  settings.seed = *seed;
  settings.budget = static_cast<int>(*budget);
  return std::nullopt;
}

int run_front(std::span<char* const> arguments) {
  if (arguments.size() < 5) return fail("--front FILE FILE ... METHOD SEED BUDGET");
  std::vector<LatticeTable> objectives;
  for (char* const path : arguments.first(arguments.size() - 3)) {
    Expected<LatticeTable> table = lattice_of(path);
    if (!table) return fail(table.errors()[0].message);
    objectives.push_back(*std::move(table));
    if (objectives.back().variables != objectives[0].variables ||
        objectives.back().plans != objectives[0].plans)
      return fail(std::string(path) + ": other variables or plans than the first file");
  }
  FrontRivalSettings settings;
  settings.method = arguments[arguments.size() - 3];
  const std::vector<std::string> all = pagmo_front_names();
  if (std::find(all.begin(), all.end(), settings.method) == all.end())
    return fail("METHOD is pagmo_nsga2 or pagmo_moead");
  if (const auto problem = read_numbers(arguments.last(2), settings)) return fail(*problem);
  settings.on_plan = [](std::size_t combination) { std::printf("%zu\n", combination); };
  search_front_by_pagmo(objectives, settings);
  return 0;
}

int run(std::span<char* const> arguments) {
  if (arguments.size() == 1 && std::string_view(arguments[0]) == "--list") {
    for (const std::string& name : names()) std::puts(name.c_str());
    return 0;
  }
  if (!arguments.empty() && std::string_view(arguments[0]) == "--front")
    return run_front(arguments.subspan(1));
  if (arguments.size() != 4) return fail("LATTICE_FILE METHOD SEED BUDGET, --front, or --list");
  const Expected<LatticeTable> table = lattice_of(arguments[0]);
  if (!table) return fail(table.errors()[0].message);

  RivalSettings settings;
  settings.method = arguments[1];
  const std::vector<std::string> all = names();
  if (std::find(all.begin(), all.end(), settings.method) == all.end())
    return fail("METHOD is one of those of --list");
  if (const auto problem = read_numbers(arguments.last(2), settings)) return fail(*problem);
  settings.on_improvement = [&](const Improvement& i) {
    std::printf("%s,%s,%d,%.17g\n", settings.method.c_str(), arguments[2], i.evaluations, i.cost);
    std::fflush(stdout);
  };
  const RivalRun result = run_rival(*table, settings, [&](const auto& problem, const auto& cost) {
    search(settings.method, problem, cost);
  });
  std::printf("%s,%s,%d,end\n", settings.method.c_str(), arguments[2], result.evaluations);
  std::fprintf(stderr, "%d evaluations, %d calls\n", result.evaluations, result.calls);
  return 0;
}

}  // namespace
}  // namespace coapt::rivals

int main(int argc, char** argv) {
  try {
    return coapt::rivals::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    return coapt::rivals::fail(error.what());
  }
}
