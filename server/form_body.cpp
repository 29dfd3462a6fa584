#include "server/form_body.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "io/json/base64.h"
#include "io/json/json.h"
#include "io/json/parse_json.h"

namespace coapt {
namespace {

constexpr std::size_t kMostParts = 1000;
constexpr std::size_t kLongestBoundary = 70;  // RFC 2046, 5.1.1
constexpr std::string_view kEnd = "\r\n";
constexpr std::array<std::string_view, 3> kLists = {"leaflets", "slicerheart", "files"};
constexpr std::array<std::string_view, 4> kStrings = {"name", "units", "frame", "reference"};

std::string lower_case(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

/// `name="value"` or name=value among the parameters of a header; none: it is not there.
std::optional<std::string> parameter(std::string_view header, const std::string& name) {
  const std::string lower = lower_case(header);
  for (std::size_t at = lower.find(name + '='); at != std::string::npos;
       at = lower.find(name + '=', at + 1)) {
    if (at > 0 && lower[at - 1] != ' ' && lower[at - 1] != ';') continue;
    std::string_view value = header.substr(at + name.size() + 1);
    if (!value.starts_with('"')) return std::string(value.substr(0, value.find_first_of("; \r\n")));
    value.remove_prefix(1);
    return std::string(value.substr(0, value.find('"')));
  }
  return {};
}

const Error kNotWhole = {ErrorCode::InvalidJson, "", "the form is incomplete"};

/// Puts a part where it belongs.
Errors take_part(std::string_view headers, std::string_view content, Json& document) {
  std::string disposition;
  while (!headers.empty()) {
    const std::string_view line = headers.substr(0, headers.find(kEnd));
    if (lower_case(line).starts_with("content-disposition:")) disposition = line;
    headers.remove_prefix(std::min(headers.size(), line.size() + kEnd.size()));
  }
  std::optional<std::string> name = parameter(disposition, "name");
  if (!name || name->empty())
    return {Error{ErrorCode::MissingField, "", "a part of the form has no name"}};
  Json value;
  const bool is_list = std::find(kLists.begin(), kLists.end(), *name) != kLists.end();
  if (const auto file = parameter(disposition, "filename")) {
    value = {{"name", *file}, {"base64", encoded_base64(content)}};
  } else {
    const bool is_string = std::find(kStrings.begin(), kStrings.end(), *name) != kStrings.end();
    const Expected<Json> read =
        is_string ? Expected<Json>(Json(std::string(content))) : parse_json(std::string(content));
    value = read ? *read : Json(std::string(content));
  }
  Json* target = &document;
  if (const std::size_t dot = name->find('.'); dot != std::string::npos) {
    target = &document[name->substr(0, dot)];
    if (target->is_null()) *target = Json::object();
    if (!target->is_object())
      return {Error{ErrorCode::BadReference, "", "two parts of the form have the same name"}};
    name->erase(0, dot + 1);
  }
  const bool is_new = !target->contains(*name);
  Json& place = (*target)[*name];
  if (is_list && !value.is_array() && (is_new || place.is_array()))
    place.push_back(std::move(value));
  else if (is_new)
    place = std::move(value);
  else
    return {Error{ErrorCode::BadReference, "", "two parts of the form have the same name"}};
  return {};
}

}  // namespace

bool is_form(std::string_view content_type) {
  return lower_case(content_type).starts_with("multipart/form-data");
}

Expected<std::string> json_of_form(std::string_view body, std::string_view content_type) {
  const std::optional<std::string> boundary = parameter(content_type, "boundary");
  if (!boundary || boundary->empty() || boundary->size() > kLongestBoundary)
    return Error{ErrorCode::InvalidJson, "", "the form's Content-Type has no boundary"};
  const std::string mark = "--" + *boundary;
  const std::string next = std::string(kEnd) + mark;
  Json document = Json::object();
  if (!body.starts_with(mark)) {
    const std::size_t first = body.find(next);  // behind a preamble
    if (first == std::string_view::npos) return kNotWhole;
    body.remove_prefix(first + kEnd.size());
  }
  body.remove_prefix(mark.size());
  for (std::size_t part = 0; !body.starts_with("--"); ++part) {
    if (part == kMostParts)
      return Error{ErrorCode::OutOfRange, "", "the form has more than 1000 parts"};
    if (!body.starts_with(kEnd)) return kNotWhole;
    body.remove_prefix(kEnd.size());
    const std::size_t end = body.find(next);
    const std::size_t headers = body.find("\r\n\r\n");
    if (end == std::string_view::npos || headers == std::string_view::npos || headers > end)
      return kNotWhole;
    const std::size_t content = headers + 2 * kEnd.size();
    if (content > end) return kNotWhole;
    if (Errors errors =
            take_part(body.substr(0, headers), body.substr(content, end - content), document);
        !errors.empty())
      return errors;
    body.remove_prefix(end + next.size());
  }
  return json_text(document);
}

}  // namespace coapt
