// A valve out of the folder that SlicerHeart's ValveFemExport writes, or that `coapt export` does.
//
// By the names and the content of the files, in one coordinate system:
// - *.vtk with faces: the leaflets. Those named "anterior" and "posterior" are the sheets; a single other one is
//   the skirt. Names with "annulus" are passed over: that is a tube for the eye.
// - *.vtk with lines: chordae, from the papillary tip to the leaflet; lines that begin where another ends are its
//   branches. Data rest_length_mm, diameter_mm, kind and to_insertion are taken where they are there (valve_vtk.h).
// - *.csv with rows index,x,y,z,x,y,z,name: chordae, straight, as older versions of ValveFemExport write them.
// - tissue.json (coapt.tissue/1): tissue and pressure, of an open valve that coapt exported.
// - *.mrk.json: a closed curve is the annulus (several: the one named so); points of a list named "papillary" are the
//   tips, labelled with their side (AL..., PM..., or words). Those named "under pressure" say point by point where the
//   others go when the valve closes. ValveFemExport writes no markups: save
//   them there from Slicer.
// - of these, lines named "tie: ..." are the ties of an edge-to-edge repair, from the anterior to the posterior leaflet.
// A tip without label gets its side from where it lies, which needs an anterior and a posterior sheet.
#pragma once

#include "io/exchange/formats.h"
#include "io/mesh/import_valve.h"

namespace coapt {

/// Whether files of such names or paths are such a folder, or one that lacks a part: .vtk beside .mrk.json, or chordae as .vtk.
bool is_slicerheart_folder(const std::vector<std::string>& names);

/// For import_valve(). Errors: all problems of all files, the path beginning with the file's name
/// ("Chords_mesh.vtk/lines/3"); what is missing altogether has the empty path.
Expected<ImportSource> read_slicerheart(const std::vector<NamedFile>& files);

}  // namespace coapt
