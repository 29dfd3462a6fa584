#include "io/exchange/import_files.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "core/valve/contour.h"
#include "core/valve/number_text.h"
#include "core/valve/problem_list.h"
#include "io/exchange/chorda_trees.h"
#include "io/exchange/landmark_files.h"
#include "io/exchange/markups.h"
#include "io/exchange/mesh_leaflets.h"
#include "io/exchange/part_names.h"
#include "io/exchange/stated_axes.h"
#include "io/mesh/csv_table.h"
#include "io/mesh/given_landmarks.h"
#include "io/mesh/gltf.h"
#include "io/mesh/import_readers.h"
#include "io/mesh/plausibility.h"
#include "io/mesh/source_units.h"

namespace coapt {
namespace {

/// Into `target`, or its problems below `pointer`.
template <class T, class Target>
void take(Expected<T> read, const std::string& pointer, ProblemList& problems, Target& target) {
  if (read) {
    target = *std::move(read);
  } else {
    for (const Error& error : read.errors()) {
      const bool below = error.path == pointer || error.path.starts_with(pointer + "/") ||
                         error.path.starts_with("/label_numbers");
      problems.add(error.code, below ? error.path : pointer + error.path, error.message);
    }
  }
}

}  // namespace

std::string format_of(const std::string& file_name) {
  std::string extension = std::filesystem::path(file_name).extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

namespace {

Expected<Points> without_stray(Expected<Points> loop) {
  if (!loop) return loop;
  if (const std::string stray = stray_point(*loop); !stray.empty())
    return Error{ErrorCode::BadGeometry, "", stray};
  return loop;
}

}  // namespace

Expected<Points> read_closed_loop(std::string_view text, const std::string& format) {
  if (format == "obj" || format == "vtk" || format == "vtp" || is_gltf_format(format))
    return without_stray(read_mesh_line(text, format));
  if (format == "ply" || format == "stl" || format == "vtu")
    return Error{ErrorCode::Unsupported, "",
                 "is a surface, ." + format +
                     "; an annulus must be a table, a closed curve from Slicer (.mrk.json), or "
                     "lines in OBJ, glTF, .vtk or .vtp"};
  if (format != "json") return without_stray(read_points_csv(text));
  const Expected<std::vector<Markup>> markups = read_markups(text);
  if (!markups) return markups.errors();
  std::vector<const Markup*> curves, named;
  for (const Markup& markup : *markups) {
    if (markup.type != MarkupType::ClosedCurve) continue;
    curves.push_back(&markup);
    if (part_named(markup.name) == NamedPart::Annulus) named.push_back(&markup);
  }
  if (curves.empty()) return Error{ErrorCode::MissingField, "/markups", "has no ClosedCurve"};
  if (curves.size() > 1 && named.size() != 1)
    return Error{ErrorCode::Unsupported, "/markups",
                 "has " + std::to_string(curves.size()) + " ClosedCurves, " +
                     std::to_string(named.size()) +
                     " of them named as a mitral annulus; must have one, or one with such a name"};
  const Markup& curve = curves.size() > 1 ? *named[0] : *curves[0];
  if (const auto loop = without_stray(curve.points_mm); !loop)
    return Error{loop.errors()[0].code, "/markups", loop.errors()[0].message};
  Expected<Points> drawn = drawn_closed_curve(curve);
  if (!drawn) return Error{drawn.errors()[0].code, "/markups", drawn.errors()[0].message};
  return drawn;
}

Expected<std::vector<ImportedTip>> read_tips(std::string_view text, const std::string& format) {
  if (format != "json") return read_tips_csv(text);
  const Expected<std::vector<Markup>> markups = read_markups(text);
  if (!markups) return markups.errors();
  std::vector<LabelledTip> labelled;
  for (const Markup& markup : *markups)
    for (Eigen::Index i = 0; i < markup.points_mm.rows(); ++i)
      labelled.push_back(
          {Vec3(markup.points_mm.row(i)), markup.labels[static_cast<std::size_t>(i)], {}});
  std::vector<ImportedTip> tips = imported_tips(labelled);
  if (tips.empty())
    return Error{ErrorCode::MissingField, "/markups", "has no point labelled AL or PM"};
  return tips;
}

namespace {

/// Of words of a file those that may be repeated: others may name a patient.
bool is_plain(std::string_view word) {
  constexpr std::size_t kLongest = 20;
  return word.size() <= kLongest && std::all_of(word.begin(), word.end(), [](unsigned char c) {
           return std::isalpha(c) != 0 || c == '_';
         });
}

/// Columns or arrays that are not used: said once a file, by name where that is a plain word.
void tell_left_over(const std::string& part, const char* what, const LeftOver& left,
                    ImportSource& source) {
  constexpr std::size_t kMostNamed = 5;
  if (left.names.empty()) return;
  std::string named;
  std::size_t count = 0;
  for (const std::string& name : left.names) {
    if (!is_plain(name) || count == kMostNamed) continue;
    named += (count++ == 0 ? ": " : ", ") + name;
  }
  if (const std::size_t others = left.names.size() - count; count > 0 && others > 0)
    named += " and " + std::to_string(others) + " more";
  source.decisions.push_back({"files",
                              part + ": " + std::to_string(left.names.size()) + " of " +
                                  std::to_string(left.of) + ' ' + what + " not used" + named,
                              "an import has no use for them"});
}

/// Which files are turned to LPS, and why, one decision for all that are alike.
class AxesOfFiles {
 public:
  explicit AxesOfFiles(const std::optional<PatientAxes>& given) : given_(given) {}

  /// Whether the numbers of a file are to be turned. Markups say their axes themselves (markups.h).
  bool turned(const NamedFile& file, const std::string& part, bool is_markup = false) {
    const auto stated = is_markup ? PatientAxes::LPS : stated_axes(file.bytes);
    const bool overruled = given_ && !is_markup, of_slicer = format_of(file.name) == "fcsv";
    stated_ = stated_ && (overruled || stated);
    given_is_used_ = given_is_used_ || overruled;
    const PatientAxes axes =
        overruled ? *given_ : stated.value_or(of_slicer ? PatientAxes::RAS : PatientAxes::LPS);
    std::string reason =
        is_markup   ? "stated in the markups"
        : overruled ? "as given"
        : is_gltf_format(format_of(file.name))
            ? "not stated; glTF has axes for display alone, which are taken as LPS"
        : stated    ? std::string("stated in their headers as SPACE=") + to_string(*stated)
        : of_slicer ? "not stated in the file; 3D Slicer's lists of points without a "
                      "coordinate system are RAS"
                    : "not stated in the files; LPS is the DICOM convention";
    const bool contrary = overruled && stated && *stated != *given_;
    if (contrary)
      reason += std::string(", contrary to their headers, which state SPACE=") + to_string(*stated);
    const char* done = axes == PatientAxes::RAS ? "RAS, converted to LPS" : "LPS";
    if (decisions_.empty() || decisions_.back().reason != reason || done != done_) {
      decisions_.push_back({"axes", part + ": " + done, reason, contrary, contrary ? 0.5 : 1.0});
      parts_ = part;
    } else {
      parts_ += ", " + part;
      decisions_.back().value = parts_ + ": " + done;
    }
    done_ = done;
    return axes == PatientAxes::RAS;
  }

  /// Of all files so far.
  bool are_stated() const { return stated_; }

  std::vector<ImportDecision> take() && {
    if (given_ && !given_is_used_)
      decisions_.push_back({"options", "frame not used",
                            "label maps and markups state their axes themselves", true});
    return std::move(decisions_);
  }

 private:
  std::optional<PatientAxes> given_;
  std::vector<ImportDecision> decisions_;
  std::string parts_, done_;  ///< of the last decision
  bool stated_ = true, given_is_used_ = false;
};

void take_labels(const ImportFiles& files, const ImportReading& reading, ImportSource& source,
                 ProblemList& problems) {
  if (!files.leaflets.empty())
    return problems.add(
        ErrorCode::UnknownField, "/labels",
        "cannot be combined with leaflet meshes, because its labels are the leaflets");
  std::optional<LabelMap> map;
  take(read_label_map(files.labels->bytes, reading.most_voxels, reading.phase), "/labels", problems,
       map);
  if (!map) return;
  std::optional<std::string> placed;
  if (reading.series) take(place(*map, *reading.series), "/series", problems, placed);
  if (!problems.empty()) return;
  if (placed) source.decisions.push_back({"series", *placed, ""});
  Expected<LabelParts> parts =
      label_parts(*map, reading.labels, {!files.annulus.has_value(), reading.phase > 0});
  if (!parts) {
    for (const Error& error : parts.errors()) problems.add(error.code, error.path, error.message);
    return;
  }
  source.leaflets = std::move(parts->leaflets);
  source.order = std::move(parts->order);
  source.parts = std::move(parts->parts);
  source.sided = std::move(parts->sided);
  source.witnesses = std::move(parts->witnesses);
  source.axes = map->placed ? SourceAxes::Stated : SourceAxes::Unknown;
  source.unit = LengthUnit::Millimetre;
  if (!files.annulus) {
    source.annulus_mm = std::move(parts->annulus_mm);
    source.annulus_band_mm = parts->annulus_band_mm;
  }
  source.decisions.insert(source.decisions.end(), parts->decisions.begin(), parts->decisions.end());
}

}  // namespace

namespace {

/// One file: a skirt, or both leaflets and perhaps the annulus as its parts.
void take_parts(const ImportFiles& files, const ImportReading& reading, AxesOfFiles& axes,
                ImportSource& source, ProblemList& problems) {
  const NamedFile& file = files.leaflets[0];
  std::optional<MeshParts> parts;
  take(read_mesh_parts(file.bytes, format_of(file.name), reading.most_unpacked), "/leaflets/0",
       problems, parts);
  const bool turned = axes.turned(file, "leaflets");
  if (!parts) return;
  tell_left_over("leaflets", "arrays", parts->arrays, source);
  std::optional<MeshLeaflets> found;
  take(leaflets_of(*std::move(parts), reading.labels), "/leaflets/0", problems, found);
  if (!found) return;
  source.leaflets = std::move(found->leaflets);
  source.order = std::move(found->order);
  source.parts = std::move(found->parts);
  source.sided = std::move(found->sided);
  source.decisions.insert(source.decisions.end(), found->decisions.begin(), found->decisions.end());
  if (turned) {
    for (TriangleMesh& mesh : source.leaflets) turn_axes(mesh.vertices_mm);
    for (ImportedTip& place : source.sided) turn_axes(place.position_mm);
  }
  if (files.annulus || found->annulus_mm.rows() == 0) return;
  source.annulus_mm = std::move(found->annulus_mm);
  if (turned) turn_axes(source.annulus_mm);
}

/// A file for each leaflet, or several for one.
void take_leaflets(const ImportFiles& files, const ImportReading& reading, AxesOfFiles& axes,
                   ImportSource& source, ProblemList& problems) {
  std::array<std::vector<TriangleMesh>, 2> sides;
  for (std::size_t i = 0; i < files.leaflets.size(); ++i) {
    const NamedFile& file = files.leaflets[i];
    TriangleMesh mesh;
    take(read_mesh(file.bytes, format_of(file.name), reading.most_unpacked),
         "/leaflets/" + std::to_string(i), problems, mesh);
    const std::string part = "leaflet " + std::to_string(i + 1);
    if (axes.turned(file, part)) turn_axes(mesh.vertices_mm);
    tell_left_over(part, "arrays", mesh.arrays, source);
    const std::string name = file.name.substr(file.name.find_last_of("/\\") + 1);
    if (const auto side = side_named(name.substr(0, name.rfind('.')));
        side && mesh.faces.rows() > 0)
      source.sided.push_back(
          {*side, Vec3(mesh.vertices_mm(mesh.faces.reshaped(), Eigen::all).colwise().mean())});
    const bool posterior = files.posterior_from ? i >= *files.posterior_from : i > 0;
    sides[posterior ? 1 : 0].push_back(std::move(mesh));
  }
  for (std::vector<TriangleMesh>& side : sides)
    if (!side.empty())
      source.leaflets.push_back(side.size() == 1 ? std::move(side[0]) : joined(side));
  source.order = files.order;
}

/// Whether a spline by the number of its points would swing between them.
bool is_uneven(const Points& loop) {
  constexpr double kEven = 6.0;
  double shortest = 1e300, longest = 0.0;
  for (Index i = 0; i < loop.rows(); ++i) {
    const double side = (loop.row((i + 1) % loop.rows()) - loop.row(i)).norm();
    if (i + 1 == loop.rows() && side == 0.0) continue;  // the first point again
    shortest = std::min(shortest, side);
    longest = std::max(longest, side);
  }
  return longest > kEven * shortest;
}

/// An annulus of so few points that their polygon is more than 0.3 % too short is the smooth curve through them.
void smooth_few_points(ImportSource& source) {
  constexpr Index kLeast = 6, kFew = 24;
  const Index count = source.annulus_mm.rows();
  if (count < kLeast || count >= kFew || !source.annulus_mm.allFinite() ||
      is_uneven(source.annulus_mm))
    return;
  Markup curve;
  curve.points_mm = source.annulus_mm;
  const Expected<Points> drawn = drawn_closed_curve(curve);
  if (!drawn || drawn->rows() == count) return;
  const double polygon = ArcLength(source.annulus_mm).total_mm();
  source.annulus_mm = *drawn;
  source.decisions.push_back(
      {"annulus", "the smooth closed curve through its " + std::to_string(count) + " points",
       "a polygon through them would be " +
           significant(100.0 * (1.0 - polygon / ArcLength(*drawn).total_mm()), 2) + " % shorter"});
}

/// The columns of a table that none of its readers looks at (of Slicer's own tables that is most of them), and a unit that is none.
void tell_columns(const NamedFile& file, const std::string& part,
                  std::initializer_list<std::string_view> used, ImportSource& source) {
  const std::string format = format_of(file.name);
  if (!is_table_format(format)) return;
  const Expected<CsvTable> table = read_csv(file.bytes, used);
  if (!table) return;  // who reads it says why
  if (format != "fcsv") tell_left_over(part, "columns", unused_columns(*table, used), source);
  if (const std::string& stated = table->no_unit; !stated.empty())
    source.decisions.push_back(
        {"units",
         part + ": " + (is_plain(stated) ? '"' + stated + '"' : "what is stated") + " is ignored",
         "the names of its columns state it, and it is no unit of length (mm, cm, m, in); use "
         "--units to say which",
         true});
}

void take_annulus(const NamedFile& file, AxesOfFiles& axes, ImportSource& source,
                  ProblemList& problems) {
  const std::string format = format_of(file.name);
  take(read_closed_loop(file.bytes, format), "/annulus", problems, source.annulus_mm);
  if (is_table_format(format)) {
    smooth_few_points(source);
    if (const auto unit = stated_unit(file.bytes)) take_annulus_unit(source, *unit);
  }
  tell_columns(file, "annulus", {"x"}, source);
  if (axes.turned(file, "annulus", format == "json")) turn_axes(source.annulus_mm);
}

/// The unit that the columns of a table state; none of other formats, which have one.
std::optional<LengthUnit> unit_of_table(const NamedFile& file,
                                        std::initializer_list<std::string_view> columns) {
  return is_table_format(format_of(file.name)) ? stated_unit(file.bytes, columns) : std::nullopt;
}

/// What else a person saw: chordae, tips, landmarks.
void take_others(const ImportFiles& files, AxesOfFiles& axes, ImportSource& source,
                 ProblemList& problems) {
  if (files.chordae) {
    take(read_chordae(files.chordae->bytes, format_of(files.chordae->name)), "/chordae", problems,
         source.chordae);
    source.chordae_unit = unit_of_table(*files.chordae, {"papillary"});
    tell_columns(*files.chordae, "chordae",
                 {"id", "papillary", "ins_x", "ins_y", "ins_z", "tip_x", "tip_y", "tip_z", "kind"},
                 source);
    if (axes.turned(*files.chordae, "chordae"))
      for (ImportedChorda& chorda : source.chordae) turn_axes(chorda);
  }
  if (files.tips) {
    const std::string format = format_of(files.tips->name);
    take(read_tips(files.tips->bytes, format), "/tips", problems, source.tips);
    source.tips_unit = unit_of_table(*files.tips, {"papillary", "label", "name"});
    tell_columns(*files.tips, "papillary tips",
                 {"papillary", "label", "name", "x", "tip_x", "tip_y", "tip_z"}, source);
    if (axes.turned(*files.tips, "papillary tips", format == "json"))
      for (ImportedTip& tip : source.tips) turn_axes(tip.position_mm);
  }
  if (files.landmarks) {
    const std::string format = format_of(files.landmarks->name);
    take(landmarks_in(files.landmarks->bytes, format), "/landmarks", problems, source.landmarks);
    source.landmarks_unit = unit_of_table(*files.landmarks, {"label", "name"});
    tell_columns(*files.landmarks, "landmarks", {"label", "name", "x"}, source);
    if (axes.turned(*files.landmarks, "landmarks", format == "json"))
      for_each_given(source.landmarks, [](Vec3 place) {
        turn_axes(place);
        return place;
      });
  }
}

}  // namespace

Expected<ImportSource> read_import_files(const ImportFiles& files, const ImportReading& reading) {
  ImportSource source;
  ProblemList problems;
  AxesOfFiles axes(reading.axes);
  if (files.leaflets.size() == 1)
    take_parts(files, reading, axes, source, problems);
  else
    take_leaflets(files, reading, axes, source, problems);
  if (!files.leaflets.empty() && axes.are_stated()) source.axes = SourceAxes::Stated;
  if (files.labels)
    take_labels(files, reading, source, problems);
  else if (reading.series)
    problems.add(ErrorCode::MissingField, "/labels",
                 "is missing: the geometry of a series of images applies only to a label map");
  for (const auto& [file, path] : {std::pair(&files.annulus, "/annulus"),
                                   {&files.chordae, "/chordae"},
                                   {&files.tips, "/tips"},
                                   {&files.landmarks, "/landmarks"}})
    if (*file && is_in_voxels((*file)->bytes))
      problems.add(ErrorCode::Unsupported, path,
                   "is in voxels of an image (CoordinateSystem = IJK); must be in LPS or RAS");
  if (files.annulus) take_annulus(*files.annulus, axes, source, problems);
  if (files.annulus && problems.empty() &&
      std::any_of(files.leaflets.begin(), files.leaflets.end(),
                  [](const NamedFile& file) { return is_gltf_format(format_of(file.name)); }))
    take_metres(source);
  take_others(files, axes, source, problems);
  if (!problems.empty()) return std::move(problems).take();
  const std::vector<ImportDecision> turned = std::move(axes).take();
  source.decisions.insert(source.decisions.end(), turned.begin(), turned.end());
  return source;
}

}  // namespace coapt
