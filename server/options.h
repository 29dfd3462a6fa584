// The command line of coapt-server.
#pragma once

#include <string>
#include <vector>

#include "io/command_line/command_line.h"
#include "server/http.h"
#include "server/limits.h"

namespace coapt {

struct ServerOptions {
  std::string host = "127.0.0.1";
  int port = 8080;
  std::string database = "coapt.sqlite";
  std::string token_file;            ///< empty: a token is made where others may log in
  bool no_token = false;             ///< none is made
  bool print_token = false;          ///< that, and nothing else
  std::vector<std::string> hosts;    ///< names by which a proxy may call this server
  std::vector<std::string> origins;  ///< sites whose pages may use it
  std::string farm;                  ///< that searches and closes for studies; empty: this process
  std::string web;                   ///< folder of the page; empty: the usual place (page.h)
  bool log_requests = false;
  HttpLimits http;
  ServiceLimits service;
};

void add_options(Command app, ServerOptions& options);

/// What speaks against flags that are each in range.
Errors check_together(const ServerOptions& options);

}  // namespace coapt
