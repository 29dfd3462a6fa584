#include "search/plans/plan_key.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/valve/number_text.h"

namespace coapt {
namespace {

constexpr double kPerMillimetre = 1e6;

std::string number(double value) {
  const double rounded = std::round(value * kPerMillimetre) / kPerMillimetre;
  return ' ' + with_decimals(rounded + 0.0, 6);  // no -0
}

/// Ids and names may hold anything, a whole step's text too.
std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char letter : name) {
    if (letter == '"' || letter == '\\') text += '\\';
    if (letter == '\n')
      text += "\\n";
    else
      text += letter;
  }
  return text + '"';
}

std::string words(const LeafletPoint& point) {
  return std::string(" ") + to_string(point.leaflet) + number(point.along) + number(point.height);
}

std::string words(const Annuloplasty& step) {
  if (const auto* designed = std::get_if<DesignedRing>(&step.ring)) {
    std::string text = "designed ring " + quoted(designed->shape.name);
    for (const RingTermRow& row : kRingTerms) text += number(designed->shape.terms.*row.member);
    return text + number(designed->size_mm);
  }
  const auto* ring = std::get_if<CatalogueRing>(&step.ring);
  const auto* own = std::get_if<OwnRing>(&step.ring);
  return "ring " + quoted(shape_of(step)) + number(ring != nullptr ? ring->size_mm : 0.0) + ' ' +
         std::to_string(own != nullptr ? own->sizes_below : 0);
}
std::string words(const Neochorda& step) {
  return "neochorda " + quoted(step.head) + words(step.insertion) + number(step.length_mm);
}
std::string words(const ChordalLengthChange& step) {
  return "length " + quoted(step.chorda) + number(step.change_mm);
}
std::string words(const ChordalExcision& step) { return "excision " + quoted(step.chorda); }
std::string words(const ChordalTransfer& step) {
  return "transfer " + quoted(step.chorda) + words(step.insertion);
}
std::string words(const PapillaryApproximation& suture) {
  std::string text =
      std::string("suture ") + to_string(suture.side) + ' ' + to_string(suture.anchor);
  if (suture.anchor == Anchor::AnnulusPoint) text += number(suture.annulus_around);
  return text + number(suture.suture_length_mm);
}

std::string words(const EdgeToEdge& step) {
  const std::string text =
      std::string("edges ") + to_string(step.device) + number(step.along) + number(step.width_mm);
  if (step.device != EdgeDevice::Clip) return text;
  return text + number(step.grasp_mm) + number(step.rows) + number(step.annulus_drawn_in_percent);
}

std::string words(const LeafletResection& step) {
  std::string text = std::string("resection ") + to_string(step.shape) + ' ' +
                     to_string(step.leaflet) + number(step.along) + number(step.width_mm);
  if (step.shape == ResectionShape::Triangular) return text + number(step.height);
  return text + (step.sliding ? " sliding" : " plication");
}

std::string operation_words(const Neochorda& step) {
  return std::string("neochorda ") + to_string(step.insertion.leaflet);
}
std::string operation_words(const PapillaryApproximation& suture) {
  return std::string("suture ") + to_string(suture.side) + ' ' + to_string(suture.anchor);
}
std::string operation_words(const LeafletResection& step) {
  return std::string("resection ") + to_string(step.shape) + ' ' + to_string(step.leaflet);
}
std::string operation_words(const auto& step) { return words(step); }

std::string joined(std::vector<std::string> steps) {
  std::sort(steps.begin(), steps.end());
  std::string key;
  for (const std::string& step : steps) key += (key.empty() ? "" : "; ") + step;
  return key;
}

}  // namespace

std::string plan_key(const RepairPlan& plan) {
  std::vector<std::string> steps;
  for (const RepairStep& step : plan.steps)
    steps.push_back(std::visit([](const auto& s) { return words(s); }, step));
  return joined(std::move(steps));
}

std::string operation_key(const RepairPlan& plan) {
  std::vector<std::string> steps;
  for (const RepairStep& step : plan.steps)
    steps.push_back(std::visit([](const auto& s) { return operation_words(s); }, step));
  return joined(std::move(steps));
}

}  // namespace coapt
