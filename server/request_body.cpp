#include "server/request_body.h"

#include <strings.h>

#include "server/form_body.h"

namespace coapt {
namespace {

Answer too_large(std::size_t most_bytes) {
  return problem(413, ErrorCode::OutOfRange,
                 "the body is larger than " + std::to_string(most_bytes) + " bytes");
}

Answer not_whole(ReadEnd end) {
  switch (end) {
    case ReadEnd::TooSlow:
      return problem(408, ErrorCode::OutOfRange, "the body did not arrive in time");
    case ReadEnd::GivenUp:
      return problem(503, ErrorCode::Busy, "the server is shutting down");
    case ReadEnd::ClientEnded:
    case ReadEnd::TooMuch:
      return problem(400, ErrorCode::InvalidJson, "the body ends too early");
    case ReadEnd::None:
      break;
  }
  return problem(400, ErrorCode::InvalidJson, "the chunked encoding of the body is invalid");
}

bool is_chunked(const HeaderBlock& header) { return header.fields.contains("transfer-encoding"); }

}  // namespace

std::optional<Answer> refuse_body(const HeaderBlock& header, std::size_t most_bytes,
                                  bool takes_form) {
  const std::string type = field(header, "content-type");
  if (type.starts_with("multipart/") && !(takes_form && is_form(type))) {
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

std::size_t BodySource::take(char* to, std::size_t size) {
  const std::size_t got = connection.read(to, size);
  return !is_chunked(header) || framing.follow({to, got}) ? got : 0;
}

std::optional<Answer> read_body(BodySource& source, const HttpLimits& limits, std::string& body) {
  Connection& connection = source.connection;
  // Chunks may be small: a quarter more on the wire is taken for their headers.
  connection.start_reading({limits.body_seconds, limits.body_bytes_per_second, 2.0,
                            limits.body_bytes + limits.body_bytes / 4 + (64 << 10)});
  if (strcasecmp(field(source.header, "expect").c_str(), "100-continue") == 0 &&
      !connection.send("HTTP/1.1 100 Continue\r\n\r\n", limits.answer_seconds)) {
    return problem(400, ErrorCode::InvalidJson, "the client has disconnected");
  }
  const bool complete = source.decoded([&](std::string_view part) {
    body.append(part);
    return body.size() <= limits.body_bytes;
  });
  if (body.size() > limits.body_bytes || connection.read_end() == ReadEnd::TooMuch) {
    return too_large(limits.body_bytes);
  }
  // To the library a chunk without an end is the end of the body.
  if (complete && (!is_chunked(source.header) || source.framing.has_ended())) return std::nullopt;
  return not_whole(connection.read_end());
}

}  // namespace coapt
