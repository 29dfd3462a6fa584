#include "core/valve/dimension_table.h"

#include <string>
#include <utility>

#include "core/valve/pressure_unit.h"
#include "core/valve/validate.h"

namespace coapt {
namespace {

template <auto First, auto... Rest>
auto& member(auto& of) {
  if constexpr (sizeof...(Rest) == 0) {
    return of.*First;
  } else {
    return member<Rest...>(of.*First);
  }
}

/// The member that `Path` leads to.
template <auto... Path>
Dimension number(const char* name, const char* what, const char* unit, Range accepted,
                 bool material = false) {
  return {name,
          what,
          unit,
          accepted,
          [](const ParametricValve& d) -> std::optional<double> { return member<Path...>(d); },
          [](ParametricValve& d, double value) { member<Path...>(d) = value; },
          material};
}

template <int Axis>
Dimension tip_asymmetry(const char* name, const char* what) {
  return {
      name,
      what,
      " mm",
      {-10.0, 10.0},
      [](const ParametricValve& d) -> std::optional<double> { return d.asymmetry.tip_mm(Axis); },
      [](ParametricValve& d, double value) { d.asymmetry.tip_mm(Axis) = value; }};
}

using TissueNumber = double Tissue::*;

/// What is left of a transition strain in the unpressurised heart.
template <int Direction, TissueNumber Transition, TissueNumber Prestretch>
Dimension extension(const char* name, const char* what) {
  return {name,
          what,
          "",
          {0.0, 0.4},
          [](const ParametricValve& d) -> std::optional<double> {
            return (1.0 + d.tissue.*Transition) / prestretch(d.tissue)[Direction] - 1.0;
          },
          [](ParametricValve& d, double left) {
            if (d.tissue.reference == TissueReference::Excised)
              d.tissue.*Transition = left;
            else
              d.tissue.*Prestretch = (1.0 + d.tissue.*Transition) / (1.0 + left);
          },
          true};
}

/// A modulus over the default's.
template <TissueNumber Modulus>
Dimension stiffness(const char* name, const char* what) {
  return {
      name,
      what,
      "",
      {0.01, 100.0},
      [](const ParametricValve& d) -> std::optional<double> {
        return d.tissue.*Modulus / (Tissue{}.*Modulus);
      },
      [](ParametricValve& d, double factor) { d.tissue.*Modulus = factor * (Tissue{}.*Modulus); },
      true};
}

}  // namespace

const std::vector<Dimension>& dimension_table() {
  using P = ParametricValve;
  using A = Asymmetry;
  using S = ChordalSlack;
  using T = Tissue;
  constexpr Range kSlack = {0.6, 2.0}, kInclination = {-45.0, 45.0}, kTakenShare = {0.0, 0.6};
  static const std::vector<Dimension> table = {
      number<&P::ap_mm>("ap_mm", "Anteroposterior diameter of the annulus", " mm", {8, 80}),
      number<&P::al_pm_mm>("al_pm_mm", "Transverse diameter of the annulus", " mm", {8, 100}),
      number<&P::saddle_height_mm>(
          "saddle_height_mm",
          "Saddle height of the annulus (default: 6.8 for 39 mm al-pm, in proportion)", " mm",
          {0, 20}),
      number<&P::anterior_arc>("anterior_arc", "Anterior fraction of the annulus", "", {0.25, 0.5}),
      number<&P::trigone_share>(
          "trigone_share",
          "Position of the trigones, as a fraction of the arc from saddle peak to commissure", "",
          {0.3, 1.0}),
      number<&P::anterior_height_mm>(
          "anterior_height_mm", "Leaflet height at A2 (default: 23.5 for 29 mm ap, in proportion)",
          " mm", {4, 60}),
      number<&P::posterior_height_mm>(
          "posterior_height_mm",
          "Leaflet height at P2 (default: 15.25 for 29 mm ap, in proportion)", " mm", {3, 60}),
      number<&P::lateral_height_mm>(
          "lateral_height_mm",
          "Leaflet height at P1 and P3 (default: 14.25 for 39 mm al-pm, in proportion)", " mm",
          {3, 60}),
      number<&P::commissure_height_mm>(
          "commissure_height_mm",
          "Leaflet height at a commissure (default: 9 for 39 mm al-pm, in proportion)", " mm",
          {2, 30}),
      number<&P::asymmetry, &A::leaflet_height>("height_asymmetry",
                                                "Fraction added to the leaflet height at the "
                                                "medial commissure and removed at the lateral one",
                                                "", {-0.4, 0.4}),
      number<&P::cleft_depth_mm>("cleft_depth_mm", "Depth of the clefts between posterior scallops",
                                 " mm", {0, 10}),
      number<&P::posterior_fold_mm>(
          "posterior_fold_mm", "Depth of the folds between posterior scallops at the free edge",
          " mm", {0, 6}),
      number<&P::anterior_fold_mm>("anterior_fold_mm",
                                   "Depth of the folds beside A2 at the free edge", " mm", {0, 6}),
      number<&P::anterior_inclination_deg>(
          "anterior_inclination_deg",
          "Inward inclination of the anterior leaflet from the vertical", " degrees", kInclination),
      number<&P::posterior_inclination_deg>(
          "posterior_inclination_deg",
          "Inward inclination of the posterior leaflet from the vertical (negative: outward)",
          " degrees", kInclination),
      number<&P::tip_depth_mm>("tip_depth_mm", "Depth of the papillary tips below the annulus",
                               " mm", {8, 60}),
      number<&P::tip_spread_mm>("tip_spread_mm", "Transverse distance between the papillary tips",
                                " mm", {4, 60}),
      number<&P::tip_posterior_mm>(
          "tip_posterior_mm", "Distance of the papillary tips behind the centre", " mm", {-20, 20}),
      tip_asymmetry<0>("tip_asymmetry_transverse_mm",
                       "Displacement of both tips towards the posteromedial commissure"),
      tip_asymmetry<1>(
          "tip_asymmetry_posterior_mm",
          "Displacement of the posteromedial tip backwards and of the other tip forwards"),
      tip_asymmetry<2>("tip_asymmetry_apical_mm",
                       "Displacement of the posteromedial tip apically and of the other tip "
                       "towards the annulus"),
      number<&P::slack, &S::anterior>(
          "anterior_slack", "Length of anterior marginal chordae, relative to the closed valve", "",
          kSlack),
      number<&P::slack, &S::posterior>(
          "posterior_slack", "Length of posterior marginal chordae, relative to the closed valve",
          "", kSlack),
      number<&P::slack, &S::commissural>(
          "commissural_slack",
          "Length of marginal chordae at the commissures, relative to the closed valve; slack ones "
          "let a commissure fold in several ways",
          "", kSlack),
      number<&P::slack, &S::strut>(
          "strut_slack", "Length of strut chordae, relative to the closed valve", "", kSlack),
      number<&P::slack, &S::basal>(
          "basal_slack", "Length of basal chordae, relative to the closed valve", "", kSlack),
      number<&P::asymmetry, &A::slack>(
          "slack_asymmetry",
          "Fraction added to posteromedial chordal lengths and removed from anterolateral ones", "",
          {-0.2, 0.2}),
      number<&P::tissue, &T::thickness_mm>("thickness_mm", "Thickness of the leaflets", " mm",
                                           {0.05, 10.0}, true),
      extension<1, &T::radial_transition, &T::radial_prestretch>(
          "radial_extension",
          "Radial strain, from the unpressurised heart, at which the leaflets stiffen"),
      extension<0, &T::circumferential_transition, &T::circumferential_prestretch>(
          "circumferential_extension",
          "Circumferential strain, from the unpressurised heart, at which the leaflets stiffen"),
      stiffness<&T::radial_post_kpa>("radial_stiffness",
                                     "Radial modulus beyond that strain, in units of 760 kPa"),
      stiffness<&T::circumferential_post_kpa>(
          "circumferential_stiffness",
          "Circumferential modulus beyond that strain, in units of 2300 kPa"),
      number<&P::pressure_mmhg>("pressure_mmhg", "Pressure across the closed valve (default: 120)",
                                " mmHg", {1.0, 400.0}, true),
      number<&P::systole, &SystolicMotion::annular_contraction>(
          "annular_contraction", "Systolic reduction of the diastolic annular area, as a fraction",
          "", kTakenShare),
      number<&P::systole, &SystolicMotion::tip_approach>(
          "tip_approach",
          "Systolic reduction of the diastolic distance between the tips, as a fraction", "",
          kTakenShare)};
  return table;
}

std::vector<const Dimension*> material_table() {
  std::vector<const Dimension*> material;
  for (const Dimension& dimension : dimension_table())
    if (dimension.material) material.push_back(&dimension);
  return material;
}

Expected<Valve> with_material(const Valve& valve, const std::vector<MaterialValue>& values) {
  if (values.empty()) return valve;
  ProblemList problems;
  ParametricValve dimensions;
  dimensions.tissue = valve.tissue;
  for (const auto& [dimension, value] : values) {
    check_range(problems, '/' + std::string(dimension->name), value, dimension->accepted,
                dimension->unit);
    dimension->set(dimensions, value);
  }
  if (!problems.empty()) return std::move(problems).take();
  Valve changed = valve;
  changed.tissue = dimensions.tissue;
  if (dimensions.pressure_mmhg) changed.pressure_kpa = *dimensions.pressure_mmhg / kMmhgPerKpa;
  if (Errors errors = validate(changed); !errors.empty()) return errors;
  return changed;
}

}  // namespace coapt
