#include "search/fit/fit_parameters.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/valve/leaflet_coordinates.h"
#include "core/valve/leaflet_of.h"
#include "core/valve/leaflets.h"
#include "core/valve/ruptures.h"
#include "core/valve/validate.h"
#include "search/model_draw.h"

namespace coapt {
namespace {

constexpr double kBounds_sd = 3.0;
constexpr double kShownHeight = 0.5;  // of a leaflet, above its hidden part
constexpr double kOneMuscle_mm = 5.0;
constexpr double kDrawnSlack_sd = 0.12;  // of a mean of 1; three of them hold a third more; assumed

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;  // clang 14 does not deduce it

/// Where a chorda pulls: its first insertion.
int first_face(const Chorda& chorda) {
  const auto end = std::find_if(chorda.segments.begin(), chorda.segments.end(),
                                [](const ChordaSegment& segment) { return segment.inserts; });
  return end->insertion.face;
}

const char* marginal_place(Segment segment) {
  if (segment == Segment::AC || segment == Segment::PC) return "commissural";
  return leaflet_of(segment) == Leaflet::Anterior ? "anterior" : "posterior";
}

/// A papillary muscle.
struct Muscle {
  std::string name;
  std::vector<int> heads;  ///< into Valve::heads
};

bool holds(const Muscle& muscle, int head) {
  return std::find(muscle.heads.begin(), muscle.heads.end(), head) != muscle.heads.end();
}

Muscle muscle_of(const Valve& valve, Side side) {
  Muscle muscle{side == Side::Anterolateral ? "AL" : "PM", {}};
  for (std::size_t i = 0; i < valve.heads.size(); ++i)
    if (valve.heads[i].side == side) muscle.heads.push_back(static_cast<int>(i));
  return muscle;
}

/// Of a mitral valve both sides, of another one heads that are near each other, in the order of their first.
std::vector<Muscle> muscles_of(const Valve& valve) {
  if (is_mitral(valve))
    return {muscle_of(valve, Side::Anterolateral), muscle_of(valve, Side::Posteromedial)};
  std::vector<Muscle> muscles;
  std::vector<bool> taken(valve.heads.size(), false);
  for (std::size_t first = 0; first < valve.heads.size(); ++first) {
    if (taken[first]) continue;
    taken[first] = true;
    Muscle muscle{valve.heads[first].id, {static_cast<int>(first)}};
    for (std::size_t done = 0; done < muscle.heads.size(); ++done)
      for (std::size_t other = 0; other < valve.heads.size(); ++other) {
        const PapillaryHead& head = valve.heads[static_cast<std::size_t>(muscle.heads[done])];
        if (taken[other] || (valve.heads[other].rest_mm - head.rest_mm).norm() >= kOneMuscle_mm)
          continue;
        taken[other] = true;
        muscle.heads.push_back(static_cast<int>(other));
      }
    muscles.push_back(std::move(muscle));
  }
  return muscles;
}

/// Marginal chordae by leaflet, or where nobody has seen them by segment, because elongated ones let a scallop prolapse; others by
/// kind; of a valve that is not mitral all by leaflet.
std::string group_name(const Valve& valve, const Chorda& chorda) {
  const auto face = static_cast<std::size_t>(first_face(chorda));
  std::string where;
  if (!is_mitral(valve))
    where = leaflet_name(valve, static_cast<int>(face));
  else if (chorda.kind == ChordaKind::Marginal)
    where = valve.drawn_chordae ? to_string(held_by(valve, chorda).value_or(valve.segments[face]))
                                : marginal_place(valve.segments[face]);
  else
    where = to_string(chorda.kind);
  return "slack_" + where + "_";
}

/// By muscle, too. Neochordae have the length that was chosen.
void add_slack(const Valve& valve, const std::vector<Muscle>& muscles, double sd,
               std::vector<FitParameter>& parameters) {
  if (valve.drawn_chordae) sd = std::max(sd, kDrawnSlack_sd);
  std::map<std::string, ChordalGroup> groups;
  for (std::size_t i = 0; i < valve.chordae.size(); ++i) {
    const Chorda& chorda = valve.chordae[i];
    if (chorda.kind == ChordaKind::Neochorda || chorda.ruptured) continue;
    const auto muscle = std::find_if(muscles.begin(), muscles.end(), [&](const Muscle& candidate) {
      return holds(candidate, chorda.head);
    });
    groups[group_name(valve, chorda) + muscle->name].chordae.push_back(static_cast<int>(i));
  }
  for (const auto& [name, group] : groups)
    parameters.push_back({name, "1", 1.0, sd, 1.0 - kBounds_sd * sd, 1.0 + kBounds_sd * sd, group});
}

void add_tips(const std::vector<Muscle>& muscles, double sd_mm,
              std::vector<FitParameter>& parameters) {
  for (const Muscle& muscle : muscles)
    for (int axis = 0; axis < 3; ++axis)
      parameters.push_back({"tip_" + muscle.name + '_' + "xyz"[static_cast<std::size_t>(axis)],
                            "mm", 0.0, sd_mm, -kBounds_sd * sd_mm, kBounds_sd * sd_mm,
                            TipPlace{muscle.heads, axis}});
}

void add_prestretch(const Tissue& tissue, const FitUnknowns& unknowns,
                    std::vector<FitParameter>& parameters) {
  const auto add = [&](const char* name, double prior, double sd, bool radial) {
    parameters.push_back({name, "1", prior, sd, std::max(1.0, prior - kBounds_sd * sd),
                          prior + kBounds_sd * sd, Prestretch{radial}});
  };
  add("prestretch_circumferential", tissue.circumferential_prestretch,
      unknowns.circumferential_prestretch_sd, false);
  add("prestretch_radial", tissue.radial_prestretch, unknowns.radial_prestretch_sd, true);
}

void add_stiffness(double sd, std::vector<FitParameter>& parameters) {
  const ModelParameter& drawn = post_moduli();
  parameters.push_back({"stiffness", "1", 1.0, sd, drawn.lower, drawn.upper, Stiffness{}});
}

/// Direction in which the leaflet's height grows at each vertex, mean of the faces around it.
Points down_the_leaflet(const Valve& valve, const std::vector<double>& height) {
  Points down = Points::Zero(valve.rest_mm.rows(), 3);
  for (Eigen::Index f = 0; f < valve.faces.rows(); ++f) {
    const auto corner = [&](int k) { return Vec3(valve.rest_mm.row(valve.faces(f, k))); };
    const Vec3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    Vec3 gradient = Vec3::Zero();  // times twice the area
    for (int k = 0; k < 3; ++k) {
      const Vec3 opposite = corner((k + 2) % 3) - corner((k + 1) % 3);
      gradient +=
          height[static_cast<std::size_t>(valve.faces(f, k))] * normal.normalized().cross(opposite);
    }
    for (int k = 0; k < 3; ++k) down.row(valve.faces(f, k)) += gradient.transpose();
  }
  down.rowwise().normalize();
  return down;
}

/// How much of the leaflet's own hidden height a vertex takes: less towards the commissures.
double share_of(Leaflet leaflet, double around) {
  const bool anterior = around < 0.5;
  if (anterior != (leaflet == Leaflet::Anterior)) return 0.0;
  return std::abs(std::sin(2.0 * 3.14159265358979323846 * around));
}

void add_hidden(const Valve& valve, double sd_mm, std::vector<FitParameter>& parameters) {
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  const Points down = down_the_leaflet(valve, coordinates.height);
  for (const Leaflet leaflet : {Leaflet::Anterior, Leaflet::Posterior}) {
    HiddenHeight hidden{Points::Zero(down.rows(), 3)};
    for (Eigen::Index v = 0; v < down.rows(); ++v) {
      const auto at = static_cast<std::size_t>(v);
      const double below =
          std::max(0.0, (coordinates.height[at] - kShownHeight) / (1.0 - kShownHeight));
      hidden.per_mm.row(v) = below * share_of(leaflet, coordinates.around[at]) * down.row(v);
    }
    parameters.push_back({leaflet == Leaflet::Anterior ? "hidden_anterior" : "hidden_posterior",
                          "mm", 0.0, sd_mm, -kBounds_sd * sd_mm, kBounds_sd * sd_mm,
                          std::move(hidden)});
  }
}

/// Circumferential directions back into the planes of their faces, after vertices have moved.
void turn_fibres(Valve& valve) {
  for (Eigen::Index f = 0; f < valve.faces.rows(); ++f) {
    const Vec3 a = valve.rest_mm.row(valve.faces(f, 0)), b = valve.rest_mm.row(valve.faces(f, 1)),
               c = valve.rest_mm.row(valve.faces(f, 2));
    const Vec3 normal = (b - a).cross(c - a).normalized();
    const Vec3 fibre = valve.fibre.row(f);
    valve.fibre.row(f) = (fibre - normal.dot(fibre) * normal).normalized().transpose();
  }
}

}  // namespace

std::vector<FitParameter> fit_parameters(const Valve& valve, const FitUnknowns& unknowns) {
  std::vector<FitParameter> parameters;
  const std::vector<Muscle> muscles = muscles_of(valve);
  if (unknowns.slack) add_slack(valve, muscles, unknowns.slack_sd, parameters);
  if (unknowns.tips) add_tips(muscles, unknowns.tip_sd_mm, parameters);
  if (unknowns.prestretch && valve.tissue.reference == TissueReference::InVivo)
    add_prestretch(valve.tissue, unknowns, parameters);
  if (unknowns.stiffness) add_stiffness(unknowns.stiffness_sd, parameters);
  if (unknowns.hidden && is_mitral(valve)) add_hidden(valve, unknowns.hidden_sd_mm, parameters);
  return parameters;
}

Expected<Valve> with_parameters(const Valve& valve, const std::vector<FitParameter>& parameters,
                                const std::vector<double>& values) {
  Valve changed = valve;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double value = values[i];
    std::visit(
        Overloaded{[&](const ChordalGroup& group) {
                     for (const int chorda : group.chordae)
                       for (ChordaSegment& segment :
                            changed.chordae[static_cast<std::size_t>(chorda)].segments)
                         segment.rest_length_mm *= value;
                   },
                   [&](const TipPlace& tip) {
                     for (const int at : tip.heads) {
                       PapillaryHead& head = changed.heads[static_cast<std::size_t>(at)];
                       head.rest_mm(tip.axis) += value;
                       head.tip_mm(tip.axis) += value;
                     }
                   },
                   [&](const Prestretch& stretch) {
                     (stretch.radial ? changed.tissue.radial_prestretch
                                     : changed.tissue.circumferential_prestretch) = value;
                   },
                   [&](const Stiffness&) {
                     changed.tissue.circumferential_post_kpa *= value;
                     changed.tissue.radial_post_kpa *= value;
                   },
                   [&](const HiddenHeight& hidden) { changed.rest_mm += value * hidden.per_mm; }},
        parameters[i].changes);
  }
  turn_fibres(changed);
  if (Errors errors = validate(changed); !errors.empty()) return errors;
  return changed;
}

}  // namespace coapt
