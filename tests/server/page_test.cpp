#include "server/page.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "server/access.h"

namespace coapt {
namespace {

namespace fs = std::filesystem;

class PageFolder : public testing::Test {
 protected:
  PageFolder() : root_(testing::TempDir() + "coapt_page_" + std::to_string(getpid())) {
    fs::create_directories(root_ / "assets");
    write("index.html", "<!doctype html>");
    write("assets/a-1.js", "run()");
    write("assets/a-1.css", "p{}");
    write("notes.txt", "not for the web");
  }
  ~PageFolder() override { fs::remove_all(root_); }

  void write(const std::string& name, const std::string& content) {
    std::ofstream(root_ / name, std::ios::binary) << content;
  }

  static Answer get(const Page& page, const std::string& path) {
    Request request;
    request.method = "GET";
    request.path = path;
    return GetPage{page}(request);
  }

  static std::string header_of(const Answer& answer, const std::string& name) {
    for (const auto& [key, value] : all_headers(answer))
      if (key == name) return value;
    return "";
  }

  fs::path root_;
};

TEST_F(PageFolder, GivesItsFilesWithTheirTypesAndNothingElse) {
  const Expected<Page> page = read_page(root_.string());
  ASSERT_TRUE(page);
  EXPECT_EQ(content_bytes(get(*page, "/")), "<!doctype html>");
  EXPECT_EQ(content_type(get(*page, "/")), "text/html; charset=utf-8");
  EXPECT_EQ(content_type(get(*page, "/assets/a-1.js")), "text/javascript; charset=utf-8");
  EXPECT_EQ(content_type(get(*page, "/assets/a-1.css")), "text/css; charset=utf-8");
  for (const char* path :
       {"/notes.txt", "/favicon.svg", "/coapt-engine.wasm", "/assets/../notes.txt", "/assets/b.js"})
    EXPECT_EQ(get(*page, path).status, 404) << path;
}

TEST_F(PageFolder, GivesTheEngineThatLiesBesideIt) {
  write("coapt-engine.wasm", std::string("\0asm", 4));
  const Expected<Page> page = read_page(root_.string());
  ASSERT_TRUE(page);
  const Answer engine = get(*page, "/coapt-engine.wasm");
  EXPECT_EQ(content_type(engine), "application/wasm");
  EXPECT_EQ(content_bytes(engine), std::string("\0asm", 4));
  EXPECT_EQ(header_of(engine, "Cache-Control"), "no-cache");
}

TEST_F(PageFolder, ItsLinksAreNotFollowed) {
  fs::create_symlink("/etc/passwd", root_ / "assets" / "link.js");
  const Expected<Page> page = read_page(root_.string());
  ASSERT_TRUE(page);
  EXPECT_EQ(get(*page, "/assets/link.js").status, 404);
  EXPECT_EQ(get(*page, "/assets/a-1.js").status, 200);
}

TEST_F(PageFolder, MayRunItsOwnScriptsOnlyAndItsAssetsMayBeKept) {
  const Expected<Page> page = read_page(root_.string());
  ASSERT_TRUE(page);
  const std::string policy = header_of(get(*page, "/"), "Content-Security-Policy");
  EXPECT_NE(policy.find("script-src 'self' 'wasm-unsafe-eval'; worker-src 'self';"),
            std::string::npos);
  EXPECT_EQ(policy.find("'unsafe"), std::string::npos);
  EXPECT_EQ(header_of(get(*page, "/"), "Cache-Control"), "no-cache");
  EXPECT_NE(header_of(get(*page, "/assets/a-1.js"), "Cache-Control").find("immutable"),
            std::string::npos);
}

TEST_F(PageFolder, WithoutIndexOrAssetsIsNoPage) {
  EXPECT_FALSE(read_page((root_ / "nowhere").string()));
  fs::remove_all(root_ / "assets");
  EXPECT_FALSE(read_page(root_.string()));
}

TEST_F(PageFolder, ThatIsNotBuiltSaysHowItIs) {
  const Page none;
  const Answer answer = get(none, "/");
  EXPECT_EQ(answer.status, 404);
  EXPECT_NE(content_bytes(answer).find("make web"), std::string::npos);
}

TEST_F(PageFolder, TheirsNeedNoTokenAndTheDataDo) {
  const Access access{"0123456789abcdef", {}};
  Request request;
  request.method = "GET";
  request.headers["host"] = "localhost";
  for (const char* path : {"/", "/favicon.svg", "/coapt-engine.wasm", "/assets/a-1.js"}) {
    request.path = path;
    EXPECT_FALSE(refuse(access, request)) << path;
  }
  for (const char* path : {"/v1/presets", "/assets", "/version", "//", "/metrics"}) {
    request.path = path;
    EXPECT_TRUE(refuse(access, request)) << path;
  }
}

}  // namespace
}  // namespace coapt
