// A keyword line opens a block; the lines after it are its data. Each keyword has a function that
// takes one data line; blocks that are passed over have none.

#include "io/exchange/abaqus_input.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>
#include <utility>

#include "core/valve/problem_list.h"
#include "io/mesh/text_scan.h"

namespace coapt {
namespace {

std::string capitals(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return result;
}

struct Keyword {
  std::string name;
  std::map<std::string, std::string> options;  // in capitals; flags have no value
  int line = 0;

  bool has(const std::string& option) const { return options.contains(option); }
  std::string get(const std::string& option) const {
    const auto found = options.find(option);
    return found == options.end() ? std::string() : found->second;
  }
};

Keyword parse_keyword(const Line& line) {
  Keyword keyword;
  keyword.line = line.number;
  for (const std::string_view field : fields(line.text.substr(1))) {
    const std::string text = capitals(field);
    const std::size_t equals = text.find('=');
    if (keyword.name.empty()) {
      keyword.name = text;
    } else if (equals == std::string::npos) {
      keyword.options[text];
    } else {
      keyword.options[std::string(trimmed(text.substr(0, equals)))] =
          trimmed(text.substr(equals + 1));
    }
  }
  return keyword;
}

// What concerns neither shape nor loads nor materials, or is replaced by ours.
const std::set<std::string>& passed_over() {
  static const std::set<std::string> names = {"HEADING",
                                              "PREPRINT",
                                              "PART",
                                              "END PART",
                                              "ASSEMBLY",
                                              "END ASSEMBLY",
                                              "INSTANCE",
                                              "END INSTANCE",
                                              "DISTRIBUTION TABLE",
                                              "AMPLITUDE",
                                              "TRANSVERSE SHEAR",
                                              "SURFACE INTERACTION",
                                              "FRICTION",
                                              "SURFACE BEHAVIOR",
                                              "DYNAMIC",
                                              "BULK VISCOSITY",
                                              "CONTACT",
                                              "CONTACT INCLUSIONS",
                                              "OUTPUT",
                                              "ELEMENT OUTPUT",
                                              "CONTACT PROPERTY ASSIGNMENT",
                                              "NODE OUTPUT",
                                              "CONTACT OUTPUT",
                                              "VARIABLE MASS SCALING",
                                              "RESTART",
                                              "FIXED MASS SCALING",
                                              "END STEP"};
  return names;
}

class Reader {
 public:
  Expected<AbaqusModel> read(std::string_view text);

 private:
  using Fields = std::vector<std::string_view>;
  using TakeLine = std::function<void(const Fields&)>;

  void refuse(ErrorCode code, const std::string& message) {
    problems_.add(code, "/lines/" + std::to_string(line_), message);
  }
  std::optional<double> number(const Fields& f, std::size_t i) {
    const std::optional<double> value = i < f.size() ? to_number(f[i]) : std::nullopt;
    if (!value || !std::isfinite(*value))
      refuse(ErrorCode::WrongType, "needs a finite number as value " + std::to_string(i + 1));
    return value;
  }
  std::optional<int> integer(const Fields& f, std::size_t i) {
    const std::optional<long long> value = i < f.size() ? to_integer(f[i]) : std::nullopt;
    if (value && *value > 0 && *value < 100'000'000) return static_cast<int>(*value);
    refuse(ErrorCode::WrongType,
           "needs a whole number from 1 to 99,999,999 as value " + std::to_string(i + 1));
    return std::nullopt;
  }
  std::optional<Vec3> vector(const Fields& f, std::size_t i) {
    const auto x = number(f, i), y = number(f, i + 1), z = number(f, i + 2);
    if (!x || !y || !z) return std::nullopt;
    return Vec3(*x, *y, *z);
  }

  TakeLine open(const Keyword& keyword);
  TakeLine open_model(const Keyword& keyword);
  TakeLine open_material(const Keyword& keyword);
  TakeLine open_step(const Keyword& keyword);
  TakeLine nodes(const Keyword& keyword);
  TakeLine elements(const Keyword& keyword);
  TakeLine set(const Keyword& keyword, const std::string& name, bool of_nodes);
  TakeLine section(const Keyword& keyword, bool shell);

