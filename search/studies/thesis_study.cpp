#include "search/studies/thesis_study.h"

#include <algorithm>
#include <limits>

#include "core/valve/leaflet_point.h"

namespace coapt {
namespace {

constexpr double kBellyShift_mm = 6.0;

std::array<Vec3, 3> belly_shift(const Valve& valve) {
  std::array<Vec3, 3> shift;
  shift.fill(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  const Expected<Valve> moved =
      configure(valve, displacement(Displaced::Anterolateral, Vec3(kBellyShift_mm, 0.0, 0.0)));
  if (!moved) return shift;
  const Points before = close_valve(valve).closed_mm, after = close_valve(*moved).closed_mm;
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  for (std::size_t k = 0; k < shift.size(); ++k) {
    const double along = (2.0 * static_cast<double>(k) + 1.0) / 6.0;
    const Insertion middle = locate(valve, coordinates, {Leaflet::Anterior, along, 0.5});
    shift[k] = position(middle, valve.faces, after) - position(middle, valve.faces, before);
  }
  return shift;
}

}  // namespace

AnchorStudies study_anchors(OrificeTable& table, const ThesisStudyOptions& options) {
  const auto begin = [&](const std::string& part) {
    if (options.stage) options.stage(part);
  };
  AnchorStudies study;
  const std::vector<Protocol>& protocols = options.protocols;
  for (const Protocol protocol : protocols) {
    begin(std::string("approximation, ") + to_string(protocol));
    study.approximation.push_back(
        study_approximation(table, protocol, thesis_anchors(table.valve()), options.approximation));
  }
  if (options.scan_sites == 0 || protocols.empty()) return study;
  begin("anchors around the annulus");
  const bool extended =
      std::find(protocols.begin(), protocols.end(), Protocol::LookupExtended) != protocols.end();
  study.scan = summarise(
      study_approximation(table, extended ? Protocol::LookupExtended : protocols.front(),
                          annulus_scan(table.valve(), options.scan_sites), options.approximation));
  return study;
}

ThesisStudy study_thesis(OrificeTable& table, const ThesisStudyOptions& options) {
  const auto begin = [&](const std::string& part) {
    if (options.stage) options.stage(part);
  };
  ThesisStudy study;
  begin("annulus");
  study.annulus = study_annulus(table);
  begin("papillary");
  study.papillary = study_papillary(table, options.papillary_nodes);
  begin("ring");
  study.ring = study_ring(table);
  study.anchors = study_anchors(table, options);
  study.belly_shift_mm = belly_shift(table.valve());
  return study;
}

}  // namespace coapt
