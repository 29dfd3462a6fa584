#include "io/exchange/formats.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/valve/patient_frame.h"
#include "io/exchange/feb.h"
#include "io/exchange/measurements_csv.h"
#include "io/exchange/placed_valve.h"
#include "io/exchange/valve_glb.h"
#include "io/exchange/valve_labels.h"
#include "io/exchange/valve_markups.h"
#include "io/exchange/valve_vtk.h"
#include "io/image/write_label_map.h"
#include "io/json/valve_json.h"
#include "io/mesh/write_mesh.h"
#include "io/mesh/write_vtk.h"

namespace coapt {
namespace {

using Writer = Expected<std::string> (*)(const ClosedValve&, const ValveShape&,
                                         const ExportOptions&);

struct Format {
  FileFormat file;
  Writer write;
};

MarkupAxes axes_of(const Valve& valve) {
  return lies_in_patient_frame(valve) ? MarkupAxes::Patient : MarkupAxes::Valve;
}

template <const char* Name>
Expected<std::string> mesh(const ClosedValve& exported, const ValveShape& shape,
                           const ExportOptions&) {
  return write_mesh(leaflet_mesh(exported.valve, shape.vertices_mm), Name, shape.doubt);
}

Expected<std::string> vtk(const ClosedValve& exported, const ValveShape& shape,
                          const ExportOptions&) {
  return write_vtk(valve_vtk(exported, shape));
}

Expected<std::string> glb(const ClosedValve& exported, const ValveShape&,
                          const ExportOptions& options) {
  return options.open ? write_open_glb(exported) : write_glb(exported);
}

Expected<std::string> markups(const ClosedValve& exported, const ValveShape& shape,
                              const ExportOptions&) {
  return write_markups(valve_markups(exported, shape), axes_of(exported.valve), shape.doubt);
}

Expected<std::string> measurements(const ClosedValve& exported, const ValveShape&,
                                   const ExportOptions& options) {
  if (options.open)
    return Error{ErrorCode::Unsupported, "",
                 "measurements are of the closed valve, not the open one"};
  return write_measurements_csv(exported);
}

Expected<std::string> feb(const ClosedValve& exported, const ValveShape&, const ExportOptions&) {
  return write_feb(exported.valve);
}

template <auto Write>
Expected<std::string> labels(const ClosedValve& exported, const ValveShape& shape,
                             const ExportOptions& options) {
  if (options.grid && axes_of(exported.valve) == MarkupAxes::Valve)
    return Error{
        ErrorCode::BadReference, "/grid",
        "cannot be used, because the valve is written in its own axes, not in those of the images"};
  const Expected<LabelMap> map =
      valve_labels(exported, shape, options.grid ? &*options.grid : nullptr, options.cancelled);
  if (!map) return map.errors();
  return Write(*map, shape.doubt);
}

constexpr const char* kBytes = "application/octet-stream";
constexpr char kPly[] = "ply", kObj[] = "obj", kStl[] = "stl";

constexpr std::array<Format, 11> kFormats = {
    {{{"glb", "model/gltf-binary", "leaflets and chordae, closing animation (metres)"}, glb},
     {{"vtk", kBytes, "leaflets and chordae with data (legacy VTK)", true}, vtk},
     {{kPly, kBytes, "the leaflets", true}, mesh<kPly>},
     {{kObj, "model/obj", "the leaflets", true}, mesh<kObj>},
     {{kStl, "model/stl", "the leaflets", true}, mesh<kStl>},
     {{"mrk.json", "application/json", "annulus, tips, landmarks and repair as Slicer markups"},
      markups},
     {{"csv", "text/csv", "measurements under SlicerHeart's names"}, measurements},
     {{"feb", "application/xml", "a model of the open valve for FEBio 4"}, feb},
     {{"nrrd", kBytes, "leaflets and annulus as a label map (Slicer segmentation)", true, true},
      labels<write_nrrd>},
     {{"nii", kBytes, "the same (NIfTI-1)", true, true}, labels<write_nifti>},
     {{"nii.gz", "application/gzip", "the same (NIfTI-1, compressed)", true, true},
      labels<write_nifti_gz>}}};

Errors check_finite(const ClosedValve& exported, const ExportOptions& options) {
  if (options.open || exported.closure.closed_mm.allFinite()) return {};
  return {
      {ErrorCode::BadGeometry, "", "the closure diverged, so there is no closed shape to write"}};
}

ClosedValve placed(const ClosedValve& closed, const ExportOptions& options) {
  return options.frame == ExportFrame::Patient ? in_patient_frame(closed) : closed;
}

ValveShape shape_of(const ClosedValve& exported, const ExportOptions& options) {
  return options.open ? unstressed_shape(exported.valve) : closed_shape(exported);
}

}  // namespace

std::span<const FileFormat> file_formats() {
  static constexpr auto kFiles = [] {
    std::array<FileFormat, kFormats.size()> files{};
    for (std::size_t i = 0; i < files.size(); ++i) files[i] = kFormats[i].file;
    return files;
  }();
  return kFiles;
}

const FileFormat* format_named(std::string_view name) {
  const auto formats = file_formats();
  const auto found = std::find_if(formats.begin(), formats.end(),
                                  [&](const FileFormat& format) { return name == format.name; });
  return found == formats.end() ? nullptr : &*found;
}

const FileFormat* format_of_path(std::string_view path) {
  std::string lower(path);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto formats = file_formats();
  const auto found = std::find_if(formats.begin(), formats.end(), [&](const FileFormat& format) {
    return lower.ends_with('.' + std::string(format.name));
  });
  return found == formats.end() ? nullptr : &*found;
}

std::string format_names() {
  std::string names;
  for (const FileFormat& format : file_formats())
    names += (names.empty() ? "" : ", ") + std::string(format.name);
  return names;
}

Expected<std::string> write_valve_file(const ClosedValve& closed, const FileFormat& format,
                                       const ExportOptions& options) {
  if (Errors errors = check_finite(closed, options); !errors.empty()) return errors;
  const ClosedValve exported = placed(closed, options);
  const auto found = std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& f) {
    return std::string_view(f.file.name) == format.name;
  });
  return found->write(exported, shape_of(exported, options), options);
}

