#include "io/exchange/label_parts.h"

#include <algorithm>

#include "core/valve/problem_list.h"
#include "io/exchange/label_candidates.h"
#include "io/exchange/label_doubts.h"
#include "io/exchange/part_names.h"
#include "io/image/label_curve.h"
#include "io/image/label_surface.h"

namespace coapt {
namespace {

constexpr std::size_t kMostLookedAt = 16;  // labels without a role whose shape is looked at

class LabelChoice {
 public:
  LabelChoice(const LabelMap& map, ProblemList& problems)
      : map_(map), all_(candidates(map)), problems_(problems) {}

  void take_given(ValvePart part, const std::vector<int>& numbers) {
    for (const int number : numbers) {
      const auto found = std::find_if(all_.begin(), all_.end(),
                                      [&](const LabelCandidate& c) { return c.number == number; });
      if (found == all_.end()) {
        problems_.add(ErrorCode::BadReference, pointer(part),
                      "is " + std::to_string(number) +
                          ", which no voxel has; the file has labels " +
                          listed([](const LabelCandidate&) { return true; }));
      } else if (found->part) {
        problems_.add(
            ErrorCode::BadReference, "/label_numbers",
            "has label " + std::to_string(number) + " for two structures; each must have its own");
      } else {
        found->part = part;
        found->reason = "as given";
      }
    }
  }

  /// By name, unless the part was given.
  void take_named(ValvePart part) {
    if (!of(part).empty()) return;
    const bool mitral = std::any_of(all_.begin(), all_.end(), [&](const LabelCandidate& c) {
      return c.meant == named(part) && is_mitral(c.name);
    });
    std::size_t taken = 0;
    for (LabelCandidate& candidate : all_) {
      if (candidate.part || candidate.meant != named(part)) continue;
      if (mitral && !is_mitral(candidate.name) && !is_scallop(candidate.name)) continue;
      // Several labels of one part are its scallops; of several whole leaflets the first is used and the others are left over.
      if (taken > 0 && !is_scallop(candidate.name)) continue;
      candidate.part = part;
      candidate.reason = "by its name in the file";
      ++taken;
    }
    if (part == ValvePart::Posterior && taken > 0) take_commissures();
  }

  /// Leaflets of another valve beside ones that need not be mitral.
  void refuse_other_valves(bool given) {
    const auto other = [](const LabelCandidate& c) { return c.meant == NamedPart::OtherLeaflet; };
    if (given || std::none_of(all_.begin(), all_.end(), other)) return;
    const auto leaflets = of(ValvePart::Anterior);
    if (!leaflets.empty() && is_mitral(leaflets[0]->name)) return;
    problems_.add(
        ErrorCode::Unsupported, "/labels",
        "has a label named as a leaflet of another valve (septal, tricuspid, aortic or pulmonary; "
        "label " +
            listed(other) +
            "); a mitral valve has an anterior and a posterior leaflet. If the file holds several "
            "valves, name the mitral labels (--label anterior=N, --label posterior=N)");
  }

  /// The closed band among labels whose names say nothing.
  void find_annulus() {
    if (!of(ValvePart::Annulus).empty()) return;
    std::size_t looked_at = 0;
    for (LabelCandidate& candidate : all_) {
      if (candidate.part || candidate.meant || ++looked_at > kMostLookedAt) continue;
      if (!label_curve(map_, candidate.label)) continue;
      candidate.part = ValvePart::Annulus;
      candidate.reason = "it is the only closed band";
      return;
    }
  }

