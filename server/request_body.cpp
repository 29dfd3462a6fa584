#include "server/request_body.h"

#include <strings.h>

namespace coapt {

Answer too_large(std::size_t most_bytes) {
  return problem(413, ErrorCode::OutOfRange,
                 "the body is larger than " + std::to_string(most_bytes) + " bytes");
}

std::optional<Answer> refuse_body(const HeaderBlock& header, std::size_t most_bytes) {
  if (field(header, "content-type").starts_with("multipart/")) {
    return problem(415, ErrorCode::Unsupported, "the body must be application/json");
  }
  if (header.fields.contains("content-encoding")) {
    return problem(415, ErrorCode::Unsupported, "the body must not be encoded");
  }
  const bool has_length = header.fields.contains("content-length");
  const bool has_encoding = header.fields.contains("transfer-encoding");
  if (!has_length && !has_encoding) {
    return problem(411, ErrorCode::MissingField, "the body has no Content-Length");
  }
  const std::string length = field(header, "content-length");
  const bool digits = length.find_first_not_of("0123456789") == length.npos && !length.empty();
  const bool chunked = strcasecmp(field(header, "transfer-encoding").c_str(), "chunked") == 0;
  if ((has_length && (has_encoding || !digits)) || (has_encoding && !chunked)) {
    return problem(400, ErrorCode::Unsupported,
                   "give either a Content-Length or Transfer-Encoding: chunked");
  }
  if (has_length && (length.size() > 18 || std::stoull(length) > most_bytes)) {
    return too_large(most_bytes);
  }
  return std::nullopt;
}

}  // namespace coapt
