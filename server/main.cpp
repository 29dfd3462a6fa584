// coapt-server: closures and plans over HTTP on this machine.
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <string>

#include "io/json/plan_json.h"
#include "io/json/result_json.h"
#include "server/endpoints/closures.h"
#include "server/endpoints/health.h"
#include "server/endpoints/plans.h"
#include "server/http.h"

namespace coapt {
namespace {

Routes all_routes(const std::atomic<bool>& stopping) {
  return {
      {"GET", "/healthz/live", GetHealthzLive{}},
      {"POST", "/v1/closures", PostClosures{ring_catalogue()}},
      {"POST", "/v1/plans", PostPlans{ring_catalogue(), stopping}},
  };
}

int run(int argc, char** argv) {
  CLI::App app("Serves closures and repair plans on 127.0.0.1.", "coapt-server");
  int port = 8080;
  app.add_option("--port", port, "0 takes a free port")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  app.set_version_flag(
      "--version", "coapt-server " + std::string(version()) + "\n" + std::string(kResearchNotice));
  app.footer(
      "POST /v1/closures {\"valve\": ..., \"plan\": ...}, POST /v1/plans {\"valve\": ..., "
      "\"search\": ...},\n"
      "GET /healthz/live. For other machines put a reverse proxy with limits before it.\n\n" +
      std::string(kResearchNotice));
  CLI11_PARSE(app, argc, argv);

  std::atomic<bool> stopping = false;
  const Routes routes = all_routes(stopping);
  if (serve(port, routes, stopping)) return 0;
  std::cerr << "coapt-server: port " << port << " cannot be served\n";
  return 1;
}

}  // namespace
}  // namespace coapt

int main(int argc, char** argv) {
  try {
    return coapt::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "coapt-server: " << error.what() << '\n';
    return 1;
  }
}
