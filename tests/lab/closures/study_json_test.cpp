#include "lab/closures/study_json.h"

#include <gtest/gtest.h>

#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

TEST(StudyJson, HasTheKeysThatScriptsRelyOn) {
  ClosureStudyOptions options;
  options.count = 2;
  options.accuracy = false;
  const auto json = to_json(options, study_closures({small_valve()}, options));
  for (const char* key : {"method", "membrane", "closures_per_second_per_core", "median_ms",
                          "unconverged", "crossed", "other_equilibria"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_TRUE(json["other_equilibria"].is_null());
}

}  // namespace
}  // namespace coapt
