// The input of an import, checked and moved into the valve's frame.
#pragma once

#include "io/mesh/import_valve.h"

namespace coapt {

/// Without tips (chordae are to be drawn) y leads from the posterior to the anterior sheet, z away from the leaflets or, if they
/// are closed, to where the front and back of the annulus rise over its sides.
/// Origin: mean of the annulus by arc length. z: normal of its plane of least squares, away from
/// the tips. x: from the mean anterolateral to the mean posteromedial tip, within the plane. y = z
/// x x is then anterior, because the sides are known.
struct FramedSource {
  std::vector<TriangleMesh> leaflets;
  Points
      annulus_mm;  ///< counter-clockwise seen from the atrium, no point twice, star-shaped about z
  Points pressed_annulus_mm;     ///< point by point as annulus_mm, or empty
  double annulus_band_mm = 0.0;  ///< ImportSource::annulus_band_mm
  std::vector<ImportedChorda> chordae;
  std::vector<ImportedTip> tips;
  std::vector<ImportedTie> ties;
  GivenLandmarks landmarks;
  PatientFrame patient;  ///< from here back to the source's coordinates
  ImportDecision change;
  ImportDecision atrium;  ///< which side of the annulus it is on; nothing where the tips tell
};

struct FrameOptions {
  bool draws_chordae = false;
  bool closed = false;  ///< the leaflets were imaged so
  bool flip = false;    ///< ImportOptions::flip
};

/// Errors: what ImportSource lacks or has too much of, units that are not millimetres, an annulus
/// that is not star-shaped, sheets in the wrong order, a mirrored input; pointers are those of
/// ImportSource.
Expected<FramedSource> into_import_frame(const ImportSource& source, const FrameOptions& options);

}  // namespace coapt
