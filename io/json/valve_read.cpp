// Only form is checked here: types, fields, lengths of rows. What the numbers mean is validate()'s,
// which runs on whatever could be read; of its problems those are dropped that lie where the form
// is wrong.

#include <algorithm>

#include "core/valve/validate.h"
#include "io/json/json_reader.h"
#include "io/json/parse_json.h"
#include "io/json/valve_json.h"

namespace coapt {
namespace {

Segment read_segment(const JsonPlace& place) {
  static const std::vector<Segment> choices = {Segment::A1, Segment::A2, Segment::A3, Segment::P1,
                                               Segment::P2, Segment::P3, Segment::AC, Segment::PC};
  return read_name(place, choices);
}

ChordaKind read_kind(const JsonPlace& place) {
  return read_name<ChordaKind>(
      place, {ChordaKind::Marginal, ChordaKind::Strut, ChordaKind::Basal, ChordaKind::Neochorda});
}

TissueReference read_reference(const JsonPlace& place) {
  return read_name<TissueReference>(place, {TissueReference::Excised, TissueReference::InVivo});
}

Tissue read_tissue(const JsonPlace& place) {
  Tissue tissue;
  const auto number = [](double& target) { return into(target, read_number); };
  read_fields(place,
              {{"density_g_per_mm3", number(tissue.density_g_per_mm3)},
               {"thickness_mm", number(tissue.thickness_mm)},
               {"circumferential_pre_kpa", number(tissue.circumferential_pre_kpa)},
               {"circumferential_post_kpa", number(tissue.circumferential_post_kpa)},
               {"circumferential_transition", number(tissue.circumferential_transition)},
               {"radial_pre_kpa", number(tissue.radial_pre_kpa)},
               {"radial_post_kpa", number(tissue.radial_post_kpa)},
               {"radial_transition", number(tissue.radial_transition)},
               {"chordae_kpa", number(tissue.chordae_kpa)},
               {"reference", into(tissue.reference, read_reference), false},
               {"circumferential_prestretch", number(tissue.circumferential_prestretch), false},
               {"radial_prestretch", number(tissue.radial_prestretch), false},
               {"bending_n_mm", number(tissue.bending_n_mm), false}});
  return tissue;
}

/// Of coapt.valve/2, where each leaflet has its own.
Tissue read_shared_tissue(const JsonPlace& place) {
  Tissue tissue;
  const auto number = [](double& target) { return into(target, read_number); };
  read_fields(place, {{"density_g_per_mm3", number(tissue.density_g_per_mm3)},
                      {"contact_thickness_mm", number(tissue.thickness_mm)},
                      {"chordae_kpa", number(tissue.chordae_kpa)},
                      {"bending_n_mm", number(tissue.bending_n_mm)}});
  return tissue;
}

NamedLeaflet read_named_leaflet(const JsonPlace& place) {
  NamedLeaflet leaflet;
  const auto number = [](double& target) { return into(target, read_number); };
  read_fields(place, {{"name", into(leaflet.name, read_string)},
                      {"thickness_mm", number(leaflet.thickness_mm)},
                      {"c0_kpa", number(leaflet.tissue.c0_kpa)},
                      {"c1_kpa", number(leaflet.tissue.c1_kpa)},
                      {"c2", number(leaflet.tissue.c2)}});
  return leaflet;
}

Faces read_faces(const JsonPlace& place) {
  const auto rows = read_list(place, read_indices);
  Faces faces(std::ssize(rows), 3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    faces.row(static_cast<Eigen::Index>(i)) << rows[i][0], rows[i][1], rows[i][2];
  }
  return faces;
}

Landmarks read_landmarks(const JsonPlace& place) {
  Landmarks marks;
  const auto vertex = [](int& target) { return into(target, read_integer); };
  read_fields(place, {{"anterolateral_trigone", vertex(marks.anterolateral_trigone)},
                      {"posteromedial_trigone", vertex(marks.posteromedial_trigone)},
                      {"saddle_peak", vertex(marks.saddle_peak)},
                      {"mid_posterior", vertex(marks.mid_posterior)},
                      {"anterolateral_commissure", vertex(marks.anterolateral_commissure)},
                      {"posteromedial_commissure", vertex(marks.posteromedial_commissure)}});
  return marks;
}

PapillaryHead read_head(const JsonPlace& place) {
  PapillaryHead head;
  read_fields(place, {{"id", into(head.id, read_string)},
                      {"side", into(head.side, read_side)},
                      {"rest_mm", into(head.rest_mm, read_vector)},
                      {"tip_mm", into(head.tip_mm, read_vector)}});
  return head;
}

Insertion read_insertion(const JsonPlace& place) {
  Insertion insertion;
  read_fields(place, {{"face", into(insertion.face, read_integer)},
                      {"weights", [&](const JsonPlace& weights) {
                         const Vec3 read = read_vector(weights);
                         insertion.weights = {read[0], read[1], read[2]};
                       }}});
  return insertion;
}

PapillaryHead read_plain_head(const JsonPlace& place) {
  PapillaryHead head;
  read_fields(place, {{"id", into(head.id, read_string)},
                      {"rest_mm", into(head.rest_mm, read_vector)},
                      {"tip_mm", into(head.tip_mm, read_vector)}});
  return head;
}

ChordaSegment read_chorda_segment(const JsonPlace& place) {
  ChordaSegment segment;
  bool branches = false;
  read_fields(place, {{"parent", into(segment.parent, read_integer)},
                      {"rest_length_mm", into(segment.rest_length_mm, read_number)},
                      {"diameter_mm", into(segment.diameter_mm, read_number)},
                      {"modulus_kpa", into(segment.modulus_kpa, read_number), false},
                      {"insertion",
                       [&](const JsonPlace& insertion) {
                         segment.inserts = true;
                         segment.insertion = read_insertion(insertion);
                       },
                       false},
                      {"zone_mm", into(segment.zone_mm, read_number), false},
                      {"branch_point_mm",
                       [&](const JsonPlace& point) {
                         branches = true;
                         segment.branch_point_mm = read_vector(point);
                       },
                       false}});
  if (place.value.is_object() && segment.inserts == branches) {
    add_problem(place, branches ? ErrorCode::UnknownField : ErrorCode::MissingField,
                "must have either insertion or branch_point_mm");
  }
  return segment;
}

Tie read_tie(const JsonPlace& place) {
  Tie tie;
  read_fields(place, {{"id", into(tie.id, read_string)},
                      {"anterior", into(tie.anterior, read_insertion)},
                      {"posterior", into(tie.posterior, read_insertion)},
                      {"rest_length_mm", into(tie.rest_length_mm, read_number)},
                      {"zone_mm", into(tie.zone_mm, read_number)},
                      {"stiffness_n_per_mm", into(tie.stiffness_n_per_mm, read_number)}});
  return tie;
}

Chorda read_chorda(const JsonPlace& place) {
  Chorda chorda;
  read_fields(place, {{"id", into(chorda.id, read_string)},
                      {"kind", into(chorda.kind, read_kind)},
                      {"head", into(chorda.head, read_integer)},
                      {"ruptured", into(chorda.ruptured, read_boolean)},
                      {"segments", [&](const JsonPlace& segments) {
                         chorda.segments = read_list(segments, read_chorda_segment);
                       }}});
  return chorda;
}

/// Four rows of four numbers, the last 0, 0, 0, 1.
PatientFrame read_patient_frame(const JsonPlace& place) {
  PatientFrame frame;
  const auto rows =
      read_list(place, [](const JsonPlace& row) { return read_list(row, read_number); });
  const bool square = rows.size() == 4 && std::all_of(rows.begin(), rows.end(),
                                                      [](const auto& r) { return r.size() == 4; });
  if (!square || rows[3] != std::vector<double>{0.0, 0.0, 0.0, 1.0}) {
    add_problem(place, ErrorCode::BadGeometry,
                "must be four rows of four numbers, the last of them 0, 0, 0, 1");
    return frame;
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) frame.axes(i, j) = rows[i][j];
    frame.origin_mm[i] = rows[i][3];
  }
  return frame;
}

SystolicMotion read_systole(const JsonPlace& place) {
  SystolicMotion systole;
  read_fields(place, {{"annular_contraction", into(systole.annular_contraction, read_number)},
                      {"tip_approach", into(systole.tip_approach, read_number)}});
  return systole;
}

DrawnChordae read_drawn_chordae(const JsonPlace& place) {
  DrawnChordae drawn;
  read_fields(place, {{"seed", into(drawn.seed, read_integer)},
                      {"tips_given", into(drawn.tips_given, read_boolean)}});
  return drawn;
}

FittedValues read_fitted(const JsonPlace& place) {
  FittedValues fitted;
  std::vector<std::vector<double>> rows;
  read_fields(place,
              {{"parameters",
                [&](const JsonPlace& names) { fitted.parameters = read_list(names, read_string); }},
               {"covariance", [&](const JsonPlace& matrix) {
                  rows = read_list(
                      matrix, [](const JsonPlace& row) { return read_list(row, read_number); });
                }}});
  const std::size_t count = rows.size();
  const bool square =
      std::all_of(rows.begin(), rows.end(), [&](const auto& row) { return row.size() == count; });
  if (!square) {
    add_problem(place, ErrorCode::BadGeometry, "covariance must have as many columns as rows");
    return fitted;
  }
  fitted.covariance.resize(std::ssize(rows), std::ssize(rows));
  for (std::size_t i = 0; i < count; ++i)
    fitted.covariance.row(static_cast<Eigen::Index>(i)) =
        Eigen::Map<const Eigen::RowVectorXd>(rows[i].data(), std::ssize(rows));
  return fitted;
}

// Reads a list of what `read` returns into `target`.
template <class T, class Read>
std::function<void(const JsonPlace&)> list_into(std::vector<T>& target, Read read) {
  return [&target, read](const JsonPlace& place) { target = read_list(place, read); };
}

Valve read_form(const JsonPlace& root) {
  Valve valve;
  const auto read_annulus = [&](const JsonPlace& place) {
    read_fields(place, {{"vertices", list_into(valve.annulus, read_integer)},
                        {"positions_mm", into(valve.annulus_mm, read_points)}});
  };
  read_fields(root,
              {{"schema", [](const JsonPlace& place) { read_schema(place, "coapt.valve/1"); }},
               {"name", into(valve.name, read_string)},
               {"provenance", list_into(valve.provenance, read_string)},
               {"pressure_kpa", into(valve.pressure_kpa, read_number)},
               {"systole", into(valve.systole, read_systole), false},
               {"tissue", into(valve.tissue, read_tissue)},
               {"vertices_mm", into(valve.rest_mm, read_points)},
               {"faces", into(valve.faces, read_faces)},
               {"segments", list_into(valve.segments, read_segment)},
               {"fibre", into(valve.fibre, read_points)},
               {"annulus", read_annulus},
               {"landmarks", into(valve.landmarks, read_landmarks)},
               {"papillary_heads", list_into(valve.heads, read_head)},
               {"chordae", list_into(valve.chordae, read_chorda)},
               {"ties", list_into(valve.ties, read_tie), false},
               {"drawn_chordae", into(valve.drawn_chordae, read_drawn_chordae), false},
               {"observed", into(valve.observed, read_observed), false},
               {"fit", into(valve.fitted, read_fitted), false},
               {"patient_frame", into(valve.patient, read_patient_frame), false}});
  return valve;
}

/// coapt.valve/2.
Valve read_leaflet_form(const JsonPlace& root) {
  Valve valve;
  const auto read_annulus = [&](const JsonPlace& place) {
    read_fields(place, {{"vertices", list_into(valve.annulus, read_integer)},
                        {"positions_mm", into(valve.annulus_mm, read_points)}});
  };
  read_fields(root,
              {{"schema", [](const JsonPlace& place) { read_schema(place, "coapt.valve/2"); }},
               {"name", into(valve.name, read_string)},
               {"provenance", list_into(valve.provenance, read_string)},
               {"pressure_kpa", into(valve.pressure_kpa, read_number)},
               {"tissue", into(valve.tissue, read_shared_tissue)},
               {"leaflets", list_into(valve.leaflets, read_named_leaflet)},
               {"vertices_mm", into(valve.rest_mm, read_points)},
               {"faces", into(valve.faces, read_faces)},
               {"face_leaflets", list_into(valve.face_leaflet, read_integer)},
               {"fibre", into(valve.fibre, read_points)},
               {"annulus", read_annulus},
               {"papillary_heads", list_into(valve.heads, read_plain_head)},
               {"chordae", list_into(valve.chordae, read_chorda)},
               {"fit", into(valve.fitted, read_fitted), false},
               {"patient_frame", into(valve.patient, read_patient_frame), false}});
  if (valve.leaflets.empty()) {
    root.problems.add(ErrorCode::MissingField, "/leaflets", "must have at least one leaflet");
  }
  return valve;
}

bool within(const std::string& path, const std::string& outer) {
  return path.starts_with(outer) && (path.size() == outer.size() || path[outer.size()] == '/');
}

}  // namespace

