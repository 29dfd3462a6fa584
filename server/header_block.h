// The header of a request as bytes. It is read here, not by cpp-httplib, which percent-decodes the values,
// hands Range to a recursive regular expression and skips what it cannot read.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace coapt {

struct HeaderBlock {
  std::string request_line;  ///< without its end
  std::map<std::string, std::string>
      fields;  ///< names in lower case; the first of each, X-Forwarded-For joined
};

/// What has no place in a header or the line of a chunk's size: control characters but the tab.
bool is_control(char c);

/// Without the optional whitespace around it: blanks and tabs (RFC 9110, 5.6.3).
std::string_view without_ows(std::string_view text);

std::string field(const HeaderBlock& header, const char* name);  ///< empty: not there

/// How many bytes the header takes with the blank line that ends it; none: it has not ended. Lines end in
/// CRLF or LF. @param from where an earlier look at fewer bytes ended
std::optional<std::size_t> header_length(std::string_view bytes, std::size_t from = 0);

/// None if the request line is not METHOD SP target SP HTTP/1.x (RFC 9112, 3), if a line is no field, has a control character, is folded, or if host, content-length or
/// transfer-encoding stands there twice: readers would differ about what it means.
std::optional<HeaderBlock> parse_header(std::string_view bytes);

/// Whether a request announces a body by its method: POST, PUT, PATCH.
bool brings_body(std::string_view bytes);

}  // namespace coapt
