#include "io/mesh/made_faults.h"

#include <algorithm>
#include <map>
#include <optional>

#include "core/metrics/leaflet_sides.h"
#include "core/valve/number_text.h"
#include "core/valve/patient_frame.h"
#include "io/mesh/source_units.h"
#include "io/mesh/text_scan.h"

namespace coapt {
namespace {

/// The face that a pointer names, or one of the vertex that it names.
std::optional<Eigen::Index> face_of(const std::string& path, const Valve& valve) {
  for (const std::string_view list : {"/faces/", "/fibre/", "/vertices_mm/"}) {
    if (!path.starts_with(list)) continue;
    const std::string rest = path.substr(list.size());
    const auto index = to_integer(rest.substr(0, rest.find('/')));
    if (!index || *index < 0) return {};
    if (list != "/vertices_mm/")
      return *index < valve.faces.rows() ? std::optional<Eigen::Index>(*index) : std::nullopt;
    for (Eigen::Index f = 0; f < valve.faces.rows(); ++f)
      if ((valve.faces.row(f).array() == static_cast<int>(*index)).any()) return f;
  }
  return {};
}

std::string place_text(const Valve& valve, Eigen::Index face, LengthUnit unit) {
  Points middle(1, 3);
  middle.row(0).setZero();
  for (int k = 0; k < 3; ++k) middle.row(0) += valve.rest_mm.row(valve.faces(face, k)) / 3.0;
  if (valve.patient) middle = to_patient(*valve.patient, middle);
  std::string text = "(";
  for (int k = 0; k < 3; ++k)
    text += (k > 0 ? ", " : "") + significant(middle(0, k) / in_mm(unit), 4);
  return text + ") " + to_string(unit);
}

}  // namespace

Errors made_faults(const Errors& errors, const Valve& valve,
                   const std::array<std::string, 2>& called, LengthUnit unit) {
  const std::vector<Leaflet> sides = leaflet_sides(valve);
  Errors told;
  std::map<std::pair<std::string, std::string>, std::pair<std::size_t, int>> alike;
  for (const Error& error : errors) {
    const std::optional<Eigen::Index> face = face_of(error.path, valve);
    const std::size_t side =
        face && sides[static_cast<std::size_t>(*face)] == Leaflet::Posterior ? 1 : 0;
    const std::string path = face ? "/leaflets/" + std::to_string(side) : error.path;
    const auto [known, is_new] = alike.try_emplace({path, error.message}, told.size(), 0);
    ++known->second.second;
    if (!is_new) continue;
    const bool of_valve = !error.path.empty() && !error.path.starts_with("/tips");
    std::string message = (of_valve ? "the valve made from the files " : "") + error.message;
    if (face)
      message = called[side] + " yields a defective leaflet: near " +
                place_text(valve, *face, unit) + ", in " +
                to_string(valve.segments[static_cast<std::size_t>(*face)]) + ", a triangle " +
                error.message;
    told.push_back({error.code, path, std::move(message)});
  }
  for (const auto& [what, of] : alike)
    if (of.second > 1)
      told[of.first].message += " (" + std::to_string(of.second) + " places in all)";
  return told;
}

}  // namespace coapt
