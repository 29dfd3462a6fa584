#include "io/exchange/slicerheart.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>

#include "core/valve/problem_list.h"
#include "io/exchange/chorda_trees.h"
#include "io/exchange/markups.h"
#include "io/exchange/valve_markups.h"
#include "io/exchange/valve_vtk.h"
#include "io/json/json_reader.h"
#include "io/json/valve_json.h"
#include "io/mesh/csv_table.h"
#include "io/mesh/vtk.h"

namespace coapt {
namespace {

constexpr std::size_t kChordRowFields = 7;  // at least: index, two points

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool has(const std::string& text, const char* part) {
  return lower(text).find(part) != std::string::npos;
}

/// All that the files hold, in LPS.
struct Found {
  std::map<std::string, TriangleMesh> surfaces;  ///< by file
  std::vector<TracedLine> lines;
  std::vector<Markup> markups;
  std::optional<TissueFile> tissue;
};

void take_vtk(const NamedFile& file, Found& found, ProblemList& problems) {
  Expected<VtkPolyData> data = read_vtk(file.bytes);
  if (!data) return add_below(problems, file.name, data.errors());
  const bool ras = data->title.find("SPACE=RAS") != std::string::npos;
  if (ras) data->points_mm.leftCols(2) *= -1.0;
  const auto scalars = [&](const char* name) -> const VtkScalars* {
    for (const VtkScalars& s : data->line_data)
      if (s.name == name) return &s;
    return nullptr;
  };
  const VtkScalars *rest = scalars("rest_length_mm"), *diameter = scalars("diameter_mm"),
                   *kind = scalars("kind");
  const std::array<const VtkScalars*, 3> on = {scalars(kToInsertion[0]), scalars(kToInsertion[1]),
                                               scalars(kToInsertion[2])};
  const double across = ras ? -1.0 : 1.0;
  for (std::size_t i = 0; i < data->lines.size(); ++i) {
    TracedLine& line = found.lines.emplace_back();
    line.file = file.name;
    line.place = "/lines/" + std::to_string(i);
    line.start_mm = data->points_mm.row(data->lines[i][0]);
    line.end_mm = data->points_mm.row(data->lines[i][1]);
    if (on[0] != nullptr && on[1] != nullptr && on[2] != nullptr)
      line.end_mm += Vec3(across * on[0]->values[i], across * on[1]->values[i], on[2]->values[i]);
    if (rest != nullptr) line.rest_length_mm = rest->values[i];
    if (diameter != nullptr) line.diameter_mm = diameter->values[i];
    if (kind != nullptr && kind->values[i] == static_cast<double>(ChordaKind::Strut))
      line.kind = ChordaKind::Strut;
    if (kind != nullptr && kind->values[i] == static_cast<double>(ChordaKind::Basal))
      line.kind = ChordaKind::Basal;
  }
  if (data->faces.rows() > 0 && data->lines.empty() && !has(file.name, "annulus"))
    found.surfaces[file.name] = {std::move(data->points_mm), std::move(data->faces)};
}

/// A table of chords if its first row is one; else another table, which is none of ours.
void take_csv(const NamedFile& file, Found& found, ProblemList& problems) {
  const Expected<CsvTable> table = read_csv(file.bytes, {});
  if (!table) return add_below(problems, file.name, table.errors());
  if (table->rows.empty() || table->rows[0].fields.size() < kChordRowFields ||
      !to_integer(table->rows[0].fields[0]))
    return;
  for (std::size_t i = 0; i < table->rows.size(); ++i) {
    const CsvRow& row = table->rows[i];
    TracedLine line;
    line.file = file.name;
    line.place = "/chordae/" + std::to_string(i);
    bool good = row.fields.size() >= kChordRowFields;
    for (std::size_t k = 0; good && k < 6; ++k) {
      const auto number = to_number(row.fields[k + 1]);
      good = number && std::abs(*number) <= 1e5;
      if (good) (k < 3 ? line.start_mm : line.end_mm)[static_cast<Eigen::Index>(k % 3)] = *number;
    }
    if (good) {
      found.lines.push_back(line);
    } else {
      problems.add(ErrorCode::WrongType, file.name + line.place,
                   "line " + std::to_string(row.line) +
                       ": must be index,x,y,z,x,y,z,name with numbers from -1e5 to 1e5 mm");
    }
  }
}

void take_markups(const NamedFile& file, Found& found, ProblemList& problems) {
  Expected<std::vector<Markup>> markups = read_markups(file.bytes);
  if (!markups) return add_below(problems, file.name, markups.errors());
  for (Markup& markup : *markups) {
    if (markup.name.empty()) markup.name = file.name;
    found.markups.push_back(std::move(markup));
  }
}

void take_tissue(const NamedFile& file, Found& found, ProblemList& problems) {
  const Expected<TissueFile> tissue = read_tissue_file(file.bytes);
  if (!tissue) return add_below(problems, file.name, tissue.errors());
  found.tissue = *tissue;
}

void choose_leaflets(const Found& found, ImportSource& source, ProblemList& problems) {
  std::vector<std::string> anterior, posterior, others;
  for (const auto& [name, mesh] : found.surfaces)
    (has(name, "anterior")    ? anterior
     : has(name, "posterior") ? posterior
                              : others)
        .push_back(name);
  if (anterior.size() == 1 && posterior.size() == 1) {
    source.leaflets = {found.surfaces.at(anterior[0]), found.surfaces.at(posterior[0])};
    source.order = {LeafletClaim::Named,
                    {"the surface named anterior", "the surface named posterior"},
                    {},
                    "exchange their names"};
  } else if (anterior.empty() && posterior.empty() && others.size() == 1) {
    source.leaflets = {found.surfaces.at(others[0])};
  } else {
    problems.add(
        ErrorCode::MissingField, "",
        "has " + std::to_string(anterior.size()) + " surfaces named anterior, " +
            std::to_string(posterior.size()) + " named posterior and " +
            std::to_string(others.size()) +
            " others (.vtk); must be one anterior and one posterior leaflet, or one skirt");
  }
}

bool under_pressure(const Markup& markup) { return has(markup.name, "under pressure"); }

void take_curve(const Markup& markup, Points& points_mm, ProblemList& problems) {
  Expected<Points> drawn = drawn_closed_curve(markup);
  if (drawn)
    points_mm = *std::move(drawn);
  else
    add_below(problems, "", drawn.errors());
}

void choose_annulus(const Found& found, ImportSource& source, ProblemList& problems) {
  std::vector<const Markup*> curves;
  for (const Markup& markup : found.markups) {
    if (markup.type != MarkupType::ClosedCurve || has(markup.name, "ring:")) continue;
    if (under_pressure(markup)) {
      take_curve(markup, source.pressed_annulus_mm, problems);
    } else {
      curves.push_back(&markup);
    }
  }
  if (curves.size() > 1)
    std::erase_if(curves, [](const Markup* curve) { return !has(curve->name, "annulus"); });
  if (curves.size() == 1) {
    return take_curve(*curves[0], source.annulus_mm, problems);
  }
  problems.add(
      ErrorCode::MissingField, "",
      "has " + std::to_string(curves.size()) +
          " closed curves for the annulus; must have one, so save the annulus contour curve from "
          "Slicer as .mrk.json in the folder (ValveFemExport writes no markups)");
}

std::vector<LabelledTip> tips_of(const Found& found) {
  std::vector<LabelledTip> tips;
  const auto each = [&](bool pressed, const auto& take) {
    for (const Markup& markup : found.markups) {
      if (markup.type != MarkupType::Fiducial || !has(markup.name, "papillary") ||
          under_pressure(markup) != pressed)
        continue;
      for (Eigen::Index i = 0; i < markup.points_mm.rows(); ++i)
        take(Vec3(markup.points_mm.row(i)), markup.labels[static_cast<std::size_t>(i)]);
    }
  };
  each(false, [&](const Vec3& position_mm, const std::string& label) {
    tips.push_back({position_mm, label, {}});
  });
  each(true, [&](const Vec3& position_mm, const std::string& label) {
    for (LabelledTip& tip : tips)
      if (tip.label == label) tip.pressed_mm = position_mm;
  });
  return tips;
}

void take_ties(const Found& found, ImportSource& source, ProblemList& problems) {
  for (const Markup& markup : found.markups) {
    if (markup.type != MarkupType::Line || !markup.name.starts_with(kTieMarkup)) continue;
    if (markup.points_mm.rows() == 2)
      source.ties.push_back({markup.name.substr(kTieMarkup.size()), markup.points_mm.row(0),
                             markup.points_mm.row(1)});
    else
      problems.add(ErrorCode::BadGeometry, "",
                   "has '" + markup.name.substr(0, 60) + "' with " +
                       std::to_string(markup.points_mm.rows()) +
                       " points; must have two, on the anterior and on the posterior leaflet");
  }
}

}  // namespace

bool is_slicerheart_folder(const std::vector<std::string>& names) {
  bool vtk = false, markups = false, chordae = false;
  for (const std::string& path : names) {
    const std::string name = lower(path.substr(path.find_last_of("/\\") + 1));
    const bool is_vtk = name.ends_with(".vtk");
    vtk = vtk || is_vtk;
    markups = markups || name.ends_with(".mrk.json");
    chordae = chordae || (is_vtk && has(name, "chord"));
  }
  return chordae || (vtk && markups);
}

Expected<ImportSource> read_slicerheart(const std::vector<NamedFile>& files) {
  Found found;
  ProblemList problems;
  for (const NamedFile& file : files) {
    const std::string name = lower(file.name);
    if (name.ends_with(".vtk")) take_vtk(file, found, problems);
    if (name.ends_with(".csv")) take_csv(file, found, problems);
    if (name.ends_with(".mrk.json")) take_markups(file, found, problems);
    if (name == kOptionalFiles[3]) take_tissue(file, found, problems);
  }
  if (!problems.empty()) return std::move(problems).take();
  ImportSource source;
  choose_leaflets(found, source, problems);
  choose_annulus(found, source, problems);
  take_ties(found, source, problems);
  if (found.tissue) {
    source.tissue = found.tissue->tissue;
    source.pressure_kpa = found.tissue->pressure_kpa;
  }
  if (!problems.empty()) return std::move(problems).take();
  if (found.lines.empty())
    source.tips = imported_tips(tips_of(found));
  else
    source.chordae = chorda_trees(found.lines, tips_of(found), source, problems);
  if (!problems.empty()) return std::move(problems).take();
  source.provenance = {"SlicerHeart folder: " + std::to_string(source.leaflets.size()) +
                       " leaflet surfaces, " + std::to_string(found.lines.size()) +
                       " lines of chordae"};
  return source;
}

}  // namespace coapt
