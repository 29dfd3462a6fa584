#include "io/mesh/import_sheets.h"

#include <algorithm>
#include <numeric>

#include "core/valve/counted.h"
#include "core/valve/number_text.h"
#include "core/valve/problem_list.h"
#include "io/mesh/find_annulus.h"
#include "io/mesh/mid_surface.h"
#include "io/mesh/sheet_repair.h"

namespace coapt {
namespace {

constexpr double kIslandsToCheck = 0.005;  // of a leaflet; a few stray voxels are less
constexpr double kThickOfArea = 0.6;       // with an opposite side, of a shell that has an edge
constexpr const char *kAnterior = "anterior leaflet", *kPosterior = "posterior leaflet";
constexpr int kToldHoles = 5;
constexpr double kFurthest_mm = 1e6;       // further away, products of coordinates lose the valve
constexpr double kThickestSheet_mm = 4.0;  // above it, sides of a folded sheet are meant

std::string which(const std::vector<TriangleMesh>& leaflets, std::size_t i) {
  if (leaflets.size() == 1) return "skirt";
  return i == 0 ? kAnterior : kPosterior;
}

std::string place(const Vec3& point) {
  return '(' + significant(point.x(), 3) + ", " + significant(point.y(), 3) + ", " +
         significant(point.z(), 3) + ')';
}

void tell_repairs(const RepairedSheet& sheet, const std::string& name,
                  std::vector<ImportDecision>& told) {
  if (sheet.collapsed > 0)
    told.push_back({name, counted(sheet.collapsed, "collapsed triangle") + " dropped",
                    "two corners coincide"});
  if (sheet.repeated > 0)
    told.push_back({name, counted(sheet.repeated, "repeated triangle") + " dropped",
                    "same corners as another triangle"});
  if (sheet.turned > 0)
    told.push_back({name, counted(sheet.turned, "triangle") + " flipped",
                    "orientation opposite to that of the neighbours"});
  if (sheet.islands > 0)
    told.push_back(
        {name,
         counted(sheet.islands, "loose piece") + " with a total area of " +
             significant(sheet.islands_mm2, 2) + " mm2 dropped",
         "each less than 5 % of the leaflet's " + significant(sheet.area_mm2, 3) + " mm2",
         sheet.islands_mm2 > kIslandsToCheck * sheet.area_mm2});
  if (sheet.branching_edges > 0)
    told.push_back(
        {name,
         counted(sheet.branching_edges, "edge") + " shared by more than two triangles, unchanged",
         "cuts follow two of the triangles", true});
  std::string widths;
  int filled = 0;
  for (const SheetHole& hole : sheet.holes) {
    if (!hole.filled || ++filled > kToldHoles) continue;
    widths += (filled == 1 ? "" : ", ") + significant(hole.width_mm, 2) + " mm at " +
              place(hole.centre_mm);
  }
  const int small = static_cast<int>(sheet.holes.size()) - filled;
  if (filled > 0)
    told.push_back(
        {name, counted(filled, "hole") + " filled",
         "at most 6 mm wide, interpreted as gaps of the segmentation, not as perforations: " +
             widths + (filled > kToldHoles ? ", ..." : "") + " in the axes of the files",
         true});
  if (small > 0)
    told.push_back(
        {name, counted(small, "hole") + " of at most 3 mm bridged by the cuts",
         "such narrow gaps are due to the segmentation or lie between the roots of chordae"});
}

MeasuredThickness measured(const std::vector<double>& values, std::size_t leaflet) {
  MeasuredThickness thickness{leaflet, values};
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  const auto share = [&](double q) {
    return sorted[static_cast<std::size_t>(q * static_cast<double>(sorted.size() - 1))];
  };
  thickness.p10_mm = share(0.1);
  thickness.p90_mm = share(0.9);
  thickness.mean_mm =
      std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  return thickness;
}

/// A shell becomes its mid-surface; a sheet stays.
Errors flatten(TriangleMesh& mesh, std::size_t i, std::size_t outlines, const std::string& name,
               const ClosureBudget& budget, SheetPreparation& prepared) {
  const std::vector<std::vector<int>> edges = boundary_loops(mesh);
  const bool closed = edges.empty();
  if (!closed && opposed_share(mesh, budget) < kThickOfArea) return {};
  Expected<MidSurface> middle = mid_surface(mesh, budget);
  if (!middle) return closed ? middle.errors() : Errors{};
  MeasuredThickness thickness = measured(middle->thickness_mm, i);
  if (!closed && thickness.mean_mm > kThickestSheet_mm) return {};
  if (outlines == 2) {
    const auto loops = boundary_loops(middle->sheet);
    if (loops.size() < 2 || length_mm(loops[1], middle->sheet.vertices_mm) <
                                0.2 * length_mm(loops[0], middle->sheet.vertices_mm))
      return {{ErrorCode::BadTopology, "/faces",
               "is one closed surface without an opening; if both leaflets are fused in it, "
               "provide the anterior and the posterior leaflet as separate meshes"}};
  }
  prepared.decisions.push_back(
      {name,
       "thick shell (" + std::string(closed ? "closed surface" : "two sides with an open rim") +
           ") replaced by its mid-surface; measured " + significant(thickness.mean_mm, 2) +
           " mm thick (p10 " + significant(thickness.p10_mm, 2) + ", p90 " +
           significant(thickness.p90_mm, 2) + ")",
       "triangles that face each other across at most 8 mm are its two sides; area " +
           significant(area_mm2(middle->sheet), 3) + " mm2"});
  prepared.thickness.push_back(std::move(thickness));
  mesh = std::move(middle->sheet);
  return {};
}

}  // namespace

std::vector<ImportDecision> drop_loose_points(ImportSource& source) {
  std::vector<ImportDecision> told;
  for (std::size_t i = 0; i < source.leaflets.size(); ++i) {
    TriangleMesh& mesh = source.leaflets[i];
    if (mesh.faces.rows() == 0 || mesh.faces.minCoeff() < 0 ||
        mesh.faces.maxCoeff() >= mesh.vertices_mm.rows())
      continue;
    if (const int loose = drop_loose_points(mesh); loose > 0)
      told.push_back(
          {which(source.leaflets, i), counted(loose, "point") + " left out", "in no triangle"});
  }
  return told;
}

void swap_names(SheetPreparation& prepared) {
  for (ImportDecision& decision : prepared.decisions) {
    if (decision.subject == kAnterior)
      decision.subject = kPosterior;
    else if (decision.subject == kPosterior)
      decision.subject = kAnterior;
  }
  for (MeasuredThickness& of : prepared.thickness) of.leaflet = 1 - of.leaflet;
}

void check_leaflets(const std::vector<TriangleMesh>& leaflets, ProblemList& problems) {
  if (leaflets.empty() || leaflets.size() > 2) {
    problems.add(ErrorCode::OutOfRange, "/leaflets",
                 "has " + std::to_string(leaflets.size()) +
                     " meshes, must be the anterior and the posterior sheet, or one skirt");
  }
  for (std::size_t i = 0; i < leaflets.size(); ++i) {
    const TriangleMesh& mesh = leaflets[i];
    const std::string path = "/leaflets/" + std::to_string(i);
    if (mesh.faces.rows() == 0 || mesh.faces.rows() > kMostFaces) {
      problems.add(
          ErrorCode::OutOfRange, path + "/faces",
          "has " + std::to_string(mesh.faces.rows()) + " triangles, must have 1 to 1000000");
    } else if (mesh.faces.minCoeff() < 0 || mesh.faces.maxCoeff() >= mesh.vertices_mm.rows()) {
      problems.add(
          ErrorCode::BadReference, path + "/faces",
          "must hold indices of vertices, 0 to " + std::to_string(mesh.vertices_mm.rows() - 1));
    }
    if (!(mesh.vertices_mm.array().abs() <= kFurthest_mm).all())
      problems.add(ErrorCode::OutOfRange, path + "/vertices_mm",
                   "must be numbers from -1e6 to 1e6 mm");
  }
}

bool is_sound(const std::vector<TriangleMesh>& leaflets) {
  ProblemList problems;
  check_leaflets(leaflets, problems);
  return problems.empty();
}

Expected<SheetPreparation> prepare_sheets(ImportSource& source, const ClosureBudget& budget) {
  SheetPreparation prepared;
  if (!is_sound(source.leaflets)) return prepared;
  ProblemList problems;
  const std::size_t outlines = source.leaflets.size() == 1 ? 2 : 1;
  for (std::size_t i = 0; i < source.leaflets.size(); ++i) {
    TriangleMesh& mesh = source.leaflets[i];
    const std::string name = which(source.leaflets, i);
    const auto add = [&](const Errors& errors) {
      for (const Error& error : errors)
        problems.add(error.code, "/leaflets/" + std::to_string(i) + error.path, error.message);
    };
    const auto is_mended = [&] {
      Expected<RepairedSheet> repaired = repaired_sheet(mesh, outlines, budget);
      if (!repaired) {
        add(repaired.errors());
        return false;
      }
      tell_repairs(*repaired, name, prepared.decisions);
      mesh = std::move(repaired->mesh);
      return true;
    };
    if (!is_mended()) continue;
    const std::size_t shells = prepared.thickness.size();
    if (Errors errors = flatten(mesh, i, outlines, name, budget, prepared); !errors.empty())
      add(errors);
    else if (prepared.thickness.size() > shells)
      is_mended();  // holes that trimming left
  }
  if (!problems.empty()) return std::move(problems).take();
  if (source.annulus_mm.rows() > 0) return prepared;
  Expected<FoundAnnulus> found = find_annulus(source);
  if (!found) return found.errors();
  const double percent = 100.0 * found->margin;
  const std::string margin =
      (percent < 100.0 ? significant(percent, 2) : with_decimals(percent, 0)) + " %";
  if (source.leaflets.size() == 1)
    prepared.decisions.push_back({"annulus",
                                  "not given; detected as the edge of the skirt that is further "
                                  "from the papillary tips, by " +
                                      margin,
                                  "a skirt has two edges, and the free edge is nearer to the tips",
                                  true});
  else
    prepared.decisions.push_back({"annulus",
                                  "not given; detected along the leaflet outlines, with a score " +
                                      margin + " above that of the next loop",
                                  "it is the widest, flattest loop formed by their edges; " +
                                      significant(found->off_plane_mm, 2) +
                                      " mm from a plane (rms), " + significant(found->gap_mm, 2) +
                                      " mm between the leaflets where they meet",
                                  true});
  source.annulus_mm = std::move(found->annulus_mm);
  return prepared;
}

}  // namespace coapt
