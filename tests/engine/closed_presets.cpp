// closed_presets DIR: writes each preset as NAME.json, and prints its name, the steps that it closes in and a hash of the
// closed vertices' bits (FNV-1a of their bytes).
#include <bit>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>

#include "core/closure/closure.h"
#include "core/presets/presets.h"
#include "io/json/valve_json.h"

int main(int count, char** arguments) {
  using namespace coapt;
  static_assert(std::endian::native == std::endian::little);
  if (count != 2) return 2;
  for (const std::string& name : preset_names()) {
    const Valve valve = *make_preset(name);
    std::ofstream file(std::string(arguments[1]) + '/' + name + ".json");
    file << write_valve(valve);
    if (!file.flush()) return 1;
    const ClosureResult closure = close_valve(valve, {});
    std::uint64_t hash = 0xcbf29ce484222325;
    const auto* bytes = reinterpret_cast<const unsigned char*>(closure.closed_mm.data());
    const std::size_t size = static_cast<std::size_t>(closure.closed_mm.size()) * sizeof(double);
    for (std::size_t i = 0; i < size; ++i) hash = (hash ^ bytes[i]) * 0x100000001b3;
    std::printf("%s %d %016llx\n", name.c_str(), closure.steps,
                static_cast<unsigned long long>(hash));
  }
}
