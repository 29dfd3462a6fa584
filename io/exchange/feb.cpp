#include "io/exchange/feb.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/closure/continuum.h"
#include "core/closure/model.h"
#include "core/metrics/leaflet_sides.h"
#include "core/valve/number_text.h"
#include "io/json/version.h"
#include "io/mesh/mesh_text.h"

namespace coapt {
namespace {

constexpr double kToePower = 20.0, kPoisson = 0.45;
constexpr double kTonnePerG = 1e-6;
constexpr int kIdsPerLine = 16;  // FEBio has trouble with very long lines
constexpr double kMoves_mm = 1e-6;

std::string shown9(double number) { return significant(number, kExchangeDigits); }

std::string triple(const Vec3& v) {
  return shown9(v.x()) + ',' + shown9(v.y()) + ',' + shown9(v.z());
}

/// XML elements with their ends, indented.
class Xml {
 public:
  /// @param tag with its attributes: `material id="1"`
  void open(const std::string& tag) {
    indent();
    text_ += '<' + tag + ">\n";
    open_.push_back(tag.substr(0, tag.find(' ')));
  }
  void close() {
    const std::string name = open_.back();
    open_.pop_back();
    indent();
    text_ += "</" + name + ">\n";
  }
  void leaf(const std::string& tag, const std::string& value) {
    indent();
    text_ += '<' + tag + '>' + value + "</" + tag.substr(0, tag.find(' ')) + ">\n";
  }
  void leaf(const std::string& tag, double value) { leaf(tag, shown9(value)); }
  void empty(const std::string& tag) {
    indent();
    text_ += '<' + tag + "/>\n";
  }
  void comment(const std::string& words) {
    indent();
    text_ += "<!-- " + words + " -->\n";  // no "--" in it: plain()
  }
  std::string take() && { return std::move(text_); }

 private:
  void indent() { text_.append(open_.size(), '\t'); }

