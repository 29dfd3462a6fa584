#include "io/json/search_options_json.h"

#include <type_traits>
#include <variant>
#include <vector>

#include "io/json/json_reader.h"
#include "io/json/plan_json.h"
#include "io/json/ring_json.h"
#include "search/plans/search_option_table.h"

namespace coapt {
namespace {

constexpr std::size_t kMostForbidden = 100;  // there are fewer to forbid

template <class Options>
JsonField option_field(const OptionRow<Options>& row, Options& options) {
  return std::visit(
      [&]<class Value>(Value Options::*member) -> JsonField {
        const auto read = [&](const JsonPlace& place) -> Value {
          if constexpr (std::is_same_v<Value, bool>) {
            return read_boolean(place);
          } else if constexpr (std::is_same_v<Value, double>) {
            return read_number_in(place, row.range, row.unit);
          } else if constexpr (std::is_same_v<Value, int>) {
            return read_integer_in(place, static_cast<int>(row.range.min),
                                   static_cast<int>(row.range.max));
          } else {
            return read_unsigned(place);
          }
        };
        return {row.name, into(options.*member, read), false};
      },
      row.member);
}

template <class Options>
void add_option_fields(std::vector<JsonField>& fields, std::span<const OptionRow<Options>> rows,
                       Options& options) {
  for (const OptionRow<Options>& row : rows) fields.push_back(option_field(row, options));
}

template <class Options>
void write_options(Json& json, std::span<const OptionRow<Options>> rows, const Options& options) {
  for (const OptionRow<Options>& row : rows)
    std::visit([&](auto member) { json[row.name] = options.*member; }, row.member);
}

std::vector<std::string> read_words(const JsonPlace& place) {
  if (place.value.is_array() && place.value.size() > kMostForbidden) {
    add_problem(place, ErrorCode::OutOfRange,
                "has " + std::to_string(place.value.size()) + " words, must have at most " +
                    std::to_string(kMostForbidden));
    return {};
  }
  return read_list(place, read_string);
}

std::vector<DesignedShape> read_shapes(const JsonPlace& place) {
  if (place.value.is_array() && place.value.size() > kMostShapes) {
    add_problem(place, ErrorCode::OutOfRange,
                "has " + std::to_string(place.value.size()) + " shapes, must have at most " +
                    std::to_string(kMostShapes));
    return {};
  }
  return read_list(place, read_designed_shape);
}

SearchRules read_rules(const JsonPlace& place) {
  SearchRules rules;
  std::vector<JsonField> fields = {{"fixed", into(rules.fixed, read_plan_within), false},
                                   {"forbidden", into(rules.forbidden, read_words), false},
                                   {"shapes", into(rules.shapes, read_shapes), false}};
  add_option_fields(fields, search_rule_rows(), rules);
  read_fields(place, fields);
  return rules;
}

Json rules_json(const SearchRules& rules) {
  Json json = {{"fixed", to_json(rules.fixed)}, {"forbidden", rules.forbidden}};
  for (const DesignedShape& shape : rules.shapes) json["shapes"].push_back(to_json(shape));
  write_options(json, search_rule_rows(), rules);
  return json;
}

}  // namespace

CostWeights read_cost_weights(const JsonPlace& place) {
  CostWeights weights;
  std::vector<JsonField> fields;
  add_option_fields(fields, cost_weight_rows(), weights);
  read_fields(place, fields);
  return weights;
}

Expected<SearchOptions> search_options_from_json(const Json& json) {
  ProblemList problems;
  SearchOptions options;
  std::vector<JsonField> fields;
  add_option_fields(fields, search_option_rows(), options);
  fields.push_back({"rules", into(options.rules, read_rules), false});
  fields.push_back({"weights", into(options.weights, read_cost_weights), false});
  read_fields({json, problems}, fields);
  if (!problems.empty()) return std::move(problems).take();
  return options;
}

Json to_json(const SearchOptions& options) {
  Json json;
  write_options(json, search_option_rows(), options);
  json["rules"] = rules_json(options.rules);
  json["weights"] = to_json(options.weights);
  return json;
}

Json to_json(const CostWeights& weights) {
  Json json;
  write_options(json, cost_weight_rows(), weights);
  return json;
}

}  // namespace coapt
