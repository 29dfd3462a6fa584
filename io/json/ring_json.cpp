#include "io/json/ring_json.h"

#include "io/json/parse_json.h"

namespace coapt {
namespace {

void read_provenance(const JsonPlace& place) {
  if (!place.value.is_object()) add_problem(place, ErrorCode::WrongType, "must be an object");
}

}  // namespace

Json to_json(const DesignedShape& shape) {
  Json json = {{"name", shape.name}};
  for (const RingTermRow& row : kRingTerms) json[row.name] = shape.terms.*row.member;
  return json;
}

DesignedShape read_designed_shape(const JsonPlace& place) {
  DesignedShape shape;
  std::vector<JsonField> fields = {{"name", into(shape.name, read_string)}};
  for (const RingTermRow& row : kRingTerms)
    fields.push_back({row.name, into(shape.terms.*row.member, [&row](const JsonPlace& term) {
                        return read_number_in(term, row.range);
                      })});
  read_fields(place, fields);
  return shape;
}

Json to_json(const RingDesign& design, const Json& provenance) {
  Json json = {{"schema", "coapt.ring/1"},
               {"ring", to_json(design.shape)},
               {"sizing", {{"width_over_transverse", design.width_over_transverse}}}};
  if (!provenance.empty()) json["provenance"] = provenance;
  return json;
}

Expected<RingDesign> ring_from_json(const Json& json) {
  ProblemList problems;
  RingDesign design;
  const auto read_sizing = [&](const JsonPlace& sizing) {
    read_fields(sizing, {{"width_over_transverse",
                          into(design.width_over_transverse, [](const JsonPlace& share) {
                            return read_number_in(share, kRingWidthShares);
                          })}});
  };
  read_fields({json, problems},
              {{"schema", [](const JsonPlace& schema) { read_schema(schema, "coapt.ring/1"); }},
               {"ring", into(design.shape, read_designed_shape)},
               {"sizing", read_sizing},
               {"provenance", read_provenance, false}});
  if (!problems.empty()) return std::move(problems).take();
  if (Errors errors = check_ring_design(design); !errors.empty()) return errors;
  return design;
}

Expected<RingDesign> read_ring(std::string_view text) {
  const auto json = parse_json(text);
  if (!json) return json.errors();
  return ring_from_json(*json);
}

}  // namespace coapt
