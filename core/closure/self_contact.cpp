#include "core/closure/self_contact.h"

namespace coapt {

std::vector<ContactSides> contact_sides(SelfContact self) {
  switch (self) {
    case SelfContact::All:
      return {ContactSides{}};
    case SelfContact::NotAnterior:
      return {{{true, false, false}, {false, true, true}},
              {{false, true, true}, {true, true, true}}};
    case SelfContact::None:
      return {{{true, false, false}, {false, true, true}},
              {{false, true, false}, {true, false, true}},
              {{false, false, true}, {true, true, false}}};
  }
  return {};
}

}  // namespace coapt
