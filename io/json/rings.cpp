#include "io/json/rings.h"

#include "io/json/json_reader.h"
#include "io/json/plan_json.h"

namespace coapt {
namespace {

RingShape read_ring(const JsonPlace& place) {
  RingShape ring;
  const auto number = [](double& target, Range range) {
    return into(target, [range](const JsonPlace& share) { return read_number_in(share, range); });
  };
  read_fields(place, {{"name", into(ring.name, read_string)},
                      {"ap_over_transverse", number(ring.ap_over_transverse, {0.3, 1.0})},
                      {"transverse_factor", number(ring.transverse_factor, {0.5, 1.5})},
                      {"saddle_over_transverse", number(ring.saddle_over_transverse, {0.0, 0.5})},
                      {"note", into(ring.note, read_string)}});
  return ring;
}

}  // namespace

Expected<std::vector<RingShape>> read_rings(std::string_view text) {
  const auto json = parse_json(text);
  if (!json) return json.errors();
  ProblemList problems;
  std::vector<RingShape> rings;
  read_fields({*json, problems},
              {{"schema", [](const JsonPlace& place) { read_schema(place, "coapt.rings/1"); }},
               {"rings", [&](const JsonPlace& place) { rings = read_list(place, read_ring); }}});
  if (!problems.empty()) return std::move(problems).take();
  return rings;
}

const std::vector<RingShape>& ring_catalogue() {
  static const std::vector<RingShape> catalogue = *read_rings(rings_text());
  return catalogue;
}

}  // namespace coapt
