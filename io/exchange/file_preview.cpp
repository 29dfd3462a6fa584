#include "io/exchange/file_preview.h"

#include <algorithm>

#include "io/exchange/import_files.h"
#include "io/exchange/label_parts.h"
#include "io/exchange/markups.h"
#include "io/image/detached.h"
#include "io/mesh/csv_table.h"
#include "io/mesh/import_readers.h"

namespace coapt {
namespace {

const char* side_label(Side side) { return side == Side::Anterolateral ? "AL" : "PM"; }

FilePreview tips_preview(const std::vector<ImportedTip>& tips) {
  FilePreview preview{FileContent::Tips, Points(std::ssize(tips), 3), {}, {}, {}};
  for (const ImportedTip& tip : tips) {
    preview.points.row(std::ssize(preview.labels)) = tip.position_mm.transpose();
    preview.labels.emplace_back(side_label(tip.side));
  }
  return preview;
}

FilePreview chordae_preview(const std::vector<ImportedChorda>& chordae) {
  FilePreview preview{FileContent::Chordae, Points(2 * std::ssize(chordae), 3), {}, {}, {}};
  for (const ImportedChorda& chorda : chordae)
    for (const Vec3& end : {chorda.insertion_mm, chorda.tip_mm}) {
      preview.points.row(std::ssize(preview.labels)) = end.transpose();
      preview.labels.emplace_back(side_label(chorda.side));
    }
  return preview;
}

FilePreview markups_preview(const std::vector<Markup>& markups) {
  const auto curve = std::find_if(markups.begin(), markups.end(), [](const Markup& markup) {
    return markup.type == MarkupType::ClosedCurve;
  });
  if (curve != markups.end()) return {FileContent::Curve, curve->points_mm, {}, {}, {}};
  FilePreview preview{FileContent::PointList, {}, {}, {}, {}};
  for (const Markup& markup : markups) {
    const Eigen::Index before = preview.points.rows();
    preview.points.conservativeResize(before + markup.points_mm.rows(), 3);
    preview.points.bottomRows(markup.points_mm.rows()) = markup.points_mm;
    preview.labels.insert(preview.labels.end(), markup.labels.begin(), markup.labels.end());
  }
  return preview;
}

FilePreview json_preview(const std::string& text) {
  if (const auto chordae = read_chordae(text, "json")) return chordae_preview(*chordae);
  if (const auto tips = read_tips(text, "json")) return tips_preview(*tips);
  const Expected<std::vector<Markup>> markups = read_markups(text);
  if (markups) return markups_preview(*markups);
  return {FileContent::Unknown, {}, {}, {}, markups.errors()};
}

FilePreview csv_preview(const std::string& text) {
  if (const auto chordae = read_chordae(text, "csv"); chordae && !chordae->empty())
    return chordae_preview(*chordae);
  if (const auto tips = read_tips_csv(text); tips && !tips->empty()) return tips_preview(*tips);
  const Expected<Points> points = read_points_csv(text);
  if (points) return {FileContent::Curve, *points, {}, {}, {}};
  return {FileContent::Unknown, {}, {}, {}, points.errors()};
}

/// Anterior and posterior leaflet as one surface.
FilePreview labels_preview(const std::string& bytes) {
  if (const auto voxels = data_file_of(bytes); voxels && *voxels)
    return {FileContent::Labels, {}, {}, {}, {}};  // a header: by itself it shows nothing
  const Expected<LabelMap> map = read_label_map(bytes, kMostVoxelsSent);
  if (!map) return {FileContent::Unknown, {}, {}, {}, map.errors()};
  const Expected<LabelParts> parts = label_parts(*map, {}, {.annulus = false});
  if (!parts) return {FileContent::Labels, {}, {}, {}, parts.errors(), labels_in(*map)};
  const TriangleMesh leaflets = joined(parts->leaflets);
  return {FileContent::Labels, leaflets.vertices_mm, leaflets.faces, {}, {}, labels_in(*map)};
}

}  // namespace

const char* to_string(FileContent content) {
  switch (content) {
    case FileContent::Surface:
      return "surface";
    case FileContent::Labels:
      return "labels";
    case FileContent::Curve:
      return "curve";
    case FileContent::PointList:
      return "points";
    case FileContent::Tips:
      return "tips";
    case FileContent::Chordae:
      return "chordae";
    case FileContent::Unknown:
      return "unknown";
  }
  return "";
}

FilePreview preview_file(const NamedFile& file, const MeshLimits& most) {
  const std::string format = format_of(file.name);
  if (format == "json") return json_preview(file.bytes);
  if (is_table_format(format)) return csv_preview(file.bytes);
  if (is_label_map_format(format)) return labels_preview(file.bytes);
  if (format == "raw" || format == "zraw") return {FileContent::Unknown, {}, {}, {}, {}};
  const Expected<TriangleMesh> mesh = read_mesh(file.bytes, format, kMostUnpackedSent, most);
  if (mesh) return {FileContent::Surface, mesh->vertices_mm, mesh->faces, {}, {}};
  return {FileContent::Unknown, {}, {}, {}, mesh.errors()};
}

}  // namespace coapt
