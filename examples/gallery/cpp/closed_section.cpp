// Closes a valve in C++, cuts the closed leaflets through the middle of both, and draws the cut as SVG.
#include <cstdio>
#include <fstream>
#include <vector>

#include "core/closed/closed_valve.h"
#include "core/presets/presets.h"

int main() {
  const auto valve = coapt::make_preset("human-functional-mr");
  if (!valve) return 1;
  const coapt::ClosedValve closed = coapt::close_and_measure(*valve);
  const auto& points = closed.closure.closed_mm;
  std::ofstream svg("closed_section.svg");
  svg << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='-20 -6 40 24' stroke='#c8372d' "
         "stroke-width='0.5'>";
  int pieces = 0;
  for (int face = 0; face < valve->faces.rows(); ++face) {
    std::vector<coapt::Vec3> ends;  // of the piece of this triangle in the plane x = 0
    for (int corner = 0; corner < 3; ++corner) {
      const coapt::Vec3 p = points.row(valve->faces(face, corner)),
                        q = points.row(valve->faces(face, (corner + 1) % 3));
      if ((p.x() < 0) != (q.x() < 0)) ends.push_back(p + p.x() / (p.x() - q.x()) * (q - p));
    }
    if (ends.size() != 2) continue;
    svg << "<path d='M" << -ends[0].y() << ' ' << -ends[0].z() << 'L' << -ends[1].y() << ' '
        << -ends[1].z() << "'/>";
    ++pieces;
  }
  svg << "</svg>\n";
  std::printf("%d pieces, leak %.1f mm2\n", pieces, closed.measure.leak.area_mm2);
}
