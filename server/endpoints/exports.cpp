#include "server/endpoints/exports.h"

#include "core/closure/closure.h"
#include "io/json/plan_json.h"
#include "io/picture/picture.h"
#include "server/answers.h"

namespace coapt {
namespace {

const FileFormat* read_format(const JsonPlace& place) {
  std::vector<std::string> names;
  for (const FileFormat& format : file_formats()) names.push_back(format.name);
  const auto choice = read_choice(place, names);
  return choice ? &file_formats()[*choice] : nullptr;
}

/// The header that says whether what is shown of a closed valve counts.
std::pair<std::string, std::string> closure_header(const ClosureResult& closure) {
  return {"Coapt-Closure", closure.crossing ? "crossing" : to_string(closure.status)};
}

}  // namespace

Answer PostExports::operator()(const Request& request) const {
  Valve valve;
  RepairPlan plan;
  const FileFormat* format = nullptr;
  ExportOptions options;
  if (auto refused = read_body(valves.parsing, request.body,
                               {{"valve", valve_field(valves, valve)},
                                {"plan", document(plan, plan_from_json), false},
                                {"format", into(format, read_format)},
                                {"open", into(options.open, read_boolean), false}}))
    return *std::move(refused);
  const Expected<Valve> repaired = repaired_valve(valve, plan, rings);
  if (!repaired) return problem(422, repaired.errors());
  const Compute::Turn turn(compute);
  if (!turn) return too_busy();
  return valve_file_answer(close_for_export(*repaired, plan), *format, options);
}

Answer PostPictures::operator()(const Request& request) const {
  Valve valve;
  RepairPlan plan;
  if (auto refused = read_body(
          valves.parsing, request.body,
          {{"valve", valve_field(valves, valve)}, {"plan", document(plan, plan_from_json), false}}))
    return *std::move(refused);
  const Expected<Valve> repaired = repaired_valve(valve, plan, rings);
  if (!repaired) return problem(422, repaired.errors());
  const Compute::Turn turn(compute);
  if (!turn) return too_busy();
  const ClosureResult closure = close_valve(*repaired, {.samples = kThesisSamples});
  const RepairMarks marks = repair_marks(valve, *repaired, plan);
  return {200,
          Content{"image/png",
                  closure_picture_png({*repaired, closure, measure(*repaired, closure), marks})},
          {closure_header(closure)}};
}

Answer valve_file_answer(const ExportedValve& exported, const FileFormat& format,
                         const ExportOptions& options) {
  Expected<std::string> bytes = write_valve_file(exported, format, options);
  if (!bytes) return problem(422, bytes.errors());
  return {
      200,
      Content{format.media_type, *std::move(bytes)},
      {{"Content-Disposition", std::string("attachment; filename=\"valve.") + format.name + '"'},
       closure_header(exported.closure)}};
}

}  // namespace coapt
