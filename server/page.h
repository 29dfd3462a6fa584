// The web page: files built from clients/web, read once when the server starts.
#pragma once

#include <map>
#include <string>

#include "server/route.h"

namespace coapt {

/// By path: "/" (index.html), "/favicon.svg", "/coapt-engine.wasm", "/assets/NAME".
using Page = std::map<std::string, Content>;

/// index.html, favicon.svg and coapt-engine.wasm, if they are there, and what lies in assets/; other files and links are left out. InputOutput: `folder` has no index.html or assets/, a
/// file cannot be read, or is larger than 16 MiB.
Expected<Page> read_page(const std::string& folder);

/// Where the page lies if nothing else is said: beside the build's folder (build/web), or installed in share/coapt/web;
/// else empty.
std::string usual_page_folder();

/// GET /, /favicon.svg, /coapt-engine.wasm, /assets/{name}: needs no token, as it tells nothing of any valve. What the page itself asks for
/// does. Assets have their content's hash in their name and may be kept for ever.
struct GetPage {
  const Page& page;
  Answer operator()(const Request& request) const;
};

/// Whether that is a file of the page.
bool is_page_path(std::string_view path);

}  // namespace coapt
