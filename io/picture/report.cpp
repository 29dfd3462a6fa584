// What a surgeon asks first comes first (report_first_page.cpp), then the evidence, then the limits and how
// to get the same again.
#include "io/picture/report.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>

#include "core/closed/diagnosis_sentence.h"
#include "io/json/base64.h"
#include "io/json/plan_json.h"
#include "io/picture/html.h"
#include "io/picture/picture.h"
#include "io/picture/report_page_style.h"
#include "io/picture/report_parts.h"
#include "io/picture/report_words.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr std::size_t kLongestTitle = 160;  // bytes of a name in the title
constexpr std::size_t kLongestHeader = 60;

/// Cut short between characters, with an ellipsis.
std::string shortened(std::string text, std::size_t most) {
  if (text.size() <= most) return text;
  text.resize(most);
  while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0u) == 0x80u)
    text.pop_back();
  if (!text.empty() && static_cast<unsigned char>(text.back()) >= 0xC0u) text.pop_back();
  return text + "…";
}

std::string title_of(const PlanReport& report) {
  const std::string name = shortened(report.before.valve.name, kLongestTitle);
  const auto plans = report.result.plans.size();
  if (report.about == 0 || plans == 0)
    return std::string(plans == 1 ? "Repair plan for " : "Repair plans for ") + name;
  return "Repair plan " + std::to_string(report.result.plans[plan_in_front(report)].rank) + " of " +
         std::to_string(plans) + " for " + name;
}

std::string without_plans(const PlanReport& report) {
  const SearchResult& result = report.result;
  const bool closed = result.stop == SearchStop::Exhausted && result.plans_possible == 0;
  std::string words = result.diagnosis
                          ? sentence_of(*result.diagnosis, result.before_estimates.leak_mm2) + " "
                          : "";
  words += closed ? "The rules leave none of the operations that are indicated."
                  : "The search ended before any plan was scored.";
  return "<section><h2>No plan</h2><p>" + escape_html(words) + "</p>" +
         picture_html(picture_of(report, {}), "The valve before repair", "Before repair") +
         "</section>\n";
}

}  // namespace

std::string drawn(const ReportPicture& picture, const ClosedValve& before,
                  const std::vector<ClosedValve>& after) {
  switch (picture.view) {
    case ReportPicture::View::Before:
      return encoded_base64(closure_picture_png(before));
    case ReportPicture::View::AtrialPair:
      return encoded_base64(atrial_pair_png(before, after.at(picture.plan)));
    case ReportPicture::View::SectionChange:
      return encoded_base64(section_change_png(before, after.at(picture.plan)));
    case ReportPicture::View::After:
      return encoded_base64(after_pair_png(after.at(picture.plan)));
  }
  return "";
}

std::string picture_of(const PlanReport& report, const ReportPicture& picture) {
  return report.picture ? report.picture(picture) : drawn(picture, report.before, report.after);
}

std::size_t plan_in_front(const PlanReport& report) {
  const std::vector<RankedPlan>& plans = report.result.plans;
  const auto found = std::find_if(plans.begin(), plans.end(), [&](const RankedPlan& plan) {
    return plan.rank == report.about;
  });
  return found == plans.end() ? 0 : static_cast<std::size_t>(found - plans.begin());
}

bool is_told(const PlanReport& report, const RankedPlan& plan) {
  return report.about == 0 || plan.rank == report.result.plans[plan_in_front(report)].rank;
}

std::string plan_report_html(const PlanReport& report) {
  const std::string contents =
      "<p class=\"contents\"><a href=\"#ranked\">All ranked plans</a> · <a "
      "href=\"#evidence\">Evidence</a> · <a href=\"#search\">Search</a> · <a "
      "href=\"#limits\">Limits</a> · <a href=\"#reproduce\">How to reproduce</a></p>\n";
  std::string html;
  if (report.result.plans.empty())
    html += without_plans(report);
  else
    html += first_page(report) + contents + ranked_section(report) + evidence_section(report) +
            information_section(report.result);
  html += search_section(report.result) + limits_section() + reproduction_section(report);
  const std::string header = shortened(report.before.valve.name, kLongestHeader);
  const std::string lead =
      (report.date.empty() ? "" : report.date + ". ") + valve_words(report.before);
  return html_page({title_of(report), lead, report_page_style(header, report.date)}, html);
}

std::string today() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm day{};
  localtime_r(&now, &day);
  static constexpr std::array kMonths = {"January",   "February", "March",    "April",
                                         "May",       "June",     "July",     "August",
                                         "September", "October",  "November", "December"};
  return std::to_string(day.tm_mday) + ' ' + kMonths[static_cast<std::size_t>(day.tm_mon)] + ' ' +
         std::to_string(1900 + day.tm_year);
}

PlanPictures pictures_of(const SearchResult& result) {
  PlanPictures pictures{*result.closed_before, {}};
  for (const RankedPlan& ranked : result.plans) pictures.after.push_back(*ranked.closed);
  return pictures;
}

std::string plan_report_html(const SearchResult& result, const SearchRequest& request) {
  const PlanPictures pictures = pictures_of(result);
  return plan_report_html({pictures.before, pictures.after, result, request, 0, today()});
}

}  // namespace coapt
