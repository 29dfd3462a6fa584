#include "server/endpoints/exports.h"

#include "core/closure/closure.h"
#include "io/picture/picture.h"
#include "server/answers.h"
#include "server/repair_request.h"

namespace coapt {
namespace {

const FileFormat* read_format(const JsonPlace& place) {
  std::vector<std::string> names;
  for (const FileFormat& format : file_formats()) names.push_back(format.name);
  const auto choice = read_choice(place, names);
  return choice ? &file_formats()[*choice] : nullptr;
}

ExportFrame read_frame(const JsonPlace& place) {
  return read_choice(place, {"patient", "valve"}).value_or(0) == 0 ? ExportFrame::Patient
                                                                   : ExportFrame::Valve;
}

/// The header that says whether what is shown of a closed valve counts.
std::pair<std::string, std::string> closure_header(const ClosureResult& closure) {
  return {"Coapt-Closure", closure.crossing ? "crossing" : to_string(closure.status)};
}

}  // namespace

Answer PostExports::operator()(const Request& request) const {
  const FileFormat* format = nullptr;
  ExportOptions options;
  return answer_repair(valves, compute, request,
                       {{"format", into(format, read_format)},
                        {"open", into(options.open, read_boolean), false},
                        {"frame", into(options.frame, read_frame), false}},
                       [&](const RepairRequest& asked, RequestClosures& closures) {
                         return valve_file_answer(with_repair(closures.close_and_measure(
                                                                  asked.repaired, {.motion = true}),
                                                              asked.valve, asked.plan),
                                                  *format, options);
                       });
}

Answer PostPictures::operator()(const Request& request) const {
  return answer_repair(
      valves, compute, request, {}, [](const RepairRequest& asked, RequestClosures& closures) {
        const ClosedValve closed =
            with_repair(closures.close_and_measure(asked.repaired), asked.valve, asked.plan);
        return Answer{200,
                      Content{"image/png", closure_picture_png(closed)},
                      {closure_header(closed.closure)}};
      });
}

Answer valve_file_answer(const ClosedValve& exported, const FileFormat& format,
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
