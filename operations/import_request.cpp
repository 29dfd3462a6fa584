#include "operations/import_request.h"

#include "core/valve/patient_frame.h"
#include "core/valve/validate.h"
#include "io/exchange/decisions_json.h"
#include "io/exchange/slicerheart.h"
#include "io/image/detached.h"
#include "io/json/fit_json.h"
#include "io/json/valve_json.h"
#include "io/mesh/csv_table.h"
#include "io/mesh/import_readers.h"
#include "io/mesh/skirt.h"
#include "io/mesh/source_units.h"
#include "io/picture/fit_picture.h"
#include "io/picture/text.h"
#include "io/store/sha256.h"

namespace coapt {
namespace {

constexpr std::size_t kLongestText = 200;

std::vector<NamedFile> read_named_files(const JsonPlace& place) {
  return read_list(place, read_file);
}

std::string read_short_text(const JsonPlace& place) {
  std::string name = read_string(place);
  if (name.size() > kLongestText)
    add_problem(place, ErrorCode::OutOfRange, "is longer than 200 bytes");
  return name;
}

std::vector<std::string> read_short_texts(const JsonPlace& place) {
  return read_list(place, read_short_text);
}

TissueReference read_state(const JsonPlace& place) {
  return read_name<TissueReference>(place, {TissueReference::Excised, TissueReference::InVivo});
}

PatientAxes read_axes(const JsonPlace& place) {
  return read_name<PatientAxes>(place, {PatientAxes::LPS, PatientAxes::RAS});
}

/// One, or several that make a part.
std::vector<int> read_labels_of_part(const JsonPlace& place) {
  if (place.value.is_array()) return read_list(place, integer_in(1, 65535));
  return {integer_in(1, 65535)(place)};
}

LabelNumbers read_label_numbers(const JsonPlace& place) {
  LabelNumbers numbers;
  read_fields(place, {{"anterior", into(numbers.anterior, read_labels_of_part), false},
                      {"posterior", into(numbers.posterior, read_labels_of_part), false},
                      {"annulus", into(numbers.annulus, read_labels_of_part), false}});
  return numbers;
}

GivenLandmarks read_landmarks(const JsonPlace& place) {
  GivenLandmarks seen;
  read_fields(
      place,
      {{"anterolateral_commissure", into(seen.anterolateral_commissure_mm, read_vector), false},
       {"posteromedial_commissure", into(seen.posteromedial_commissure_mm, read_vector), false},
       {"saddle_peak", into(seen.saddle_peak_mm, read_vector), false},
       {"mid_posterior", into(seen.mid_posterior_mm, read_vector), false}});
  return seen;
}

FitRequest read_fit_request(const JsonPlace& place) {
  FitRequest fit;
  std::vector<JsonField> fields = fit_fields(fit.target);
  fields.push_back({"surface", into(fit.surface, read_file), false});
  read_fields(place, fields);
  return fit;
}

/// With what a file of a folder is called in the message: its pointer is that of the list.
Errors below_folder(Errors errors) {
  for (Error& error : errors) {
    if (error.path.starts_with("/landmarks")) continue;
    if (!error.path.empty()) error.message = error.path + ": " + error.message;
    error.path = "/slicerheart";
  }
  return errors;
}

/// As the request calls what the import calls by its unit.
Errors as_import_calls(Errors errors) {
  for (Error& error : errors) {
    for (const std::string given : {"/annulus", "/tips"})
      if (error.path.starts_with(given + "_mm")) error.path.erase(given.size(), 3);
    if (error.path == "/tissue/thickness_mm") error.path = "/thickness_mm";
    if (error.path.starts_with("/landmarks/") && error.path.ends_with("_mm"))
      error.path.resize(error.path.size() - 3);
  }
  return errors;
}

/// A header with its voxels.
Expected<std::optional<NamedFile>> whole_labels(const ImportRequest& asked) {
  if (!asked.labels || !asked.voxels) return asked.labels;
  const Expected<std::optional<std::string>> named = data_file_of(asked.labels->bytes);
  if (!named) return Error{named.errors()[0].code, "/labels", named.errors()[0].message};
  if (!*named)
    return Error{ErrorCode::UnknownField, "/voxels",
                 "is not allowed, because labels refers to no separate voxel file"};
  return std::optional(
      NamedFile{asked.labels->name, attached(asked.labels->bytes, asked.voxels->bytes)});
}

ImportDecision fit_decision(const ValveFit& fit) {
  int known = 0;
  for (const FittedParameter& parameter : fit.parameters) known += parameter.identifiable ? 1 : 0;
  std::string doubts;
  for (const std::string& doubt : doubts_of(fit)) doubts += "; " + doubt;
  return {"fit",
          "adjusted so that the valve closes onto the given surface: distance " +
              fixed(fit.rms_before_mm, 2) + " mm rms before, " + fixed(fit.rms_mm, 2) + " mm after",
          std::to_string(known) + " of " + std::to_string(fit.parameters.size()) +
              " parameters are constrained by the surface; the others keep their uncertainty" +
              (fit.stop == FitStop::AtRest ? "" : "; stopped before convergence") + doubts,
          !doubts.empty()};
}

}  // namespace

LengthUnit read_unit(const JsonPlace& place) {
  return read_name<LengthUnit>(
      place, {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Inch, LengthUnit::Metre});
}

std::vector<JsonField> import_fields(ImportRequest& asked) {
  ImportOptions& options = asked.options;
  asked.reading.most_voxels = kMostVoxelsSent;
  return {{"leaflets", into(asked.leaflets, read_named_files), false},
          {"labels", into(asked.labels, read_file), false},
          {"voxels", into(asked.voxels, read_file), false},
          {"label_numbers", into(asked.reading.labels, read_label_numbers), false},
          {"phase", into(asked.reading.phase, integer_in(1, kMostPhases)), false},
          {"frame", into(asked.reading.axes, read_axes), false},
          {"annulus", into(asked.annulus, read_file), false},
          {"chordae", into(asked.chordae, read_file), false},
          {"chordae_seed", into(options.chordae_seed, integer_in(0, 2147483647)), false},
          {"tips", into(asked.tips, read_file), false},
          {"landmarks", into(asked.landmarks, read_landmarks), false},
          {"closed", into(options.closed, read_boolean), false},
          {"hidden_mm", into(options.hidden_mm, number_in(0.0, 15.0)), false},
          {"slicerheart", into(asked.slicerheart, read_named_files), false},
          {"name", into(asked.name, read_short_text), false},
          {"provenance", into(asked.provenance, read_short_texts), false},
          {"triangles", into(options.triangles, integer_in(100, 100'000)), false},
          {"branches", into(options.branches, integer_in(1, 5)), false},
          {"branch_at", into(options.branch_at, number_in(0.05, 0.95)), false},
          {"slack", into(options.slack, number_in(0.8, 1.5)), false},
          {"reference", into(options.reference, read_state), false},
          {"thickness_mm", into(options.thickness_mm, read_number), false},
          {"thickness_measured", into(options.thickness_measured, read_boolean), false},
          {"observed", into(asked.observed, read_observed), false},
          {"units", into(options.units, read_unit), false},
          {"trust_labels", into(options.trust_labels, read_boolean), false},
          {"flip", into(options.flip, read_boolean), false},
          {"mirrored", into(options.mirrored, read_boolean), false}};
}

JsonField fit_field(ImportRequest& request) {
  return {"fit", into(request.fit, read_fit_request), false};
}

/// Either all of one kind of files or all of the other; chordae that were seen, or a seed of those to be drawn.
Errors check_import(const ImportRequest& asked, const OperationLimits& limits) {
  ProblemList problems;
  if (const int vertices = skirt_size(asked.options.triangles).vertices();
      vertices > limits.vertices)
    problems.add(ErrorCode::OutOfRange, "/triangles",
                 "is " + std::to_string(asked.options.triangles) + ", which takes " +
                     std::to_string(vertices) + " vertices; this service accepts at most " +
                     std::to_string(limits.vertices));
  for (const auto& [given, path] : {std::pair(asked.leaflets.has_value(), "/leaflets"),
                                    {asked.labels.has_value(), "/labels"},
                                    {asked.annulus.has_value(), "/annulus"}})
    if (given && asked.slicerheart)
      problems.add(ErrorCode::UnknownField, path, "cannot be given together with slicerheart");
  if (asked.options.thickness_mm && asked.options.thickness_measured)
    problems.add(ErrorCode::UnknownField, "/thickness_measured",
                 "cannot be given together with thickness_mm");
  if (asked.voxels && !asked.labels)
    problems.add(ErrorCode::UnknownField, "/voxels",
                 "requires labels, the header that refers to this voxel file");
  if (!asked.leaflets && !asked.labels && !asked.slicerheart)
    problems.add(ErrorCode::MissingField, "/leaflets",
                 "is missing (alternatives: labels, a label map, or slicerheart)");
  const bool drawn = asked.options.chordae_seed.has_value();
  if (asked.chordae && asked.slicerheart)
    problems.add(ErrorCode::UnknownField, "/chordae", "cannot be given together with slicerheart");
  if (asked.chordae && drawn)
    problems.add(ErrorCode::UnknownField, "/chordae_seed",
                 "cannot be given together with chordae, because it synthesises chordae");
  if (!asked.chordae && !drawn && !asked.slicerheart)
    problems.add(
        ErrorCode::MissingField, "/chordae",
        "is missing (alternatives: chordae_seed, which synthesises chordae, or slicerheart)");
  if (asked.tips && asked.slicerheart)
    problems.add(ErrorCode::UnknownField, "/tips",
                 "cannot be given together with slicerheart, whose files include them");
  else if (asked.tips && !drawn)
    problems.add(ErrorCode::UnknownField, "/tips",
                 "requires chordae_seed, because imaged chordae already begin at their tips");
  if (asked.leaflets && (asked.leaflets->empty() || asked.leaflets->size() > 2))
    problems.add(
        ErrorCode::OutOfRange, "/leaflets",
        "has " + std::to_string(asked.leaflets->size()) +
            " files, must have 1 (a skirt, or both leaflets as its parts) or 2 (the anterior, then "
            "the posterior sheet)");
  if (asked.fit && !asked.fit->surface && !asked.options.closed.value_or(false))
    problems.add(ErrorCode::MissingField, "/fit/surface",
                 "is missing; it may be omitted only for leaflets imaged closed");
  return std::move(problems).take();
}

Expected<ImportedValve> make_import(const ImportRequest& asked, const ClosureBudget& budget) {
  const Expected<std::optional<NamedFile>> labels = whole_labels(asked);
  if (!labels) return labels.errors();
  Expected<ImportSource> source =
      asked.slicerheart ? read_slicerheart(*asked.slicerheart)
                        : read_import_files({asked.leaflets.value_or(std::vector<NamedFile>{}),
                                             asked.annulus, asked.chordae, asked.tips, *labels},
                                            asked.reading);
  if (!source) return asked.slicerheart ? below_folder(source.errors()) : source.errors();
  source->name = asked.name;
  source->provenance.insert(source->provenance.begin(), asked.provenance.begin(),
                            asked.provenance.end());
  source->landmarks = asked.landmarks;
  ImportOptions options = asked.options;
  options.budget = budget;
  Expected<ImportedValve> done = import_with_decisions(*std::move(source), options);
  if (done) {
    if (asked.observed.empty()) return done;
    for (const Observation& seen : asked.observed) observe(done->valve.observed, seen);
    if (Errors errors = validate(done->valve); !errors.empty()) return errors;
    return done;
  }
  Errors errors = as_import_calls(done.errors());
  return asked.slicerheart ? below_folder(std::move(errors)) : errors;
}

Expected<LeafletMesh> fit_surface(const ImportRequest& request, const ImportedValve& imported) {
  LeafletMesh surface;
  if (!request.fit->surface) {
    const TriangleMesh leaflets = joined(imported.input.leaflets);
    surface.vertices_mm = leaflets.vertices_mm;
    surface.faces = leaflets.faces;
    return surface;
  }
  const NamedFile& file = *request.fit->surface;
  const std::string format = format_of(file.name);
  Errors errors;
  if (is_table_format(format)) {
    const Expected<Points> points = read_points_csv(file.bytes);
    if (points)
      surface.vertices_mm = *points;
    else
      errors = points.errors();
  } else {
    const Expected<TriangleMesh> mesh = read_mesh(file.bytes, format);
    if (mesh) {
      surface.vertices_mm = mesh->vertices_mm;
      surface.faces = mesh->faces;
    } else {
      errors = mesh.errors();
    }
  }
  for (Error& error : errors) error.path = "/fit/surface" + error.path;
  if (!errors.empty()) return errors;
  surface.vertices_mm *= in_mm(imported.unit);
  if (imported.valve.patient)
    surface.vertices_mm = from_patient(*imported.valve.patient, surface.vertices_mm);
  return surface;
}

FittedImport fitted_import(const ValveFit& fit, const MeasuredClosure& measured,
                           const std::string& imported_id) {
  FittedImport fitted{fit.closed.valve, fit_decision(fit),
                      fit_to_json(fit, {imported_id, kFittedSurface, measured})};
  fitted.valve.provenance.push_back(fit_sentence(fit, kFittedSurface));
  return fitted;
}

std::string valve_id(const Valve& valve) { return sha256(write_valve(valve)); }

Json import_answer(const ImportedValve& imported, const Valve& made, Json fit) {
  Json answer = import_to_json(imported);
  answer["valve"] = valve_id(made);
  answer["imported"] = valve_id(imported.valve);
  answer["fit"] = std::move(fit);
  answer["made"] = Json::parse(write_valve(made));
  return answer;
}

}  // namespace coapt
