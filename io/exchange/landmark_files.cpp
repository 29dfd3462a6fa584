#include "io/exchange/landmark_files.h"

#include <cctype>
#include <optional>
#include <vector>

#include "io/exchange/markups.h"
#include "io/mesh/import_readers.h"

namespace coapt {
namespace {

/// Labelled points of either kind of file.
Expected<std::vector<LabelledPoint>> read_labelled_points(std::string_view text,
                                                          const std::string& format) {
  if (format != "json") return read_labelled_points_csv(text);
  const Expected<std::vector<Markup>> markups = read_markups(text);
  if (!markups) return markups.errors();
  std::vector<LabelledPoint> points;
  for (const Markup& markup : *markups)
    if (markup.type == MarkupType::Fiducial)
      for (Eigen::Index i = 0; i < markup.points_mm.rows(); ++i)
        points.push_back(
            {markup.labels[static_cast<std::size_t>(i)], Vec3(markup.points_mm.row(i))});
  return points;
}

/// In lower case without blanks and marks: "Saddle peak" is saddlepeak.
std::string letters_of(std::string_view label) {
  std::string letters;
  for (const unsigned char c : label)
    if (std::isalpha(c) != 0) letters += static_cast<char>(std::tolower(c));
  return letters;
}

/// The landmark that a label means; null: none.
std::optional<Vec3>* landmark_labelled(std::string_view label, GivenLandmarks& landmarks) {
  const std::string name = letters_of(label);
  if (name == "alc" || name == "anterolateralcommissure")
    return &landmarks.anterolateral_commissure_mm;
  if (name == "pmc" || name == "posteromedialcommissure")
    return &landmarks.posteromedial_commissure_mm;
  if (name == "a" || name == "saddlepeak") return &landmarks.saddle_peak_mm;
  if (name == "p" || name == "midposterior") return &landmarks.mid_posterior_mm;
  return nullptr;
}

}  // namespace

Expected<GivenLandmarks> landmarks_in(std::string_view text, const std::string& format) {
  const auto points = read_labelled_points(text, format);
  if (!points) return points.errors();
  GivenLandmarks landmarks;
  bool any = false;
  for (const LabelledPoint& point : *points) {
    std::optional<Vec3>* const place = landmark_labelled(point.label, landmarks);
    if (place == nullptr) continue;
    if (*place)
      return Error{ErrorCode::BadReference, "", "has two points with the same landmark's label"};
    *place = point.position_mm;
    any = true;
  }
  if (any) return landmarks;
  return Error{
      ErrorCode::MissingField, "",
      "has no point labelled ALC, PMC (commissures), A (saddle peak) or P (mid-posterior)"};
}

bool has_commissures(std::string_view text, const std::string& format) {
  const Expected<GivenLandmarks> landmarks = landmarks_in(text, format);
  return landmarks &&
         (landmarks->anterolateral_commissure_mm || landmarks->posteromedial_commissure_mm);
}

}  // namespace coapt
