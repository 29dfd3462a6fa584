#include "farm/work/work_file.h"

#include <charconv>
#include <optional>

namespace coapt {
namespace {

constexpr std::string_view kWorkHeader = "coapt.work/1 ";
constexpr std::size_t kMostParts = 1'000'000;

Error not_work(const std::string& why) {
  return {ErrorCode::Unsupported, "", "is no work request (coapt.work/1): " + why};
}

/// The bytes before the end of the line, taken away with it; none if there is no such end.
std::optional<std::string_view> take_line(std::string_view& bytes) {
  const std::size_t end = bytes.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view line = bytes.substr(0, end);
  bytes.remove_prefix(end + 1);
  return line;
}

std::optional<std::size_t> count_in(std::string_view text) {
  std::size_t count = 0;
  const auto [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (wrong != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return count;
}

}  // namespace

std::string write_work(const WorkRequest& request) {
  std::string bytes =
      std::string(kWorkHeader) + request.kind + ' ' + std::to_string(request.parts.size()) + '\n';
  for (const std::string& part : request.parts) {
    bytes += std::to_string(part.size()) + '\n';
    bytes += part;
  }
  return bytes;
}

Expected<WorkRequest> read_work(std::string_view bytes) {
  const std::optional<std::string_view> header = take_line(bytes);
  if (!header || !header->starts_with(kWorkHeader)) return not_work("it has another first line");
  const std::string_view what = header->substr(kWorkHeader.size());
  const std::size_t space = what.find(' ');
  if (space == 0 || space == std::string_view::npos) return not_work("its first line is cut off");
  const std::optional<std::size_t> parts = count_in(what.substr(space + 1));
  if (!parts || *parts > kMostParts) return not_work("its number of parts is none");
  WorkRequest request{std::string(what.substr(0, space)), {}};
  for (std::size_t i = 0; i < *parts; ++i) {
    const std::optional<std::string_view> line = take_line(bytes);
    const std::optional<std::size_t> size = line ? count_in(*line) : std::nullopt;
    if (!size || *size > bytes.size()) return not_work("part " + std::to_string(i) + " is cut off");
    request.parts.emplace_back(bytes.substr(0, *size));
    bytes.remove_prefix(*size);
  }
  if (!bytes.empty()) return not_work("bytes follow its last part");
  return request;
}

}  // namespace coapt
