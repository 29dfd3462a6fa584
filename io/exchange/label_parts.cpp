#include "io/exchange/label_parts.h"

#include <algorithm>
#include <array>

#include "core/valve/number_text.h"
#include "core/valve/problem_list.h"
#include "io/exchange/part_names.h"
#include "io/image/label_curve.h"
#include "io/image/label_surface.h"

namespace coapt {
namespace {

struct Wanted {
  NamedPart part;
  const char* name;
  int number;  ///< without any other hint
  std::optional<int> given;
};

struct Chosen {
  LabelAt label;
  const char* reason;
  bool look = false;  ///< its number alone chose it
};

std::string numbers_in(const std::vector<LabelAt>& labels) {
  std::string text;
  for (const LabelAt& label : labels) {
    if (text.size() > 100) return text + ", ...";
    text += (text.empty() ? "" : ", ") + std::to_string(label.value);
  }
  return text.empty() ? "none" : text;
}

std::optional<LabelAt> label_of_number(const std::vector<LabelAt>& labels, int number) {
  for (const LabelAt& label : labels)
    if (label.value == number) return label;
  return {};
}

bool is_there(const std::vector<LabelAt>& labels, const LabelAt& wanted) {
  return std::any_of(labels.begin(), labels.end(), [&](const LabelAt& label) {
    return label.layer == wanted.layer && label.value == wanted.value;
  });
}

std::optional<LabelAt> label_of_name(const LabelMap& map, const std::vector<LabelAt>& labels,
                                     NamedPart part) {
  for (const LabelName& name : map.names)
    if (part_named(name.name) == part && is_there(labels, {name.layer, name.value}))
      return LabelAt{name.layer, name.value};
  return {};
}

class LabelChoice {
 public:
  LabelChoice(const LabelMap& map, ProblemList& problems)
      : map_(map),
        labels_(labels_of(map)),
        problems_(problems),
        named_(label_of_name(map, labels_, NamedPart::Anterior) ||
               label_of_name(map, labels_, NamedPart::Posterior)) {}

  std::optional<Chosen> choose(const Wanted& wanted) {
    if (wanted.given) {
      if (const auto label = label_of_number(labels_, *wanted.given))
        return Chosen{*label, "as given"};
      miss(wanted, "is " + std::to_string(*wanted.given) + ", which no voxel has");
      return {};
    }
    if (const auto label = label_of_name(map_, labels_, wanted.part))
      return Chosen{*label, "by the name that the file gives it"};
    if (!named_)
      if (const auto label = label_of_number(labels_, wanted.number))
        return Chosen{*label,
                      "without names 1 is the anterior leaflet, 2 the posterior one, 3 the annulus",
                      true};
    if (wanted.part != NamedPart::Annulus)
      miss(wanted, std::string("is missing: no label is named the ") + wanted.name +
                       (named_ ? "" : ", and none is " + std::to_string(wanted.number)));
    return {};
  }

 private:
  void miss(const Wanted& wanted, const std::string& what) {
    const std::string name = wanted.part == NamedPart::Anterior    ? "anterior"
                             : wanted.part == NamedPart::Posterior ? "posterior"
                                                                   : "annulus";
    problems_.add(ErrorCode::BadReference, "/label_numbers/" + name,
                  what + "; the file has labels " + numbers_in(labels_));
  }

  const LabelMap& map_;
  std::vector<LabelAt> labels_;
  ProblemList& problems_;
  bool named_;
};

/// Two parts of one label.
void check_different(const std::vector<std::optional<Chosen>>& chosen, ProblemList& problems) {
  for (std::size_t i = 0; i < chosen.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (chosen[i] && chosen[k] && chosen[i]->label.value == chosen[k]->label.value &&
          chosen[i]->label.layer == chosen[k]->label.layer)
        problems.add(ErrorCode::BadReference, "/label_numbers",
                     "has label " + std::to_string(chosen[i]->label.value) +
                         " for two parts; each must have its own");
}

std::string frame_words(const LabelMap& map) {
  const Vec3 edges = map.to_lps_mm.topLeftCorner<3, 3>().colwise().norm();
  return "voxels of " + significant(edges[0], 3) + " x " + significant(edges[1], 3) + " x " +
         significant(edges[2], 3) + " mm";
}

}  // namespace

Expected<LabelParts> label_parts(const LabelMap& map, const LabelNumbers& numbers,
                                 bool with_annulus) {
  const std::array wanted = {
      Wanted{NamedPart::Anterior, "anterior leaflet", 1, numbers.anterior},
      Wanted{NamedPart::Posterior, "posterior leaflet", 2, numbers.posterior},
      Wanted{NamedPart::Annulus, "annulus", 3, numbers.annulus}};
  ProblemList problems;
  LabelChoice choice(map, problems);
  std::vector<std::optional<Chosen>> chosen;
  for (const Wanted& part : wanted)
    if (with_annulus || part.part != NamedPart::Annulus) chosen.push_back(choice.choose(part));
  check_different(chosen, problems);
  if (!problems.empty()) return std::move(problems).take();
  LabelParts parts;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (!chosen[i]) continue;
    parts.decisions.push_back(
        {"labels", "label " + std::to_string(chosen[i]->label.value) + " is the " + wanted[i].name,
         chosen[i]->reason, chosen[i]->look});
    const auto take = [&](const Errors& errors) {
      for (const Error& error : errors) problems.add(error.code, "/labels", error.message);
    };
    if (wanted[i].part == NamedPart::Annulus) {
      Expected<Points> line = label_curve(map, chosen[i]->label);
      line ? void(parts.annulus_mm = *std::move(line)) : take(line.errors());
    } else {
      Expected<TriangleMesh> surface = label_surface(map, chosen[i]->label);
      surface ? void(parts.leaflets.push_back(*std::move(surface))) : take(surface.errors());
    }
  }
  if (!problems.empty()) return std::move(problems).take();
  parts.decisions.push_back(
      {"labels", frame_words(map) + (map.placed ? ", in the patient's frame, LPS" : ""),
       map.placed
           ? "as the label map says"
           : "the label map does not say where the patient is; axes are those of its voxels"});
  return parts;
}

}  // namespace coapt
