#include "search/information.h"

#include <gtest/gtest.h>

#include <cmath>

#include "search/model_draw.h"
#include "search/studies/model_study.h"

namespace coapt {
namespace {

/// Draws whose leak after a repair is half of that before and 2 mm2 of what only the thickness decides; gap and shape say nothing.
ModelStudy study_of(int draws) {
  ModelStudy study;
  for (const std::vector<double>& shares : model_draws(draws, 1)) {
    ModelStudyDraw draw{shares, true, 0.0};
    const double before_mm2 = 60.0 * shares[4];
    draw.leak_mm2 = 0.5 * before_mm2 + 4.0 * shares[2];
    draw.figures = ModelFigures{{before_mm2, 100.0, 2.0}, {}};
    draw.closed_shape = {5.0, 100.0, 3.0};
    draw.weight = 1.0 / draws;
    study.draws.push_back(draw);
  }
  study.effective = draws;
  return study;
}

const InformationRow* row_of(const std::vector<InformationRow>& rows, const std::string& name) {
  for (const InformationRow& row : rows)
    if (row.measurement.starts_with(name)) return &row;
  return nullptr;
}

TEST(Information, IsTheShareOfTheVarianceThatAMeasurementRemoves) {
  const std::vector<InformationRow> rows = information_rows(study_of(256));
  // Variance of the leak: 30^2 / 12 by the moduli, 4^2 / 12 by the thickness.
  const double whole = 900.0 / 12.0 + 16.0 / 12.0;
  const InformationRow* tissue = row_of(rows, "tissue test");
  ASSERT_NE(tissue, nullptr);
  // Shares to 0.05: what is left is 30^2 0.05^2 and the thickness.
  EXPECT_NEAR(tissue->share_removed, 1.0 - (900.0 * 0.0025 + 16.0 / 12.0) / whole, 0.02);
  EXPECT_NEAR(tissue->remaining_mm2, std::sqrt(whole * (1.0 - tissue->share_removed)), 0.05);
  EXPECT_NEAR(row_of(rows, "leaflet thickness")->share_removed, 16.0 / 12.0 / whole, 0.03);
  EXPECT_GT(row_of(rows, "regurgitant area to")->share_removed, 0.7);
  EXPECT_LT(row_of(rows, "tenting area")->share_removed, 0.03);
}

TEST(Information, ComesMostTellingFirst) {
  const std::vector<InformationRow> rows = information_rows(study_of(256));
  for (std::size_t i = 1; i < rows.size(); ++i)
    EXPECT_GE(rows[i - 1].share_removed, rows[i].share_removed);
  EXPECT_TRUE(rows.front().measurement.starts_with("tissue test"));
}

TEST(Information, OfTooFewDrawsIsNotKnown) {
  ModelStudy study = study_of(64);
  study.effective = 3.0;
  for (const InformationRow& row : information_rows(study))
    EXPECT_TRUE(std::isnan(row.share_removed)) << row.measurement;
}

TEST(Information, OfWhatWasObservedAlreadyIsSmall) {
  ModelStudy study = study_of(1024);
  double sum = 0.0;
  for (ModelStudyDraw& draw : study.draws)
    sum += draw.weight = std::exp(-0.5 * std::pow((draw.figures->value[0] - 30.0) / 3.0, 2));
  double squares = 0.0;
  for (ModelStudyDraw& draw : study.draws) squares += std::pow(draw.weight /= sum, 2);
  study.effective = 1.0 / squares;
  EXPECT_LT(row_of(information_rows(study), "regurgitant area to")->share_removed, 0.3);
}

}  // namespace
}  // namespace coapt
