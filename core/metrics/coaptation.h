// Coaptation: how much of the anterior side lies on the posterior side, across the line of
// coaptation and in three dimensions (a projection hides gaps).
//
// Nine planes cut the anterior side. Along each cut, points a tenth of a millimetre apart are
// measured against the triangles of the posterior side (exact point-triangle distance); the height
// is the length of the cut that is in contact. Where the cut passes from one side to the other
// inside a commissure the distance is zero: the tissue is whole there.
#pragma once

#include <array>
#include <vector>

#include "core/metrics/section.h"

namespace coapt {

/// Mid-surfaces of leaflets in contact are nearer than so many thicknesses: pressed together they rest
/// at 0.85 to 1, and coarse meshes have facets.
inline constexpr double kContactThicknesses = 1.25;

struct CoaptationOptions {
  /// Mid-surfaces nearer than this are in contact. 0: kContactThicknesses x the tissue's thickness.
  double contact_distance_mm = 0.0;
  double sample_mm = 0.1;  ///< largest distance of points along a cut
};

/// One of nine sections across the line of coaptation.
struct CoaptationSection {
  double along = 0.0;        ///< 0 anterolateral commissure, 1 posteromedial
  double height_mm = 0.0;    ///< length of contact of the anterior with the posterior side
  double distance_mm = 0.0;  ///< smallest of the mid-surfaces; infinite without anterior tissue
  bool contact = false;
  /// Where the sides are nearest: on the anterior one, in the section, and on the posterior one.
  std::array<Vec3, 2> nearest_mm{Vec3::Zero(), Vec3::Zero()};
};

/// Of the sections at these places along the line between the commissures (coaptation_plane). One
/// without anterior tissue has an infinite distance.
std::vector<CoaptationSection> coaptation_sections(const Valve& valve, const Points& closed_mm,
                                                   const std::vector<double>& along,
                                                   const CoaptationOptions& options = {});

/// 37 sections, at 0.05 to 0.95: for what is drawn.
std::vector<CoaptationSection> fine_coaptation_sections(const Valve& valve,
                                                        const Points& closed_mm);

struct Coaptation {
  std::array<CoaptationSection, 9> sections;
  double height_min_mm = 0.0, height_mean_mm = 0.0, height_p10_mm = 0.0;
  double distance_max_mm = 0.0;  ///< the widest of the sections' smallest distances
};

/// Nine sections, at 0.1 to 0.9. A height's and a distance's tenth percentile and extremes are over
/// them (linear interpolation).
Coaptation measure_coaptation(const Valve& valve, const Points& closed_mm,
                              const CoaptationOptions& options = {});

struct Tenting {
  double height_mm = 0.0;
  double area_mm2 = 0.0;
  /// Along each leaflet from the annulus to where it touches the other, or to its free edge.
  double anterior_mm = 0.0, posterior_mm = 0.0;
  Vec3 coaptation_point_mm = Vec3::Zero();
  bool contact = false;
};

/// In the mid-valve section, against the annular line (saddle peak to mid-posterior). The
/// coaptation point is midway between the highest points of either side that are in contact, or,
/// without contact, the higher free edge. The area is enclosed by the annular line and both
/// leaflets down to that point. Both are positive towards the ventricle; leaflets that billow above
/// the line subtract.
Tenting measure_tenting(const Valve& valve, const Points& closed_mm,
                        const CoaptationOptions& options = {});

}  // namespace coapt