  std::string text_ = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n";
  std::vector<std::string> open_;
};

/// Only printable ASCII, nothing that XML knows and no two hyphens in a row.
std::string plain(const std::string& words) {
  constexpr std::string_view kSpecial = "<>&\"'";
  std::string out;
  for (const char c : words) {
    const bool good = c >= ' ' && c <= '~' && kSpecial.find(c) == std::string_view::npos &&
                      !(c == '-' && out.ends_with('-'));
    out += good ? c : '_';
  }
  return out;
}

/// The heaviest node of its end, 0-based.
int end_node(const Cable& cable) {
  return std::max_element(
             cable.end.begin(), cable.end.end(),
             [](const NodeShare& a, const NodeShare& b) { return a.weight < b.weight; })
      ->node;
}

/// Unique, also where ids differ only in what plain() takes away.
std::string name_of(const Valve& valve, const Cable& cable) {
  if (cable.chorda < 0)  // a half of a tie
    return "tie " + std::to_string(cable.segment + 1) + '.' + std::to_string(end_node(cable) + 1) +
           ' ' + plain(valve.ties[static_cast<std::size_t>(cable.segment)].id);
  return std::to_string(cable.chorda + 1) + '.' + std::to_string(cable.segment + 1) + ' ' +
         plain(valve.chordae[static_cast<std::size_t>(cable.chorda)].id);
}

void add_fibre(Xml& xml, const char* axis, double post_kpa, double transition) {
  const double stretch = 1.0 + transition, square = stretch * stretch;
  // So that the slope of the nominal stress over the stretch is the modulus at the transition.
  const double slope =
      1.0 / stretch + (square - 1.0) / (2.0 * (kToePower - 1.0) * stretch * square);
  xml.open("solid type=\"fiber-pow-linear\"");
  xml.leaf("E", kMpaPerKpa * post_kpa / slope);
  xml.leaf("beta", kToePower);
  xml.leaf("lam0", stretch);
  xml.leaf("fiber type=\"vector\"", axis);
  xml.close();
}

void add_material(Xml& xml, const Tissue& tissue) {
  const double density = kTonnePerG * tissue.density_g_per_mm3;
  xml.open("Material");
  xml.open("material id=\"1\" name=\"leaflet\" type=\"solid mixture\"");
  xml.leaf("density", density);
  xml.open("solid type=\"neo-Hookean\"");
  xml.leaf("density", density);
  xml.leaf("E", kMpaPerKpa * tissue.radial_pre_kpa);
  xml.leaf("v", kPoisson);
  xml.close();
  add_fibre(xml, "1,0,0", tissue.circumferential_post_kpa, tissue.circumferential_transition);
  add_fibre(xml, "0,1,0", tissue.radial_post_kpa, tissue.radial_transition);
  xml.close();
  xml.close();
}

void add_node_set(Xml& xml, const std::string& name, const std::vector<int>& nodes) {
  std::string list;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (i > 0) list += i % kIdsPerLine == 0 ? ",\n" : ",";
    list += std::to_string(nodes[i] + 1);
  }
  xml.leaf("NodeSet name=\"" + name + '"', list);
}

std::string corners(const Faces& faces, Eigen::Index f) {
  return std::to_string(faces(f, 0) + 1) + ',' + std::to_string(faces(f, 1) + 1) + ',' +
         std::to_string(faces(f, 2) + 1);
}

void add_surface(Xml& xml, const std::string& name, const Faces& faces,
                 const std::vector<Eigen::Index>& chosen) {
  xml.open("Surface name=\"" + name + '"');
  int id = 0;
  for (const Eigen::Index f : chosen)
    xml.leaf("tri3 id=\"" + std::to_string(++id) + '"', corners(faces, f));
  xml.close();
}

/// Nodes without branch points of ruptured chordae, which nothing holds.
std::vector<bool> used_nodes(const ClosureModel& model) {
  std::vector<bool> used(static_cast<std::size_t>(model.rest_mm.rows()), false);
  std::fill_n(used.begin(), model.vertices, true);
  for (const Cable& cable : model.cables)
    used[static_cast<std::size_t>(cable.start)] = used[static_cast<std::size_t>(end_node(cable))] =
        true;
  return used;
}

/// Those that are held: they stay, or are moved by the load curve.
struct Held {
  std::vector<int> still, moved;
};

Held held_nodes(const ClosureModel& model, const std::vector<bool>& used) {
  Held held;
  for (int i = 0; i < model.rest_mm.rows(); ++i) {
    if (!model.fixed[static_cast<std::size_t>(i)] || !used[static_cast<std::size_t>(i)]) continue;
    const double way = (model.target_mm.row(i) - model.rest_mm.row(i)).norm();
    (way > kMoves_mm ? held.moved : held.still).push_back(i);
  }
  return held;
}

void add_mesh(Xml& xml, const Valve& valve, const ClosureModel& model,
              const std::vector<bool>& used, const Held& held) {
  xml.open("Mesh");
  xml.open("Nodes name=\"nodes\"");
  for (int i = 0; i < model.rest_mm.rows(); ++i)
    if (used[static_cast<std::size_t>(i)])
      xml.leaf("node id=\"" + std::to_string(i + 1) + '"', triple(model.rest_mm.row(i)));
  xml.close();
  xml.open("Elements type=\"tri3\" name=\"leaflets\"");
  for (Eigen::Index f = 0; f < valve.faces.rows(); ++f)
    xml.leaf("elem id=\"" + std::to_string(f + 1) + '"', corners(valve.faces, f));
  xml.close();
  if (!held.still.empty()) add_node_set(xml, "held", held.still);
  for (const int node : held.moved) add_node_set(xml, "moved_" + std::to_string(node + 1), {node});

  std::vector<Eigen::Index> all(static_cast<std::size_t>(valve.faces.rows())), anterior, posterior;
  std::iota(all.begin(), all.end(), 0);
  const std::vector<Leaflet> sides = leaflet_sides(valve);
  for (const Eigen::Index f : all)
    (sides[static_cast<std::size_t>(f)] == Leaflet::Anterior ? anterior : posterior).push_back(f);
  add_surface(xml, "atrial_side", valve.faces, all);
  add_surface(xml, "anterior_side", valve.faces, anterior);
  add_surface(xml, "posterior_side", valve.faces, posterior);
  xml.open("SurfacePair name=\"coaptation\"");
  xml.leaf("primary", std::string("anterior_side"));
  xml.leaf("secondary", std::string("posterior_side"));
  xml.close();
  for (const Cable& cable : model.cables) {
    xml.open("DiscreteSet name=\"" + name_of(valve, cable) + '"');
    xml.leaf("delem", std::to_string(cable.start + 1) + ',' + std::to_string(end_node(cable) + 1));
    xml.close();
  }
  xml.close();
}

/// Axes of the elements: along the fibres, across them.
void add_axes(Xml& xml, const Valve& valve) {
  xml.open("MeshData");
  xml.open("ElementData type=\"mat_axis\" elem_set=\"leaflets\"");
  for (Eigen::Index f = 0; f < valve.faces.rows(); ++f) {
    const Vec3 a = valve.rest_mm.row(valve.faces(f, 0)), b = valve.rest_mm.row(valve.faces(f, 1)),
               c = valve.rest_mm.row(valve.faces(f, 2)), along = valve.fibre.row(f);
    const Vec3 across = (b - a).cross(c - a).normalized().cross(along);
    xml.leaf("e lid=\"" + std::to_string(f + 1) + '"',
             "<a>" + triple(along) + "</a><d>" + triple(across) + "</d>");
  }
  xml.close();
  xml.close();
}

void add_boundary(Xml& xml, const ClosureModel& model, const Held& held) {
  xml.open("Boundary");
  if (!held.still.empty()) {
    xml.open("bc name=\"held\" node_set=\"held\" type=\"zero displacement\"");
    for (const char* axis : {"x", "y", "z"}) xml.leaf(std::string(axis) + "_dof", 1.0);
    xml.close();
  }
  for (const int node : held.moved)
    for (int axis = 0; axis < 3; ++axis) {
      const std::string set = "moved_" + std::to_string(node + 1), letter(1, "xyz"[axis]);
      xml.open("bc name=\"" + set + '_' + letter + "\" node_set=\"" + set +
               "\" type=\"prescribed displacement\"");
      xml.leaf("dof", letter);
      xml.leaf("value lc=\"1\"", model.target_mm(node, axis) - model.rest_mm(node, axis));
      xml.leaf("relative", 0.0);
      xml.close();
    }
  xml.close();
}

/// A spring's force over its elongation from the unstressed model: 0 until its rest length, then linear.
void add_springs(Xml& xml, const Valve& valve, const ClosureModel& model) {
  xml.open("Discrete");
  int id = 0;
  for (const Cable& cable : model.cables) {
    const double length =
        (end_position(cable, model.rest_mm) - Vec3(model.rest_mm.row(cable.start))).norm();
    const double slack = cable.rest_mm - length;
    xml.open("discrete_material id=\"" + std::to_string(++id) + "\" name=\"" +
             name_of(valve, cable) + "\" type=\"nonlinear spring\"");
    xml.leaf("scale", 1.0);
    xml.leaf("measure", std::string("elongation"));
    xml.open("force type=\"point\"");
    xml.leaf("interpolate", std::string("LINEAR"));
    xml.leaf("extend", std::string("EXTRAPOLATE"));
    xml.open("points");
    for (const double beyond : {-1.0, 0.0, 1.0})
      xml.leaf("pt", shown9(slack + beyond) + ',' +
                         shown9(std::max(0.0, beyond) * cable.stiffness_n_per_mm));
    xml.close();
    xml.close();
    xml.close();
  }
  id = 0;
  for (const Cable& cable : model.cables)
    xml.empty("discrete dmat=\"" + std::to_string(++id) + "\" discrete_set=\"" +
              name_of(valve, cable) + '"');
  xml.close();
}

void add_control(Xml& xml) {
  xml.empty("Module type=\"solid\"");
  xml.open("Control");
  xml.leaf("analysis", std::string("DYNAMIC"));
  xml.leaf("time_steps", 200.0);
  xml.leaf("step_size", 1e-3);
  xml.open("time_stepper type=\"default\"");
  xml.leaf("max_retries", 10.0);
  xml.leaf("opt_iter", 15.0);
  xml.leaf("dtmin", 1e-6);
  xml.leaf("dtmax", 1e-3);
  xml.close();
  xml.open("solver type=\"solid\"");
  xml.leaf("symmetric_stiffness", std::string("non-symmetric"));
  xml.leaf("max_refs", 25.0);
  xml.close();
  xml.close();
}

void add_loads(Xml& xml, const Valve& valve) {
  xml.open("Loads");
  xml.open("surface_load name=\"systole\" surface=\"atrial_side\" type=\"pressure\"");
  // Faces look to the atrium, and FEBio's pressure is against the normal.
  xml.leaf("pressure lc=\"1\"", -kMpaPerKpa * valve.pressure_kpa);
  xml.leaf("symmetric_stiffness", 0.0);
  xml.leaf("linear", 0.0);
  xml.leaf("shell_bottom", 0.0);
  xml.close();
  xml.close();
  xml.open("Contact");
  xml.open("contact name=\"coaptation\" surface_pair=\"coaptation\" type=\"sliding-elastic\"");
  for (const auto& [name, value] : {std::pair{"laugon", "PENALTY"},
                                    {"penalty", "1"},
                                    {"auto_penalty", "1"},
                                    {"two_pass", "1"},
                                    {"search_tol", "0.01"},
                                    {"symmetric_stiffness", "0"},
                                    {"fric_coeff", "0"}})
    xml.leaf(name, std::string(value));
  xml.leaf("search_radius", 2.0 * valve.tissue.thickness_mm);
  xml.close();
  xml.close();
}

void add_curve_and_output(Xml& xml) {
  xml.open("LoadData");
  xml.open("load_controller id=\"1\" name=\"systole\" type=\"loadcurve\"");
  xml.leaf("interpolate", std::string("SMOOTH"));
  xml.leaf("extend", std::string("CONSTANT"));
  xml.open("points");
  xml.leaf("pt", std::string("0,0"));
  xml.leaf("pt", std::string("0.1,1"));
  xml.close();
  xml.close();
  xml.close();
  xml.open("Output");
  xml.open("plotfile type=\"febio\"");
  for (const char* name : {"displacement", "stress", "Lagrange strain", "shell thickness"})
    xml.empty(std::string("var type=\"") + name + '"');
  xml.close();
  xml.close();
}

}  // namespace

std::string write_feb(const Valve& valve) {
  const ClosureModel model = make_closure_model(valve);
  const std::vector<bool> used = used_nodes(model);
  const Held held = held_nodes(model, used);
  Xml xml;
  xml.comment(plain(std::string(kResearchNotice)));
  xml.comment("Valve " + plain(valve.name) +
              ", unstressed. Units: mm, N, MPa, tonne, s. Axes of the valve: x posteromedial, y "
              "anterior, z to the atrium.");
  xml.open("febio_spec version=\"4.0\"");
  add_control(xml);
  add_material(xml, valve.tissue);
  add_mesh(xml, valve, model, used, held);
  xml.open("MeshDomains");
  xml.open("ShellDomain name=\"leaflets\" mat=\"leaflet\" type=\"elastic-shell\"");
  xml.leaf("shell_thickness", valve.tissue.thickness_mm);
  xml.leaf("shell_normal_nodal", 1.0);
  xml.close();
  xml.close();
  add_axes(xml, valve);
  add_boundary(xml, model, held);
  add_loads(xml, valve);
  add_springs(xml, valve, model);
  add_curve_and_output(xml);
  xml.close();
  return std::move(xml).take();
}

}  // namespace coapt
