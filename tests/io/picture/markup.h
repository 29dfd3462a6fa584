// What tests ask of SVG and HTML.
#pragma once

#include <cctype>
#include <cstddef>
#include <string>
#include <vector>

namespace coapt {

inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The markup without its embedded pictures, whose base64 may spell anything.
inline std::string without_pictures(std::string html) {
  const std::string opening = "base64,";
  for (std::size_t at = html.find(opening); at != std::string::npos; at = html.find(opening, at))
    html.erase(at, html.find('"', at) - at);
  return html;
}

/// The first thing that keeps an SVG from being well-formed XML: a tag that does not match, an
/// attribute without quotes, a stray "<" or "&". Empty if there is none.
inline std::string markup_error(const std::string& xml) {
  std::vector<std::string> open;
  std::size_t at = 0;
  for (std::size_t start; (start = xml.find('<', at)) != std::string::npos;) {
    const std::size_t end = xml.find('>', start);
    if (end == std::string::npos) return "unfinished tag";
    const std::string tag = xml.substr(start + 1, end - start - 1);
    if (tag.find('<') != std::string::npos) return "stray < in " + tag;
    if (count(tag, "\"") % 2 != 0) return "quotes in " + tag;
    const bool closing = tag.front() == '/', alone = tag.back() == '/';
    if (!closing && !std::isalpha(static_cast<unsigned char>(tag.front())))
      return "no name: " + tag;
    if (closing && (open.empty() || tag.substr(1) != open.back())) return "does not close: " + tag;
    if (closing)
      open.pop_back();
    else if (!alone)
      open.push_back(tag.substr(0, tag.find_first_of(" \n")));
    at = end + 1;
  }
  for (std::size_t amp = xml.find('&'); amp != std::string::npos; amp = xml.find('&', amp + 1)) {
    const std::size_t end = xml.find(';', amp);
    if (end == std::string::npos || end - amp > 6) return "stray &";
  }
  return open.empty() ? "" : "left open: " + open.back();
}

}  // namespace coapt
