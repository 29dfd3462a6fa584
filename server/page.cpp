#include "server/page.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace coapt {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytes = std::uintmax_t{16} << 20;
constexpr const char* kAssets = "/assets/";
constexpr const char* kEngine = "/coapt-engine.wasm";
constexpr const char* kIcon = "/favicon.svg";

// The page's own files and nothing else: no inline script or style, no other host. The engine is WebAssembly, which
// 'wasm-unsafe-eval' lets compile, and nothing more; it runs in a worker. WebGL pictures leave as blobs.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; "
    "style-src 'self'; img-src 'self' blob: data:; connect-src 'self'; base-uri 'none'; "
    "form-action 'none'; frame-ancestors 'none'";

std::string media_type(const fs::path& file) {
  const std::string extension = file.extension();
  if (extension == ".html") return kHtmlType;
  if (extension == ".js") return "text/javascript; charset=utf-8";
  if (extension == ".css") return "text/css; charset=utf-8";
  if (extension == ".svg") return "image/svg+xml";
  if (extension == ".wasm") return "application/wasm";
  return "application/octet-stream";
}

/// Reads `file` as what stands at `path`.
Errors add_file(Page& page, const std::string& path, const fs::path& file) {
  std::error_code failed;
  const std::uintmax_t size = fs::file_size(file, failed);
  if (!failed && size > kMostBytes)
    return {Error{ErrorCode::InputOutput, "", file.string() + " is larger than 16 MiB"}};
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (failed || !stream || bytes.size() != size)
    return {Error{ErrorCode::InputOutput, "", file.string() + " cannot be read"}};
  page[path] = {media_type(file), std::move(bytes)};
  return {};
}

}  // namespace

Expected<Page> read_page(const std::string& folder) {
  Page page;
  const fs::path root(folder);
  if (const Errors errors = add_file(page, "/", root / "index.html"); !errors.empty())
    return errors;
  std::error_code failed;
  for (const std::string path : {kIcon, kEngine}) {
    const fs::path file = root / path.substr(1);
    if (!fs::exists(file, failed)) continue;
    if (const Errors errors = add_file(page, path, file); !errors.empty()) return errors;
  }
  fs::directory_iterator assets(root / "assets", failed);
  if (failed)
    return Error{ErrorCode::InputOutput, "", (root / "assets").string() + " cannot be read"};
  for (const fs::directory_entry& entry : assets) {
    // A link would lead to any file of this machine.
    if (!fs::is_regular_file(entry.symlink_status(failed))) continue;
    const std::string path = kAssets + entry.path().filename().string();
    if (const Errors errors = add_file(page, path, entry.path()); !errors.empty()) return errors;
  }
  return page;
}

std::string usual_page_folder() {
  std::error_code failed;
  const fs::path programs = fs::read_symlink("/proc/self/exe", failed).parent_path();
  for (const fs::path& folder : {programs.parent_path().parent_path() / "web",
                                 programs.parent_path() / "share" / "coapt" / "web"})
    if (fs::exists(folder / "index.html", failed)) return folder;
  return "";
}

Answer GetPage::operator()(const Request& request) const {
  const auto found = page.find(request.path);
  if (found == page.end())
    return problem(404, ErrorCode::BadReference,
                   page.empty()
                       ? "the page is not built (make web) or not in the folder given by --web"
                       : "the page has no such file");
  const bool is_asset = request.path.starts_with(kAssets);
  return {200,
          found->second,
          {{"Content-Security-Policy", kPolicy},
           {"Cache-Control", is_asset ? "public, max-age=31536000, immutable" : "no-cache"}}};
}

bool is_page_path(std::string_view path) {
  return path == "/" || path == kIcon || path == kEngine || path.starts_with(kAssets);
}

}  // namespace coapt
