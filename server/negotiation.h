// What a client may get in place of an answer: the same bytes compressed, or that it has them already.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "server/route.h"

namespace coapt {

/// RFC 1952. @param level of zlib, 1 to 9
std::string gzip(std::string_view bytes, int level);
/// Of what gzip() gave; none of anything else. @param most bytes that may come of it
std::optional<std::string> gunzip(std::string_view compressed, std::size_t most);

/// Whether a field Accept-Encoding (RFC 9110, 12.5.3) takes gzip.
bool takes_gzip(std::string_view accept_encoding);

/// `answer` as it goes to who sent `request`: with an ETag if it is all of what stands at a path (200 to a GET), 304 if
/// its If-None-Match names that, and compressed if its Accept-Encoding takes gzip. Streams stay as they are.
Answer negotiated(Answer answer, const Request& request);

}  // namespace coapt
