// Error and time of the orifice's image at four resolutions against the exact orifice, over closures of
// all presets with their annulus dilated by up to 30 % and their tips displaced by up to 6 mm.
// Usage: orifice_resolution DIRECTORY [VARIANTS]   (of each preset, default 13: 104 closures)
// Writes orifice-resolution.csv (a line per closure and resolution), which lab/charts/plot.py draws; prints a
// summary. Times are the least of seven, on one core.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "core/closure/closure.h"
#include "core/metrics/exact_orifice.h"
#include "core/metrics/orifice.h"
#include "core/metrics/quantile.h"
#include "core/presets/presets.h"
#include "core/valve/remodel.h"
#include "search/parallel.h"

namespace {

using namespace coapt;

constexpr std::array<ImageSize, 4> kSizes = {{{200, 150}, {400, 300}, {800, 600}, {1600, 1200}}};

/// One area and what it costs.
struct Timed {
  double area_mm2 = 0.0, us = 0.0;
};

struct Scene {
  std::string preset;
  Valve valve;
  ClosureResult closure;
  Timed exact;
  std::array<Timed, kSizes.size()> images;
};

template <class Area>
Timed timed(const Area& area_mm2) {
  Timed result{0.0, std::numeric_limits<double>::infinity()};
  for (int i = 0; i < 7; ++i) {
    const auto start = std::chrono::steady_clock::now();
    result.area_mm2 = area_mm2();
    const std::chrono::duration<double, std::micro> passed =
        std::chrono::steady_clock::now() - start;
    result.us = std::min(result.us, passed.count());
  }
  return result;
}

/// A displacement of any direction, uniform in its length, which is 6 mm at most.
Vec3 random_displacement(std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> length(0.0, 6.0);
  const Vec3 direction = Vec3(normal(random), normal(random), normal(random)).normalized();
  return length(random) * direction;
}

std::vector<Scene> close_scenes(int variants) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> dilation(0.0, 30.0);
  std::vector<Scene> scenes;
  for (const std::string& name : preset_names()) {
    const Expected<Valve> preset = make_preset(name);
    for (int i = 0; preset && i < variants; ++i) {
      Remodelling change;
      change.ap_dilation_percent = dilation(random);
      change.anterolateral_mm = random_displacement(random);
      change.posteromedial_mm = random_displacement(random);
      if (const Expected<Valve> valve = remodel(*preset, change))
        scenes.push_back({name, *valve, {}, {}, {}});
    }
  }
  for_each_index(static_cast<int>(scenes.size()), 0, [&](int i) {
    Scene& scene = scenes[static_cast<std::size_t>(i)];
    scene.closure = close_valve(scene.valve);
  });
  std::erase_if(scenes, [](const Scene& scene) { return !scene.closure.closed_mm.allFinite(); });
  return scenes;
}

void measure_scene(Scene& scene) {
  const double half_thickness_mm = 0.5 * scene.valve.tissue.thickness_mm;
  const Points& closed_mm = scene.closure.closed_mm;
  scene.exact =
      timed([&] { return exact_orifice(scene.valve, closed_mm, half_thickness_mm).area_mm2; });
  for (std::size_t i = 0; i < kSizes.size(); ++i)
    scene.images[i] = timed([&] {
      double total = 0.0;
      for (const Orifice& orifice :
           view_orifices(scene.valve, closed_mm, half_thickness_mm, kSizes[i]).orifices)
        total += orifice.area_mm2;
      return total;
    });
}

void write_csv(const std::filesystem::path& file, const std::vector<Scene>& scenes) {
  std::ofstream csv(file);
  csv << "preset,status,crossing,columns,rows,exact_mm2,image_mm2,exact_us,image_us\n";
  for (const Scene& scene : scenes)
    for (std::size_t i = 0; i < kSizes.size(); ++i)
      csv << scene.preset << ',' << to_string(scene.closure.status) << ','
          << (scene.closure.crossing ? "true" : "false") << ',' << kSizes[i].width << ','
          << kSizes[i].height << ',' << scene.exact.area_mm2 << ',' << scene.images[i].area_mm2
          << ',' << scene.exact.us << ',' << scene.images[i].us << '\n';
}

void print_summary(const std::vector<Scene>& scenes) {
  std::printf("columns  error rms   p90    max mm2   image us   exact us (medians)\n");
  for (std::size_t i = 0; i < kSizes.size(); ++i) {
    std::vector<double> errors, image, exact;
    double squares = 0.0;
    for (const Scene& scene : scenes) {
      errors.push_back(std::abs(scene.images[i].area_mm2 - scene.exact.area_mm2));
      squares += errors.back() * errors.back();
      image.push_back(scene.images[i].us);
      exact.push_back(scene.exact.us);
    }
    std::printf("%7d  %9.4f  %.4f  %.4f  %9.0f  %9.0f\n", kSizes[i].width,
                std::sqrt(squares / static_cast<double>(scenes.size())), quantile(errors, 0.9),
                quantile(errors, 1.0), quantile(image, 0.5), quantile(exact, 0.5));
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int variants = argc > 2 ? std::atoi(argv[2]) : 13;
  if (argc < 2 || variants < 1) {
    std::fprintf(stderr, "usage: %s DIRECTORY [VARIANTS]\n", argv[0]);
    return 2;
  }
  const std::filesystem::path directory = argv[1];
  std::filesystem::create_directories(directory);
  std::vector<Scene> scenes = close_scenes(variants);
  for (Scene& scene : scenes) measure_scene(scene);
  write_csv(directory / "orifice-resolution.csv", scenes);
  print_summary(scenes);
  return 0;
}
