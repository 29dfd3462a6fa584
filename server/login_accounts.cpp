#include "server/login_accounts.h"

#include <pwd.h>
#include <unistd.h>

#include <set>

namespace coapt {

std::vector<std::string> other_login_accounts() {
  std::set<std::string> shells;
  setusershell();
  while (const char* shell = getusershell()) shells.insert(shell);
  endusershell();
  std::vector<std::string> names;
  setpwent();
  while (const passwd* account = getpwent())
    if (account->pw_uid != 0 && account->pw_uid != geteuid() && shells.contains(account->pw_shell))
      names.emplace_back(account->pw_name);
  endpwent();
  return names;
}

}  // namespace coapt
