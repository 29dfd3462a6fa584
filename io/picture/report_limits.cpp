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
      "An area of one closure: ± is its numerical error (mesh, stopping early, another "
      "equilibrium). Nine of ten scenes that were closed on finer meshes, too, were nearer. Coarse "
      "meshes read too little rather than too much. A mean over the region of interest has the "
      "same error of the mesh; closed again from another starting state it differs by about 0.05 "
      "mm², with a flail leaflet by 0.2 mm². Smaller differences between plans mean nothing.",
      "The leak is anatomic: what the closed leaflets leave open. It is not an effective "
      "regurgitant orifice area (EROA), and does not grade regurgitation.",
      "The spread covers errors of suture length (1 mm) and papillary position (5 degrees) only. "
      "Errors of imaging, ring placement and pressure are not included. What is not known of "
      "tissue and chordae is stated apart, as an interval of the leak as planned.",
      "Nothing here has been validated on patients."};
  return kSentences;
}

std::string folded(const std::string& summary, const std::string& content) {
  return "<details class=\"fold\"><summary>" + summary + "</summary>\n" + content + "</details>\n";
}

}  // namespace

std::string limits_section() {
  return "<section id=\"limits\"><h2>Limits</h2>\n" +
         folded("What is not modelled, and how accurate the figures are",
                "<h3>What is not modelled</h3>\n" + list_html(not_modelled()) +
                    "<h3>Accuracy of the figures</h3>\n" + list_html(how_far())) +
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
      "</tbody></table></div>\n<p class=\"small\">The result is the same on any number of threads, "
      "unless a time limit or a user stopped the search. <code>coapt evaluate VALVE PLAN</code> "
      "scores a plan file again.</p>\n";
  if (!report.before.valve.provenance.empty())
    html += "<h3>Where the valve comes from</h3>\n" + list_html(report.before.valve.provenance);
  return "<section id=\"reproduce\"><h2>How to reproduce</h2>\n" +
         folded("Version, seed, command, options, plan", html) + "</section>\n";
}

}  // namespace coapt
