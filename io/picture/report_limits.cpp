// Residual uncertainties are those measured in docs/researcher/accuracy.md (equilibria, mesh), and
// what outranking.cpp takes a mean over the region to be worth.
#include "io/json/plan_json.h"
#include "io/json/result_json.h"
#include "io/json/search_options_json.h"
#include "io/json/version.h"
#include "io/picture/html.h"
#include "io/picture/report_parts.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

const std::vector<std::string>& how_far() {
  static const std::vector<std::string> kSentences = {
      "The ± of the area of one closure is its numerical error (mesh, stopping criterion, other "
      "equilibria). In nine of ten test cases the area on finer meshes lay within it. Coarse "
      "meshes tend to underestimate the leak. A mean over the region of interest has the same mesh "
      "error; a closure from another starting state changes it by about 0.05 mm², or 0.2 mm² with "
      "a flail leaflet. Smaller differences between plans are not significant.",
      "The leak is the anatomic area left open by the closed leaflets. It is not an effective "
      "regurgitant orifice area (EROA) and does not grade regurgitation.",
      "The spread covers only errors of suture length (1 mm) and papillary position (5 degrees), "
      "not errors of imaging, ring placement and pressure. The tissue error is reported "
      "separately, as an interval of the planned leak.",
      "Nothing here has been validated on patients."};
  return kSentences;
}

std::string folded(const std::string& summary, const std::string& content) {
  return "<details class=\"fold\"><summary>" + summary + "</summary>\n" + content + "</details>\n";
}

}  // namespace

std::string limits_section() {
  return "<section id=\"limits\"><h2>Limits</h2>\n" +
         folded("Model limitations and accuracy",
                "<h3>Not modelled</h3>\n" + list_html(not_modelled()) + "<h3>Accuracy</h3>\n" +
                    list_html(how_far())) +
         "</section>\n";
}

std::string reproduction_section(const PlanReport& report) {
  const SearchRequest& request = report.request;
  const auto row = [](const std::string& name, const std::string& value) {
    return "<tr><th scope=\"row\">" + name + "</th><td class=\"mono\">" + escape_html(value) +
           "</td></tr>\n";
  };
  Json options = to_json(request.options);
  options.erase("threads");  // the same plans on any number
  std::string html = "<div class=\"scroll\"><table class=\"facts\"><tbody>\n";
  if (!request.command.empty()) html += row("Command", request.command);
  html += row("Seed", std::to_string(request.options.seed)) +
          row("Version of coapt", std::string(version())) +
          row("Valve and closure (hash)", request.valve_hash) +
          row("Options of the search", options.dump());
  if (!report.result.plans.empty()) {
    const RankedPlan& plan = report.result.plans[plan_in_front(report)];
    html += row("Plan " + std::to_string(plan.rank) + " as a file", to_json(plan.plan).dump());
  }
  html +=
      "</tbody></table></div>\n<p class=\"small\">The result does not depend on the number of "
      "threads, unless the search was stopped by a time limit or by the user. <code>coapt evaluate "
      "VALVE PLAN</code> scores a plan file again.</p>\n";
  if (!report.before.valve.provenance.empty())
    html += "<h3>Source of the valve</h3>\n" + list_html(report.before.valve.provenance);
  return "<section id=\"reproduce\"><h2>How to reproduce</h2>\n" +
         folded("Version, seed, command, options, plan", html) + "</section>\n";
}

}  // namespace coapt
