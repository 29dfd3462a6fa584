// What a relaxation works on, laid out for the kernels: made once for a model, copied for each
// relaxation.
#pragma once

#include <vector>

#include "core/closure/contact_pairs.h"
#include "core/closure/relaxation_model.h"

namespace coapt {

template <class R>
struct RelaxationLayout {
  RelaxationModel<R> laid;
  ContactPairs<R> faces;                  ///< with vertices
  std::vector<ContactPairs<R>> parted{};  ///< the same, where some leaflets do not touch themselves
};

template <class R>
RelaxationLayout<R> lay_out(const ClosureModel& model, const ContactLaw& contact,
                            kernels::InstructionSet instructions);

}  // namespace coapt
