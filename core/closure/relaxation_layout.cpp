#include "core/closure/relaxation_layout.h"

#include <utility>

namespace coapt {

template <class R>
RelaxationLayout<R> lay_out(const ClosureModel& model, const ContactLaw& contact,
                            kernels::InstructionSet instructions) {
  const kernels::Kernels<R>& kernels = kernels::kernels<R>(instructions);
  RelaxationModel<R> laid = make_relaxation_model<R>(model);
  ContactPairs<R> faces(model, laid.node_of, contact, PairKind::VertexFace, kernels);
  RelaxationLayout<R> layout{std::move(laid), std::move(faces)};
  if (contact.self != SelfContact::All)
    for (const ContactSides& sides : contact_sides(contact.self))
      layout.parted.emplace_back(model, layout.laid.node_of, contact, PairKind::VertexFace, kernels,
                                 std::vector<std::array<int, 2>>(), sides);
  return layout;
}
template RelaxationLayout<float> lay_out(const ClosureModel&, const ContactLaw&,
                                         kernels::InstructionSet);
template RelaxationLayout<double> lay_out(const ClosureModel&, const ContactLaw&,
                                          kernels::InstructionSet);

}  // namespace coapt
