#include "clients/python/engine/shapes.h"

#include <array>
#include <utility>

#include "clients/python/engine/problems.h"
#include "io/exchange/formats.h"
#include "io/exchange/shape_file.h"
#include "io/json/comparison_json.h"
#include "io/json/fit_json.h"
#include "io/mesh/write_mesh.h"
#include "io/picture/fit_picture.h"

namespace coapt {
namespace {

template <class Value>
Value chosen(const std::string& word, const std::string& path,
             const std::vector<std::pair<std::string, Value>>& choices) {
  std::string words;
  for (const auto& [name, value] : choices) {
    if (name == word) return value;
    words += (words.empty() ? "" : ", ") + name;
  }
  throw Problems({{ErrorCode::BadReference, path, "is \"" + word + "\", must be one of " + words}});
}

FitUnknowns unknowns_of(const std::vector<std::string>& known) {
  FitUnknowns unknowns;
  for (const std::string& name : known)
    unknowns.*chosen<bool FitUnknowns::*>(name, "/known",
                                          {{"slack", &FitUnknowns::slack},
                                           {"tips", &FitUnknowns::tips},
                                           {"prestretch", &FitUnknowns::prestretch},
                                           {"hidden", &FitUnknowns::hidden}}) = false;
  return unknowns;
}

}  // namespace

LocalShape shape_of(const LocalClosure& closed) {
  const Valve& valve = closed.closed.valve;
  if (!closed.closed.closure.closed_mm.allFinite())
    throw Problems({{ErrorCode::BadGeometry, "",
                     "diverged during closure; there is no closed shape to compare"}});
  return {valve.name, shape_of(closed.closed), valve.tissue.thickness_mm};
}

LocalShape shape_of(std::string source, const Points& vertices_mm, const Faces& faces) {
  if (faces.rows() == 0 || faces.minCoeff() < 0 || faces.maxCoeff() >= vertices_mm.rows())
    throw Problems({{ErrorCode::BadReference, "/faces",
                     "must be at least one triangle, of vertices that are there"}});
  return {std::move(source), without_loose_vertices(in_pieces(vertices_mm, faces)), {}};
}

LocalShape shape_of_file(std::string source, std::string_view bytes, const std::string& format) {
  if (!is_shape_format(format))
    throw Problems(
        {{ErrorCode::Unsupported, "", source + " must end in one of " + shape_format_names()}});
  return {std::move(source), taken(read_shape(bytes, format)), {}};
}

std::string file_of(const LocalClosure& closed, const std::string& path, bool open) {
  const FileFormat* const known = format_of_path(path);
  if (known == nullptr)
    throw Problems({{ErrorCode::Unsupported, "", path + " must end in one of " + format_names()}});
  return taken(write_valve_file(closed.closed, *known, {.open = open}));
}

TriangleMesh mesh_of_file(std::string_view bytes, const std::string& format) {
  return taken(read_mesh(bytes, format, kMostUnpacked));
}

std::string file_of(const TriangleMesh& mesh, const std::string& format) {
  return taken(write_mesh(mesh, format));
}

LocalComparison compare_locally(const LocalShape& closed, const LocalShape& reference,
                                const std::string& align) {
  const auto alignment = chosen<Alignment>(
      align, "/align",
      {{"auto", Alignment::Auto}, {"none", Alignment::None}, {"rigid", Alignment::Rigid}});
  const double contact_mm =
      kContactThicknesses * closed.thickness_mm.value_or(reference.thickness_mm.value_or(1.0));
  const auto compared = [contact_mm](const LocalShape& shape) {
    return ComparedShape{shape.source, shape.mesh, nodes_in_contact(shape.mesh, contact_mm)};
  };
  ShapeComparison comparison = compare_shapes(closed.mesh, reference.mesh, alignment);
  std::string document =
      comparison_to_json(comparison, compared(closed), compared(reference), contact_mm).dump();
  return {std::move(document), std::move(comparison.moved_mm), std::move(comparison.signed_mm)};
}

LocalFitted fit_locally(const LocalValve& valve, const LocalFit& asked,
                        std::function<bool(int, double)> progress,
                        std::function<bool()> cancelled) {
  FitOptions options;
  options.unknowns = unknowns_of(asked.known);
  options.threads = asked.threads;
  options.ruptures = asked.ruptures;
  options.most_points = asked.points.value_or(options.most_points);
  options.most_rounds = asked.rounds.value_or(options.most_rounds);
  options.progress = std::move(progress);
  options.cancelled = std::move(cancelled);
  MeasuredClosure measured;
  measured.points_mm = asked.points_mm;
  measured.side = chosen<MeasuredSide>(
      asked.side, "/side", {{"atrial", MeasuredSide::Atrial}, {"middle", MeasuredSide::Middle}});
  measured.leak_mm2 = asked.leak_mm2;
  measured.leak_sd_mm2 = asked.leak_sd_mm2.value_or(measured.leak_sd_mm2);
  const ValveFit fit = taken(fit_valve(*valve.valve, measured, options));
  Valve fitted = fit.closed.valve;
  fitted.provenance.push_back(fit_sentence(fit, "an array"));
  return {{std::make_shared<const Valve>(std::move(fitted))},
          fit_to_json(fit, {valve.valve->name, "an array", measured}).dump()};
}

}  // namespace coapt
