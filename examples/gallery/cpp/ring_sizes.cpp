// Closes a valve with rings of all sizes in C++, with libcoapt alone, and draws leak over size as SVG.
#include <cstdio>
#include <fstream>

#include "core/closure/closure.h"
#include "core/metrics/measure.h"
#include "core/presets/presets.h"
#include "core/repair/apply_plan.h"

int main() {
  const auto valve = coapt::make_preset("human-functional-mr");
  if (!valve) return 1;
  std::ofstream svg("ring_sizes.svg");
  svg << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 420 260' font-family='sans-serif' "
         "font-size='12'>"
      << "<text x='10' y='20'>leak, mm², by the size of the ring, mm</text>";
  for (int size_mm = 26; size_mm <= 40; size_mm += 2) {
    const coapt::RepairPlan plan{
        {coapt::Annuloplasty{coapt::CatalogueRing{"generic-classic", double(size_mm)}}}};
    const auto repaired = coapt::apply_plan(*valve, plan);
    if (!repaired) return 1;
    const double leak_mm2 = coapt::measure(*repaired, coapt::close_valve(*repaired)).leak.area_mm2;
    std::printf("%d mm: %.1f mm2\n", size_mm, leak_mm2);
    const double x = 50.0 * (size_mm - 26) / 2 + 15.0, height = 3.4 * leak_mm2 + 1.0;
    svg << "<rect fill='#0072b2' width='34' x='" << x << "' y='" << 230.0 - height << "' height='"
        << height << "'/>"
        << "<text x='" << x + 9 << "' y='246'>" << size_mm << "</text>"
        << "<text x='" << x + 9 << "' y='" << 226.0 - height << "'>" << int(leak_mm2 + 0.5)
        << "</text>";
  }
  svg << "</svg>\n";
}
