#include "operations/import_request.h"

#include "core/valve/patient_frame.h"
#include "core/valve/validate.h"
#include "io/exchange/abaqus_valve.h"
#include "io/exchange/decisions_json.h"
#include "io/json/fit_json.h"
#include "io/json/valve_json.h"
#include "io/mesh/csv_table.h"
#include "io/mesh/given_landmarks.h"
#include "io/mesh/import_readers.h"
#include "io/mesh/skirt.h"
#include "io/mesh/source_units.h"
#include "io/picture/fit_picture.h"
#include "io/picture/text.h"
#include "io/store/sha256.h"
#include "operations/given_shape.h"
#include "operations/import_source.h"
#include "operations/voxel_grid.h"

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

GivenLandmarks read_placed(const JsonPlace& place) {
  GivenLandmarks seen;
  read_fields(
      place,
      {{"anterolateral_commissure", into(seen.anterolateral_commissure_mm, read_vector), false},
       {"posteromedial_commissure", into(seen.posteromedial_commissure_mm, read_vector), false},
       {"saddle_peak", into(seen.saddle_peak_mm, read_vector), false},
       {"mid_posterior", into(seen.mid_posterior_mm, read_vector), false}});
  return seen;
}

/// Placed one by one, or a file of labelled points.
void read_landmarks(const JsonPlace& place, ImportRequest& asked) {
  if (place.value.is_object() && place.value.contains("name"))
    asked.landmarks_file = read_file(place);
  else
    asked.landmarks = read_placed(place);
}

bool any_placed(GivenLandmarks landmarks) {
  bool any = false;
  for_each_given(landmarks, [&](const Vec3& place) {
    any = true;
    return place;
  });
  return any;
}