Side read_side(const JsonPlace& place) {
  return read_name<Side>(place, {Side::Anterolateral, Side::Posteromedial});
}

namespace {

bool has_leaflets(const Json& json) {
  if (!json.is_object()) return false;
  const auto schema = json.find("schema");
  return schema != json.end() && *schema == "coapt.valve/2";
}

Expected<Valve> checked(const Json& json, Valve (*read_form_of)(const JsonPlace&)) {
  ProblemList problems;
  const Valve valve = read_form_of({json, problems});
  const Errors form = problems.listed();
  const ProblemList meaning = problems_in(valve);
  for (const Error& error : meaning.listed()) {
    const auto overlaps = [&](const Error& earlier) {
      return within(error.path, earlier.path) || within(earlier.path, error.path);
    };
    if (std::none_of(form.begin(), form.end(), overlaps)) {
      problems.add(error.code, error.path, error.message);
    }
  }
  problems.add_unlisted(meaning.unlisted());
  if (!problems.empty()) return std::move(problems).take();
  return valve;
}

}  // namespace

std::vector<Observation> read_observed(const JsonPlace& place) {
  std::vector<Observation> observed;
  const auto read_one = [&](ObservedFigure figure) {
    return [&observed, figure](const JsonPlace& one) {
      Observation seen{figure, 0.0, 0.0, {}};
      read_fields(one, {{"value", into(seen.value, read_number)},
                        {"sd", into(seen.sd, read_number)},
                        {"source", into(seen.source, read_string), false}});
      observed.push_back(std::move(seen));
    };
  };
  read_fields(
      place,
      {{row_of(ObservedFigure::Leak).name, read_one(ObservedFigure::Leak), false},
       {row_of(ObservedFigure::TentingArea).name, read_one(ObservedFigure::TentingArea), false},
       {row_of(ObservedFigure::WidestGap).name, read_one(ObservedFigure::WidestGap), false}});
  return observed;
}

Expected<Valve> valve_from_json(const Json& json) {
  if (has_leaflets(json))
    return Error{ErrorCode::Unsupported, "/schema",
                 "is \"coapt.valve/2\", which can only be closed and checked; must be "
                 "\"coapt.valve/1\", a mitral valve"};
  return checked(json, read_form);
}

Expected<Valve> read_valve(std::string_view text) {
  const auto json = parse_json(text);
  if (!json) return json.errors();
  return valve_from_json(*json);
}

Expected<Valve> read_any_valve(std::string_view text) {
  const auto json = parse_json(text);
  if (!json) return json.errors();
  return checked(*json, has_leaflets(*json) ? read_leaflet_form : read_form);
}

Expected<TissueFile> read_tissue_file(std::string_view text) {
  const auto json = parse_json(text);
  if (!json) return json.errors();
  ProblemList problems;
  TissueFile file;
  read_fields({*json, problems},
              {{"schema", [](const JsonPlace& place) { read_schema(place, "coapt.tissue/1"); }},
               {"pressure_kpa", into(file.pressure_kpa, read_number)},
               {"tissue", into(file.tissue, read_tissue)}});
  if (!problems.empty()) return std::move(problems).take();
  return file;
}

}  // namespace coapt
