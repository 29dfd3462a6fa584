// Where the next page of a list starts, as a word that tells nothing and that nobody can make up.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/valve/problem_list.h"
#include "server/route.h"

namespace coapt {

/// A token is one block of AES-128 under a key that lives as long as this object: the place, and a mark of the list
/// that it is of. So a token of another list, of another run of the server or of the caller's invention is none.
class PageTokens {
 public:
  PageTokens();

  /// 32 hexadecimal digits. @param list what tells lists apart: their path
  std::string token(std::string_view list, std::int64_t place) const;
  std::optional<std::int64_t> place(std::string_view list, std::string_view token) const;

 private:
  using Block = std::array<unsigned char, 16>;

  Block key_;
};

/// The place that "page_token" of the query names in the list at the request's path; 0 if it is not there. What is no
/// token of this list is a problem.
std::int64_t page_token_in(const Request& request, const PageTokens& tokens, ProblemList& problems);

/// For "next_page_token": null if `place` is 0.
Json next_page_token(const Request& request, const PageTokens& tokens, std::int64_t place);

}  // namespace coapt
