#include "server/content_id.h"

#include <openssl/rand.h>

#include <array>
#include <stdexcept>

namespace coapt {

std::string content_id(std::string_view bytes) { return sha256(bytes); }

std::string random_id() {
  std::array<unsigned char, 16> bytes{};
  if (RAND_bytes(bytes.data(), static_cast<int>(bytes.size())) != 1)
    throw std::runtime_error("no random numbers are available");
  return hexadecimal(bytes);
}

}  // namespace coapt
