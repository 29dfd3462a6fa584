// --server: the work is done by a coapt-server.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clients/cli/service.h"
#include "io/command_line/command_line.h"

namespace coapt {

struct ServerOption {
  std::string url, token_file;
  bool plain_http = false;  ///< the token may go unencrypted to another machine
};

/// --server (or COAPT_SERVER) and --token-file (or the token itself in COAPT_TOKEN).
void add_server_option(Command command, ServerOption& option);

/// The service to ask; none if the work is done here. Errors: an address that is none, a token that cannot be read, or
/// one of the options `only_here` of `command` was given, which the service does not offer.
Expected<std::optional<Service>> service_of(const Command& command, const ServerOption& option,
                                            const std::vector<std::string>& only_here);

/// A valve for a request: a file (or "-") is checked here and sent; any other word is the service's preset, or the id of
/// a valve that it has stored.
Expected<Json> valve_to_send(const std::string& argument);

}  // namespace coapt
