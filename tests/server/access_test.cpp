#include "server/access.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "server/cors.h"

namespace coapt {
namespace {

const std::string kToken = "0123456789abcdef";

class TokenFile : public testing::Test {
 protected:
  TokenFile() : path_(testing::TempDir() + "coapt_token_" + std::to_string(getpid())) {}
  ~TokenFile() override { std::filesystem::remove(path_); }

  Expected<std::string> read(const std::string& content, mode_t mode = 0600,
                             gid_t group = getegid()) {
    std::filesystem::remove(path_);
    std::ofstream(path_, std::ios::binary) << content;
    if (chown(path_.c_str(), geteuid(), group) != 0) return Error{};
    chmod(path_.c_str(), mode);
    return read_token(path_);
  }

  std::string path_;
};

TEST_F(TokenFile, ItsFirstLineIsTheToken) {
  for (const std::string& content : {kToken, kToken + "\n", "  " + kToken + " \r\nmore\n"}) {
    const auto token = read(content);
    ASSERT_TRUE(token) << content;
    EXPECT_EQ(*token, kToken);
  }
  EXPECT_TRUE(read(std::string(4096, 'x') + '\n'));
}

TEST_F(TokenFile, ItMustBeLongVisibleAscii) {
  for (const std::string& content :
       {std::string(), kToken.substr(1), "\n" + kToken, kToken + " x", kToken + "\xc3\xa4",
        std::string(4097, 'x'), std::string(100000, 'x'), kToken + std::string(1, '\0')}) {
    EXPECT_FALSE(read(content)) << content.size();
  }
}

TEST_F(TokenFile, ItMustBeClosedToOthers) {
  for (const mode_t mode : {0604, 0602, 0601, 0620, 0610, 0644})
    EXPECT_FALSE(read(kToken, mode)) << mode;
  EXPECT_TRUE(read(kToken, 0400));
  if (geteuid() != 0) GTEST_SKIP() << "only root can give files to other groups";
  EXPECT_TRUE(read(kToken, 0640, 0));
  EXPECT_FALSE(read(kToken, 0640, 1));
}

TEST_F(TokenFile, IsMadeOnceForItsOwnerAlone) {
  const Expected<std::string> made = kept_token(path_);
  ASSERT_TRUE(made);
  EXPECT_GE(made->size(), 32u);
  struct stat status {};
  ASSERT_EQ(stat(path_.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0600u);
  EXPECT_EQ(*kept_token(path_), *made) << "a link to the page outlives a start";
  std::filesystem::permissions(path_, std::filesystem::perms::others_read,
                               std::filesystem::perm_options::add);
  EXPECT_FALSE(kept_token(path_)) << "others know it";
  EXPECT_FALSE(kept_token(path_ + "/no/such/folder"));
}

TEST_F(TokenFile, ItMustBeAFile) {
  EXPECT_FALSE(read_token(path_ + ".none"));
  EXPECT_FALSE(read_token("/dev/zero"));
  EXPECT_FALSE(read_token(testing::TempDir()));
  ASSERT_EQ(mkfifo(path_.c_str(), 0600), 0);
  EXPECT_FALSE(read_token(path_));
}

int status(const Access& access, std::map<std::string, std::string> headers,
           const std::string& path = "/v1/jobs") {
  Request request;
  request.path = path;
  request.headers = std::move(headers);
  const auto refusal = refuse(access, request);
  return refusal ? refusal->status : 0;
}

TEST(Refuse, WithoutATokenHostMustNameThisServer) {
  const Access access{"", {"Coapt.Example", "10.0.0.1"}};
  for (const char* host : {"localhost", "LOCALHOST:8080", "127.0.0.1:1", "[::1]", "[::1]:80",
                           "coapt.example:1", "10.0.0.1"}) {
    EXPECT_EQ(status(access, {{"host", host}}), 0) << host;
  }
  for (const char* host : {"", "evil.example", "localhost.evil.example", "localhost:80:80",
                           "localhost:x", "::1", "[::1", "127.0.0.1@x"}) {
    EXPECT_EQ(status(access, {{"host", host}}), 421) << host;
  }
  EXPECT_EQ(status(access, {}), 421);
}

TEST(Refuse, ATokenMustBeTheWholeToken) {
  const Access access{kToken, {}};
  EXPECT_EQ(status(access, {{"authorization", "Bearer " + kToken}}), 0);
  EXPECT_EQ(status(access, {{"authorization", "bEARER   " + kToken}, {"host", "any.example"}}), 0);
  for (const std::string& given : std::vector<std::string>{
           "", kToken, "Bearer", "Bearer ", "Bearer " + kToken.substr(1), "Bearer " + kToken + "0",
           "Bearer " + kToken + kToken, "Bearer 0123456789abcdeF", "Basic " + kToken}) {
    EXPECT_EQ(status(access, {{"authorization", given}}), 401) << given;
  }
  Request request;
  EXPECT_EQ(refuse(access, request)->headers, (Headers{{"WWW-Authenticate", "Bearer"}}));
}

TEST(Refuse, PagesOfOtherOriginsStayOutWhateverTheyKnow) {
  const std::string bearer = "Bearer " + kToken;
  for (const char* origin : {"http://evil.example", "null", "", "http://localhost",
                             "http://localhost:80800", "ftp://localhost:8080"}) {
    EXPECT_EQ(status({}, {{"host", "localhost:8080"}, {"origin", origin}}), 403) << origin;
    EXPECT_EQ(status({kToken, {}},
                     {{"host", "localhost:8080"}, {"origin", origin}, {"authorization", bearer}}),
              403);
  }
  EXPECT_EQ(status({}, {{"host", "localhost:8080"}, {"origin", "http://LOCALHOST:8080"}}), 0);
  EXPECT_EQ(
      status({kToken, {}},
             {{"host", "x.example"}, {"origin", "https://x.example"}, {"authorization", bearer}}),
      0);
}

TEST(Refuse, WhetherItLivesEverybodyMayAsk) {
  EXPECT_EQ(status({kToken, {}}, {{"host", "evil.example"}}, "/healthz/live"), 0);
  EXPECT_EQ(status({kToken, {}}, {}, "/healthz/ready"), 0);
  EXPECT_EQ(status({"", {}}, {{"host", "evil.example"}}, "/healthz/ready"), 421);
}

Request from_site(const std::string& method, const std::string& origin) {
  Request request;
  request.method = method;
  request.path = "/v1/presets";
  request.headers = {{"host", "localhost"}, {"origin", origin}};
  return request;
}

std::string header_of(const Answer& answer, const std::string& name) {
  for (const auto& [given, value] : answer.headers)
    if (given == name) return value;
  return "";
}

TEST(Cors, PagesOfNamedSitesComeInAndMayReadTheAnswer) {
  const Access access{.origins = {"https://plans.example"}};
  const Request named = from_site("GET", "https://plans.example");
  EXPECT_FALSE(refuse(access, named));
  EXPECT_EQ(header_of(for_origin(access, named, {}), "Access-Control-Allow-Origin"),
            "https://plans.example");
  for (const char* origin : {"https://plans.example.org", "http://plans.example", "null"}) {
    const Request other = from_site("GET", origin);
    EXPECT_EQ(refuse(access, other)->status, 403) << origin;
    EXPECT_EQ(header_of(for_origin(access, other, {}), "Access-Control-Allow-Origin"), "")
        << origin;
  }
}

TEST(Cors, ABrowserMayAskWhetherItMaySend) {
  const Access access{.token = kToken, .origins = {"https://plans.example"}};
  Request asks = from_site("OPTIONS", "https://plans.example");
  EXPECT_FALSE(answer_preflight(access, asks));
  asks.headers["access-control-request-method"] = "POST";
  const std::optional<Answer> answer = answer_preflight(access, asks);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 204);
  EXPECT_EQ(header_of(*answer, "Access-Control-Allow-Origin"), "https://plans.example");
  asks.headers["origin"] = "https://other.example";
  EXPECT_FALSE(answer_preflight(access, asks));
}

}  // namespace
}  // namespace coapt
