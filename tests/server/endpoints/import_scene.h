// Requests for imports.
#pragma once

#include <openssl/evp.h>

#include <algorithm>
#include <string>

#include "core/closed/closed_valve.h"
#include "io/exchange/slicerheart.h"
#include "io/mesh/write_mesh.h"
#include "tests/io/mesh/cone_scene.h"
#include "tests/server/endpoints/service_scene.h"

namespace coapt {

inline std::string base64(const std::string& bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  text.resize(static_cast<std::size_t>(EVP_EncodeBlock(
      reinterpret_cast<unsigned char*>(text.data()),
      reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()))));
  return text;
}

inline std::string csv_row(const Vec3& p) {
  return std::to_string(p.x()) + ',' + std::to_string(p.y()) + ',' + std::to_string(p.z());
}

/// The cone as three files; its leaflet as STL, in base64, if asked.
inline Json cone_request(bool as_stl = false) {
  const ImportSource source = cone_source();
  std::string annulus, chordae = "id,papillary,ins_x,ins_y,ins_z,tip_x,tip_y,tip_z\n";
  for (Index i = 0; i < source.annulus_mm.rows(); ++i)
    annulus += csv_row(source.annulus_mm.row(i)) + '\n';
  for (const ImportedChorda& chorda : source.chordae)
    chordae += chorda.id + (chorda.side == Side::Anterolateral ? ",AL," : ",PM,") +
               csv_row(chorda.insertion_mm) + ',' + csv_row(chorda.tip_mm) + '\n';
  const std::string mesh = *write_mesh(source.leaflets.front(), as_stl ? "stl" : "obj");
  Json leaflet = {{"name", as_stl ? "Skirt.STL" : "skirt.obj"}};
  leaflet[as_stl ? "base64" : "text"] = as_stl ? base64(mesh) : mesh;
  return {{"leaflets", {leaflet}},
          {"annulus", {{"name", "annulus.csv"}, {"text", annulus}}},
          {"chordae", {{"name", "chordae.csv"}, {"text", chordae}}},
          {"triangles", 300}};
}

/// The first one; null if there is none.
inline Json decision_about(const Json& decisions, const std::string& what) {
  const auto found = std::find_if(decisions.begin(), decisions.end(),
                                  [&](const Json& of) { return of["subject"] == what; });
  return found == decisions.end() ? Json() : *found;
}

/// Two sheets whose chordae nobody has seen.
inline Json unseen_request() {
  const ImportSource source = cone_source_with_gaps();
  Json request = cone_request();
  request["leaflets"] = Json::array();
  for (const TriangleMesh& sheet : source.leaflets)
    request["leaflets"].push_back({{"name", "sheet.obj"}, {"text", *write_mesh(sheet, "obj")}});
  request.erase("chordae");
  request["chordae_seed"] = 1;
  return request;
}

/// Leaflets of a small valve as they hang, and its closed surface with a tip elsewhere.
inline Json fit_request() {
  const auto files_of = [](const Valve& valve, bool open) {
    return *write_slicerheart(close_and_measure(valve, {.motion = open}), {.open = open});
  };
  Json request = {{"slicerheart", Json::array()}, {"triangles", 150}};
  for (const NamedFile& file : files_of(small_valve(), true))
    request["slicerheart"].push_back({{"name", file.name}, {"text", file.bytes}});
  Valve displaced = small_valve();
  for (PapillaryHead& head : displaced.heads)
    if (head.side == Side::Anterolateral) head.tip_mm.z() -= 1.0;
  std::string points;
  const ClosedValve closed = close_and_measure(displaced);
  for (const auto vertex : closed.closure.closed_mm.rowwise())
    points += csv_row(vertex.transpose()) + '\n';
  request["fit"] = {{"surface", {{"name", "Smith_John_systole.csv"}, {"text", points}}},
                    {"side", "middle"},
                    {"known", {"slack", "prestretch", "stiffness", "hidden"}},
                    {"rounds", 1}};
  return request;
}

}  // namespace coapt
