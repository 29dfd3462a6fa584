#include "server/header_block.h"

#include <algorithm>
#include <array>

namespace coapt {
namespace {

bool is_name_character(char c) {
  constexpr std::string_view kOthers = "!#$%&'*+-.^_`|~";
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         kOthers.find(c) != kOthers.npos;
}

// Takes the first line off, without its end.
std::string_view next_line(std::string_view& bytes) {
  const std::size_t end = bytes.find('\n');
  std::string_view line = bytes.substr(0, end);
  bytes.remove_prefix(end == bytes.npos ? bytes.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

bool is_request_line(std::string_view line) {
  constexpr std::string_view kVersion = " HTTP/1.";
  const std::size_t method = line.find(' ');
  if (method == line.npos || line.size() < method + 1 + kVersion.size() + 1) return false;
  const std::size_t version = line.size() - kVersion.size() - 1;
  const std::string_view target = line.substr(method + 1, version - method - 1);
  return method > 0 && std::all_of(line.begin(), line.begin() + method, is_name_character) &&
         !target.empty() && target.find_first_of(" \t") == target.npos &&
         line.substr(version, kVersion.size()) == kVersion && line.back() >= '0' &&
         line.back() <= '9';
}

bool add_field(std::string_view line, std::map<std::string, std::string>& fields) {
  const std::size_t colon = line.find(':');
  if (colon == line.npos || colon == 0) return false;
  std::string name(line.substr(0, colon));
  if (!std::all_of(name.begin(), name.end(), is_name_character)) return false;
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  const std::string_view value = without_ows(line.substr(colon + 1));
  const auto [place, is_new] = fields.emplace(name, value);
  // A proxy may add its word as a line of its own: it is the last of one list (RFC 9110, 5.3).
  if (!is_new && name == "x-forwarded-for") place->second.append(",").append(value);
  constexpr std::array<std::string_view, 3> kOnce = {"host", "content-length", "transfer-encoding"};
  return is_new || std::find(kOnce.begin(), kOnce.end(), name) == kOnce.end();
}

}  // namespace

std::string_view without_ows(std::string_view text) {
  const std::size_t from = text.find_first_not_of(" \t");
  if (from == text.npos) return "";
  return text.substr(from, text.find_last_not_of(" \t") - from + 1);
}

bool is_control(char c) { return (c >= '\0' && c < ' ' && c != '\t') || c == '\x7f'; }

std::string field(const HeaderBlock& header, const char* name) {
  const auto found = header.fields.find(name);
  return found == header.fields.end() ? "" : found->second;
}

std::optional<std::size_t> header_length(std::string_view bytes, std::size_t from) {
  // The blank line may have begun in the bytes looked at before.
  for (std::size_t i = bytes.find('\n', from < 3 ? 0 : from - 3); i != bytes.npos;
       i = bytes.find('\n', i + 1)) {
    const std::string_view rest = bytes.substr(i + 1);
    if (rest.starts_with('\n')) return i + 2;
    if (rest.starts_with("\r\n")) return i + 3;
  }
  return std::nullopt;
}

std::optional<HeaderBlock> parse_header(std::string_view bytes) {
  HeaderBlock block;
  block.request_line = next_line(bytes);
  if (std::any_of(block.request_line.begin(), block.request_line.end(), is_control) ||
      !is_request_line(block.request_line))
    return std::nullopt;
  for (std::string_view line = next_line(bytes); !line.empty(); line = next_line(bytes)) {
    if (std::any_of(line.begin(), line.end(), is_control) || !add_field(line, block.fields)) {
      return std::nullopt;
    }
  }
  return block;
}

bool brings_body(std::string_view bytes) {
  return bytes.starts_with("POST ") || bytes.starts_with("PUT ") || bytes.starts_with("PATCH ");
}

}  // namespace coapt
