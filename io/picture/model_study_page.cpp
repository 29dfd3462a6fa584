#include "io/picture/model_study_page.h"

#include <sstream>
#include <utility>

#include "core/valve/number_text.h"
#include "io/picture/histogram_chart.h"
#include "io/picture/study_csv.h"
#include "io/picture/study_page.h"
#include "io/picture/text.h"
#include "io/picture/text_table.h"
#include "search/conditioning.h"
#include "search/model_draw.h"

namespace coapt {
namespace {

TableRows areas_table(const ModelStudy& study) {
  TableRows rows = {{"mm2", "nominal", "mean", "tissue ±", "5 %", "95 %"}};
  const ModelUncertainty& leak = study.leak;
  rows.push_back({"leak", fixed(leak.as_it_is_mm2, 1), fixed(leak.mean_mm2, 1),
                  fixed(leak.sd_mm2, 1), fixed(leak.p5_mm2, 1), fixed(leak.p95_mm2, 1)});
  return rows;
}

TableRows parameters_table(const ModelStudy& study) {
  TableRows rows = {{"parameter", "from", "to", "first", "total", "effect"}};
  for (int i = 0; i < kModelParameters; ++i) {
    const ModelParameter& parameter = model_parameters()[i];
    rows.push_back({parameter.name, shown(parameter.lower), shown(parameter.upper)});
    const SobolIndices& by = study.leak.decided_by;
    for (const auto& [values, decimals] :
         {std::pair{by.first, 2}, std::pair{by.total, 2}, std::pair{by.effect, 1}})
      rows.back().push_back(values.empty() ? "n/a" : fixed(values[i], decimals));
  }
  return rows;
}

std::string lead_of(const ModelStudy& study) {
  return counted(static_cast<long>(study.draws.size()), "variant") + " of tissue and chordae, " +
         std::to_string(study.untrusted) + " excluded as unreliable." +
         (study.observed.empty()
              ? ""
              : (study.contradicts ? " The observation "
                                   : " They are weighted by the observations of the valve and ") +
                    weight_words(study.contradicts, study.effective) + ".");
}

std::string decides_words(const ModelStudy& study) {
  return "First-order and total Sobol indices of each parameter, given as a factor of the valve's "
         "own value, and the change of the leak from the low to the high end of the parameter, "
         "mm2. Fraction of variance predicted for held-out variants (Q2; below 0.5 the indices are "
         "unreliable): " +
         fixed(study.leak.decided_by.predicted_share, 2) + ".";
}

std::string page_of(const ModelStudy& study, const std::string& valve) {
  HistogramChart chart{"", "", {}, 1};
  Sample sample{"leak over the variants", {}};
  for (const ModelStudyDraw& draw : study.draws)
    if (draw.trusted) sample.values.push_back(draw.leak_mm2);
  chart.panels.push_back({{"leak", "leak, mm²", "variants"}, "mm²", {std::move(sample)}});
  return study_page(
      "Tissue error of the leak: " + valve, lead_of(study),
      {{"Distribution of the leak", "", histogram_chart_svg(chart), areas_table(study)},
       {"Sensitivity of the leak", decides_words(study), "", parameters_table(study)}});
}

std::string summary_of(const ModelStudy& study, const std::string& valve) {
  std::ostringstream out;
  out << printable(valve) << ": " << lead_of(study) << "\n\n";
  print_table(out, areas_table(study));
  out << "\n" << decides_words(study) << "\n\n";
  print_table(out, parameters_table(study));
  return out.str();
}

}  // namespace

std::string weight_words(bool contradicts, double effective) {
  if (contradicts)
    return "contradicts the model: no variant lies within three standard deviations of it, so the "
           "variants are not weighted";
  return "are equivalent to " + fixed(effective, 0) + " of equal weight" +
         (effective < kLeastEffective ? ", too few for a reliable interval" : "");
}

std::vector<NamedFile> model_study_files(const ModelStudy& study, const std::string& valve) {
  return {{"areas.csv", table_csv(areas_table(study))},
          {"parameters.csv", table_csv(parameters_table(study))},
          {"draws.csv", model_draws_csv(study)},
          {"index.html", page_of(study, valve)},
          {"summary.txt", summary_of(study, valve)}};
}

}  // namespace coapt
