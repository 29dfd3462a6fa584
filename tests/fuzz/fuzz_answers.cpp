// Answers of a farm's workers, as whoever asked reads them: the first byte chooses the kind of work, and whether pictures of the report are
// drawn, too, which takes most of the time. Nothing may be thrown; what raises no objection can be shown.
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "farm/work/orifice_work.h"
#include "farm/work/plan_work.h"
#include "farm/work/population_work.h"
#include "io/picture/report_material.h"
#include "tests/fuzz/asked_work.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace coapt;
  static const std::array<Work, kAskedKinds> works = asked_works();
  if (size == 0) return 0;
  const std::size_t kind = data[0] % kAskedKinds;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  const Work& work = works[kind];
  if (!work.objection(0, 1, bytes).empty()) return 0;
  if (work.doubt) (void)work.doubt(0, 1, bytes);
  if (kind != kAskedPlans || data[0] < 0xc0) return 0;
  const Expected<std::vector<PlanAnswer>> answers = plan_answers(bytes);
  if (!answers) std::abort();
  const std::string_view material = answers->front().material;
  const Expected<std::size_t> pages = report_pages(material);
  if (!pages || *pages == 0) std::abort();
  if (!report_page(material, 0, small_valve())) std::abort();
  return 0;
}