FitRequest read_fit_request(const JsonPlace& place) {
  FitRequest fit;
  std::vector<JsonField> fields = fit_fields(fit.target);
  fields.push_back({"surface", into(fit.surface, read_file), false});
  read_fields(place, fields);
  return fit;
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
  return {{"files", into(asked.files, read_named_files), false},
          {"leaflets", into(asked.leaflets, read_named_files), false},
          {"labels", into(asked.labels, read_file), false},
          {"voxels", into(asked.voxels, read_file), false},
          {"label_numbers", into(asked.reading.labels, read_label_numbers), false},
          {"phase", into(asked.reading.phase, integer_in(1, kMostPhases)), false},
          {"frame", into(asked.reading.axes, read_axes), false},
          {"annulus", into(asked.annulus, read_file), false},
          {"chordae", into(asked.chordae, read_file), false},
          {"chordae_seed", into(options.chordae_seed, integer_in(0, 2147483647)), false},
          {"tips", into(asked.tips, read_file), false},
          {"landmarks", [&asked](const JsonPlace& place) { read_landmarks(place, asked); }, false},
          {"grid", into(asked.reading.series, grid_in(kMostVoxelsSent)), false},
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
  for (const auto& [given, path] : {std::pair(asked.files.has_value(), "/files"),
                                    {asked.leaflets.has_value(), "/leaflets"},
                                    {asked.labels.has_value(), "/labels"},
                                    {asked.annulus.has_value(), "/annulus"},
                                    {asked.chordae.has_value(), "/chordae"}})
    if (given && asked.slicerheart)
      problems.add(ErrorCode::UnknownField, path, "cannot be given together with slicerheart");
  if (asked.options.thickness_mm && asked.options.thickness_measured)
    problems.add(ErrorCode::UnknownField, "/thickness_measured",
                 "cannot be given together with thickness_mm");
  if (asked.voxels && !asked.labels)
    problems.add(ErrorCode::UnknownField, "/voxels",
                 "requires labels, the header that refers to this voxel file");
  if (!asked.files && !asked.leaflets && !asked.labels && !asked.slicerheart)
    problems.add(ErrorCode::MissingField, "/leaflets",
                 "is missing (alternatives: labels, a label map; files, whose parts are detected; "
                 "or slicerheart)");
  const bool drawn = asked.options.chordae_seed.has_value();
  const bool may_lack_chordae = asked.files || asked.labels || asked.slicerheart;
  if (asked.chordae && drawn)
    problems.add(ErrorCode::UnknownField, "/chordae_seed",
                 "cannot be given together with chordae, because it synthesises chordae");
  if (!asked.chordae && !drawn && !may_lack_chordae)
    problems.add(ErrorCode::MissingField, "/chordae",
                 "is missing (alternative: chordae_seed, which synthesises chordae)");
  if (asked.tips && asked.slicerheart)
    problems.add(ErrorCode::UnknownField, "/tips",
                 "cannot be given together with slicerheart, whose files include them");
  else if (asked.tips && asked.chordae)
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

namespace {

/// Options that change nothing of this import: those of straight chordae, and of leaflets that were imaged closed.
std::vector<ImportDecision> unused_options(const ImportOptions& options,
                                           const ImportedValve& imported) {
  struct Unused {
    bool differs, used;
    const char *name, *reason;
  };
  constexpr const char* kDrawn = "synthesised chordae have their own branches and slack";
  const ImportOptions usual;
  const bool model = !is_mitral(imported.valve);
  const bool given = !model && !imported.valve.drawn_chordae;
  std::vector<ImportDecision> unused;
  for (const Unused& option :
       {Unused{options.branches != usual.branches, given, "branches", kDrawn},
        {options.branch_at != usual.branch_at, given, "branching point", kDrawn},
        {options.slack != usual.slack, given, "slack", kDrawn},
        {options.hidden_mm != usual.hidden_mm, imported.input.closed, "hidden height",
         "the leaflets were not interpreted as closed"}})
    if (option.differs && !option.used)
      unused.push_back({"options", std::string(option.name) + " not used",
                        model ? "a finite element model is taken as it is" : option.reason, true});
  return unused;
}

/// Of any number of leaflets; what an import decides of a mitral valve is not asked.
Expected<ImportedValve> import_model(const NamedFile& file, const ImportRequest& asked) {
  const ImportReading& reading = asked.reading;
  const ImportOptions& options = asked.options;
  ProblemList problems;
  for (const auto& [given, path] :
       {std::pair(asked.leaflets.has_value(), "/leaflets"),
        {asked.labels.has_value(), "/labels"},
        {asked.annulus.has_value(), "/annulus"},
        {asked.chordae.has_value(), "/chordae"},
        {asked.tips.has_value(), "/tips"},
        {asked.landmarks_file || any_placed(asked.landmarks), "/landmarks"},
        {reading.labels.any(), "/label_numbers"},
        {reading.phase > 0, "/phase"},
        {reading.axes.has_value(), "/frame"},
        {reading.series.has_value(), "/grid"},
        {options.units.has_value(), "/units"},
        {options.closed.has_value(), "/closed"},
        {options.chordae_seed.has_value(), "/chordae_seed"},
        {options.reference != ImportOptions{}.reference, "/reference"},
        {options.triangles != ImportOptions{}.triangles, "/triangles"},
        {options.thickness_mm.has_value(), "/thickness_mm"},
        {options.thickness_measured, "/thickness_measured"},
        {options.trust_labels, "/trust_labels"},
        {options.flip, "/flip"},
        {options.mirrored, "/mirrored"},
        {!asked.observed.empty(), "/observed"},
        {asked.fit.has_value(), "/fit"}})
    if (given)
      problems.add(ErrorCode::Unsupported, path,
                   "applies to mitral valves and cannot be given with a finite element model");
  if (!problems.empty()) return std::move(problems).take();
  Expected<Valve> valve = read_abaqus_valve(file.bytes, {asked.name, asked.provenance});
  if (!valve) {
    Errors errors = valve.errors();
    for (Error& error : errors) error.path.insert(0, "/files/0");
    return errors;
  }
  ImportedValve imported;
  imported.valve = *std::move(valve);
  imported.decisions.push_back(
      {"files",
       "a finite element model: " + counted(std::ssize(imported.valve.leaflets), "leaflet") + ", " +
           counted(std::ssize(imported.valve.chordae), "chorda", "chordae"),
       "its shells are the leaflets, its trusses the chordae"});
  const auto unused = unused_options(options, imported);
  imported.decisions.insert(imported.decisions.end(), unused.begin(), unused.end());
  return imported;
}

}  // namespace

Expected<ImportedValve> make_import(ImportRequest asked, const ClosureBudget& budget) {
  if (asked.files) {
    const Expected<std::optional<NamedFile>> model = model_among(*asked.files);
    if (!model) return model.errors();
    if (*model) return import_model(**model, asked);
  }
  const GivenLandmarks landmarks = asked.landmarks;
  const std::vector<Observation> observed = asked.observed;
  ImportOptions options = asked.options;
  options.budget = budget;
  // Where what was seen holds no chordae, they are drawn.
  const bool draws = asked.files || asked.labels;
  const int seed = asked.seed;
  std::string name = std::move(asked.name);
  std::vector<std::string> provenance = std::move(asked.provenance);
  RequestedSource requested;
  Expected<ImportSource> source = requested.read(std::move(asked));
  if (!source) return source.errors();
  source->name = std::move(name);
  source->provenance.insert(source->provenance.begin(), provenance.begin(), provenance.end());
  if (any_placed(landmarks) && any_placed(source->landmarks))
    return Error{ErrorCode::UnknownField, "/landmarks",
                 "cannot be given, because the files have landmarks, too"};
  if (any_placed(landmarks)) source->landmarks = landmarks;
  if (draws && options.chordae_seed && !source->chordae.empty())
    return Error{ErrorCode::UnknownField, "/chordae_seed",
                 "cannot be given together with chordae, because it synthesises chordae"};
  if (draws && source->chordae.empty() && !options.chordae_seed) options.chordae_seed = seed;
  Expected<ImportedValve> made = import_with_decisions(*std::move(source), options);
  if (!made) return requested.as_requested(made.errors());
  const auto unused = unused_options(options, *made);
  made->decisions.insert(made->decisions.end(), unused.begin(), unused.end());
  if (observed.empty()) return made;
  for (const Observation& seen : observed) observe(made->valve.observed, seen);
  if (Errors errors = validate(made->valve); !errors.empty()) return errors;
  return made;
}

Expected<LeafletMesh> fit_surface(const ImportRequest& request, const ImportedValve& imported,
                                  const OperationLimits& limits) {
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
    const Expected<TriangleMesh> mesh =
        read_mesh(file.bytes, format, kMostUnpackedSent, surface_limits(limits));
    if (mesh) {
      surface.vertices_mm = mesh->vertices_mm;
      surface.faces = mesh->faces;
    } else {
      errors = mesh.errors();
    }
  }
  for (Error& error : errors) error.path = "/fit/surface" + error.path;
  if (!errors.empty()) return errors;
  const auto stated = stated_axes(file.bytes);
  if (request.reading.axes.value_or(stated.value_or(PatientAxes::LPS)) == PatientAxes::RAS)
    turn_axes(surface.vertices_mm);
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
