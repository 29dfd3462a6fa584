#include "io/picture/study_page.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "io/picture/html.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr const char* kStudyStyle =
    ".agrees,.differs{font-weight:600;white-space:nowrap;text-align:left}\n"
    ".agrees{color:#00694d}.differs{color:var(--warn)}\n"
    ".why{color:var(--muted);font-size:.85rem}\n"
    ".findings td,.findings th{text-align:left}\n"
    "@media (prefers-color-scheme:dark){.agrees{color:#3fd3a2}}\n";

std::string paragraphs(const std::string& text) {
  std::string html, paragraph;
  std::istringstream lines(text + "\n\n");
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty())
      paragraph += (paragraph.empty() ? "" : " ") + line;
    else if (!paragraph.empty())
      html += tag("p", escape_html(std::exchange(paragraph, "")));
  }
  return html;
}

std::string section_html(const PageSection& section) {
  std::string html = "<section>";
  if (!section.heading.empty()) html += tag("h2", escape_html(section.heading));
  html += paragraphs(section.text);
  if (!section.svg.empty()) html += chart_html(section.svg);
  if (!section.table.empty()) html += table_html(section.table);
  return html + "</section>\n";
}

std::string page(const std::string& title, const std::string& lead, const std::string& content) {
  return html_page({title, lead, kStudyStyle}, content);
}

/// "dilation-grows-superlinearly" in words.
std::string in_words(std::string name) {
  std::replace(name.begin(), name.end(), '-', ' ');
  if (!name.empty() && name.front() >= 'a' && name.front() <= 'z')
    name.front() = static_cast<char>(name.front() - 'a' + 'A');
  return name;
}

std::string finding_row(const Finding& finding) {
  const std::string why =
      finding.judged.empty() ? "" : "<div class=\"why\">" + escape_html(finding.judged) + "</div>";
  return "<tr><td>" + escape_html(in_words(finding.finding)) + why + "</td><td>" +
         escape_html(finding.section) + "</td><td>" + escape_html(finding.thesis) + "</td><td>" +
         escape_html(finding.ours) + "</td>" +
         (finding.agrees ? "<td class=\"agrees\">✓ agrees</td>"
                         : "<td class=\"differs\">✗ differs</td>") +
         "</tr>\n";
}

std::string findings_table(const std::vector<Finding>& findings) {
  if (findings.empty()) return "";
  std::string html =
      "<section><h2>Findings</h2>\n<div class=\"scroll\"><table class=\"findings\">"
      "<thead><tr><th>Finding and criterion for this valve</th><th>Section</th><th>Thesis</th>"
      "<th>This valve</th><th>Verdict</th></tr></thead>\n<tbody>";
  for (const Finding& finding : findings) html += finding_row(finding);
  return html + "</tbody></table></div></section>\n";
}

}  // namespace

std::string study_page(const std::string& title, const std::string& lead,
                       const std::vector<PageSection>& sections) {
  std::string content;
  for (const PageSection& section : sections) content += section_html(section);
  return page(title, lead, content);
}

std::string findings_page(const std::string& valve_name, const std::vector<Finding>& findings,
                          const std::vector<PageSection>& figures, const std::string& closures) {
  const auto hold = std::count_if(findings.begin(), findings.end(),
                                  [](const Finding& finding) { return finding.agrees; });
  std::string content = "<p class=\"verdict\">" + std::to_string(hold) + " of " +
                        counted(static_cast<long>(findings.size()), "finding") + " of the thesis " +
                        (hold == 1 ? "holds" : "hold") + " on this valve.</p>\n" +
                        findings_table(findings);
  for (const PageSection& figure : figures) content += section_html(figure);
  if (!closures.empty()) content += section_html({"Closures", closures, "", {}});
  return page("Ischaemic mitral regurgitation: " + valve_name,
              "Studies of chapter 4 of the thesis, repeated on this valve.", content);
}

}  // namespace coapt
