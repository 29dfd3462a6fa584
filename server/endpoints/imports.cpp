#include "server/endpoints/imports.h"

#include "io/exchange/decisions_json.h"
#include "server/content_id.h"
#include "server/endpoints/valves.h"

namespace coapt {
namespace {

/// What the reader answers, as long as somebody waits for it.
Answer read(const ImportReader& reader, ImportStep step, const Request& request, Context& context) {
  std::optional<Answer> answer =
      reader(step, request.body, context.budget(), reader.limits.request_seconds + 1.0);
  return answer ? *std::move(answer) : refusal({context.refusal()});
}

}  // namespace

Answer ImportValve::operator()(const Request& request) const {
  return answer_in_turn(compute, reader.limits, request, kImport_s, [&](Context& context) {
    Answer answer = read(reader, ImportStep::Valve, request, context);
    if (answer.status != 200) return answer;
    const Expected<ImportedValve> made = import_from(answer_document(answer));
    if (!made) return problem(422, made.errors());
    return store_valve(store, reader.limits, made->valve,
                       {{"decisions", to_json(made->decisions)}});
  });
}

Answer PostImports::operator()(const Request& request) const {
  std::optional<Valve> valve;
  bool has_fit = false;
  const Answer refused =
      answer_in_turn(compute, reader.limits, request, kImport_s, [&](Context& context) {
        Answer answer = read(reader, ImportStep::Submission, request, context);
        if (answer.status != 200) return answer;
        const Json document = answer_document(answer);
        Expected<ImportedValve> made = import_from(document);
        if (!made) return problem(422, made.errors());
        valve = std::move(made->valve);
        has_fit = document.value("fit", false);
        return answer;
      });
  if (!valve) return refused;
  return submit(
      submitting, request,
      {"import", *valve, {{"files", content_id(request.body)}, {"fit", has_fit}}, request.body});
}

Answer PreviewImport::operator()(const Request& request) const {
  return answer_in_turn(compute, reader.limits, request, kImport_s, [&](Context& context) {
    return read(reader, ImportStep::Preview, request, context);
  });
}

}  // namespace coapt
