// Clients that wait alternate: next is the one that has had no turn for longest, however many of its requests wait. Whoever comes
// anew waits for one turn of each of the others. Not to be used by two threads at once.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace coapt {

class Rounds {
 public:
  /// One more request of this client waits; each is to be given to left(), too.
  void came(const std::string& client) {
    const auto [place, is_new] = clients_.try_emplace(client);
    if (is_new) place->second.last = turns_ - 1;
    ++place->second.requests;
  }
  /// It waits no more: it has its turn.
  void begins(const std::string& client) { clients_[client].last = turns_ += 2; }
  /// It had its turn, or goes without.
  void left(const std::string& client) {
    const auto place = clients_.find(client);
    if (--place->second.requests == 0) clients_.erase(place);
  }
  /// The smallest is next.
  std::int64_t last_turn(const std::string& client) const { return clients_.at(client).last; }

 private:
  struct Client {
    std::int64_t last = 0;
    int requests = 0;
  };
  std::map<std::string, Client> clients_;
  std::int64_t turns_ = 0;
};

}  // namespace coapt
