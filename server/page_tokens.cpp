#include "server/page_tokens.h"

#include <openssl/evp.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <memory>
#include <span>
#include <stdexcept>

#include "server/content_id.h"

namespace coapt {
namespace {

template <std::size_t N>
std::optional<std::array<unsigned char, N>> bytes_of(std::string_view digits) {
  std::array<unsigned char, N> bytes{};
  if (digits.size() != 2 * N) return std::nullopt;
  for (std::size_t i = 0; i < N; ++i) {
    const char* const first = digits.data() + 2 * i;
    if (std::from_chars(first, first + 2, bytes[i], 16).ptr != first + 2) return std::nullopt;
  }
  return bytes;
}

template <std::size_t N>
std::array<unsigned char, N> cipher(const std::array<unsigned char, N>& key,
                                    const std::array<unsigned char, N>& block, bool encrypt) {
  const std::unique_ptr<EVP_CIPHER_CTX, decltype(&EVP_CIPHER_CTX_free)> context(
      EVP_CIPHER_CTX_new(), EVP_CIPHER_CTX_free);
  std::array<unsigned char, N> result{};
  int size = 0;
  if (!context ||
      EVP_CipherInit_ex(context.get(), EVP_aes_128_ecb(), nullptr, key.data(), nullptr, encrypt) !=
          1 ||
      EVP_CIPHER_CTX_set_padding(context.get(), 0) != 1 ||
      EVP_CipherUpdate(context.get(), result.data(), &size, block.data(), N) != 1)
    throw std::runtime_error("AES is not available");
  return result;
}

/// The first half of what a block holds: the list; the second is the place.
std::array<unsigned char, 8> mark_of(std::string_view list) {
  return *bytes_of<8>(content_id(list).substr(0, 16));
}

}  // namespace

PageTokens::PageTokens() : key_(*bytes_of<16>(random_id())) {}

std::string PageTokens::token(std::string_view list, std::int64_t place) const {
  Block block{};
  std::ranges::copy(mark_of(list), block.begin());
  std::memcpy(block.data() + 8, &place, sizeof place);
  return hexadecimal(cipher(key_, block, true));
}

std::optional<std::int64_t> PageTokens::place(std::string_view list, std::string_view token) const {
  const std::optional<Block> sealed = bytes_of<16>(token);
  if (!sealed) return std::nullopt;
  const Block block = cipher(key_, *sealed, false);
  if (!std::ranges::equal(mark_of(list), std::span(block).first(8))) return std::nullopt;
  std::int64_t place = 0;
  std::memcpy(&place, block.data() + 8, sizeof place);
  return place;
}

std::int64_t page_token_in(const Request& request, const PageTokens& tokens,
                           ProblemList& problems) {
  const auto given = request.query.find("page_token");
  if (given == request.query.end()) return 0;
  const std::optional<std::int64_t> place = tokens.place(request.path, given->second);
  if (!place)
    problems.add(ErrorCode::BadReference, "?page_token",
                 "must be the next_page_token of another page of this list, given since the server "
                 "started");
  return place.value_or(0);
}

Json next_page_token(const Request& request, const PageTokens& tokens, std::int64_t place) {
  if (place == 0) return nullptr;
  return tokens.token(request.path, place);
}

}  // namespace coapt
