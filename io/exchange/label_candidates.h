// The labels of a map and what is known of each by its name, number and shape, before any is taken as a part of a valve.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/exchange/part_names.h"
#include "io/image/label_map.h"

namespace coapt {

/// The number that most tools give the anterior leaflet.
inline constexpr int kUsualAnterior = 1;

/// Whose numbers these are; empty: nobody's that is known. Geometry decides; numbers say which two of several labels are meant.
std::string convention(int anterior, int posterior);

enum class ValvePart { Anterior, Posterior, Annulus };
inline constexpr std::array kValveParts = {ValvePart::Anterior, ValvePart::Posterior,
                                           ValvePart::Annulus};

const char* option_of(ValvePart part);  ///< "anterior", ...
const char* words_of(ValvePart part);   ///< "anterior leaflet", ...
NamedPart named(ValvePart part);

/// How thick a label is, in voxels, and how many it has.
struct LabelShape {
  double thickness = 0.0;
  Index voxels = 0;
};

/// Whether it may be a leaflet beside `other`: about as thick and as large.
bool is_like(const LabelShape& shape, const LabelShape& other);

struct LabelCandidate {
  LabelAt label;
  int number = 0;  ///< as the user says it
  std::string_view name;
  std::optional<NamedPart> meant;  ///< by its name
  std::optional<ValvePart> part;   ///< what it was taken as
  const char* reason = "";
};

/// All labels; views into the map. Where all layers hold one label and two the same, they are numbered by layer.
std::vector<LabelCandidate> candidates(const LabelMap& map);

LabelShape shape_of(const LabelMap& map, const LabelCandidate& candidate);

}  // namespace coapt
