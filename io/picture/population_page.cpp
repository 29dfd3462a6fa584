#include "io/picture/population_page.h"

#include <cmath>
#include <vector>

#include "core/metrics/mean_and_sd.h"
#include "io/picture/csv_lines.h"
#include "io/picture/histogram_chart.h"
#include "io/picture/study_page.h"
#include "io/picture/text.h"
#include "search/population/population_factors.h"
#include "search/population/truncated_normal.h"
#include "search/training/binomial.h"

namespace coapt {
namespace {

using Table = std::vector<std::vector<std::string>>;

std::vector<double> drawn_anatomy(const Population& population, int factor) {
  std::vector<double> values;
  for (const PopulationMember& member : population.members)
    values.push_back(member.anatomy[static_cast<std::size_t>(factor)]);
  return values;
}

std::vector<double> drawn_lesion(const Population& population, Aetiology aetiology, int lesion) {
  std::vector<double> values;
  for (const PopulationMember& member : population.members)
    if (member.aetiology == aetiology)
      values.push_back(member.lesions[static_cast<std::size_t>(lesion)]);
  return values;
}

/// As many values as there are members, at equal steps of the prior's share.
std::vector<double> prior_values(const PriorDistribution& distribution, std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(truncated_normal(distribution, normal_quantile((static_cast<double>(i) + 0.5) /
                                                                    static_cast<double>(count))));
  return values;
}

double correlation_of(const std::vector<double>& first, const std::vector<double>& second) {
  const MeanAndSd a = mean_and_sd(first), b = mean_and_sd(second);
  double sum = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) sum += (first[i] - a.mean) * (second[i] - b.mean);
  return sum / (static_cast<double>(first.size()) * a.sd * b.sd);
}

std::vector<std::string> factor_row(const std::string& words, const PriorFactor& factor,
                                    const std::vector<double>& values) {
  const PriorDistribution& d = factor.distribution;
  const MeanAndSd cut = cut_moments(d), drawn = mean_and_sd(values);
  const int decimals = d.mean < 3.0 && d.sd < 0.5 ? 2 : 1;
  return {words,
          fixed(d.mean, decimals) + " ± " + fixed(d.sd, decimals),
          fixed(cut.mean, decimals) + " ± " + fixed(cut.sd, decimals),
          values.empty() ? "n/a" : fixed(drawn.mean, decimals) + " ± " + fixed(drawn.sd, decimals),
          cut.sd > 0.0 ? fixed((drawn.mean - cut.mean) / cut.sd, 2) : "n/a",
          factor.assumed ? "assumed" : "source",
          factor.source};
}

const std::vector<std::string> kFactorHeader = {
    "factor", "prior", "prior, truncated", "members", "shift, sd", "by", "source"};

Table anatomy_table(const Population& population) {
  Table rows = {kFactorHeader};
  for (const PriorFactor& factor : population.prior.anatomy)
    rows.push_back(factor_row(anatomy_factors()[static_cast<std::size_t>(factor.factor)].words,
                              factor, drawn_anatomy(population, factor.factor)));
  return rows;
}

Table lesion_table(const Population& population, const AetiologyPrior& aetiology) {
  Table rows = {kFactorHeader};
  for (const PriorFactor& lesion : aetiology.lesions)
    rows.push_back(factor_row(lesion_factors()[static_cast<std::size_t>(lesion.factor)].words,
                              lesion,
                              drawn_lesion(population, aetiology.aetiology, lesion.factor)));
  return rows;
}

Table correlation_table(const Population& population) {
  Table rows = {{"first", "second", "prior r", "members r", "by", "source"}};
  for (const PriorCorrelation& pair : population.prior.correlations)
    rows.push_back({anatomy_factors()[static_cast<std::size_t>(pair.first)].words,
                    anatomy_factors()[static_cast<std::size_t>(pair.second)].words,
                    fixed(pair.r, 2),
                    fixed(correlation_of(drawn_anatomy(population, pair.first),
                                         drawn_anatomy(population, pair.second)),
                          2),
                    pair.assumed ? "assumed" : "source", pair.source});
  return rows;
}

Table draws_table(const Population& population) {
  Table rows = {{"aetiology", "members", "anatomies drawn", "not constructible", "not closed",
                 "leak", "competent with all lesions", "lesions drawn", "not constructible",
                 "not closed", "still competent"}};
  for (const AetiologyPrior& aetiology : population.prior.aetiologies) {
    DrawCounts sum;
    long members = 0;
    for (const PopulationMember& member : population.members) {
      if (member.aetiology != aetiology.aetiology) continue;
      const DrawCounts& d = member.draws;
      ++members;
      sum.anatomies += d.anatomies;
      sum.anatomies_invalid += d.anatomies_invalid;
      sum.anatomies_untrusted += d.anatomies_untrusted;
      sum.anatomies_leaking += d.anatomies_leaking;
      sum.anatomies_resistant += d.anatomies_resistant;
      sum.lesions += d.lesions;
      sum.lesions_invalid += d.lesions_invalid;
      sum.lesions_untrusted += d.lesions_untrusted;
      sum.lesions_competent += d.lesions_competent;
    }
    rows.push_back({to_string(aetiology.aetiology)});
    for (const long count :
         {members, long{sum.anatomies}, long{sum.anatomies_invalid}, long{sum.anatomies_untrusted},
          long{sum.anatomies_leaking}, long{sum.anatomies_resistant}, long{sum.lesions},
          long{sum.lesions_invalid}, long{sum.lesions_untrusted}, long{sum.lesions_competent}})
      rows.back().push_back(grouped(count));
  }
  return rows;
}

std::string anatomy_histograms(const Population& population) {
  HistogramChart chart{
      "Anatomies before disease", "Blue: the prior; orange: the members, competent.", {}, 3, 250.0};
  for (const PriorFactor& factor : population.prior.anatomy) {
    if (factor.distribution.sd <= 0.0) continue;
    const std::string words = anatomy_factors()[static_cast<std::size_t>(factor.factor)].words;
    chart.panels.push_back(
        {{words, "", "members"},
         "",
         {{"prior", prior_values(factor.distribution, population.members.size()), Hue::Blue},
          {"members", drawn_anatomy(population, factor.factor), Hue::Orange}}});
  }
  return histogram_chart_svg(chart);
}

std::string leak_histograms(const Population& population) {
  HistogramChart chart{"Leak with disease", "", {}, 2, 250.0};
  for (const AetiologyPrior& aetiology : population.prior.aetiologies) {
    Sample sample{"members", {}, Hue::Vermillion};
    for (const PopulationMember& member : population.members)
      if (member.aetiology == aetiology.aetiology) sample.values.push_back(member.leak_mm2);
    chart.panels.push_back(
        {{to_string(aetiology.aetiology), "leak, mm²", "members"}, "mm²", {std::move(sample)}});
  }
  return histogram_chart_svg(chart);
}

}  // namespace

