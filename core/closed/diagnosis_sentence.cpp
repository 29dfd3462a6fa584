#include "core/closed/diagnosis_sentence.h"

#include <algorithm>
#include <cmath>

#include "core/metrics/estimate_text.h"
#include "core/repair/limits.h"
#include "core/valve/number_text.h"

namespace coapt {
namespace {

std::string in_mm(double value) { return with_decimals(value, 0) + " mm"; }

/// "P1", "P1 and P2", "P1, P2 and P3".
std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
  return text;
}

/// "the chordae of P2 are ruptured" and "its edge rises up to 4 mm above the annulus".
struct Reason {
  std::string what;
  std::string figures;  ///< may be empty
};

/// Their names; both sides of a commissure are one lesion: "the anterolateral commissure (A1 and P1)".
std::vector<std::string> names_of(const std::vector<SegmentDiagnosis>& segments) {
  const auto has = [&](Segment wanted) {
    return std::any_of(segments.begin(), segments.end(),
                       [wanted](const SegmentDiagnosis& one) { return one.segment == wanted; });
  };
  std::vector<std::string> names;
  const bool anterolateral = has(Segment::A1) && has(Segment::P1);
  const bool posteromedial = has(Segment::A3) && has(Segment::P3);
  if (anterolateral) names.push_back("the anterolateral commissure (A1 and P1)");
  if (posteromedial) names.push_back("the posteromedial commissure (A3 and P3)");
  for (const SegmentDiagnosis& one : segments)
    if (!(anterolateral && (one.segment == Segment::A1 || one.segment == Segment::P1)) &&
        !(posteromedial && (one.segment == Segment::A3 || one.segment == Segment::P3)))
      names.push_back(to_string(one.segment));
  return names;
}

std::vector<SegmentDiagnosis> of_finding(const std::vector<SegmentDiagnosis>& segments,
                                         SegmentFinding finding) {
  std::vector<SegmentDiagnosis> found;
  std::copy_if(segments.begin(), segments.end(), std::back_inserter(found),
               [&](const SegmentDiagnosis& segment) { return segment.finding == finding; });
  return found;
}

/// "its edge rises up to 4 mm above the annulus over 14 mm of its length".
std::string height_of(const SegmentDiagnosis& segment, bool is_alone) {
  const std::string edge =
      is_alone ? "its edge" : std::string("the edge of ") + to_string(segment.segment);
  const std::string width =
      segment.width_mm >= 1.0 ? " over " + in_mm(segment.width_mm) + " of its length" : "";
  if (segment.highest_mm >= 0.5)
    return edge + " rises up to " + in_mm(segment.highest_mm) + " above the annulus" + width;
  if (segment.override_mm < 0.5)
    return "blood leaks through an opening beside " +
           (is_alone ? std::string("it") : std::string(to_string(segment.segment)));
  return edge + " overrides the opposite leaflet by " + in_mm(segment.override_mm) +
         " more than normal" + width;
}

Reason of_excess(const Diagnosis& diagnosis) {
  const std::vector<SegmentDiagnosis> all = prolapsing(diagnosis);
  const auto flail = of_finding(all, SegmentFinding::Flail),
             others = of_finding(all, SegmentFinding::Prolapse);
  const auto highest = *std::max_element(all.begin(), all.end(),
                                         [](const SegmentDiagnosis& a, const SegmentDiagnosis& b) {
                                           return a.override_mm < b.override_mm;
                                         });
  std::string what;
  if (!flail.empty()) what = "the chordae of " + joined(names_of(flail)) + " are ruptured";
  if (const std::vector<std::string> names = names_of(others); !names.empty())
    what += (what.empty() ? "" : ", and ") + joined(names) +
            (names.size() == 1 ? " prolapses" : " prolapse");
  return {what, height_of(highest, all.size() == 1)};
}

Reason of_tethering(const Diagnosis& diagnosis) {
  const auto away = [&](int side) { return with_decimals(diagnosis.tip_to_trigone_mm[side], 0); };
  const std::string depth =
      diagnosis.tenting_height_mm >= 0.5
          ? ", and the tenting height is " + in_mm(diagnosis.tenting_height_mm)
          : "";
  if (!diagnosis.tethered_side)
    return {"both papillary muscles tether the leaflets",
            "the tips lie " + away(0) + " and " + away(1) + " mm from their trigones" + depth};
  const int side = *diagnosis.tethered_side == Side::Anterolateral ? 0 : 1;
  return {std::string("the ") + to_string(*diagnosis.tethered_side) +
              " papillary muscle tethers the leaflets",
          "its tip lies " + away(side) + " mm from its trigone, that of the other muscle " +
              away(1 - side) + " mm" + depth};
}

/// "the cleft between P1 and P2 leaks" and "8 mm deep, 16 mm² of the leak".
Reason of_clefts(const Diagnosis& diagnosis) {
  std::vector<std::string> places, depths;
  for (const Cleft& cleft : diagnosis.clefts) {
    places.push_back(std::string("between ") + to_string(cleft.first) + " and " +
                     to_string(cleft.second));
    depths.push_back(in_mm(cleft.depth_mm));
  }
  const bool one = places.size() == 1;
  return {(one ? "the cleft " : "the clefts ") + joined(places) + (one ? " leaks" : " leak"),
          joined(depths) + " deep, and " + with_decimals(leak_through(diagnosis.clefts), 0) +
              " mm² of the leak pass through " + (one ? "it" : "them")};
}

Reason of_annulus(const Diagnosis& diagnosis) {
  return {diagnosis.annulus_dilated ? "the annulus is too wide for the leaflets"
                                    : "the leaflets are too short for the annulus",
          "its diameters are " + in_mm(diagnosis.ap_mm) + " (anteroposterior) and " +
              in_mm(diagnosis.transverse_mm) + " (transverse)" +
              (diagnosis.annulus_dilated
                   ? ", a ratio of " + with_decimals(diagnosis.ap_mm / diagnosis.transverse_mm, 2) +
                         ", where 0.75 is normal"
                   : "")};
}

/// Clefts, and what they do not explain.
Reason of_normal_motion(const Diagnosis& diagnosis) {
  if (diagnosis.clefts.empty()) return of_annulus(diagnosis);
  const Reason clefts = of_clefts(diagnosis);
  if (diagnosis.types.front() != CarpentierType::I || clefts_explain(diagnosis)) return clefts;
  return {of_annulus(diagnosis).what + ", and " + clefts.what, clefts.figures};
}

Reason reason_of(const Diagnosis& diagnosis, CarpentierType type) {
  switch (type) {
    case CarpentierType::I:
      return of_normal_motion(diagnosis);
    case CarpentierType::II:
      return of_excess(diagnosis);
    case CarpentierType::IIIa:
      return {"the leaflets hardly open", ""};
    case CarpentierType::IIIb:
      return of_tethering(diagnosis);
  }
  return {};
}

/// " because the chordae of P2 are ruptured (Carpentier type II)." and what is doubtful of the types.
std::string because(const Diagnosis& diagnosis, bool with_figures) {
  std::string text;
  for (std::size_t i = 0; i < diagnosis.types.size(); ++i) {
    const bool first = i == 0 && !diagnosis.competent;
    const auto [what, figures] = reason_of(diagnosis, diagnosis.types[i]);
    text += !first ? "; and " : diagnosis.type_sure ? " because " : ", probably because ";
    text += what + (with_figures && !figures.empty() ? ": " + figures : "") + " (Carpentier type " +
            to_string(diagnosis.types[i]) + ")";
  }
  text += ".";
  if (diagnosis.not_ruled_out)
    text += std::string(" Carpentier type ") + to_string(*diagnosis.not_ruled_out) +
            " is not ruled out.";
  return text;
}

/// What is doubtful of competence.
std::string doubt_of(const Diagnosis& diagnosis, const Estimate& leak) {
  const std::string limit = shown(kMildLeak_mm2) + " mm²";
  if (!diagnosis.competent_sure)
    return " The leak is too close to " + limit + " to tell whether the valve is competent.";
  if (is_competence_sure(diagnosis, leak)) return "";
  return std::string(" The ") + to_string(*widest(leak)) + " error includes leaks " +
         (diagnosis.competent ? "above " : "below ") + limit + ", the limit of competence.";
}

/// By the widest part of its error.
std::string leak_of(const Diagnosis& diagnosis, const Estimate& leak) {
  const std::optional<ErrorCause> cause = widest(leak);
  if (!cause) return with_error(diagnosis.leak_mm2, diagnosis.leak_error_mm2, "mm²");
  const EstimateWords words = words_of(leak);
  if (words.interval.empty()) return words.value + " mm²";
  if (*cause == ErrorCause::Tissue && tissue_excludes_value(leak))
    return words.value + " mm² (" + words.interval + " mm² " + words.cause + ")";
  return words.value + " mm² (" + words.interval + " mm² with " + to_string(*cause) + " error)";
}

}  // namespace

bool is_competence_sure(const Diagnosis& diagnosis, const Estimate& leak) {
  const std::optional<ErrorCause> cause = widest(leak);
  if (!diagnosis.competent_sure || !cause) return diagnosis.competent_sure;
  const Interval known = *part_of(leak, *cause);
  return diagnosis.competent ? known.high <= kMildLeak_mm2 : known.low > kMildLeak_mm2;
}

std::string sentence_of(const Diagnosis& diagnosis, const Estimate& leak) {
  return (diagnosis.competent ? "The valve is competent: it leaks " : "The valve leaks ") +
         leak_of(diagnosis, leak) + because(diagnosis, true) + doubt_of(diagnosis, leak);
}

std::string summary_of(const Diagnosis& diagnosis) {
  return (diagnosis.competent ? "The valve is competent" : "It leaks") + because(diagnosis, false) +
         doubt_of(diagnosis, {});
}

}  // namespace coapt
