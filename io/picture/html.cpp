#include "io/picture/html.h"

#include <algorithm>

#include "io/json/version.h"
#include "io/picture/report_style.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

bool is_number(const std::string& cell) {
  if (cell.empty() || cell == "n/a") return true;
  const std::size_t sign = cell.front() == '-' || cell.front() == '+' ? 1 : 0;
  return sign < cell.size() && cell[sign] >= '0' && cell[sign] <= '9';
}

}  // namespace

std::string tag(const std::string& name, const std::string& content) {
  return "<" + name + ">" + content + "</" + name + ">\n";
}

const std::string_view kPageOpening =
    "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
    "img-src data:; style-src 'unsafe-inline'\">\n";

std::string html_page(const PageFrame& frame, const std::string& content) {
  return std::string(kPageOpening) + tag("title", escape_html(frame.title)) +
         tag("style", std::string(kReportStyle) + frame.style) + "</head>\n<body>\n<main>\n" +
         tag("h1", escape_html(frame.title)) +
         (frame.lead.empty() ? "" : "<p class=\"lead\">" + escape_html(frame.lead) + "</p>\n") +
         "<p class=\"notice\">" + escape_html(kResearchNotice) + "</p>\n" + content +
         "</main>\n</body>\n</html>\n";
}

std::string list_html(const std::vector<std::string>& words, const std::string& opening) {
  std::string html = opening;
  for (const std::string& line : words) html += "<li>" + escape_html(line) + "</li>";
  return html + "</ul>\n";
}

std::string table_html(const std::vector<std::vector<std::string>>& cells) {
  const auto opening = [&](std::size_t row, bool words) {
    return std::string(row == 0 ? "<th scope=\"col\"" : "<td") + (words ? " class=\"text\">" : ">");
  };
  const auto is_words = [&](std::size_t column) {
    return std::any_of(cells.begin() + 1, cells.end(), [&](const std::vector<std::string>& row) {
      return column < row.size() && !is_number(row[column]);
    });
  };
  std::string html = "<div class=\"scroll\"><table><thead>";
  for (std::size_t row = 0; row < cells.size(); ++row) {
    html += "<tr>";
    for (std::size_t c = 0; c < cells[row].size(); ++c)
      html +=
          opening(row, is_words(c)) + escape_html(cells[row][c]) + (row == 0 ? "</th>" : "</td>");
    html += row == 0 ? "</tr></thead>\n<tbody>" : "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string picture_html(const std::string& png, const std::string& alternative,
                         const std::string& caption) {
  return "<figure><img alt=\"" + escape_html(alternative) + "\" src=\"data:image/png;base64," +
         png + "\"><figcaption>" + escape_html(caption) + "</figcaption></figure>\n";
}

std::string chart_html(const std::string& svg, const std::string& caption) {
  return "<figure><div class=\"chart\">" + svg + "</div>" +
         (caption.empty() ? "" : "<figcaption>" + escape_html(caption) + "</figcaption>") +
         "</figure>\n";
}

}  // namespace coapt
