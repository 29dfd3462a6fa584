#include "server/jobs/study_request.h"

#include <algorithm>
#include <cmath>

namespace coapt {
namespace {

constexpr std::array kDisplacementSteps_mm = {1.0, 2.0, 3.0, 6.0};  // divisors of 6 mm

double read_step(const JsonPlace& place) {
  const double step = read_number(place);
  if (std::isnan(step)) return step;  // is no number, which has been said
  if (std::find(kDisplacementSteps_mm.begin(), kDisplacementSteps_mm.end(), step) ==
      kDisplacementSteps_mm.end())
    add_problem(place, ErrorCode::OutOfRange, "must be 1, 2, 3 or 6 mm");
  return step;
}

std::vector<Protocol> read_protocols(const JsonPlace& place) {
  const std::vector<Protocol> all(kProtocols.begin(), kProtocols.end());
  std::vector<Protocol> protocols =
      read_list(place, [&](const JsonPlace& entry) { return read_name(entry, all); });
  if (place.value.is_array() && protocols.empty())
    add_problem(place, ErrorCode::OutOfRange, "is empty, must hold a protocol");
  std::vector<Protocol> each;
  for (const Protocol protocol : protocols)
    if (std::find(each.begin(), each.end(), protocol) == each.end()) each.push_back(protocol);
  return each;
}

}  // namespace

StudyRequest read_study(const JsonPlace& place) {
  StudyRequest request;
  if (const std::optional<JsonPlace> name = read_member(place, "name")) {
    const std::vector<StudyKind> kinds(kStudyKinds.begin(), kStudyKinds.end());
    request.kind = read_name(*name, kinds);
  } else {
    return request;
  }
  request.options = default_options(request.kind);
  ThesisStudyOptions& options = request.options;
  const auto name_was_read = [](const JsonPlace&) {};
  if (request.kind != StudyKind::Approximation && request.kind != StudyKind::Thesis) {
    read_fields(place, {{"name", name_was_read}});
    return request;
  }
  const auto integer = [](int min, int max) {
    return [=](const JsonPlace& one) { return read_integer_in(one, min, max); };
  };
  read_fields(
      place,
      {{"name", name_was_read},
       {"protocols", into(options.protocols, read_protocols), false},
       {"displacement_step_mm", into(options.approximation.displacement_step_mm, read_step), false},
       {"region_points", into(options.approximation.region_points, integer(17, 1089)), false},
       {"scan_sites", into(options.scan_sites, integer(0, 360)), false}});
  return request;
}

Json to_json(const StudyRequest& request) {
  const ThesisStudyOptions& options = request.options;
  Json json = {{"name", to_string(request.kind)}};
  if (request.kind != StudyKind::Approximation && request.kind != StudyKind::Thesis) return json;
  for (const Protocol protocol : options.protocols)
    json["protocols"].push_back(to_string(protocol));
  json["displacement_step_mm"] = options.approximation.displacement_step_mm;
  json["region_points"] = options.approximation.region_points;
  json["scan_sites"] = options.scan_sites;
  return json;
}

}  // namespace coapt
