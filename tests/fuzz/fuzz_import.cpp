// Whole imports of damaged leaflets, for what shows only there; fuzz_repair feeds their parts.
// The first byte says what is given with the leaflets, the others are spent on them.
#include <cstdlib>

#include "io/mesh/import_valve.h"
#include "tests/fuzz/damaged_leaflets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace coapt;
  if (size == 0) return 0;
  const int given = bytes[0];
  ImportSource source = damaged_source(given, bytes + 1, size - 1);
  ImportOptions options;
  options.triangles = 100;
  options.units = LengthUnit::Millimetre;
  if ((given & 32) != 0) options.closed = (given & 64) != 0;
  options.thickness_measured = (given & 128) != 0;
  // Chordae that are not seen would be closed with the valve; straight ones are enough here.
  source.chordae = {
      {"a", Side::Anterolateral, ChordaKind::Marginal, {-12.0, 0.0, -15.0}, {-10.0, 0.0, -25.0}},
      {"b", Side::Posteromedial, ChordaKind::Marginal, {12.0, 0.0, -15.0}, {10.0, 0.0, -25.0}}};
  const Expected<ImportedValve> imported = import_with_decisions(source, options);
  if (imported && !imported->valve.rest_mm.allFinite()) std::abort();
  return 0;
}
