#include "io/exchange/mesh_leaflets.h"

#include <algorithm>
#include <map>

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

namespace {

/// What a user says of each part, by its place in the file.
Expected<std::map<std::size_t, NamedPart>> given_parts(const MeshParts& parts,
                                                       const LabelNumbers& given) {
  std::map<std::size_t, NamedPart> meant;
  ProblemList problems;
  const auto take = [&](const std::vector<int>& numbers, NamedPart part, const char* name) {
    for (const int number : numbers) {
      const auto index = static_cast<std::size_t>(number) - 1;
      const std::string path = std::string("/label_numbers/") + name;
      if (number < 1 || index >= parts.parts.size())
        problems.add(ErrorCode::BadReference, path,
                     "is " + std::to_string(number) + "; the file has " +
                         std::to_string(parts.parts.size()) + " parts (" + parts.told_apart_by +
                         "), numbered from 1");
      else if (!meant.try_emplace(index, part).second)
        problems.add(ErrorCode::BadReference, "/label_numbers",
                     "has part " + std::to_string(number) +
                         " for two parts of the valve; each must have its own");
    }
  };
  take(given.anterior, NamedPart::Anterior, "anterior");
  take(given.posterior, NamedPart::Posterior, "posterior");
  take(given.annulus, NamedPart::Annulus, "annulus");
  if (!problems.empty()) return std::move(problems).take();
  return meant;
}

/// "say --label anterior=2 --label posterior=1": the opposite of what was taken.
std::string opposite(const std::vector<std::size_t>& anterior,
                     const std::vector<std::size_t>& posterior) {
  std::string text = "say";
  for (const auto& [parts, name] : {std::pair(&posterior, "anterior"), {&anterior, "posterior"}})
    for (const std::size_t part : *parts)
      text += std::string(" --label ") + name + '=' + std::to_string(part + 1);
  return text;
}

}  // namespace

Expected<MeshLeaflets> leaflets_of(MeshParts parts, const LabelNumbers& given) {
  const auto said = given_parts(parts, given);
  if (!said) return said.errors();
  MeshLeaflets found;
  std::vector<std::size_t> anterior, posterior, unnamed, annulus, others, foreign;
  for (std::size_t i = 0; i < parts.parts.size(); ++i) {
    const MeshPart& part = parts.parts[i];
    const bool surface = part.mesh.faces.rows() > 0;
    const auto as_given = said->find(i);
    const bool is_given = as_given != said->end();
    std::optional<NamedPart> meant = is_given ? as_given->second : part_named(part.name);
    // A side that was given is not made of names, too.
    if (!is_given && ((meant == NamedPart::Anterior && !given.anterior.empty()) ||
                      ((meant == NamedPart::Posterior || meant == NamedPart::Commissure) &&
                       !given.posterior.empty()) ||
                      (meant == NamedPart::Annulus && !given.annulus.empty())))
      meant = meant == NamedPart::Annulus ? NamedPart::Other : std::optional<NamedPart>();
    if (const auto side = side_named(part.name); surface && side && !is_given)
      found.sided.push_back(
          {*side,
           Vec3(part.mesh.vertices_mm(part.mesh.faces.reshaped(), Eigen::all).colwise().mean())});
    if (!surface && part.line_mm.rows() >= kLeastOfLine && (meant == NamedPart::Annulus || !meant))
      annulus.push_back(i);
    else if (surface && meant == NamedPart::Anterior)
      anterior.push_back(i);
    else if (surface && (meant == NamedPart::Posterior || meant == NamedPart::Commissure))
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
    return Error{
        ErrorCode::Unsupported, "",
        "has a part named as a leaflet of another valve (septal, tricuspid, aortic or pulmonary; " +
            called(foreign) + " of " + of +
            "); a mitral valve has an anterior and a posterior leaflet"};
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
    found.order.claim = said->empty() ? LeafletClaim::Named : LeafletClaim::Given;
  }
  if (anterior.empty() && posterior.empty() && unnamed.size() == 1) {
    found.leaflets = {together(parts, unnamed)};
    unnamed.clear();
  } else if (anterior.empty() || posterior.empty()) {
    return Error{ErrorCode::Unsupported, "",
                 "has " + of + ", of which " + std::to_string(unnamed.size()) +
                     " could each be a leaflet; a mitral valve has two, so name them anterior and "
                     "posterior (or A1 to P3), or provide each as a separate file"};
  } else {
    found.leaflets = {together(parts, anterior), together(parts, posterior)};
    found.order.called = {called(anterior), called(posterior)};
    found.order.swap = opposite(anterior, posterior);
  }
  if (parts.parts.size() > 1) {
    std::string used = found.leaflets.size() == 2 ? found.order.called[0] + " and " +
                                                        found.order.called[1] + " are the leaflets"
                                                  : "one part is both leaflets";
    if (annulus.size() == 1) used += ", " + called(annulus) + " is the annulus";
    found.decisions.push_back({"files", of + ": " + used,
                               found.order.claim == LeafletClaim::Guessed ? "the only surfaces"
                               : found.order.claim == LeafletClaim::Given ? "as given"
                                                                          : "by name"});
    for (std::size_t i = 0; i < parts.parts.size(); ++i)
      found.parts.push_back({static_cast<int>(i) + 1});
    for (const auto& [role, name] :
         {std::pair(&anterior, "anterior"), {&posterior, "posterior"}, {&annulus, "annulus"}})
      for (const std::size_t part : *role)
        if (role != &annulus || annulus.size() == 1) found.parts[part].part = name;
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
         "only leaflets and annulus are imported from such a file",
         !unnamed.empty() || !annulus.empty()});
  return found;
}

}  // namespace coapt