  /// The two leaflets among the labels that nothing names, where neither or one is known.
  void find_leaflets() {
    std::vector<LabelCandidate*> free;
    for (LabelCandidate& candidate : all_)
      if (!candidate.part && !candidate.meant) free.push_back(&candidate);
    const bool anterior = !of(ValvePart::Anterior).empty(),
               posterior = !of(ValvePart::Posterior).empty();
    if (anterior && posterior) return;
    const std::size_t wanted = anterior || posterior ? 1 : 2;
    if (free.size() > wanted)
      free = leaflet_like(free, anterior ? ValvePart::Anterior : ValvePart::Posterior);
    if (free.size() > wanted) return too_many(free);
    if (free.size() < wanted) {
      for (const ValvePart part : {ValvePart::Anterior, ValvePart::Posterior})
        if (of(part).empty())
          problems_.add(ErrorCode::BadReference, pointer(part),
                        std::string("is missing: no label is named as the ") + words_of(part) +
                            ", and no other label is available; the file has labels " +
                            listed([](const LabelCandidate&) { return true; }));
      return;
    }
    if (wanted == 1) {
      free[0]->part = anterior ? ValvePart::Posterior : ValvePart::Anterior;
      free[0]->reason = "the other label is the other leaflet";
      return;
    }
    free[0]->part = ValvePart::Anterior;
    free[1]->part = ValvePart::Posterior;
    found_both_ = true;
  }

  std::vector<const LabelCandidate*> of(ValvePart part) const {
    std::vector<const LabelCandidate*> found;
    for (const LabelCandidate& candidate : all_)
      if (candidate.part == part) found.push_back(&candidate);
    return found;
  }

  /// Labels without a role: what nothing names may be a leaflet that is missed.
  void tell_left_over(std::vector<ImportDecision>& decisions) const {
    const auto is_known = [](const LabelCandidate& c) {
      return !c.part && c.meant && c.meant != NamedPart::OtherLeaflet &&
             c.meant != NamedPart::Anterior && c.meant != NamedPart::Posterior;
    };
    const auto is_unknown = [&](const LabelCandidate& c) { return !c.part && !is_known(c); };
    const auto tell = [&](const auto& which, const char* why, bool look) {
      const auto count = std::count_if(all_.begin(), all_.end(), which);
      if (count == 0) return;
      decisions.push_back({"labels",
                           std::to_string(count) + " of " + std::to_string(all_.size()) +
                               " labels not used: " + listed(which),
                           why, look});
    };
    tell(is_known, "their names denote other parts of the heart", false);
    tell(is_unknown, "not recognised as leaflets or annulus", true);
  }

  std::vector<SourcePart> parts() const {
    std::vector<SourcePart> parts;
    for (const LabelCandidate& of : all_)
      parts.push_back({of.number, of.part ? option_of(*of.part) : ""});
    return parts;
  }

  /// "label 4", "labels 2, 4 and 5".
  std::string called(ValvePart part) const {
    const auto labels = of(part);
    std::string text = labels.size() == 1 ? "label " : "labels ";
    for (std::size_t i = 0; i < labels.size(); ++i)
      text += (i == 0                   ? ""
               : i + 1 == labels.size() ? " and "
                                        : ", ") +
              std::to_string(labels[i]->number);
    return text;
  }

  LeafletOrder order() const {
    LeafletOrder order;
    const auto anterior = of(ValvePart::Anterior), posterior = of(ValvePart::Posterior);
    const auto is_given = [](const LabelCandidate* c) {
      return std::string_view(c->reason) == "as given";
    };
    order.claim = found_both_ ? LeafletClaim::Guessed
                  : std::any_of(anterior.begin(), anterior.end(), is_given) ||
                          std::any_of(posterior.begin(), posterior.end(), is_given)
                      ? LeafletClaim::Given
                      : LeafletClaim::Named;
    // Of one leaflet, whatever it is made of: what is said of it is a sentence in the singular.
    const auto as_one = [&](ValvePart part) {
      return (of(part).size() > 1 ? "the union of " : "") + called(part);
    };
    order.called = {as_one(ValvePart::Anterior), as_one(ValvePart::Posterior)};
    for (std::size_t i = 0; i < 2; ++i) {
      const auto &first = i == 0 ? anterior : posterior, &second = i == 0 ? posterior : anterior;
      if (first.size() == 1 && second.size() == 1)
        order.numbered[i] = convention(first[0]->number, second[0]->number);
    }
    order.swap = "say";
    for (const auto& [labels, name] : {std::pair(posterior, "anterior"), {anterior, "posterior"}})
      for (const LabelCandidate* label : labels)
        order.swap += std::string(" --label ") + name + '=' + std::to_string(label->number);
    return order;
  }

