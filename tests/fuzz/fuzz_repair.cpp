// The parts of an import that leaflets go through before it has a valve, on tiny damaged ones. The first byte says what is given with
// them (bits 0 to 4 as in fuzz_import) and how far it goes (bits 5 to 7), the others are spent on the leaflets.
#include <cstdlib>

#include "io/mesh/import_frame.h"
#include "io/mesh/import_sheets.h"
#include "io/mesh/judged_state.h"
#include "io/mesh/leaflet_order.h"
#include "io/mesh/mid_surface.h"
#include "io/mesh/plausibility.h"
#include "io/mesh/sheet_repair.h"
#include "io/mesh/source_units.h"
#include "tests/fuzz/damaged_leaflets.h"

namespace {

using namespace coapt;

enum Part { Units, Repair, MidSurfaces, Prepare, Order, State, Frame, FrameOfClosed };

void expect_sound(const TriangleMesh& mesh) {
  if (!mesh.vertices_mm.allFinite()) std::abort();
  if (mesh.faces.rows() > 0 &&
      (mesh.faces.minCoeff() < 0 || mesh.faces.maxCoeff() >= mesh.vertices_mm.rows()))
    std::abort();
}

void repair(const ImportSource& source, bool thick) {
  for (const TriangleMesh& mesh : source.leaflets) {
    const Expected<RepairedSheet> repaired =
        repaired_sheet(mesh, source.leaflets.size() == 1 ? 2 : 1);
    if (!repaired) continue;
    expect_sound(repaired->mesh);
    if (!thick) continue;
    if (!(opposed_share(repaired->mesh) >= 0.0)) std::abort();
    if (const Expected<MidSurface> middle = mid_surface(repaired->mesh))
      expect_sound(middle->sheet);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const int given = bytes[0];
  const auto part = static_cast<Part>(given >> 5);
  ImportSource source = damaged_source(given, bytes + 1, size - 1);
  (void)drop_loose_points(source);
  if (part == Units) {
    const UnitReading read = unit_of(source);
    (void)impossible_size(source, read.unit);
    return 0;
  }
  if (part <= MidSurfaces) {
    if (is_sound(source.leaflets)) repair(source, part == MidSurfaces);
    return 0;
  }
  (void)contour_checks(source.annulus_mm);
  const Expected<SheetPreparation> prepared = prepare_sheets(source, {});
  if (!prepared) return 0;
  if (is_sound(source.leaflets))
    for (const TriangleMesh& mesh : source.leaflets) expect_sound(mesh);
  if (part == Prepare || !settle_leaflet_order(source, (given & 4) != 0) || part == Order) return 0;
  const bool closed =
      part == State ? judged_state(source, {}, prepared->thickness).closed : part == FrameOfClosed;
  const Expected<FramedSource> framed = into_import_frame(source, {true, closed, false});
  if (framed && !framed->annulus_mm.allFinite()) std::abort();
  return 0;
}
