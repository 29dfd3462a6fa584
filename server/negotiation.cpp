#include "server/negotiation.h"

#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <new>

#include "server/content_id.h"
#include "server/header_block.h"

namespace coapt {
namespace {

constexpr int kLevel = 4;                  // a scene of 200 kB takes 4 ms
constexpr std::size_t kLeastBytes = 1400;  // less fits into one packet
constexpr std::size_t kTagLength = 32;     // of the 64 digits of a content's id
constexpr int kWindowBits = 15,
              kGzip = 16;  // of deflateInit2: the largest window, with the header of gzip
constexpr std::size_t kSizeBytes = 4;  // at the end of what is compressed (RFC 1952, 2.3)

/// Calls `take` with each member of a list that commas separate, until it returns true; whether it did.
template <class Take>
bool any_member(std::string_view list, const Take& take) {
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    if (take(without_ows(list.substr(0, comma)))) return true;
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
  return false;
}

/// Of "gzip;q=0.5"; 1 if it says none, 0 if it cannot be read.
double weight(std::string_view parameters) {
  parameters = without_ows(parameters);
  if (parameters.empty()) return 1.0;
  if (!parameters.starts_with("q=") && !parameters.starts_with("Q=")) return 0.0;
  double q = 0.0;
  std::from_chars(parameters.data() + 2, parameters.data() + parameters.size(), q);
  return q;
}

/// Weak comparison, so that a client may send back what it got compressed.
bool names(std::string_view if_none_match, std::string_view tag) {
  return any_member(if_none_match,
                    [&](std::string_view member) { return member == "*" || member == tag; });
}

}  // namespace

std::string gzip(std::string_view bytes, int level) {
  z_stream stream{};
  if (deflateInit2(&stream, level, Z_DEFLATED, kWindowBits + kGzip, MAX_MEM_LEVEL,
                   Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  std::string compressed(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in =
      reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));  // zlib does not write there
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(compressed.data());
  stream.avail_out = static_cast<uInt>(compressed.size());
  deflate(&stream, Z_FINISH);  // there is room for all
  compressed.resize(stream.total_out);
  deflateEnd(&stream);
  return compressed;
}

std::optional<std::string> gunzip(std::string_view compressed, std::size_t most) {
  if (compressed.size() < kSizeBytes) return std::nullopt;
  std::size_t size = 0;  // the last four bytes, the least significant first
  for (std::size_t i = 0; i < kSizeBytes; ++i)
    size |= std::size_t{static_cast<unsigned char>(compressed[compressed.size() - kSizeBytes + i])}
            << (8 * i);
  if (size > most) return std::nullopt;
  std::string bytes(size, '\0');
  z_stream stream{};
  if (inflateInit2(&stream, kWindowBits + kGzip) != Z_OK) throw std::bad_alloc();
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(compressed.data()));
  stream.avail_in = static_cast<uInt>(compressed.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  const bool is_whole = inflate(&stream, Z_FINISH) == Z_STREAM_END && stream.total_out == size;
  inflateEnd(&stream);
  return is_whole ? std::optional(std::move(bytes)) : std::nullopt;
}

bool takes_gzip(std::string_view accept_encoding) {
  return any_member(accept_encoding, [](std::string_view member) {
    const std::size_t end = std::min(member.find(';'), member.size());
    const std::string_view coding = without_ows(member.substr(0, end));
    return (coding == "gzip" || coding == "*") &&
           weight(member.substr(std::min(end + 1, member.size()))) > 0.0;
  });
}

Answer negotiated(Answer answer, const Request& request) {
  if (std::holds_alternative<Stream>(answer.body)) return answer;
  Content content{content_type(answer), content_bytes(answer)};
  if (request.method == "GET" && answer.status == 200) {
    const std::string tag = "W/\"" + content_id(content.bytes).substr(0, kTagLength) + '"';
    answer.headers.emplace_back("ETag", tag);
    if (names(header(request, "if-none-match"), tag)) {
      answer.status = 304;
      answer.body = nullptr;
      return answer;
    }
  }
  if (content.bytes.size() < kLeastBytes || content.type == "image/png") return answer;
  answer.headers.emplace_back("Vary", "Accept-Encoding");
  if (!takes_gzip(header(request, "accept-encoding"))) return answer;
  content.bytes = gzip(content.bytes, kLevel);
  answer.headers.emplace_back("Content-Encoding", "gzip");
  answer.body = std::move(content);
  return answer;
}

}  // namespace coapt
