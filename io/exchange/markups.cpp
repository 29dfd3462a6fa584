#include "io/exchange/markups.h"

#include <Eigen/LU>

#include "io/json/json_reader.h"
#include "io/json/parse_json.h"
#include "io/json/version.h"
#include "io/mesh/mesh_builder.h"
#include "io/mesh/plausibility.h"

namespace coapt {
namespace {

constexpr const char* kSchema =
    "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/"
    "Schema/markups-schema-v1.0.3.json#";
constexpr std::string_view kVersions =
    "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/"
    "Schema/markups-schema-v1.";
constexpr MarkupType kTypes[] = {MarkupType::Fiducial, MarkupType::Line, MarkupType::Curve,
                                 MarkupType::ClosedCurve};

constexpr Index kLeastControls = 6;
constexpr Index kDense = 60, kDrawn = 240;  // points of a curve: not splined, of a spline

Json control_points(const Markup& markup) {
  Json points = Json::array();
  for (Eigen::Index i = 0; i < markup.points_mm.rows(); ++i) {
    const auto& p = markup.points_mm.row(i);
    points.push_back({{"id", std::to_string(i + 1)},
                      {"label", markup.labels[static_cast<std::size_t>(i)]},
                      {"position", {p[0], p[1], p[2]}},
                      {"selected", true},
                      {"locked", true},
                      {"visibility", true},
                      {"positionStatus", "defined"}});
  }
  return points;
}

/// The member if it is there and a string.
std::string text_of(const Json& object, const char* name, const char* otherwise) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

/// The points that are defined and their labels.
void read_control_points(const JsonPlace& place, double sign, Markup& markup) {
  std::vector<Vec3> points;
  read_array(place, [&](const JsonPlace& entry) {
    if (!entry.value.is_object())
      return add_problem(entry, ErrorCode::WrongType, "must be an object");
    if (text_of(entry.value, "positionStatus", "defined") != "defined") return;
    const auto position = read_member(entry, "position");
    if (!position) return;
    Vec3 point = read_vector(*position);
    for (const double coordinate : point)
      if (coordinate < kMeshCoordinateMm.min || coordinate > kMeshCoordinateMm.max)
        add_problem(*position, ErrorCode::OutOfRange,
                    "is " + shown(coordinate) + ", must be from -1e5 to 1e5 mm");
    points.emplace_back(sign * point.x(), sign * point.y(), point.z());
    markup.labels.push_back(text_of(entry.value, "label", ""));
  });
  markup.points_mm.resize(std::ssize(points), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    markup.points_mm.row(static_cast<Eigen::Index>(i)) = points[i];
}

const char* words_of(MarkupAxes axes) {
  return axes == MarkupAxes::Patient
             ? "of the patient's images"
             : "of the valve, not the patient's: origin annulus centroid, x to the posteromedial "
               "commissure, y anterior, z to the atrium";
}

}  // namespace

std::string write_markups(const std::vector<Markup>& markups, MarkupAxes axes,
                          const std::string& doubt) {
  Json list = Json::array();
  for (const Markup& markup : markups)
    list.push_back(
        {{"type", to_string(markup.type)},
         {"name", markup.name},
         {"coordinateSystem", "LPS"},
         {"coordinateUnits", "mm"},
         {"locked", true},
         {"fixedNumberOfControlPoints", true},
         {"labelFormat", "%N-%d"},
         {"controlPoints", control_points(markup)},
         {"display",
          {{"visibility", true}, {"pointLabelsVisibility", markup.type == MarkupType::Fiducial}}}});
  Json told = {{"notice", kResearchNotice}, {"axes", words_of(axes)}};
  if (!doubt.empty()) told["closure"] = doubt;
  const Json document = {
      {"@schema", kSchema}, {"coapt", std::move(told)}, {"markups", std::move(list)}};
  return document.dump(1) + '\n';
}

Expected<std::vector<Markup>> read_markups(std::string_view text) {
  const Expected<Json> document = parse_json(text);
  if (!document) return document.errors();
  ProblemList problems;
  const JsonPlace root{*document, problems};
  std::vector<Markup> markups;
  if (const auto schema = read_member(root, "@schema");
      schema && !read_string(*schema).starts_with(kVersions))
    add_problem(*schema, ErrorCode::Unsupported,
                "must be that of Slicer's markups, version 1 ('" + std::string(kSchema) + "')");
  if (const auto list = read_member(root, "markups")) {
    read_array(*list, [&](const JsonPlace& place) {
      if (!place.value.is_object())
        return add_problem(place, ErrorCode::WrongType, "must be an object");
      const std::string type = text_of(place.value, "type", "");
      for (const MarkupType known : kTypes) {
        if (type != to_string(known)) continue;
        const std::string system = text_of(place.value, "coordinateSystem", "LPS");
        const bool is_ras = system == "RAS" || system == "0";
        if (!is_ras && system != "LPS" && system != "1")
          add_problem(place, ErrorCode::Unsupported,
                      "has coordinateSystem '" + system.substr(0, 20) + "', must be LPS or RAS");
        if (text_of(place.value, "coordinateUnits", "mm") != "mm")
          add_problem(place, ErrorCode::Unsupported, "has other coordinateUnits than mm");
        Markup& markup = markups.emplace_back();
        markup.type = known;
        markup.name = text_of(place.value, "name", "");
        markup.straight = text_of(place.value, "curveType", "spline") == "linear";
        if (const auto points = read_member(place, "controlPoints"))
          read_control_points(*points, is_ras ? -1.0 : 1.0, markup);
      }
    });
  }
  if (!problems.empty()) return std::move(problems).take();
  return markups;
}

Expected<Points> drawn_closed_curve(const Markup& curve) {
  const Points& control = curve.points_mm;
  const Index n = control.rows();
  if (n < kLeastControls)
    return Error{ErrorCode::MissingField, "",
                 "has a ClosedCurve with " + std::to_string(n) +
                     " placed points, must have at least 6 that are placed (positionStatus "
                     "defined)"};
  if (curve.straight || n >= kDense) return control;
  // Across a gap a spline swings out, and hides it: the checks of contours look at what was placed.
  if (const auto checked = contour_checks(control); !checked || !checked->empty()) return control;
  // Second derivatives m of the spline: m[i-1] + 4 m[i] + m[i+1] = 6 (p[i-1] - 2 p[i] + p[i+1]), round the curve.
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n, n);
  Points right(n, 3);
  for (Index i = 0; i < n; ++i) {
    const Index before = (i + n - 1) % n, after = (i + 1) % n;
    system(i, i) = 4.0;
    system(i, before) += 1.0;
    system(i, after) += 1.0;
    right.row(i) = 6.0 * (control.row(before) - 2.0 * control.row(i) + control.row(after));
  }
  const Points second = system.partialPivLu().solve(right);
  const Index steps = (kDrawn + n - 1) / n;
  Points drawn(n * steps, 3);
  for (Index i = 0; i < n; ++i)
    for (Index k = 0; k < steps; ++k) {
      const Index after = (i + 1) % n;
      const double u = static_cast<double>(k) / static_cast<double>(steps), v = 1.0 - u;
      drawn.row(i * steps + k) =
          v * control.row(i) + u * control.row(after) +
          ((v * v * v - v) * second.row(i) + (u * u * u - u) * second.row(after)) / 6.0;
    }
  return drawn;
}

const char* to_string(MarkupType type) {
  switch (type) {
    case MarkupType::Fiducial:
      return "Fiducial";
    case MarkupType::Line:
      return "Line";
    case MarkupType::Curve:
      return "Curve";
    case MarkupType::ClosedCurve:
      return "ClosedCurve";
  }
  return "";
}

}  // namespace coapt
