// Pieces of HTML pages. What is called words, text or cells is escaped; content is not.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace coapt {

std::string tag(const std::string& name, const std::string& content);

/// Of a page of coapt, with its notice; no scripts, nothing fetched, pictures only from within.
struct PageFrame {
  std::string title, lead;
  std::string style;  ///< beside kReportStyle
};
/// How every page begins: with what forbids scripts and anything from elsewhere.
extern const std::string_view kPageOpening;
std::string html_page(const PageFrame& frame, const std::string& content);

/// `opening`: its tag.
std::string list_html(const std::vector<std::string>& words, const std::string& opening = "<ul>");

/// The first row is the header. Columns of words stand left, columns of numbers right.
std::string table_html(const std::vector<std::vector<std::string>>& cells);

/// A picture with words for those who do not see it, and words below. @param png in base64
std::string picture_html(const std::string& png, const std::string& alternative,
                         const std::string& caption);

/// `svg` as it is, in a frame, with words below.
std::string chart_html(const std::string& svg, const std::string& caption = "");

}  // namespace coapt
