#include "search/plans/plan_key.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace coapt {
namespace {

constexpr double kPerMillimetre = 1e6;

std::string number(double value) {
  char text[32];
  const double rounded = std::round(value * kPerMillimetre) / kPerMillimetre;
  std::snprintf(text, sizeof text, " %.6f", rounded + 0.0);  // no -0
  return text;
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

std::string words(const Annuloplasty& ring) {
  return "ring " + quoted(ring.shape) + number(ring.size_mm) + ' ' +
         std::to_string(ring.sizes_below);
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

}  // namespace

std::string plan_key(const RepairPlan& plan) {
  std::vector<std::string> steps;
  for (const RepairStep& step : plan.steps)
    steps.push_back(std::visit([](const auto& s) { return words(s); }, step));
  std::sort(steps.begin(), steps.end());
  std::string key;
  for (const std::string& step : steps) key += (key.empty() ? "" : "; ") + step;
  return key;
}

}  // namespace coapt