std::string members_csv(const Population& population) {
  std::string header = "index,aetiology,leak_healthy_mm2,leak_mm2,anatomies_drawn,lesions_drawn";
  for (const PopulationFactor& factor : anatomy_factors()) header += std::string(",") + factor.name;
  for (const PopulationFactor& factor : lesion_factors()) header += std::string(",") + factor.name;
  CsvLines csv(header);
  for (const PopulationMember& member : population.members) {
    csv << member.index << to_string(member.aetiology) << member.leak_healthy_mm2 << member.leak_mm2
        << member.draws.anatomies << member.draws.lesions;
    for (const double value : member.anatomy) csv << value;
    for (const double value : member.lesions) csv << value;
    csv.end_line();
  }
  return csv.text();
}

std::string assumed_words(const PopulationPrior& prior) {
  long all = 0, assumed = 0;
  const auto count = [&](bool is_assumed) {
    ++all;
    assumed += is_assumed;
  };
  for (const PriorFactor& factor : prior.anatomy) count(factor.assumed);
  for (const PriorCorrelation& pair : prior.correlations) count(pair.assumed);
  for (const AetiologyPrior& aetiology : prior.aetiologies) {
    count(aetiology.assumed);
    for (const PriorFactor& lesion : aetiology.lesions) count(lesion.assumed);
  }
  return "Of " + std::to_string(all) + " distributions, correlations and shares of the prior \"" +
         prior.name + "\" " + std::to_string(all - assumed) + " have a source and " +
         std::to_string(assumed) + " are assumed in whole or in part.";
}

std::string population_page(const Population& population) {
  std::vector<PageSection> sections = {
      {"Rejected draws",
       "An anatomy is accepted if its leaflets close without crossing and leak at most 5 mm² "
       "before disease; a disease is accepted if they close without crossing and leak more than "
       "that. An anatomy that stays competent in 40 draws of its disease is replaced. The members "
       "therefore follow the prior conditional on both.",
       leak_histograms(population), draws_table(population)},
      {"Anatomy", assumed_words(population.prior), anatomy_histograms(population),
       anatomy_table(population)},
      {"Correlations between dimensions",
       "Prior: correlations of the underlying normal variables; members: correlations of the "
       "values.",
       "", correlation_table(population)}};
  for (const AetiologyPrior& aetiology : population.prior.aetiologies)
    sections.push_back({std::string("Lesions: ") + to_string(aetiology.aetiology),
                        "Share: " + aetiology.source + ".", "",
                        lesion_table(population, aetiology)});
  return study_page("A population of " + grouped(std::ssize(population.members)) + " valves",
                    "Drawn from the prior \"" + population.prior.name + "\" with seed " +
                        std::to_string(population.seed) +
                        ": anatomies that are competent before disease and leak after it.",
                    sections);
}

}  // namespace coapt
