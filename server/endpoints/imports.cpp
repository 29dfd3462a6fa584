#include "server/endpoints/imports.h"

#include "io/exchange/decisions_json.h"
#include "server/content_id.h"
#include "server/endpoints/valves.h"
#include "server/form_body.h"

namespace coapt {
namespace {

/// What the reader answers, as long as somebody waits for it.
Answer read(const ImportReader& reader, ImportStep step, const std::string& body,
            Context& context) {
  std::optional<Answer> answer =
      reader(step, body, context.budget(), reader.limits.request_seconds + 1.0);
  return answer ? *std::move(answer) : refusal({context.refusal()});
}

/// `answer(body, context)` in the turn of the request, with its body as JSON: a form is read where files are.
template <class MakeAnswer>
Answer answer_import(const ImportReader& reader, Compute& compute, const Request& request,
                     const MakeAnswer& answer) {
  const std::string type = header(request, "content-type");
  return answer_in_turn(compute, reader.limits, request, kImport_s, [&](Context& context) {
    if (!is_form(type)) return answer(request.body, context);
    const Answer form = read(reader, ImportStep::Form, type + '\n' + request.body, context);
    return form.status == 200 ? answer(std::get<Content>(form.body).bytes, context) : form;
  });
}

}  // namespace

Answer ImportValve::operator()(const Request& request) const {
  const auto store_import = [&](const std::string& body, Context& context) {
    Answer answer = read(reader, ImportStep::Valve, body, context);
    if (answer.status != 200) return answer;
    const Expected<Json> document = answer_document(answer);
    if (!document) return problem(422, document.errors());
    const Expected<ImportedValve> made = import_from(*document);
    if (!made) return problem(422, made.errors());
    return store_valve(store, reader.limits, made->valve,
                       {{"decisions", to_json(made->decisions)}});
  };
  return answer_import(reader, compute, request, store_import);
}

Answer PostImports::operator()(const Request& request) const {
  std::optional<Valve> valve;
  bool has_fit = false;
  std::string input;
  const Answer refused =
      answer_import(reader, compute, request, [&](const std::string& body, Context& context) {
        Answer answer = read(reader, ImportStep::Submission, body, context);
        if (answer.status != 200) return answer;
        const Expected<Json> document = answer_document(answer);
        if (!document) return problem(422, document.errors());
        Expected<ImportedValve> made = import_from(*document);
        if (!made) return problem(422, made.errors());
        valve = std::move(made->valve);
        has_fit = document->value("fit", false);
        input = body;
        return answer;
      });
  if (!valve) return refused;
  return submit(submitting, request,
                {"import", *valve, {{"files", content_id(input)}, {"fit", has_fit}}, input});
}

Answer PreviewImport::operator()(const Request& request) const {
  return answer_import(reader, compute, request, [this](const std::string& body, Context& context) {
    return read(reader, ImportStep::Preview, body, context);
  });
}

}  // namespace coapt