  std::vector<LabelVoxels> voxels_of_leaflets() const {
    std::vector<LabelVoxels> voxels;
    for (const ValvePart part : {ValvePart::Anterior, ValvePart::Posterior})
      for (const LabelCandidate* label : of(part)) voxels.emplace_back(map_, label->label);
    return voxels;
  }

  std::vector<ImportedTip> sided() const {
    std::vector<ImportedTip> places;
    for (const LabelCandidate& candidate : all_)
      if (const auto side = side_named(candidate.name);
          side && std::string_view(candidate.reason) != "as given")
        places.push_back({*side, middle_mm(candidate)});
    return places;
  }

  std::vector<ImportedWitness> witnesses() const {
    std::vector<ImportedWitness> found;
    for (const LabelCandidate& candidate : all_)
      if (const auto side = annulus_side_named(candidate.name); side && !candidate.part)
        found.push_back({*side, middle_mm(candidate)});
    return found;
  }

 private:
  /// Of its box.
  Vec3 middle_mm(const LabelCandidate& candidate) const {
    const LabelBox box = LabelVoxels(map_, candidate.label).box();
    const auto middle = [&](std::size_t axis) {
      return 0.5 * static_cast<double>(box.min[axis] + box.max[axis]);
    };
    return map_.centre_mm(middle(0), middle(1), middle(2));
  }

  /// Labels of tissue; marks of a place are much smaller.
  void take_commissures() {
    const LabelShape posterior = shape_of(map_, *of(ValvePart::Posterior)[0]);
    for (LabelCandidate& candidate : all_) {
      if (candidate.part || candidate.meant != NamedPart::Commissure ||
          !is_like(shape_of(map_, candidate), posterior))
        continue;
      candidate.part = ValvePart::Posterior;
      candidate.reason = "by its name in the file";
    }
  }

  static std::string pointer(ValvePart part) {
    return std::string("/label_numbers/") + option_of(part);
  }

  template <class Which>
  std::string listed(const Which& which) const {
    std::string text;
    for (const LabelCandidate& candidate : all_) {
      if (!which(candidate)) continue;
      if (text.size() > 100) return text + ", ...";
      text += (text.empty() ? "" : ", ") + std::to_string(candidate.number);
    }
    return text.empty() ? "none" : text;
  }

  /// Those that are like the known leaflet or, without one, like label 1 or, if that is much thicker, the thinnest; like that
  /// is another one, if any two are alike: remains of an annulus are as thin.
  std::vector<LabelCandidate*> leaflet_like(const std::vector<LabelCandidate*>& free,
                                            ValvePart known) const {
    if (free.size() > kMostLookedAt) return free;
    std::vector<LabelShape> shapes;
    for (const LabelCandidate* candidate : free) shapes.push_back(shape_of(map_, *candidate));
    LabelShape like;
    if (const auto leaflet = of(known); !leaflet.empty()) {
      like = shape_of(map_, *leaflet[0]);
    } else {
      const auto has_other = [&](const LabelShape& one) {
        return std::count_if(shapes.begin(), shapes.end(),
                             [&](const LabelShape& other) { return is_like(other, one); }) > 1;
      };
      const bool paired = std::any_of(shapes.begin(), shapes.end(), has_other);
      like.thickness = 1e300;
      for (const LabelShape& shape : shapes)
        if ((!paired || has_other(shape)) && shape.thickness < like.thickness) like = shape;
      for (std::size_t i = 0; i < free.size(); ++i)
        if (free[i]->number == kUsualAnterior && is_like(shapes[i], like)) like = shapes[i];
    }
    std::vector<LabelCandidate*> found;
    for (std::size_t i = 0; i < free.size(); ++i)
      if (is_like(shapes[i], like)) found.push_back(free[i]);
    return found;
  }

  void too_many(const std::vector<LabelCandidate*>& free) {
    const auto is_free = [&](const LabelCandidate& c) {
      return std::any_of(free.begin(), free.end(),
                         [&](const LabelCandidate* f) { return f == &c; });
    };
    std::string why;
    if (of(ValvePart::Annulus).empty())
      for (const LabelCandidate* candidate : free)
        if (const auto line = label_curve(map_, candidate->label); !line && candidate->number == 3)
          why = "; the file " + line.errors()[0].message;
    problems_.add(ErrorCode::BadReference, "/label_numbers",
                  "is missing: labels " + listed(is_free) +
                      " could each be a leaflet, but a mitral valve has two; name their labels "
                      "(--label anterior=N, --label posterior=N, repeated for scallops)" +
                      why);
  }

