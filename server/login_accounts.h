// Who else is on this machine: any account that may log in reaches a port of 127.0.0.1.
#pragma once

#include <string>
#include <vector>

namespace coapt {

/// Accounts with a shell of /etc/shells (getusershell), but for root and this process's own.
std::vector<std::string> other_login_accounts();

}  // namespace coapt
