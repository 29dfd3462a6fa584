// Two published questions on Barlow's disease, asked of random valves of that kind (core/presets/human_presets.h).
//
// How much smaller must the annulus be? Eight patients' annuli were made smaller by 58 +- 7 % in surgery with resection, for a
// coaptation area index of 20 +- 5 %; in their finite element models 31 +- 6 % would have done without resection (Aguilera
// 2023, JTCVS Open 13:95). What does the tissue's law decide? With a healthy law such a geometry leaked severely, with a myxomatous
// one less (Aguilera 2021, J Elasticity).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace coapt {

struct BarlowStudyOptions {
  int valves = 40;
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: all cores
};

enum class BarlowTissue { Myxomatous, Healthy };
const char* to_string(BarlowTissue tissue);

/// One closure. The annulus is scaled about its centroid, all directions alike.
struct BarlowState {
  int valve = 0;
  BarlowTissue tissue = BarlowTissue::Myxomatous;
  double reduction = 0.0;  ///< of the annulus's area; below 0: dilated
  bool trusted = false;
  double coaptation_area_index = 0.0;
  double leak_mm2 = 0.0;
};

/// @param progress valves done, planned.
std::vector<BarlowState> study_barlow(const BarlowStudyOptions& options,
                                      const std::function<void(int, int)>& progress = {});

inline constexpr double kAguileraIndex = 0.2;

/// Of a valve, without resection; none: not within the reductions that were tried.
struct BarlowAnswer {
  int valve = 0;
  std::optional<double> reduction_for_index;  ///< to reach kAguileraIndex, interpolated
  std::optional<double> reduction_to_close;   ///< the first that leaks by less than 1 mm2
  double index_as_is = 0.0;
  double leak_mm2 = 0.0, healthy_leak_mm2 = 0.0;  ///< with the annulus as it is
};
std::vector<BarlowAnswer> barlow_answers(const std::vector<BarlowState>& states);

/// Columns: valve, tissue, reduction, trusted, coaptation_area_index, leak_mm2.
std::string barlow_csv(const std::vector<BarlowState>& states);

}  // namespace coapt
