// Residual uncertainties are those measured in docs/ROADMAP.md (equilibria) and README.md (membranes), and
// what outranking.cpp takes a mean over the region to be worth.
#include "io/json/plan_json.h"
#include "io/json/result_json.h"
#include "io/json/search_options_json.h"
#include "io/picture/html.h"
#include "io/picture/report_parts.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

const std::vector<std::string>& how_far() {
  static const std::vector<std::string> kSentences = {
      "One closure: closed from another start, the same plan ends with an orifice that differs by "
      "up to "
      "about 0.5 mm². A mean over the region of interest is known to about 0.05 mm², with a flail "
      "leaflet "
      "to 0.2. Smaller differences between plans say nothing.",
      "Mesh and membrane: with the default springs the orifice of one leaking valve came to "
      "between 38.6 and "
      "45.7 mm² on meshes of 648 to 10,368 triangles.",
      "The orifice is anatomic: what the closed leaflets leave open. It is not an effective "
      "regurgitant "
      "orifice area (EROA), and regurgitation is not graded by it.",
      "The spread is that of suture lengths (1 mm) and papillary positions (5 degrees) alone. "
      "Errors of "
      "imaging, of placing the ring, of tissue and of pressure come on top.",
      "Nothing here has been validated on patients."};
  return kSentences;
}

std::string folded(const std::string& summary, const std::string& content) {
  return "<details class=\"fold\"><summary>" + summary + "</summary>\n" + content + "</details>\n";
}

}  // namespace

std::string limits_section() {
  return "<section id=\"limits\"><h2>Limits</h2>\n" +
         folded("What is not modelled, and how far the figures go",
                "<h3>What is not modelled</h3>\n" + list_html(not_modelled()) +
                    "<h3>How far the figures go</h3>\n" + list_html(how_far())) +
         "</section>\n";
}

std::string reproduction_section(const PlanReport& report) {
  const SearchRequest& request = report.request;
  const auto row = [](const std::string& name, const std::string& value) {
    return "<tr><th scope=\"row\">" + name + "</th><td class=\"mono\">" + escape_html(value) +
           "</td></tr>\n";
  };
  std::string html = "<div class=\"scroll\"><table class=\"facts\"><tbody>\n";
  if (!request.command.empty()) html += row("Command", request.command);
  html += row("Seed", std::to_string(request.options.seed)) +
          row("Version of coapt", std::string(version())) +
          row("Valve and closure (hash)", request.valve_hash) +
          row("Options of the search", to_json(request.options).dump());
  if (!report.result.plans.empty()) {
    const RankedPlan& plan = report.result.plans[plan_in_front(report)];
    html += row("Plan " + std::to_string(plan.rank) + " as a file", to_json(plan.plan).dump());
  }
  html +=
      "</tbody></table></div>\n<p class=\"small\">The same on any number of threads, unless a time "
      "limit or a person stopped it. <code>coapt evaluate VALVE PLAN</code> scores a plan's file "
      "again.</p>\n";
  if (!report.before.valve.provenance.empty())
    html += "<h3>Where the valve comes from</h3>\n" + list_html(report.before.valve.provenance);
  return "<section id=\"reproduce\"><h2>How to reproduce</h2>\n" +
         folded("Version, seed, command, options, plan", html) + "</section>\n";
}

}  // namespace coapt