Expected<std::vector<NamedFile>> write_slicerheart(const ClosedValve& closed,
                                                   const ExportOptions& options) {
  if (Errors errors = check_finite(closed, options); !errors.empty()) return errors;
  const ClosedValve exported = placed(closed, options);
  const Valve& valve = exported.valve;
  const ValveShape shape = shape_of(exported, options);
  const MarkupAxes axes = axes_of(valve);
  std::vector<NamedFile> files = {
      {"leaflets.vtk", write_vtk(leaflets_vtk(exported, shape))},
      {"anterior_leaflet.vtk", write_vtk(leaflet_vtk(exported, shape, Leaflet::Anterior))},
      {"posterior_leaflet.vtk", write_vtk(leaflet_vtk(exported, shape, Leaflet::Posterior))},
      {"Chords_mesh.vtk", write_vtk(chordae_vtk(exported, shape))},
      {"annulus.mrk.json", write_markups({annulus_markup(valve, shape)}, axes, shape.doubt)},
      {"papillary_muscle_tips.mrk.json",
       write_markups({papillary_markup(valve, shape)}, axes, shape.doubt)},
      {"landmarks.mrk.json", write_markups({landmark_markup(valve, shape)}, axes, shape.doubt)}};
  if (const auto repair = repair_markups(exported, shape); !repair.empty())
    files.push_back({kOptionalFiles[0], write_markups(repair, axes, shape.doubt)});
  if (const auto pressed = pressed_markups(valve); options.open && !pressed.empty())
    files.push_back({kOptionalFiles[1], write_markups(pressed, axes)});
  if (!options.open) files.push_back({kOptionalFiles[2], write_measurements_csv(exported)});
  if (options.open)
    files.push_back({kOptionalFiles[3], write_tissue_file({valve.tissue, valve.pressure_kpa})});
  return files;
}

}  // namespace coapt
