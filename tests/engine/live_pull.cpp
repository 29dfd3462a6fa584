// live_pull VALVE.json SCRIPT: does what the script says with the valve (coapt.valve/1) and prints a hash of the vertices' bits
// (FNV-1a of their bytes) for each line "hash". For clients/web/test/static/engine.test.mjs, which does the same with the module
// for browsers. Lines: "change PLAN" (JSON), "pressure MMHG", "grab HOOK VERTEX", "cable HOOK CABLE SHARE",
// "move HOOK X Y Z" (mm), "release HOOK", "advance STEPS", "hash".
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "clients/engine/live.h"

namespace {

std::uint64_t hash_of(const coapt::LiveValve& valve, int vertices) {
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto* bytes = reinterpret_cast<const unsigned char*>(valve.vertices_mm().data());
  for (std::size_t i = 0; i < 24 * static_cast<std::size_t>(vertices); ++i)
    hash = (hash ^ bytes[i]) * 0x100000001b3;
  return hash;
}

/// One line; false if it is none that is known.
bool act(std::istringstream& line, const std::string& document, coapt::LiveEngine& live) {
  coapt::LiveValve& valve = *live.valve();
  std::string what, plan;
  int hook = 0, index = 0;
  double value = 0.0;
  coapt::Vec3 place;
  line >> what;
  if (what == "change" && std::getline(line, plan))
    return live.change("{\"valve\": " + document + ", \"plan\": " + plan + "}").status == 200;
  if (what == "pressure" && line >> value)
    valve.set_pressure(value);
  else if (what == "grab" && line >> hook >> index)
    valve.grab(hook, index);
  else if (what == "cable" && line >> hook >> index >> value)
    valve.grab_cable(hook, index, value);
  else if (what == "move" && line >> hook >> place.x() >> place.y() >> place.z())
    valve.move_to(hook, place);
  else if (what == "release" && line >> hook)
    valve.release(hook);
  else if (what == "advance" && line >> index)
    valve.advance(index);
  else if (what == "hash")
    std::printf("%016llx\n", static_cast<unsigned long long>(hash_of(valve, live.vertices())));
  else
    return false;
  return true;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) return 2;
  std::ifstream file(arguments[1]);
  const std::string document{std::istreambuf_iterator<char>(file), {}};
  coapt::LiveEngine live;
  if (live.start("{\"valve\": " + document + "}").status != 200) return 1;
  std::istringstream script(arguments[2]);
  for (std::string text; std::getline(script, text);) {
    std::istringstream line(text);
    if (!act(line, document, live)) return 1;
  }
}
