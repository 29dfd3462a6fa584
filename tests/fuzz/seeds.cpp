// Writes what the fuzzers start from: fuzz_seeds FOLDER.

#include <filesystem>
#include <fstream>

#include "io/json/plan_json.h"
#include "io/json/valve_json.h"
#include "tests/scenes/small_valve.h"

namespace {

using namespace coapt;

void write(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

RepairPlan one_of_each_step() {
  const LeafletPoint point = {Leaflet::Posterior, 0.5, 1.0};
  return {{Annuloplasty{"own", 0.0, 2}, Annuloplasty{"generic-classic", 30.0, 0},
           Neochorda{"AL1", point, 18.5}, ChordalLengthChange{"a", -1.25}, ChordalExcision{"b"},
           ChordalTransfer{"c", point},
           PapillaryApproximation{Side::Anterolateral, Anchor::SaddlePeak, 0.25, 24.0},
           PapillaryApproximation{Side::Posteromedial, Anchor::AnnulusPoint, 0.9, 25.0}}};
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const std::filesystem::path folder = arguments[1];
  write(folder / "valve" / "small.json", write_valve(small_valve()));
  write(folder / "plan" / "each_step.json", to_json(one_of_each_step()).dump(1));
  for (const RepairStep& step : one_of_each_step().steps) {
    write(folder / "plan" / (std::to_string(step.index()) + ".json"),
          to_json(RepairPlan{{step}}).dump());
  }
}
