#include <vector>

#include "operations/table.h"

namespace coapt {

std::span<const Operation> operations() {
  static const std::vector<Operation> kOperations = [] {
    const std::span<const Operation> on_a_valve = valve_operations();
    std::vector<Operation> all(on_a_valve.begin(), on_a_valve.end());
    all.push_back(
        {"evaluate", "/v1/evaluations", "Scores and ranks plans of one's own.", read_evaluate});
    all.push_back(
        {"report", "/v1/reports", "Writes the report on plans of one's own.", read_report});
    all.push_back({"prefer", "/v1/preferences",
                   "Learns the weights of the cost from comparisons of plans.", read_prefer});
    all.push_back({"physiology", "/v1/physiology",
                   "Sets loads, strains, rings and openings beside what was measured in hearts.",
                   read_physiology});
    all.push_back(
        {"export", "/v1/exports", "Closes a valve and writes it as a file.", read_export});
    all.push_back({"picture", "/v1/pictures", "Closes a valve and draws it.", read_picture});
    return all;
  }();
  return kOperations;
}

}  // namespace coapt
