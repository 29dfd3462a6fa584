// Meshes, chordae and marks of an import, drawn without perspective from one direction.
#pragma once

#include <string>
#include <vector>

#include "io/picture/leaflet_paint.h"
#include "io/picture/view_frame.h"

namespace coapt {

/// Axes of a view: right, up, towards the eye.
struct Eye {
  Vec3 right, up, towards;
  Vec2 on(const Vec3& point) const { return {point.dot(right), point.dot(up)}; }
};

struct Drawing {
  const Canvas& canvas;
  Eye eye;
  Mapping map;
  Vec2 place(const Vec3& point_mm) const { return map(eye.on(point_mm)); }
};

struct TintedMesh {
  Points vertices_mm;
  Faces faces;
  std::vector<Colour> colours;  ///< a vertex each
};

struct Stroke {
  Vec3 from_mm, to_mm;
};

struct NamedPoint {
  Vec3 at_mm;
  std::string words;
};

Colour mixed(const Colour& a, const Colour& b, double share);
Colour segment_colour(Segment segment);

/// Far to near, all together.
void paint_meshes(const Drawing& drawing, const std::vector<TintedMesh>& meshes);
void paint_strokes(const Drawing& drawing, const std::vector<Stroke>& strokes);
void paint_loop(const Drawing& drawing, const Points& loop_mm);
/// Without words a dot alone. Words away from the middle of the drawing, over and under each other where they would meet.
void paint_marks(const Drawing& drawing, const std::vector<NamedPoint>& marks,
                 const Colour& colour);
/// A1 to P3, at the middles of the segments.
void paint_segment_names(const Drawing& drawing, const Valve& valve);

}  // namespace coapt
