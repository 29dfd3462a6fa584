// Gates, found by their rules.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "search/plans/gates.h"

namespace coapt {

inline Gate gate_of(const std::vector<Gate>& gates, const std::string& rule) {
  const auto found = std::find_if(gates.begin(), gates.end(),
                                  [&rule](const Gate& gate) { return gate.rule == rule; });
  EXPECT_NE(found, gates.end()) << rule;
  return found == gates.end() ? Gate{} : *found;
}

inline void expect_gate(const std::vector<Gate>& gates, const std::string& rule,
                        GateSeverity severity, const std::string& part) {
  const Gate gate = gate_of(gates, rule);
  EXPECT_EQ(gate.severity, severity) << rule << ": " << gate.finding;
  EXPECT_NE(gate.finding.find(part), std::string::npos) << rule << ": " << gate.finding;
}

inline std::vector<std::string> rules_of(const std::vector<Gate>& gates) {
  std::vector<std::string> rules;
  for (const Gate& gate : gates) rules.push_back(gate.rule);
  return rules;
}

}  // namespace coapt