  AbaqusModel model_;
  ProblemList problems_;
  std::string material_;
  int line_ = 0, steps_ = 0;
};

Reader::TakeLine Reader::nodes(const Keyword& keyword) {
  const std::string set = keyword.get("NSET");
  return [this, set](const Fields& f) {
    const auto n = integer(f, 0);
    const auto at = vector(f, 1);
    if (!n || !at) return;
    if (!model_.nodes.emplace(*n, *at).second)
      refuse(ErrorCode::BadReference, "repeats node " + std::to_string(*n));
    if (!set.empty()) model_.node_sets[set].push_back(*n);
  };
}

Reader::TakeLine Reader::elements(const Keyword& keyword) {
  static const std::map<std::string, std::size_t> corners = {
      {"S4R", 4}, {"S4", 4}, {"S3R", 3}, {"S3", 3}, {"T3D2", 2}};
  const auto type = corners.find(keyword.get("TYPE"));
  if (type == corners.end()) {
    refuse(ErrorCode::Unsupported, "has elements of type '" + keyword.get("TYPE") +
                                       "'; supported are S4R, S4, S3R, S3 and T3D2");
    return {};
  }
  const std::string set = keyword.get("ELSET");
  const std::size_t count = type->second;
  return [this, set, count](const Fields& f) {
    const auto n = integer(f, 0);
    AbaqusElement element;
    for (std::size_t k = 1; k <= count; ++k) {
      const auto node = integer(f, k);
      if (!node) return;
      // A quadrilateral that names a node twice is a triangle.
      if (std::find(element.nodes.begin(), element.nodes.end(), *node) == element.nodes.end())
        element.nodes.push_back(*node);
    }
    if (!n) return;
    if (!model_.elements.emplace(*n, element).second)
      refuse(ErrorCode::BadReference, "repeats element " + std::to_string(*n));
    if (!set.empty()) model_.element_sets[set].push_back(*n);
  };
}

Reader::TakeLine Reader::set(const Keyword& keyword, const std::string& name, bool of_nodes) {
  const bool generated = keyword.has("GENERATE");
  return [this, name, of_nodes, generated](const Fields& f) {
    auto& sets = of_nodes ? model_.node_sets : model_.element_sets;
    std::vector<int> members;
    if (generated) {
      const auto first = integer(f, 0), last = integer(f, 1);
      const auto step = f.size() > 2 ? integer(f, 2) : 1;
      if (!first || !last || !step || (*last - *first) / *step > 10'000'000) return;
      for (int n = *first; n <= *last; n += *step) members.push_back(n);
    } else {
      for (const std::string_view field : f) {
        if (field.empty()) continue;
        if (const auto n = to_integer(field)) {
          members.push_back(static_cast<int>(*n));
        } else if (const auto other = sets.find(capitals(field)); other != sets.end()) {
          members.insert(members.end(), other->second.begin(), other->second.end());
        } else {
          refuse(ErrorCode::BadReference, "names a set that is not defined above");
        }
      }
    }
    auto& all = sets[name];
    all.insert(all.end(), members.begin(), members.end());
  };
}

Reader::TakeLine Reader::section(const Keyword& keyword, bool shell) {
  model_.sections.push_back({shell, keyword.get("ELSET"), keyword.get("MATERIAL"),
                             keyword.get("ORIENTATION"), 0.0, keyword.line});
  const std::size_t at = model_.sections.size() - 1;
  return [this, at](const Fields& f) {
    if (model_.sections[at].size == 0.0) model_.sections[at].size = number(f, 0).value_or(0.0);
  };
}

Reader::TakeLine Reader::open_model(const Keyword& k) {
  if (k.name == "NODE") return nodes(k);
  if (k.name == "ELEMENT") return elements(k);
  if (k.name == "NSET") return set(k, k.get("NSET"), true);
  if (k.name == "ELSET") return set(k, k.get("ELSET"), false);
  if (k.name == "SHELL SECTION") return section(k, true);
  if (k.name == "SOLID SECTION") return section(k, false);
  if (k.name == "DISTRIBUTION") {
    auto& axes = model_.distributions[k.get("NAME")];
    return [this, &axes](const Fields& f) {
      if (f.empty() || f[0].empty()) return;  // the default
      const auto n = integer(f, 0);
      const auto axis = vector(f, 1);
      if (n && axis) axes[*n] = *axis;
    };
  }
  if (k.name == "ORIENTATION") {
    std::string& distribution = model_.orientations[k.get("NAME")];
    return [&distribution, first = true](const Fields& f) mutable {
      if (std::exchange(first, false)) distribution = capitals(f[0]);
    };
  }
  if (k.name == "SURFACE") {
    AbaqusSurface& surface = model_.surfaces[k.get("NAME")];
    surface.max_ratio = to_number(k.get("MAXRATIO")).value_or(0.0);
    return [this, &surface](const Fields& f) {
      const std::string side = f.size() > 1 ? capitals(f[1]) : "";
      if (side != "SPOS" && side != "SNEG") {
        refuse(ErrorCode::Unsupported, "has a surface without a side; supported are SPOS and SNEG");
        return;
      }
      surface.parts.push_back({capitals(f[0]), side == "SPOS"});
    };
  }
  return {};
}

Reader::TakeLine Reader::open_material(const Keyword& k) {
  AbaqusMaterial& material = model_.materials[material_];
  if (k.name == "DENSITY")
    return [this, &material](const Fields& f) {
      material.density_t_per_mm3 = number(f, 0).value_or(0.0);
    };
  if (k.name == "HYPERELASTIC") {
    const std::size_t terms = static_cast<std::size_t>(to_integer(k.get("N")).value_or(1));
    if (!k.has("OGDEN") || terms < 1 || terms > 6) {
      refuse(ErrorCode::Unsupported, "is supported only as OGDEN with N from 1 to 6");
      return {};
    }
    return [this, &material, terms](const Fields& f) {
      for (std::size_t i = 0; i + 1 < f.size() && material.ogden.size() < terms; i += 2) {
        const auto mu = number(f, i), alpha = number(f, i + 1);
        if (mu && alpha) material.ogden.push_back({*mu, *alpha});
      }
    };
  }
  return [this, &material](const Fields& f) {  // of a user
    for (std::size_t i = 0; i < f.size(); ++i)
      if (!f[i].empty()) material.constants.push_back(number(f, i).value_or(0.0));
  };
}

Reader::TakeLine Reader::open_step(const Keyword& k) {
  if (k.name == "BOUNDARY")
    return [this](const Fields& f) {
      const auto first = integer(f, 1);
      const auto last = f.size() > 2 && !f[2].empty() ? integer(f, 2) : first;
      if (!first || !last) return;
      const double amount_mm = f.size() > 3 ? number(f, 3).value_or(0.0) : 0.0;
      for (int axis = *first; axis <= std::min(3, *last); ++axis)
        model_.motions.push_back({capitals(f[0]), axis - 1, amount_mm});
    };
  return [this](const Fields& f) {
    if (f.size() < 3 || capitals(f[1]) != "P") {
      refuse(ErrorCode::Unsupported, "has a load other than a pressure (SURFACE, P, MPA)");
      return;
    }
    model_.pressures.push_back({capitals(f[0]), number(f, 2).value_or(0.0)});
  };
}

Reader::TakeLine Reader::open(const Keyword& k) {
  static const std::set<std::string> of_model = {"NODE",    "ELEMENT",       "NSET",
                                                 "ELSET",   "DISTRIBUTION",  "ORIENTATION",
                                                 "SURFACE", "SHELL SECTION", "SOLID SECTION"};
  if (of_model.contains(k.name)) return open_model(k);
  if (k.name == "MATERIAL") {
    material_ = k.get("NAME");
    return {};
  }
  if (k.name == "DENSITY" || k.name == "HYPERELASTIC" ||
      (k.name == "ANISOTROPIC HYPERELASTIC" && k.has("USER")))
    return open_material(k);
  if (k.name == "STEP") {
    if (++steps_ > 1)
      refuse(ErrorCode::Unsupported, "begins a second step; only one step is supported");
    return {};
  }
  if (k.name == "BOUNDARY" || k.name == "DSLOAD") return open_step(k);
  if (!passed_over().contains(k.name))
    refuse(ErrorCode::Unsupported, "has the keyword *" + k.name + ", which is not supported");
  return {};
}

Expected<AbaqusModel> Reader::read(std::string_view text) {
  LineScanner scanner(text);
  TakeLine take;
  while (const std::optional<Line> raw = scanner.next()) {
    const Line line{raw->number, trimmed(raw->text)};
    line_ = line.number;
    if (line.text.empty() || line.text.starts_with("**")) continue;
    if (line.text.starts_with('*')) {
      take = open(parse_keyword(line));
    } else if (take) {
      std::vector<std::string_view> values = fields(line.text);
      if (values.size() > 1 && values.back().empty()) values.pop_back();  // a comma at the end
      take(values);
    }
  }
  if (!problems_.empty()) return std::move(problems_).take();
  return std::move(model_);
}

}  // namespace

Expected<AbaqusModel> read_abaqus(std::string_view text) { return Reader().read(text); }

}  // namespace coapt