  const LabelMap& map_;
  std::vector<LabelCandidate> all_;
  ProblemList& problems_;
  bool found_both_ = false;
};

/// With the voxels of several labels as the first of them.
LabelMap merged(const LabelMap& map, const std::vector<const LabelCandidate*>& labels) {
  LabelMap one = map;
  const auto volume = static_cast<std::size_t>(map.size[0] * map.size[1] * map.size[2]);
  const LabelAt& first = labels[0]->label;
  for (const LabelCandidate* other : labels)
    for (std::size_t i = 0; i < volume; ++i)
      if (map.voxels[static_cast<std::size_t>(other->label.layer) * volume + i] ==
          other->label.value)
        one.voxels[static_cast<std::size_t>(first.layer) * volume + i] =
            static_cast<std::uint16_t>(first.value);
  return one;
}

}  // namespace

std::vector<SourcePart> labels_in(const LabelMap& map) {
  std::vector<SourcePart> labels;
  for (const LabelCandidate& candidate : candidates(map)) labels.push_back({candidate.number});
  return labels;
}

Expected<LabelParts> label_parts(const LabelMap& map, const LabelNumbers& numbers,
                                 const LabelUse& with) {
  ProblemList problems;
  LabelChoice choice(map, problems);
  choice.take_given(ValvePart::Anterior, numbers.anterior);
  choice.take_given(ValvePart::Posterior, numbers.posterior);
  choice.take_given(ValvePart::Annulus, numbers.annulus);
  if (!problems.empty()) return std::move(problems).take();
  for (const ValvePart part : kValveParts) choice.take_named(part);
  choice.refuse_other_valves(!numbers.anterior.empty() && !numbers.posterior.empty());
  choice.find_annulus();
  choice.find_leaflets();
  if (!problems.empty()) return std::move(problems).take();
  LabelParts parts;
  parts.order = choice.order();
  parts.parts = choice.parts();
  parts.sided = choice.sided();
  parts.witnesses = choice.witnesses();
  for (const ValvePart part : kValveParts) {
    const auto labels = choice.of(part);
    if (labels.empty()) continue;
    if (part == ValvePart::Annulus && !with.annulus) {
      parts.decisions.push_back({"labels", choice.called(part) + " not used",
                                 "it is the annulus, which was provided as a separate file"});
      continue;
    }
    if (part == ValvePart::Annulus || labels.size() > 1 ||
        parts.order.claim != LeafletClaim::Guessed)
      parts.decisions.push_back(
          {"labels",
           choice.called(part) + (labels.size() == 1 ? " is the " : " are the ") + words_of(part),
           labels[0]->reason});
    std::optional<LabelMap> together;
    if (labels.size() > 1) together = merged(map, labels);
    const LabelMap& whole = together ? *together : map;
    const auto take = [&](const Errors& errors) {
      for (const Error& error : errors) problems.add(error.code, "/labels", error.message);
    };
    if (part == ValvePart::Annulus) {
      Expected<Points> line = label_curve(whole, labels[0]->label);
      if (line)
        parts.annulus_band_mm = band_over_leaflets_mm({whole, labels[0]->label}, *line, map,
                                                      choice.voxels_of_leaflets());
      line ? void(parts.annulus_mm = *std::move(line)) : take(line.errors());
    } else {
      if (auto doubt = cut_off({whole, labels[0]->label}, words_of(part)))
        parts.decisions.push_back(*std::move(doubt));
      Expected<TriangleMesh> surface = label_surface(whole, labels[0]->label);
      surface ? void(parts.leaflets.push_back(*std::move(surface))) : take(surface.errors());
    }
  }
  if (!problems.empty()) return std::move(problems).take();
  choice.tell_left_over(parts.decisions);
  const std::vector<ImportDecision> more = map_decisions(map, with.phase_given);
  parts.decisions.insert(parts.decisions.end(), more.begin(), more.end());
  return parts;
}

}  // namespace coapt
