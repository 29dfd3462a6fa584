// Results in words, for people; scripts ask for --json. What is printed comes from the JSON, so that it is the
// same whether the work was done here or by a service.
#pragma once

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace coapt {

/// Of coapt.closure/1.
void print_closure(std::ostream& out, const nlohmann::ordered_json& closure);

/// Of coapt.opening/1.
void print_opening(std::ostream& out, const nlohmann::ordered_json& opening);
/// "4.5 cm2, mean gradient 1.0 mmHg at 155 ml/s", or what speaks against that.
std::string opening_in_short(const nlohmann::ordered_json& opening);

/// Of coapt.plans/1: the state before, then one row per plan with its steps and warnings below, then how the search
/// went; "-" where the region is not known. At most 100 columns.
void print_ranked(std::ostream& out, const nlohmann::ordered_json& result);

/// The two plans of a question of coapt.question/1, side by side in at most 100 columns.
void print_question(std::ostream& out, const nlohmann::ordered_json& question);

/// Of coapt.weights/1: what answers say of each price, and of which they say little.
void print_weights(std::ostream& out, const nlohmann::ordered_json& learned);

/// NaN if it is null.
double number_of(const nlohmann::ordered_json& value);

/// Of what has a member "crossing".
const char* crossing_words(const nlohmann::ordered_json& closure);

}  // namespace coapt
