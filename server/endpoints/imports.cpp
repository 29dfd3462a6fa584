#include "server/endpoints/imports.h"

#include "io/exchange/decisions_json.h"
#include "io/exchange/import_files.h"
#include "io/exchange/slicerheart.h"
#include "server/answers.h"
#include "server/base64.h"
#include "server/endpoints/valves.h"

namespace coapt {
namespace {

constexpr std::size_t kLongestName = 200;

struct Asked {
  std::optional<std::vector<NamedFile>> leaflets, slicerheart;
  std::optional<NamedFile> annulus, chordae, tips;
  std::string name = "imported";
  std::vector<std::string> provenance;
  ImportOptions options;
};

NamedFile read_file(const JsonPlace& place) {
  NamedFile file;
  std::optional<std::string> text, base64;
  read_fields(place, std::vector<JsonField>{{"name", into(file.name, read_string)},
                                            {"text", into(text, read_string), false},
                                            {"base64", into(base64, read_string), false}});
  if (text.has_value() == base64.has_value()) {
    add_problem(place, ErrorCode::MissingField, "must have either text or base64");
  } else if (text) {
    file.bytes = *std::move(text);
  } else if (std::optional<std::string> bytes = decoded_base64(*base64)) {
    file.bytes = *std::move(bytes);
  } else {
    add_problem(place, ErrorCode::OutOfRange, "base64 has other characters than those of base64");
  }
  return file;
}

std::vector<NamedFile> read_files(const JsonPlace& place) { return read_list(place, read_file); }

std::string read_short_text(const JsonPlace& place) {
  std::string name = read_string(place);
  if (name.size() > kLongestName)
    add_problem(place, ErrorCode::OutOfRange, "is longer than 200 bytes");
  return name;
}

std::vector<std::string> read_short_texts(const JsonPlace& place) {
  return read_list(place, read_short_text);
}

TissueReference read_state(const JsonPlace& place) {
  return read_name<TissueReference>(place, {TissueReference::Excised, TissueReference::InVivo});
}

LengthUnit read_unit(const JsonPlace& place) {
  return read_name<LengthUnit>(place,
                               {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Metre});
}

/// Either all of one kind of files or all of the other; chordae that were seen, or a seed of those to be drawn.
Errors check_files(const Asked& asked) {
  ProblemList problems;
  for (const auto& [given, path] : {std::pair(asked.leaflets.has_value(), "/leaflets"),
                                    {asked.annulus.has_value(), "/annulus"}}) {
    if (given && asked.slicerheart)
      problems.add(ErrorCode::UnknownField, path, "cannot be given together with slicerheart");
  }
  if (!asked.leaflets && !asked.slicerheart)
    problems.add(ErrorCode::MissingField, "/leaflets", "is missing (or give slicerheart)");
  const bool drawn = asked.options.chordae_seed.has_value();
  if (asked.chordae && asked.slicerheart)
    problems.add(ErrorCode::UnknownField, "/chordae", "cannot be given together with slicerheart");
  if (asked.chordae && drawn)
    problems.add(ErrorCode::UnknownField, "/chordae_seed",
                 "cannot be given together with chordae: it draws those that were not seen");
  if (!asked.chordae && !drawn && !asked.slicerheart)
    problems.add(ErrorCode::MissingField, "/chordae",
                 "is missing (or give chordae_seed, which draws them, or slicerheart)");
  if (asked.tips && asked.slicerheart)
    problems.add(ErrorCode::UnknownField, "/tips",
                 "cannot be given together with slicerheart: they are among its files");
  else if (asked.tips && !drawn)
    problems.add(ErrorCode::UnknownField, "/tips",
                 "needs chordae_seed: chordae that were seen begin at their tips");
  if (asked.leaflets && (asked.leaflets->empty() || asked.leaflets->size() > 2))
    problems.add(ErrorCode::OutOfRange, "/leaflets",
                 "has " + std::to_string(asked.leaflets->size()) +
                     " files, must have 1 (a skirt) or 2 (the anterior, then the posterior sheet)");
  return std::move(problems).take();
}

/// With what a file of a folder is called in the message: its pointer is that of the list.
Errors below_folder(Errors errors) {
  for (Error& error : errors) {
    if (!error.path.empty()) error.message = error.path + ": " + error.message;
    error.path = "/slicerheart";
  }
  return errors;
}

Expected<ImportedValve> imported(const Asked& asked) {
  Expected<ImportSource> source =
      asked.slicerheart
          ? read_slicerheart(*asked.slicerheart)
          : read_import_files({*asked.leaflets, asked.annulus, asked.chordae, asked.tips});
  if (!source) return asked.slicerheart ? below_folder(source.errors()) : source.errors();
  source->name = asked.name;
  source->provenance.insert(source->provenance.begin(), asked.provenance.begin(),
                            asked.provenance.end());
  Expected<ImportedValve> done = import_with_decisions(*source, asked.options);
  if (done) return done;
  Errors errors = done.errors();
  for (Error& error : errors)
    for (const std::string given : {"/annulus", "/tips"})
      if (error.path.starts_with(given + "_mm")) error.path.erase(given.size(), 3);
  return asked.slicerheart ? below_folder(std::move(errors)) : errors;
}

}  // namespace

Answer ImportValve::operator()(const Request& request) const {
  Asked asked;
  ImportOptions& options = asked.options;
  const auto whole = [](int min, int max) {
    return [=](const JsonPlace& place) { return read_integer_in(place, min, max); };
  };
  const auto number = [](double min, double max) {
    return [=](const JsonPlace& place) { return read_number_in(place, {min, max}); };
  };
  if (auto refused =
          read_body(valves, request.body,
                    {{"leaflets", into(asked.leaflets, read_files), false},
                     {"annulus", into(asked.annulus, read_file), false},
                     {"chordae", into(asked.chordae, read_file), false},
                     {"chordae_seed", into(options.chordae_seed, whole(0, 2147483647)), false},
                     {"tips", into(asked.tips, read_file), false},
                     {"closed", into(options.closed, read_boolean), false},
                     {"hidden_mm", into(options.hidden_mm, number(0.0, 15.0)), false},
                     {"slicerheart", into(asked.slicerheart, read_files), false},
                     {"name", into(asked.name, read_short_text), false},
                     {"provenance", into(asked.provenance, read_short_texts), false},
                     {"triangles", into(options.triangles, whole(100, 100'000)), false},
                     {"branches", into(options.branches, whole(1, 5)), false},
                     {"branch_at", into(options.branch_at, number(0.05, 0.95)), false},
                     {"slack", into(options.slack, number(0.8, 1.5)), false},
                     {"reference", into(options.reference, read_state), false},
                     {"units", into(options.units, read_unit), false}}))
    return *std::move(refused);
  if (const Errors errors = check_files(asked); !errors.empty()) return problem(422, errors);
  const Compute::Turn turn(compute);
  if (!turn) return too_busy();
  const Expected<ImportedValve> done = imported(asked);
  if (!done) return problem(422, done.errors());
  if (const Errors errors = check_size(done->valve, valves.limits); !errors.empty())
    return problem(422, errors);
  return store_valve(store, valves.limits, done->valve, {{"decisions", to_json(done->decisions)}});
}

}  // namespace coapt
