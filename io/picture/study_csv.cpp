#include "io/picture/study_csv.h"

#include "io/picture/csv_lines.h"
#include "search/model_draw.h"

namespace coapt {
namespace {

void add(CsvLines& csv, const AnchorSummary& s) {
  csv << to_string(s.protocol) << to_string(s.displaced) << s.anchor.name << s.anchor.around
      << s.configurations << s.repaired << s.mean_mm2 << s.sd_mm2 << s.sd_of_means_mm2
      << s.length_sd_mm2 << s.angle_sd_mm2 << s.length_slope_mm2_per_mm << s.swing_slope_mm2_per_mm
      << s.movement_mm << s.suture_mm << s.leaking_share << s.clamped_share;
}

constexpr const char* kSummaryHeader =
    "protocol,class,anchor,around,configurations,repaired,mean_mm2,sd_mm2,sd_of_means_mm2,"
    "length_sd_mm2,angle_sd_mm2,length_slope_mm2_per_mm,swing_slope_mm2_per_mm,movement_mm,suture_"
    "mm,leaking_share,clamped_share";

}  // namespace

std::string table_csv(const std::vector<std::vector<std::string>>& rows) {
  CsvLines csv;
  for (const std::vector<std::string>& row : rows) {
    for (const std::string& cell : row) csv << cell;
    csv.end_line();
  }
  return csv.text();
}

std::string annulus_csv(const AnnulusStudy& study) {
  CsvLines csv("annular_height_percent,ap_dilation_percent,orifice_mm2");
  for (std::size_t h = 0; h < study.height_percent.size(); ++h)
    for (std::size_t d = 0; d < study.dilation_percent.size(); ++d) {
      csv << study.height_percent[h] << study.dilation_percent[d] << study.area_mm2[h][d];
      csv.end_line();
    }
  return csv.text();
}

std::string papillary_csv(const PapillaryStudy& study) {
  CsvLines csv(
      "class,transverse_mm,posterior_mm,apical_mm,orifice_mm2,gradient_transverse_mm2_per_mm,"
      "gradient_posterior_mm2_per_mm,gradient_apical_mm2_per_mm");
  for (const DisplacementGrid& grid : study.grids) {
    const std::vector<Vec3> slopes = gradients(grid);
    for (std::size_t i = 0; i < grid.area_mm2.size(); ++i) {
      csv << to_string(grid.displaced) << grid.displacement_mm(i) << grid.area_mm2[i] << slopes[i];
      csv.end_line();
    }
  }
  return csv.text();
}

std::string ring_csv(const RingStudy& study) {
  CsvLines csv(
      "class,sizes_below,transverse_mm,posterior_mm,apical_mm,orifice_mm2,ratio_to_proper_size");
  for (const auto& sizes : study.grids)
    for (const DisplacementGrid& grid : sizes) {
      const std::vector<double> ratios = ring_ratios(study, grid.displaced, grid.ring_sizes_below);
      for (std::size_t i = 0; i < grid.area_mm2.size(); ++i) {
        csv << to_string(grid.displaced) << grid.ring_sizes_below << grid.displacement_mm(i)
            << grid.area_mm2[i] << ratios[i];
        csv.end_line();
      }
    }
  return csv.text();
}

std::string approximation_csv(const std::vector<ApproximationStudy>& studies) {
  CsvLines csv(
      "protocol,class,transverse_mm,posterior_mm,apical_mm,displaced_orifice_mm2,anchor,around,"
      "repaired,to_transverse_mm,to_posterior_mm,to_apical_mm,movement_mm,suture_mm,orifice_mm2,"
      "region_points,region_mean_mm2,region_sd_mm2,region_worst_mm2,length_sd_mm2,angle_sd_mm2,"
      "length_slope_mm2_per_mm,swing_slope_mm2_per_mm,leaking_share,clamped_share");
  for (const ApproximationStudy& study : studies)
    for (const Approximation& a : study.approximations) {
      const AnchorSite& anchor = study.anchors[a.anchor];
      csv << to_string(study.protocol) << to_string(a.displaced) << a.displaced_mm
          << a.displaced_area_mm2 << anchor.name << anchor.around << a.repaired << a.position_mm
          << a.movement_mm << a.suture_mm << a.area_mm2 << study.options.region_points
          << a.region.mean_mm2 << a.region.sd_mm2 << a.region.worst_mm2 << a.region.length_sd_mm2
          << a.region.angle_sd_mm2 << a.region.length_slope_mm2_per_mm
          << a.region.swing_slope_mm2_per_mm << a.region.leaking_share << a.region.clamped_share;
      csv.end_line();
    }
  return csv.text();
}

std::string anchors_csv(const std::vector<AnchorSummary>& summaries) {
  CsvLines csv(kSummaryHeader);
  for (const AnchorSummary& summary : summaries) {
    add(csv, summary);
    csv.end_line();
  }
  return csv.text();
}

std::string anchor_scan_csv(const std::vector<ScannedAnatomy>& scan) {
  std::string header = "anatomy,";
  for (const ScanFactor& factor : scan_factors()) {
    std::string name = factor.name;
    for (char& c : name)
      if (c == ',') c = ';';
    header += name + ',';
  }
  CsvLines csv(header + kSummaryHeader);
  for (std::size_t i = 0; i < scan.size(); ++i)
    for (const AnchorSummary& summary : scan[i].summaries) {
      csv << static_cast<int>(i);
      for (std::size_t f = 0; f < scan_factors().size(); ++f) {
        const ScanFactor& factor = scan_factors()[f];
        csv << factor.lower + scan[i].shares[f] * (factor.upper - factor.lower);
      }
      add(csv, summary);
      csv.end_line();
    }
  return csv.text();
}

std::string anchor_answers_csv(const std::vector<AnchorAnswer>& answers) {
  CsvLines csv(
      "protocol,class,objective,anatomies,trigone_wins,ties,mean_difference,predicted_share,"
      "factor,sobol_first,sobol_total,effect");
  for (const AnchorAnswer& a : answers)
    for (std::size_t f = 0; f < a.decided_by.first.size(); ++f) {
      csv << to_string(a.protocol) << to_string(a.displaced) << to_string(a.objective)
          << a.anatomies << a.trigone_wins << a.ties << a.mean_difference
          << a.decided_by.predicted_share << scan_factors()[f].name << a.decided_by.first[f]
          << a.decided_by.total[f] << a.decided_by.effect[f];
      csv.end_line();
    }
  return csv.text();
}

std::string generality_csv(const std::vector<ValveFindings>& studied) {
  CsvLines csv("kind,valve,configurations,untrusted,finding,agrees,ours");
  for (const ValveFindings& valve : studied)
    for (const Finding& finding : valve.findings) {
      csv << valve.kind << valve.name << valve.configurations << valve.untrusted << finding.finding
          << finding.agrees << finding.ours;
      csv.end_line();
    }
  return csv.text();
}

std::string finding_shares_csv(const std::vector<FindingShare>& shares) {
  CsvLines csv("finding,kind,valves,agree");
  for (const FindingShare& share : shares) {
    csv << share.finding << (share.kind.empty() ? "all" : share.kind) << share.valves
        << share.agree;
    csv.end_line();
  }
  return csv.text();
}

std::string model_draws_csv(const ModelStudy& study) {
  std::string header;
  for (const ModelParameter& parameter : model_parameters())
    header += std::string(parameter.name) + ',';
  CsvLines csv(header +
               "trusted,leak_mm2,unrepaired_leak_mm2,unrepaired_tenting_area_mm2,"
               "unrepaired_widest_gap_mm,unrepaired_tenting_height_mm,unrepaired_coaptation_mm");
  for (const ModelStudyDraw& draw : study.draws) {
    for (std::size_t i = 0; i < draw.shares.size(); ++i)
      csv << model_factor(model_parameters()[i], draw.shares[i]);
    csv << draw.trusted << draw.leak_mm2;
    if (draw.figures) {
      for (const double figure : draw.figures->value) csv << figure;
      csv << draw.closed_shape[0] << draw.closed_shape[2];
    } else {
      for (int i = 0; i < 5; ++i) csv << "";
    }
    csv.end_line();
  }
  return csv.text();
}

}  // namespace coapt
