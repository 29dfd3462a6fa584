#include "io/json/ring_json.h"

#include "tests/io/json/found.h"

namespace coapt {
namespace {

using enum ErrorCode;

TEST(RingJson, RoundTripKeepsEveryTerm) {
  const RingDesign design{{"mine", {0.7, 0.01, 0.02, 0.1, 0.03, -0.04}}, 0.85};
  const auto json = to_json(design, {{"population", "p"}});
  EXPECT_EQ(json["provenance"]["population"], "p");
  const Expected<RingDesign> read = read_ring(json.dump());
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, design);
}

TEST(RingJson, ProblemsAreListedWithTheirPointers) {
  auto json = to_json(RingDesign{{"mine", {}}, 0.9}, {});
  EXPECT_EQ(problems_of(read_ring(json.dump())), Found{}) << "may be left out";
  json["ring"]["saddle"] = 0.5;
  json["ring"].erase("name");
  json["ring"]["twist"] = 1;
  json["sizing"]["width_over_transverse"] = 2.0;
  json["provenance"] = 3;
  EXPECT_EQ(problems_of(read_ring(json.dump())),
            (Found{{MissingField, "/ring/name"},
                   {OutOfRange, "/ring/saddle"},
                   {UnknownField, "/ring/twist"},
                   {OutOfRange, "/sizing/width_over_transverse"},
                   {WrongType, "/provenance"}}));
}

TEST(RingJson, AShapeThatCannotBeSewnIsRefused) {
  const RingDesign bean{
      {"bean", {.ap_over_transverse = 0.45, .flattening = 0.06, .p3_inset = 0.12}}, 0.9};
  EXPECT_EQ(problems_of(read_ring(to_json(bean, {}).dump())), (Found{{BadGeometry, "/ring"}}));
}

}  // namespace
}  // namespace coapt
