#include "io/picture/import_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/metrics/leaflet_sides.h"
#include "core/metrics/section.h"
#include "core/metrics/surface_tree.h"
#include "io/json/version.h"
#include "io/picture/import_paint.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr int kImportWidth = 1500, kImportHeight = 1010;
constexpr double kEdge = 28.0, kTop = 92.0, kGap = 34.0, kFoot = 40.0;
constexpr double kColumn = (kImportWidth - 4.0 * kEdge) / 3.0;
constexpr double kRoom = 70.0;   // px beside the valve, for words
constexpr double kFar_mm = 1.0;  // where the colours of distances end

constexpr double kCutEdge = 0.3;  // darker than the leaflet, as on the page
constexpr Colour kBlack{};
constexpr Colour kNear{0.93, 0.93, 0.91}, kAway{0.45, 0.10, 0.50};

const Eye kFromAtrium{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
const Eye kFromBehind{Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitY()};
const Eye kSection{-Vec3::UnitY(), Vec3::UnitZ(), -Vec3::UnitX()};  // anterior left

/// Where the four drawings lie, all at one scale.
struct PictureSheet {
  double pixels_per_mm = 1.0, upper = 0.0, lower = 0.0;  // heights of the rows
  Eigen::AlignedBox3d extent;

  Box box(int column, int row) const {
    return {kEdge + column * (kColumn + kEdge), kTop + (row == 0 ? 0.0 : upper + kGap), kColumn,
            row == 0 ? upper : lower};
  }
  /// Of a drawing, its middle in the middle of the box.
  Mapping map(const Box& box, const Eye& eye) const {
    const Vec3 middle = extent.center();
    return {eye.on(middle), {box.x + 0.5 * box.width, box.y + 0.5 * box.height}, pixels_per_mm};
  }
};

PictureSheet sheet_for(const ImportedValve& imported) {
  PictureSheet sheet;
  const auto hold = [&](const Points& points) {
    for (const auto point : points.rowwise()) sheet.extent.extend(Vec3(point.transpose()));
  };
  hold(imported.valve.rest_mm);
  hold(imported.input.annulus_mm);
  for (const TriangleMesh& mesh : imported.input.leaflets) hold(mesh.vertices_mm);
  for (const PapillaryHead& head : imported.valve.heads) sheet.extent.extend(head.rest_mm);
  const Vec3 size = sheet.extent.sizes();
  const double height = kImportHeight - kTop - kGap - kFoot;
  sheet.pixels_per_mm = std::min({(kColumn - 2.0 * kRoom) / std::max(size.x(), size.y()),
                                  (height - 2.0 * kRoom) / (size.y() + size.z())});
  const double spare = height - sheet.pixels_per_mm * (size.y() + size.z());
  sheet.upper = sheet.pixels_per_mm * size.y() + 0.5 * spare;
  sheet.lower = height - sheet.upper;
  return sheet;
}

/// Each leaflet in its own colour: which one was taken as the anterior is seen at once.
std::vector<TintedMesh> given_meshes(const ImportInput& input) {
  std::vector<TintedMesh> meshes;
  for (const TriangleMesh& mesh : input.leaflets) {
    const Colour colour = input.leaflets.size() < 2
                              ? palette::kSurface
                              : segment_colour(meshes.empty() ? Segment::A2 : Segment::P2);
    meshes.push_back(
        {mesh.vertices_mm, mesh.faces,
         std::vector<Colour>(static_cast<std::size_t>(mesh.vertices_mm.rows()), colour)});
  }
  return meshes;
}

/// Corners are not shared: each segment has its own colour.
TintedMesh made_mesh(const Valve& valve) {
  TintedMesh mesh{Points(3 * valve.faces.rows(), 3), Faces(valve.faces.rows(), 3), {}};
  for (Eigen::Index f = 0; f < valve.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      mesh.vertices_mm.row(3 * f + k) = valve.rest_mm.row(valve.faces(f, k));
      mesh.faces(f, k) = static_cast<int>(3 * f + k);
      mesh.colours.push_back(segment_colour(valve.segments[static_cast<std::size_t>(f)]));
    }
  return mesh;
}

std::vector<Stroke> given_chordae(const ImportInput& input) {
  std::vector<Stroke> strokes;
  for (const ImportedChorda& chorda : input.chordae) {
    if (chorda.segments.empty()) strokes.push_back({chorda.tip_mm, chorda.insertion_mm});
    for (const ImportedSegment& segment : chorda.segments)
      strokes.push_back({segment.parent < 0
                             ? chorda.tip_mm
                             : chorda.segments[static_cast<std::size_t>(segment.parent)].end_mm,
                         segment.end_mm});
  }
  return strokes;
}

std::vector<Stroke> made_chordae(const Valve& valve) {
  std::vector<Stroke> strokes;
  for (const Chorda& chorda : valve.chordae) {
    const auto end_mm = [&](const ChordaSegment& segment) {
      if (!segment.inserts) return segment.branch_point_mm;
      Vec3 at = Vec3::Zero();
      for (int k = 0; k < 3; ++k)
        at += segment.insertion.weights[static_cast<std::size_t>(k)] *
              valve.rest_mm.row(valve.faces(segment.insertion.face, k)).transpose();
      return at;
    };
    for (const ChordaSegment& segment : chorda.segments)
      strokes.push_back({segment.parent < 0
                             ? valve.heads[static_cast<std::size_t>(chorda.head)].rest_mm
                             : end_mm(chorda.segments[static_cast<std::size_t>(segment.parent)]),
                         end_mm(segment)});
  }
  return strokes;
}

/// Dots; the muscle's name below the lowest of each side.
std::vector<NamedPoint> tip_marks(const std::vector<ImportedTip>& tips) {
  std::vector<NamedPoint> marks;
  for (const Side side : {Side::Anterolateral, Side::Posteromedial}) {
    const std::size_t first = marks.size();
    for (const ImportedTip& tip : tips)
      if (tip.side == side) marks.push_back({tip.position_mm, ""});
    const auto lowest = std::min_element(
        marks.begin() + static_cast<std::ptrdiff_t>(first), marks.end(),
        [](const NamedPoint& a, const NamedPoint& b) { return a.at_mm.z() < b.at_mm.z(); });
    if (lowest != marks.end())
      lowest->words = side == Side::Anterolateral ? "AL muscle" : "PM muscle";
  }
  return marks;
}

std::vector<NamedPoint> given_tips(const ImportInput& input) {
  std::vector<ImportedTip> tips = input.tips;
  for (const ImportedChorda& chorda : input.chordae) tips.push_back({chorda.side, chorda.tip_mm});
  return tip_marks(tips);
}

std::vector<NamedPoint> made_tips(const Valve& valve) {
  std::vector<ImportedTip> tips;
  for (const PapillaryHead& head : valve.heads) tips.push_back({head.side, head.rest_mm});
  return tip_marks(tips);
}

std::vector<NamedPoint> landmark_marks(const Valve& valve) {
  const Landmarks& marks = valve.landmarks;
  const auto mark = [&](int vertex, const char* words) {
    return NamedPoint{valve.rest_mm.row(vertex).transpose(), words};
  };
  return {mark(marks.anterolateral_commissure, "AL comm."),
          mark(marks.posteromedial_commissure, "PM comm."), mark(marks.saddle_peak, "saddle peak"),
          mark(marks.mid_posterior, "mid-posterior")};
}

Points loop_of(const Valve& valve) {
  Points loop(std::ssize(valve.annulus), 3);
  for (Eigen::Index i = 0; i < loop.rows(); ++i)
    loop.row(i) = valve.rest_mm.row(valve.annulus[static_cast<std::size_t>(i)]);
  return loop;
}

void draw_views(const Canvas& canvas, const PictureSheet& sheet, const ImportedValve& imported) {
  const Valve& valve = imported.valve;
  const std::vector<TintedMesh> given = given_meshes(imported.input), made = {made_mesh(valve)};
  const std::vector<Stroke> cords = given_chordae(imported.input), chordae = made_chordae(valve);
  const std::vector<NamedPoint> tips = given_tips(imported.input), heads = made_tips(valve);
  for (int row = 0; row < 2; ++row) {
    const Eye& eye = row == 0 ? kFromAtrium : kFromBehind;
    for (int column = 0; column < 2; ++column) {
      const Box box = sheet.box(column, row);
      const Drawing drawing{canvas, eye, sheet.map(box, eye)};
      const bool is_given = column == 0;
      if (row == 0) paint_strokes(drawing, is_given ? cords : chordae);
      paint_meshes(drawing, is_given ? given : made);
      paint_loop(drawing, is_given ? imported.input.annulus_mm : loop_of(valve));
      if (row == 1) paint_strokes(drawing, is_given ? cords : chordae);
      if (row == 1) paint_marks(drawing, is_given ? tips : heads, palette::kPapillary);
      if (row == 0 && !is_given) {
        paint_segment_names(drawing, valve);
        paint_marks(drawing, landmark_marks(valve), palette::kAnnulus);
      }
      draw_scale_bar(canvas, {box, sheet.pixels_per_mm});
    }
  }
}

void draw_cut(const Drawing& drawing, const Points& points_mm, const Faces& faces, double width_px,
              const std::function<Colour(int)>& colour_of) {
  cairo_t* cairo = drawing.canvas.context.get();
  cairo_set_line_width(cairo, width_px);
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
  for (const SectionLine& line : cut(faces, points_mm, {Vec3::Zero(), Vec3::UnitX()}))
    for (std::size_t i = 0; i + 1 < line.points_mm.size(); ++i) {
      const Vec2 a = drawing.place(line.points_mm[i]), b = drawing.place(line.points_mm[i + 1]);
      set_colour(drawing.canvas, colour_of(line.faces[i]));
      cairo_move_to(cairo, a.x(), a.y());
      cairo_line_to(cairo, b.x(), b.y());
      cairo_stroke(cairo);
    }
}

/// Cut at x = 0: what was given broad and pale, the valve over it.
void draw_middle(const Canvas& canvas, const PictureSheet& sheet, const ImportedValve& imported) {
  const Box box = sheet.box(2, 1);
  const Drawing drawing{canvas, kSection, sheet.map(box, kSection)};
  for (const TriangleMesh& mesh : imported.input.leaflets)
    draw_cut(drawing, mesh.vertices_mm, mesh.faces, 7.0,
             [](int) { return mixed(palette::kSurface, palette::kPaper, 0.4); });
  const std::vector<Leaflet> sides = leaflet_sides(imported.valve);
  draw_cut(drawing, imported.valve.rest_mm, imported.valve.faces, 3.0, [&](int face) {
    const bool is_anterior = sides[static_cast<std::size_t>(face)] == Leaflet::Anterior;
    return mixed(is_anterior ? palette::kAnterior : palette::kPosterior, kBlack, kCutEdge);
  });
  draw_scale_bar(canvas, {box, sheet.pixels_per_mm});
}

/// Closed leaflets lie off open ones: they are shown with the landmarks that were found.
void draw_landmarks_on_given(const Canvas& canvas, const PictureSheet& sheet,
                             const ImportedValve& imported) {
  const Box box = sheet.box(2, 0);
  const Drawing drawing{canvas, kFromAtrium, sheet.map(box, kFromAtrium)};
  paint_meshes(drawing, given_meshes(imported.input));
  paint_loop(drawing, imported.input.annulus_mm);
  paint_marks(drawing, landmark_marks(imported.valve), palette::kAnnulus);
  draw_scale_bar(canvas, {box, sheet.pixels_per_mm});
}

/// The valve from the atrium by how far its vertices lie from what was given.
std::string draw_distances(const Canvas& canvas, const PictureSheet& sheet,
                           const ImportedValve& imported) {
  const Valve& valve = imported.valve;
  const Box box = sheet.box(2, 0);
  TintedMesh mesh{valve.rest_mm, valve.faces, {}};
  const TriangleMesh given = joined(imported.input.leaflets);
  const SurfaceTree surface(given.vertices_mm, given.faces);
  double sum = 0.0, most = 0.0;
  for (const auto vertex : valve.rest_mm.rowwise()) {
    const double away = surface.nearest(vertex.transpose()).distance_mm;
    mesh.colours.push_back(mixed(kNear, kAway, std::min(1.0, away / kFar_mm)));
    sum += away * away;
    most = std::max(most, away);
  }
  const Drawing drawing{canvas, kFromAtrium, sheet.map(box, kFromAtrium)};
  paint_meshes(drawing, {mesh});
  const double left = box.x + box.width - 150.0, top = box.y + box.height - 30.0;
  for (int i = 0; i < 100; ++i)
    fill_box(canvas, {left + i, top, 1.5, 10.0}, mixed(kNear, kAway, 0.01 * i));
  draw_text(canvas, {left, top + 24.0}, "0", {12.0, palette::kMuted, Align::Centre});
  draw_text(canvas, {left + 100.0, top + 24.0}, fixed(kFar_mm, 0) + " mm and more",
            {12.0, palette::kMuted, Align::Centre});
  draw_scale_bar(canvas, {box, sheet.pixels_per_mm});
  return "rms " + fixed(std::sqrt(sum / static_cast<double>(valve.rest_mm.rows())), 2) +
         ", at most " + fixed(most, 1) + " mm";
}

}  // namespace

