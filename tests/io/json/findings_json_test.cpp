#include "io/json/findings_json.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

TEST(FindingsJson, HasEachFindingInItsPlaceWithTheKeysThatScriptsRelyOn) {
  const auto json = to_json({{"first", "4.3.1", "thesis says", "we show", "when", true},
                             {"second", "4.4", "\"quoted\"", "5 mm2", "below", false}});
  EXPECT_EQ(json.dump(),
            R"([{"finding":"first","section":"4.3.1","thesis":"thesis says","ours":"we show",)"
            R"("judged":"when","agrees":true},)"
            R"({"finding":"second","section":"4.4","thesis":"\"quoted\"","ours":"5 mm2",)"
            R"("judged":"below","agrees":false}])");
}

TEST(FindingsJson, OfNoneIsAnEmptyList) { EXPECT_EQ(to_json({}).dump(), "[]"); }

}  // namespace
}  // namespace coapt
