#include "server/endpoints/kept_plans.h"

#include "tests/server/endpoints/service_scene.h"

namespace coapt {
namespace {

class KeptPlansTest : public ServiceTest {
 protected:
  static Json body(const std::string& name, const std::string& valve = "human-normal") {
    return {{"name", name},
            {"valve", valve},
            {"plan",
             {{"schema", "coapt.plan/1"},
              {"steps", {{{"step", "annuloplasty"}, {"shape", "own"}, {"sizes_below", 2}}}}}}};
  }
  std::string kept(const std::string& name, const std::string& valve = "human-normal") {
    const Answer answer = post("/v1/kept-plans", body(name, valve));
    EXPECT_EQ(answer.status, 201);
    return json_of(answer)["kept_plan"];
  }
  std::vector<std::string> names(const std::string& query = "") {
    std::vector<std::string> found;
    const Json page = json_of(get("/v1/kept-plans" + query));
    for (const auto& plan : page["kept_plans"]) found.push_back(plan["name"]);
    return found;
  }
  Answer rename(const std::string& id, const Json& with) {
    return ask("PATCH", "/v1/kept-plans/" + id, with.dump());
  }
};

TEST_F(KeptPlansTest, APlanIsKeptWithItsNameAndValveAndGot) {
  const Answer answer = post("/v1/kept-plans", body("Small ring"));
  EXPECT_EQ(answer.status, 201);
  const std::string id = json_of(answer)["kept_plan"];
  EXPECT_EQ(header_of(answer, "Location"), "/v1/kept-plans/" + id);
  const Json got = json_of(get("/v1/kept-plans/" + id));
  EXPECT_EQ(got, json_of(answer));
  EXPECT_EQ(got["name"], "Small ring");
  EXPECT_EQ(got["valve"], "human-normal");
  EXPECT_EQ(got["plan"], body("")["plan"]);
  EXPECT_EQ(get("/v1/kept-plans/nobody").status, 404);
}

TEST_F(KeptPlansTest, WhatIsWrongIsListedAndNotKept) {
  Json wrong = body("");
  wrong["valve"] = 7;
  wrong["plan"]["steps"][0]["sizes_below"] = -1;
  EXPECT_EQ(refusal(post("/v1/kept-plans", wrong)),
            (Refused{422, {"/name", "/valve", "/plan/steps/0/sizes_below"}}));
  EXPECT_EQ(refusal(post("/v1/kept-plans", body("a", "nobody"))), (Refused{422, {"/valve"}}));
  Json impossible = body("a");
  impossible["plan"]["steps"] = {{{"step", "chordal_excision"}, {"chorda", "none"}}};
  EXPECT_EQ(refusal(post("/v1/kept-plans", impossible)), (Refused{422, {"/plan/steps/0/chorda"}}));
  for (const std::string& name : {std::string(201, 'x'), std::string("two\nlines")})
    EXPECT_EQ(refusal(post("/v1/kept-plans", body(name))), (Refused{422, {"/name"}}));
  EXPECT_EQ(ask("POST", "/v1/kept-plans", "{").status, 400);
  EXPECT_TRUE(names().empty());
  kept(std::string(200, 'x'));
}

TEST_F(KeptPlansTest, TheyAreListedNewestFirstByPageAndByValve) {
  for (const char* name : {"a", "b", "c"}) kept(name);
  kept("d", stored_valve());
  const Json page = json_of(get("/v1/kept-plans?page_size=3"));
  EXPECT_EQ(names("?page_size=3"), (std::vector<std::string>{"d", "c", "b"}));
  const std::string token = page["next_page_token"];
  EXPECT_EQ(names("?page_token=" + token), std::vector<std::string>{"a"});
  EXPECT_EQ(names("?valve=" + std::string(64, 'a')), std::vector<std::string>{"d"});
  EXPECT_EQ(json_of(get("/v1/kept-plans"))["next_page_token"], nullptr);
  EXPECT_EQ(refusal(get("/v1/kept-plans?page_size=0&page_token=3&x=1")),
            (Refused{422, {"?x", "?page_size", "?page_token"}}));
}

TEST_F(KeptPlansTest, OneIsRenamedAndAllElseStays) {
  const std::string id = kept("a");
  const Answer renamed = rename(id, {{"name", "b"}});
  EXPECT_EQ(renamed.status, 200);
  EXPECT_EQ(json_of(renamed)["name"], "b");
  EXPECT_EQ(json_of(renamed)["plan"], body("")["plan"]);
  EXPECT_EQ(refusal(rename(id, {{"name", ""}, {"valve", "v"}})),
            (Refused{422, {"/name", "/valve"}}));
  EXPECT_EQ(rename("nobody", {{"name", "b"}}).status, 404);
  EXPECT_EQ(names(), std::vector<std::string>{"b"});
}

TEST_F(KeptPlansTest, OneIsRemovedOnce) {
  const std::string id = kept("a");
  EXPECT_EQ(remove("/v1/kept-plans/" + id).status, 204);
  EXPECT_EQ(remove("/v1/kept-plans/" + id).status, 404);
  EXPECT_EQ(get("/v1/kept-plans/" + id).status, 404);
}

TEST_F(KeptPlansTest, ThereAreNoMoreThanTheServiceKeeps) {
  limits_.kept_plans = 1;
  const std::string id = kept("a");
  EXPECT_EQ(post("/v1/kept-plans", body("b")).status, 409);
  EXPECT_EQ(remove("/v1/kept-plans/" + id).status, 204);
  kept("b");
}

TEST_F(KeptPlansTest, TheValveOfAKeptPlanStaysUntilThePlanIsRemoved) {
  const std::string valve = stored_valve();
  const std::string id = kept("a", valve);
  EXPECT_EQ(remove("/v1/valves/" + valve).status, 409);
  EXPECT_EQ(remove("/v1/kept-plans/" + id).status, 204);
  EXPECT_EQ(remove("/v1/valves/" + valve).status, 204);
}

}  // namespace
}  // namespace coapt
