#include "clients/cli/design_outputs.h"

#include <filesystem>
#include <ostream>

#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/mesh/ring_solid.h"
#include "io/mesh/write_mesh.h"
#include "io/picture/ring_page.h"
#include "io/picture/ring_picture.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

std::string with_interval(const MeanInterval& gain, int decimals) {
  return fixed(gain.mean, decimals) + " (95 %: " + fixed(gain.low, decimals) + " to " +
         fixed(gain.high, decimals) + ")";
}

}  // namespace

std::vector<std::string> ring_files(const std::string& ring_file) {
  std::vector<std::string> files;
  for (const char* extension : {".stl", ".svg", ".csv", ".html"})
    files.push_back(std::filesystem::path(ring_file).replace_extension(extension).string());
  return files;
}

int write_ring_files(const std::string& ring_file, double printed_size_mm,
                     const RingDesignResult& result, const RingDesignSource& source) {
  const DesignedShape& shape = result.search.design.shape;
  const Expected<std::string> stl =
      write_mesh(ring_solid(ring_contour_mm(shape.terms, printed_size_mm)), "stl");
  if (!stl) return report_errors(ring_file, stl.errors());
  const std::vector<std::string> contents = {
      *stl, ring_picture_svg(beside_generic(shape, printed_size_mm)),
      ring_dimensions_csv(shape.terms), ring_page_html(result, source.population)};
  if (const int failed = write_output(ring_file, ring_document(result, source).dump(2) + "\n"))
    return failed;
  const std::vector<std::string> files = ring_files(ring_file);
  for (std::size_t k = 0; k < files.size(); ++k)
    if (const int failed = write_output(files[k], contents[k])) return failed;
  return exit_code::kOk;
}

void print_ring_design(std::ostream& out, const RingDesignResult& result,
                       const RingDesignSource& source) {
  const RingDesign& design = result.search.design;
  const RingVerdict& all = result.verdicts.front();
  out << "Ring " << design.shape.name << " for " << printable(source.population) << '\n'
      << "  shares of its width:";
  for (const RingTermRow& row : kRingTerms)
    out << ' ' << row.name << ' ' << fixed(design.shape.terms.*row.member, 3);
  out << "\n  sizing: the size nearest to " << fixed(design.width_over_transverse, 3)
      << " of the annulus's transverse diameter\n";
  const RingCandidate& generic = result.search.generic.candidate;
  out << "Compared with " << std::get<std::string>(generic.shape) << " at "
      << fixed(generic.width_over_transverse, 2) << ", on "
      << counted(result.held_out_members, "member")
      << (result.held_out_members == 1 ? " with held-out disturbances:\n" : " held-out members:\n")
      << "  closures below 5 mm2: " << fixed(all.design.below_percent, 1) << " % versus "
      << fixed(all.generic.below_percent, 1) << " %, gain " << with_interval(all.below_percent, 1)
      << " points\n  mean leak: " << fixed(all.design.leak_mm2, 1) << " versus "
      << fixed(all.generic.leak_mm2, 1) << " mm2, gain " << with_interval(all.leak_mm2, 1)
      << " mm2\n  mean gradient: " << fixed(all.design.gradient_mmhg, 1) << " versus "
      << fixed(all.generic.gradient_mmhg, 1) << " mmHg; above 5 mmHg "
      << fixed(all.design.stenotic_percent, 0) << " versus "
      << fixed(all.generic.stenotic_percent, 0)
      << " % of members\n  reserve against progression: " << fixed(all.design.durability_mm, 1)
      << " versus " << fixed(all.generic.durability_mm, 1)
      << " mm of posteromedial tip displacement\n  largest suture force: "
      << fixed(all.design.suture_max_n, 2) << " versus " << fixed(all.generic.suture_max_n, 2)
      << " N\n";
  for (std::size_t k = 1; k < result.verdicts.size(); ++k) {
    const RingVerdict& verdict = result.verdicts[k];
    if (verdict.aetiology.empty()) continue;
    out << "  " << verdict.aetiology << " (" << verdict.members << "): gain "
        << with_interval(verdict.below_percent, 1) << " points\n";
  }
  out << counted(result.search.designs, "design") << " tried, "
      << grouped(result.search.evaluations) << " closures and openings.\n";
}

}  // namespace coapt
