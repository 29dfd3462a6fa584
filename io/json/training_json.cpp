#include "io/json/training_json.h"

#include <cmath>
#include <string_view>

#include "io/json/result_json.h"
#include "io/json/valve_json.h"
#include "io/json/version.h"

namespace coapt {
namespace {

Json to_thousandths(const Points& points_mm) {
  Json list = Json::array();
  for (Index i = 0; i < points_mm.rows(); ++i)
    for (Index k = 0; k < 3; ++k) list.push_back(std::round(points_mm(i, k) * 1e3) / 1e3);
  return list;
}

Json lesions_json(const CaseLesions& lesions) {
  Json chordae = Json::array(), tips = Json::array();
  for (const ChordaeLesion& lesion : lesions.chordae)
    chordae.push_back({{"segment", to_string(lesion.segment)},
                       {"side", lesion.side ? Json(to_string(*lesion.side)) : nullptr},
                       {"factor", lesion.factor}});
  for (const TipLesion& lesion : lesions.tips)
    tips.push_back({{"side", to_string(lesion.side)},
                    {"moved_mm", {lesion.moved_mm.x(), lesion.moved_mm.y(), lesion.moved_mm.z()}}});
  return {{"chordae", std::move(chordae)}, {"tips", std::move(tips)}};
}

Json difference_json(const ClosedDifference& difference) {
  return {{"edge_mm", difference.edge_mm}, {"leak_mm2", difference.leak_mm2}};
}

/// What cases of both exams begin with.
template <class Case>
Json heading(std::string_view exam, const Case& made, const Valve& from) {
  return result_document("coapt.training_case/1",
                         {{"exam", exam},
                          {"seed", made.seed},
                          {"name", from.name},
                          {"difficulty", made.difficulty},
                          {"smallest_difference", made.smallest_difference},
                          {"draws", made.draws}});
}

Json valve_document(const Valve& valve) { return Json::parse(write_valve(valve), nullptr, false); }

}  // namespace

Json to_json(const ExamACase& made, const Valve& from, const ExamARules& rules) {
  Json json = heading("A", made, from);
  json["limits"] = {{"flaccid_mm", rules.flaccid_mm},
                    {"edge_mm", rules.edge_mm},
                    {"leak_mm2", rules.leak_mm2},
                    {"half_speed_share", rules.half_speed_share}};
  json["chance"] = kChanceA;
  json["answer"] = made.answer + 1;
  json["largest_flaccid_mm"] = made.largest_flaccid_mm;
  Json& choices = json["choices"] = Json::array();
  Json& differences = json["differences"] = Json::array();
  for (std::size_t i = 0; i < kChoices; ++i) {
    const CaseChoice& choice = made.choices[i];
    choices.push_back({{"choice", i + 1},
                       {"leak_mm2", choice.closed.measure.leak.area_mm2},
                       {"lesions", lesions_json(choice.lesions)},
                       {"half_speed", difference_json(choice.half_speed)}});
    for (std::size_t j = i + 1; j < kChoices; ++j) {
      Json pair = {{"choices", {i + 1, j + 1}}};
      pair.update(difference_json(made.differences[i][j]));
      pair["scaled"] = scaled(made.differences[i][j], rules);
      differences.push_back(std::move(pair));
    }
  }
  return json;
}

Json to_json(const ExamBCase& made, const Valve& from, const ExamBRules& rules) {
  Json json = heading("B", made, from);
  json["limits"] = {{"pull_n", rules.pull_n},
                    {"limit_mm", rules.limit_mm},
                    {"margin_mm", rules.margin_mm},
                    {"flaccid_mm", rules.flaccid_mm}};
  json["chance"] = kChanceB;
  json["flaccid_difference_mm"] = made.flaccid_difference_mm;
  json["leak_mm2"] = made.closed.measure.leak.area_mm2;
  json["lesions"] = lesions_json(made.lesions);
  Json& segments = json["segments"] = Json::array();
  for (const Segment segment : kAllSegments) {
    const SegmentTruth& truth = made.truths[static_cast<std::size_t>(segment)];
    segments.push_back({{"segment", to_string(segment)},
                        {"mobility", to_string(truth.mobility)},
                        {"height_mm", truth.height_mm},
                        {"normal_mm", truth.normal_mm},
                        {"change_mm", truth.height_mm - truth.normal_mm}});
  }
  return json;
}

void add_shapes(Json& json, const ExamACase& made) {
  const CaseChoice& shown = made.choices[made.answer];
  json["valve"] = valve_document(arrested(shown.closed.valve));
  json["flaccid_mm"] = to_thousandths(shown.flaccid_mm);
  for (std::size_t i = 0; i < kChoices; ++i)
    json["choices"][i]["closed_mm"] = to_thousandths(made.choices[i].closed.closure.closed_mm);
}

void add_shapes(Json& json, const ExamBCase& made) {
  json["valve"] = valve_document(arrested(made.closed.valve));
  json["pressed_valve"] = valve_document(made.closed.valve);
  json["flaccid_mm"] = to_thousandths(made.flaccid_mm);
  json["closed_mm"] = to_thousandths(made.closed.closure.closed_mm);
}

}  // namespace coapt
