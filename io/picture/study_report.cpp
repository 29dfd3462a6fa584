#include "io/picture/study_report.h"

#include <algorithm>

#include "io/json/findings_json.h"
#include "io/json/plans_json.h"
#include "io/json/result_json.h"
#include "io/json/version.h"
#include "io/picture/displacement_charts.h"
#include "io/picture/study_charts.h"
#include "io/picture/study_csv.h"
#include "io/picture/text.h"
#include "search/studies/anchor_findings.h"
#include "search/studies/geometry_findings.h"
#include "search/studies/ring_findings.h"
#include "search/studies/thesis_figures.h"

namespace coapt {
namespace {

PageSection annulus_figure(const AnnulusStudy& study) {
  return {"Annular dilation and flattening (figure 4.5)",
          "Trigones, papillary tips and transverse diameter are fixed. Open circles: values of the "
          "thesis.",
          annulus_svg(study, true),
          {}};
}

PageSection papillary_table(const PapillaryStudy& study) {
  PageSection section{"Largest orifice by class and axes (table 4.1), mm2", "", "", {{"class"}}};
  for (const char* axes : kAxesNames) section.table[0].push_back(axes);
  for (const DisplacementGrid& grid : study.grids) {
    section.table.push_back({to_string(grid.displaced)});
    for (const double area : largest_orifices(grid)) section.table.back().push_back(fixed(area, 1));
  }
  return section;
}

PageSection ring_table(const RingStudy& study) {
  PageSection section{"Largest ratio to the properly sized annulus (table 4.2), percent",
                      "Over displacements that leak 1 mm2 or more with the properly sized annulus.",
                      "",
                      {{"class", "U1", "U2", "U3"}}};
  for (const Displaced displaced : kDisplaced) {
    section.table.push_back({to_string(displaced)});
    for (int sizes = 1; sizes <= 3; ++sizes)
      section.table.back().push_back(fixed(100.0 * largest_ring_ratio(study, displaced, sizes), 1));
  }
  return section;
}

std::string settings(const ApproximationOptions& options) {
  return "Displacements 0 to 6 mm by " + fixed(options.displacement_step_mm, 0) +
         " mm that leak more than " + fixed(options.least_mm2, 0) +
         " mm2; regions of interest of " + counted(options.region_points, "point") + ".";
}

PageSection anchors_table(const std::vector<AnchorSummary>& summaries,
                          const ApproximationOptions& options) {
  PageSection section{"Anchors",
                      settings(options) +
                          " Means over the displacements; movement and suture (mm) over the "
                          "repaired ones. Slopes in mm2 per mm of tip movement, by suture length "
                          "and by swing; all else in mm2.",
                      "",
                      {{"protocol", "class", "anchor", "repaired", "mean", "sd", "sd of means",
                        "sd by length", "sd by angles", "slope by length", "slope by swing",
                        "movement", "suture", "outside the grid"}}};
  for (const AnchorSummary& s : summaries)
    section.table.push_back({to_string(s.protocol), to_string(s.displaced), s.anchor.name,
                             std::to_string(s.repaired) + " of " + std::to_string(s.configurations),
                             fixed(s.mean_mm2, 2), fixed(s.sd_mm2, 2), fixed(s.sd_of_means_mm2, 2),
                             fixed(s.length_sd_mm2, 2), fixed(s.angle_sd_mm2, 2),
                             fixed(s.length_slope_mm2_per_mm, 1),
                             fixed(s.swing_slope_mm2_per_mm, 1), fixed(s.movement_mm, 1),
                             fixed(s.suture_mm, 1), fixed(100.0 * s.clamped_share, 0) + " %"});
  return section;
}

void add_to_report(StudyReport& report, const AnnulusStudy& study) {
  report.files.emplace_back("annulus.csv", annulus_csv(study));
  report.files.emplace_back("annulus.svg", annulus_svg(study, true));
  report.figures.push_back(annulus_figure(study));
}

void add_to_report(StudyReport& report, const PapillaryStudy& study) {
  report.files.emplace_back("papillary.csv", papillary_csv(study));
  report.files.emplace_back("papillary.svg", papillary_svg(study));
  report.figures.push_back({"Papillary displacement (figures 4.6 to 4.8)",
                            "Orifice over transverse and posterior displacement, a surface for "
                            "each apical displacement, and its gradient.",
                            papillary_svg(study),
                            {}});
  report.figures.push_back(papillary_table(study));
}

void add_to_report(StudyReport& report, const RingStudy& study) {
  report.files.emplace_back("ring.csv", ring_csv(study));
  report.files.emplace_back("ring.svg", ring_svg(study));
  report.figures.push_back({"Undersized rings (figure 4.9)", "", ring_svg(study), {}});
  report.figures.push_back(ring_table(study));
}

void add_to_report(StudyReport& report, const AnchorStudies& studies) {
  if (studies.approximation.empty()) return;
  std::vector<AnchorSummary> summaries;
  for (const ApproximationStudy& study : studies.approximation) {
    const std::string name = std::string("anchors-") + to_string(study.protocol) + ".svg";
    report.files.emplace_back(name, anchors_histogram_svg(study));
    report.figures.push_back({std::string("Trigone versus saddle peak (figure 4.10), protocol ") +
                                  to_string(study.protocol),
                              "",
                              anchors_histogram_svg(study),
                              {}});
    for (const AnchorSummary& summary : summarise(study)) summaries.push_back(summary);
  }
  report.files.emplace_back("approximation.csv", approximation_csv(studies.approximation));
  report.files.emplace_back("anchors.csv", anchors_csv(summaries));
  report.figures.push_back(anchors_table(summaries, studies.approximation.front().options));
  const std::vector<AnchorSummary>& scan = studies.scan;
  if (scan.empty()) return;
  std::vector<AnchorSummary> same;
  for (const AnchorSummary& summary : summaries)
    if (summary.protocol == scan.front().protocol) same.push_back(summary);
  report.files.emplace_back("anchor-scan.csv", anchors_csv(scan));
  report.files.emplace_back("anchor-scan.svg", anchor_scan_svg(scan, same));
  report.figures.push_back({"Anchors around the annulus", "", anchor_scan_svg(scan, same), {}});
}

StudyReport study_one_annulus(OrificeTable& table) {
  const AnnulusStudy study = study_annulus(table);
  StudyReport report;
  report.findings = annulus_findings(study);
  add_to_report(report, study);
  return report;
}

StudyReport study_one_papillary(OrificeTable& table, const ThesisStudyOptions& options) {
  const PapillaryStudy study = study_papillary(table, options.papillary_nodes);
  StudyReport report;
  report.findings = papillary_findings(study);
  add_to_report(report, study);
  return report;
}

StudyReport study_one_ring(OrificeTable& table) {
  const RingStudy study = study_ring(table);
  StudyReport report;
  report.findings = ring_findings(study);
  add_to_report(report, study);
  return report;
}

StudyReport study_approximations(OrificeTable& table, const ThesisStudyOptions& options) {
  const AnchorStudies studies = study_anchors(table, options);
  StudyReport report;
  for (const ApproximationStudy& study : studies.approximation)
    for (const Finding& finding : anchor_findings(study)) report.findings.push_back(finding);
  add_to_report(report, studies);
  return report;
}

StudyReport study_all(OrificeTable& table, const ThesisStudyOptions& options) {
  const ThesisStudy study = study_thesis(table, options);
  StudyReport report;
  report.findings = findings(study);
  add_to_report(report, study.annulus);
  add_to_report(report, study.papillary);
  add_to_report(report, study.ring);
  add_to_report(report, study.anchors);
  return report;
}

/// Empty if none was closed again.
std::string start_words(const Json& starts) {
  if (starts["closures"] == 0) return "";
  return " Repeated from the open state, " + std::to_string(starts["elsewhere"].get<int>()) +
         " of " + std::to_string(starts["closures"].get<int>()) +
         " closures settle in a different shape; orifices differ by at most " +
         fixed(starts["leak_difference_max_mm2"].get<double>(), 2) + " mm2.";
}

std::string trust_words(const Json& study) {
  return std::to_string(study["untrusted"].get<int>()) +
         " unreliable (not converged, or crossed)." + start_words(study["cold_starts"]);
}

}  // namespace

const char* to_string(StudyKind kind) {
  switch (kind) {
    case StudyKind::Annulus:
      return "annulus";
    case StudyKind::Papillary:
      return "papillary";
    case StudyKind::Ring:
      return "ring";
    case StudyKind::Approximation:
      return "approximation";
    case StudyKind::Thesis:
      return "thesis";
  }
  return "";
}

ThesisStudyOptions default_options(StudyKind kind) {
  ThesisStudyOptions options;
  if (kind == StudyKind::Thesis) options.scan_sites = 0;  // the thesis has none
  return options;
}

StudyReport run_study(StudyKind kind, OrificeTable& table, const ThesisStudyOptions& options) {
  switch (kind) {
    case StudyKind::Annulus:
      return study_one_annulus(table);
    case StudyKind::Papillary:
      return study_one_papillary(table, options);
    case StudyKind::Ring:
      return study_one_ring(table);
    case StudyKind::Approximation:
      return study_approximations(table, options);
    case StudyKind::Thesis:
      return study_all(table, options);
  }
  return {};
}

std::string study_timing(const Json& study) {
  return std::to_string(study["configurations"].get<int>()) + " configurations; " +
         std::to_string(study["closures"].get<int>() - study["closures_known"].get<int>()) +
         " newly closed in " + fixed(study["seconds"].get<double>(), 1) + " s; " +
         trust_words(study) + " The thesis: " + std::to_string(thesis::kConfigurations) +
         " in about " + fixed(thesis::kHours, 0) + " hours.";
}

Json complete(StudyReport& report, StudyKind kind, OrificeTable& table, double seconds) {
  const auto agree = std::count_if(report.findings.begin(), report.findings.end(),
                                   [](const Finding& finding) { return finding.agrees; });
  Json answer = {{"study", to_string(kind)},
                 {"valve", table.valve().name},
                 {"version", version()},
                 {"revision", revision_json()},
                 {"configurations", table.configurations()},
                 {"closures", table.configurations()},
                 {"closures_known", table.known()},
                 {"untrusted", table.untrusted()},
                 {"cold_starts", to_json(table.check_starts())},
                 {"seconds", seconds},
                 {"findings", report.findings.size()},
                 {"agree", agree},
                 {"notice", kResearchNotice}};
  // Files are the same whoever closed, when, and how often the study was begun.
  Json lasting = answer;
  lasting.erase("closures_known");
  lasting.erase("seconds");
  report.files.emplace_back("study.json", lasting.dump(2) + "\n");
  report.files.emplace_back("findings.json", to_json(report.findings).dump(2) + "\n");
  report.files.emplace_back(
      "index.html", findings_page(table.valve().name, report.findings, report.figures,
                                  std::to_string(table.configurations()) + " configurations; " +
                                      trust_words(answer)));
  return answer;
}

}  // namespace coapt
