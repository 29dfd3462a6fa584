#include "clients/cli/server_option.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <utility>

#include "clients/cli/read_argument.h"
#include "core/valve/problem_list.h"
#include "io/command_line/files.h"
#include "io/json/valve_json.h"

namespace coapt {
namespace {

constexpr std::array<std::string_view, 3> kThisMachine = {"localhost", "127.0.0.1", "[::1]"};

/// A line end in it would begin another header of the request.
Expected<std::string> without_controls(std::string token, const std::string& source) {
  const auto is_control = [](char c) { return (c >= '\0' && c < ' ') || c == '\x7f'; };
  if (std::any_of(token.begin(), token.end(), is_control))
    return Error{ErrorCode::OutOfRange, "", source + " has a control character in the token"};
  return token;
}

/// The first line, without what ends it.
Expected<std::string> read_token(const std::string& file) {
  if (file.empty()) {
    const char* const token = std::getenv("COAPT_TOKEN");
    return without_controls(token == nullptr ? "" : token, "COAPT_TOKEN");
  }
  const Expected<std::string> text = read_input(file);
  if (!text)
    return Error{ErrorCode::InputOutput, "",
                 "--token-file: " + file + ": " + text.errors().front().message};
  std::string token = text->substr(0, text->find('\n'));
  if (token.ends_with('\r')) token.pop_back();
  if (token.empty())
    return Error{ErrorCode::MissingField, "",
                 "--token-file: " + file + ": its first line is empty"};
  return without_controls(std::move(token), "--token-file: " + file);
}

bool is_url(const std::string& url) {
  for (const std::string scheme : {"http://", "https://"})
    if (url.starts_with(scheme) && url.size() > scheme.size() && url[scheme.size()] != '/')
      return true;
  return false;
}

/// Whether what is sent there can be read on the way: http, to another machine.
bool is_open_to_others(const std::string& url) {
  constexpr std::string_view kPlain = "http://";
  if (!url.starts_with(kPlain)) return false;
  const std::string host = url.substr(kPlain.size());
  return std::none_of(kThisMachine.begin(), kThisMachine.end(), [&](std::string_view name) {
    return host.starts_with(name) &&
           (host.size() == name.size() || host[name.size()] == ':' || host[name.size()] == '/');
  });
}

}  // namespace

void add_server_option(Command command, ServerOption& option) {
  command
      .add_option("--server", option.url,
                  "Run on this coapt-server, http://127.0.0.1:8080 or https://...; \"\": run here")
      .show_argument("URL")
      .environment("COAPT_SERVER")
      .group("Service");
  command
      .add_option("--token-file", option.token_file,
                  "File with the access token in its first line (default: COAPT_TOKEN)")
      .show_argument("FILE")
      .group("Service");
  command
      .add_flag("--plain-http", option.plain_http,
                "Allow sending the token unencrypted (http://) to another machine")
      .group("Service");
}

Expected<std::optional<Service>> service_of(const Command& command, const ServerOption& option,
                                            const std::vector<std::string>& only_here) {
  if (option.url.empty()) return std::optional<Service>();
  ProblemList problems;
  if (!is_url(option.url))
    problems.add(ErrorCode::OutOfRange, "",
                 "--server: is " + option.url + ", must be like http://127.0.0.1:8080");
  for (const std::string& name : only_here)
    if (command.has(name))
      problems.add(
          ErrorCode::Unsupported, "",
          name + ": is not available on a service; leave it out, or run here with --server \"\"");
  const Expected<std::string> token = read_token(option.token_file);
  if (!token) problems.add(token.errors().front().code, "", token.errors().front().message);
  if (token && !token->empty() && is_open_to_others(option.url) && !option.plain_http)
    problems.add(ErrorCode::Unsupported, "",
                 "--server: " + option.url +
                     " is not encrypted, so others could read the token; use https://, or "
                     "--plain-http on a trusted network");
  if (!problems.empty()) return std::move(problems).take();
  return std::optional<Service>(Service{option.url, *token});
}

Expected<Json> valve_to_send(const std::string& argument) {
  std::error_code ignored;
  if (argument != "-" && !std::filesystem::exists(argument, ignored)) return Json(argument);
  const Expected<Valve> valve = read_valve_argument(argument);
  if (!valve) return valve.errors();
  return Json::parse(write_valve(*valve));
}

}  // namespace coapt
