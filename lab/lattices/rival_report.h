// What `coapt-lab bench search` says of the search and its rivals.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "io/json/json.h"
#include "lab/lattices/lattice_findings.h"
#include "lab/rivals/ert.h"

namespace coapt {

/// How the product, with its defaults, does on one lattice.
struct Hits {
  std::string lattice;
  std::size_t plans = 0;
  int runs = 0, optimum = 0, top_percent = 0;
  double regret_mean = 0.0, regret_worst = 0.0;
};

Json to_json(const Hits& hits);
Json to_json(const LatticeFindings& findings);
Json to_json(const std::vector<rivals::Ert>& rows);

void print_hits(std::ostream& out, const std::vector<Hits>& hits);
void print_times(std::ostream& out, const std::vector<rivals::Ert>& rows);

/// "method,closures,share": shares of targets reached within so many closures, of the search, random search and the
/// best four others at 0.2 mm2: more curves nobody can tell apart.
std::string ecdf_csv(const std::vector<rivals::MeasuredRun>& runs,
                     const std::vector<rivals::Ert>& rows);

}  // namespace coapt
