#include "core/closure/self_contact.h"

#include <gtest/gtest.h>

#include "core/closure/contact_pairs.h"
#include "core/closure/relaxation.h"
#include "core/closure/relaxation_model.h"
#include "core/presets/presets.h"

namespace coapt {
namespace {

using kernels::Quad;

constexpr double kMargin_mm = 0.3;

/// Forces of contact on a valve that is half closed, by the kernels.
Points pushes(const ClosureModel& model, const Points& x, const ContactLaw& law) {
  const RelaxationModel<double> laid = make_relaxation_model<double>(model);
  const auto& table = kernels::kernels<double>(kernels::best_instruction_set());
  std::vector<Quad<double>> at(laid.nodes), force(at.size());
  for (std::size_t i = 0; i < laid.node_of.size(); ++i) {
    Quad<double>& quad = at[laid.node_of[i]];
    for (int k = 0; k < 3; ++k) quad.at[k] = x(i, k);
    quad.at[3] = kMargin_mm;
  }
  for (const ContactSides& sides : contact_sides(law.self)) {
    ContactPairs<double> pairs(model, laid.node_of, law, PairKind::VertexFace, table, {}, sides);
    pairs.list(at);
    pairs.push(at, 0.0, force);
  }
  Points result = Points::Zero(x.rows(), 3);
  for (std::size_t i = 0; i < laid.node_of.size(); ++i)
    for (int k = 0; k < 3; ++k) result(i, k) = force[laid.node_of[i]].at[k];
  return result;
}

TEST(ContactSides, HoldEachPairOfLeafletsOnceButThoseLeftOut) {
  for (const SelfContact self : {SelfContact::All, SelfContact::NotAnterior, SelfContact::None})
    for (std::size_t v = 0; v < kLeaflets; ++v)
      for (std::size_t f = 0; f < kLeaflets; ++f) {
        int times = 0;
        for (const ContactSides& sides : contact_sides(self))
          times += sides.vertices[v] && sides.faces[f];
        const bool left_out =
            v == f && (self == SelfContact::None || (self == SelfContact::NotAnterior && v == 0));
        EXPECT_EQ(times, left_out ? 0 : 1);
      }
}

TEST(ContactSides, AreTheSameForTheKernelsAndThePlainContact) {
  const ClosureModel model = make_closure_model(*make_preset("porcine-5"));
  RelaxationSettings settings;
  settings.max_steps = 150;
  const Points x = relax<double>(model, settings).x_mm;
  for (const SelfContact self : {SelfContact::All, SelfContact::NotAnterior, SelfContact::None}) {
    ContactLaw law;
    law.self = self;
    Points plain = Points::Zero(x.rows(), 3);
    Contact(law).add_forces(model, x, plain);
    ASSERT_GT(plain.rowwise().norm().maxCoeff(), 0.01);
    EXPECT_LT((pushes(model, x, law) - plain).cwiseAbs().maxCoeff(), 1e-9);
  }
}

}  // namespace
}  // namespace coapt
