#include "io/exchange/mesh_leaflets.h"

#include <algorithm>

#include "core/valve/problem_list.h"
#include "io/exchange/part_names.h"

namespace coapt {
namespace {

constexpr Eigen::Index kLeastOfLine = 8;  // points, of an annulus

/// "part 2", "parts 1, 3 and 4"; parts count from 1.
std::string called(const std::vector<std::size_t>& parts) {
  std::string text = parts.size() == 1 ? "part " : "parts ";
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + std::to_string(parts[i] + 1);
  return text;
}

TriangleMesh together(const MeshParts& parts, const std::vector<std::size_t>& which) {
  std::vector<TriangleMesh> meshes;
  for (const std::size_t i : which) meshes.push_back(parts.parts[i].mesh);
  return meshes.size() == 1 ? std::move(meshes[0]) : joined(meshes);
}

}  // namespace

Expected<MeshLeaflets> leaflets_of(MeshParts parts) {
  MeshLeaflets found;
  std::vector<std::size_t> anterior, posterior, unnamed, annulus, others, foreign;
  for (std::size_t i = 0; i < parts.parts.size(); ++i) {
    const MeshPart& part = parts.parts[i];
    const bool surface = part.mesh.faces.rows() > 0;
    const std::optional<NamedPart> meant = part_named(part.name);
    if (!surface && part.line_mm.rows() >= kLeastOfLine && (meant == NamedPart::Annulus || !meant))
      annulus.push_back(i);
    else if (surface && meant == NamedPart::Anterior)
      anterior.push_back(i);
    else if (surface && meant == NamedPart::Posterior)
      posterior.push_back(i);
    else if (surface && meant == NamedPart::OtherLeaflet)
      foreign.push_back(i);
    else if (surface && !meant)
      unnamed.push_back(i);
    else
      others.push_back(i);
  }
  const std::string of =
      std::to_string(parts.parts.size()) + " parts (" + parts.told_apart_by + ")";
  const bool mitral = !anterior.empty() && is_mitral(parts.parts[anterior[0]].name);
  if (!foreign.empty() && !mitral)
    return Error{ErrorCode::Unsupported, "",
                 "has a leaflet of another valve by its name, septal, tricuspid, aortic or "
                 "pulmonary (" +
                     called(foreign) + " of " + of +
                     "); a mitral valve has an anterior and a posterior one"};
  const bool one_named = anterior.empty() != posterior.empty();
  if (one_named && unnamed.size() == 1) {
    (anterior.empty() ? anterior : posterior) = unnamed;
    unnamed.clear();
  }
  if (anterior.empty() && posterior.empty() && unnamed.size() == 2) {
    anterior = {unnamed[0]};
    posterior = {unnamed[1]};
    unnamed.clear();
    found.order.claim = LeafletClaim::Guessed;
  } else {
    found.order.claim = LeafletClaim::Named;
  }
  if (anterior.empty() && posterior.empty() && unnamed.size() == 1) {
    found.leaflets = {together(parts, unnamed)};
    unnamed.clear();
  } else if (anterior.empty() || posterior.empty()) {
    return Error{ErrorCode::Unsupported, "",
                 "has " + of + ", of which " + std::to_string(unnamed.size()) +
                     " could each be a leaflet; a mitral valve has two, named anterior and "
                     "posterior (or A1 to P3), or give each as a file of its own"};
  } else {
    found.leaflets = {together(parts, anterior), together(parts, posterior)};
    found.order.called = {called(anterior), called(posterior)};
    found.order.swap = "name the parts the other way round, or give each as a file of its own";
  }
  if (parts.parts.size() > 1) {
    std::string used = found.leaflets.size() == 2 ? found.order.called[0] + " and " +
                                                        found.order.called[1] + " are the leaflets"
                                                  : "one part is both leaflets";
    if (annulus.size() == 1) used += ", " + called(annulus) + " is the annulus";
    found.decisions.push_back(
        {"files", of + ": " + used,
         found.order.claim == LeafletClaim::Guessed ? "the only surfaces" : "by name"});
  }
  if (annulus.size() == 1) {
    found.annulus_mm = std::move(parts.parts[annulus[0]].line_mm);
    annulus.clear();
  }
  for (auto* list : {&unnamed, &annulus, &foreign})
    others.insert(others.end(), list->begin(), list->end());
  std::sort(others.begin(), others.end());
  if (!others.empty())
    found.decisions.push_back(
        {"files", std::to_string(others.size()) + " of " + of + " not used: " + called(others),
         "an import takes leaflets and an annulus of such a file",
         !unnamed.empty() || !annulus.empty()});
  return found;
}

}  // namespace coapt