std::string import_picture_png(const ImportedValve& imported, const std::string& title) {
  const Canvas canvas = make_canvas(kImportWidth, kImportHeight);
  fill_box(canvas, {0.0, 0.0, kImportWidth, kImportHeight}, palette::kPaper);
  draw_text(canvas, {kEdge, 38.0}, title, {22.0, palette::kInk, Align::Left, true},
            kImportWidth - 2.0 * kEdge);
  const PictureSheet sheet = sheet_for(imported);
  draw_views(canvas, sheet, imported);
  std::string third = "Input, closed, with the detected landmarks";
  if (imported.input.closed)
    draw_landmarks_on_given(canvas, sheet, imported);
  else
    third = "Distance from input: " + draw_distances(canvas, sheet, imported);
  draw_middle(canvas, sheet, imported);
  const std::size_t count = imported.input.leaflets.size();
  const auto head = [&](int column, int row, const std::string& text) {
    const Box box = sheet.box(column, row);
    draw_text(canvas, {box.x, box.y - 12.0}, text, {15.0, palette::kInk, Align::Left, true},
              box.width);
  };
  head(0, 0,
       std::string("Input, seen from the atrium: ") +
           (count == 1 ? "one surface" : std::to_string(count) + " surfaces"));
  head(1, 0, "Resulting valve: " + counted(imported.valve.faces.rows(), "triangle"));
  head(2, 0, third);
  head(0, 1, "Input, seen from posterior: anterolateral left");
  head(1, 1, "The valve: " + counted(std::ssize(imported.valve.chordae), "chorda", "chordae"));
  head(2, 1, "Section through the middle, anterior left; pale: input");
  draw_text(canvas, {0.5 * kImportWidth, kImportHeight - 14.0}, std::string(kResearchNotice),
            {13.0, palette::kMuted, Align::Centre}, kImportWidth - 2.0 * kEdge);
  return to_png(canvas);
}

void load_import_fonts() {
  const Canvas canvas = make_canvas(1, 1);
  for (const bool bold : {false, true}) draw_text(canvas, {0.0, 0.0}, "a", {.bold = bold});
}

}  // namespace coapt
