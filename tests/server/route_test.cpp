#include "server/route.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

using Parameters = std::vector<std::string>;

Answer nothing(const Request&) { return {}; }

Request request(const std::string& method, const std::string& path) {
  Request made;
  made.method = method;
  made.path = path;
  return made;
}

TEST(Match, TakesWhatStandsInPlaceOfTheParameters) {
  EXPECT_EQ(match("/v1/jobs", "/v1/jobs"), Parameters{});
  EXPECT_EQ(match("/v1/jobs/{id}", "/v1/jobs/a7"), Parameters{"a7"});
  EXPECT_EQ(match("/v1/jobs/{id}:cancel", "/v1/jobs/a7:cancel"), Parameters{"a7"});
  EXPECT_EQ(match("/v1/jobs/{id}/plans/{rank}/mesh", "/v1/jobs/a/plans/2/mesh"),
            (Parameters{"a", "2"}));
}

TEST(Match, TakesTheWholePathOrNothing) {
  for (const char* path : {"/v1/jobs", "/v1/jobs/", "/v1/jobs/a/b", "/v1/jobs/a:cancel",
                           "/v1/jobs/:", "v1/jobs/a", ""}) {
    EXPECT_EQ(match("/v1/jobs/{id}", path), std::nullopt) << path;
  }
  EXPECT_EQ(match("/v1/jobs/{id}:cancel", "/v1/jobs/a"), std::nullopt);
  EXPECT_EQ(match("/v1/jobs/{id}:cancel", "/v1/jobs/a:cancel2"), std::nullopt);
}

TEST(Match, AParameterMayHoldAnythingElse) {
  const std::string strange("\0%\xff .", 5);
  EXPECT_EQ(match("/{x}", "/" + strange), Parameters{strange});
}

TEST(FindRoute, TellsUnknownPathsFromUnknownMethods) {
  const Routes routes = {
      {"GET", "/a/{x}", nothing}, {"DELETE", "/a/{x}", nothing}, {"POST", "/b", nothing}};
  EXPECT_EQ(find_route(routes, request("DELETE", "/a/1")).route, &routes[1]);
  EXPECT_EQ(find_route(routes, request("DELETE", "/a/1")).parameters, Parameters{"1"});
  EXPECT_EQ(find_route(routes, request("GET", "/c")).refusal.status, 404);
  const Found found = find_route(routes, request("OPTIONS", "/a/1"));
  EXPECT_EQ(found.route, nullptr);
  EXPECT_EQ(found.refusal.status, 405);
  EXPECT_EQ(found.refusal.headers, (Headers{{"Allow", "GET, HEAD, DELETE"}}));
}

}  // namespace
}  // namespace coapt
