// The table of routes.
#pragma once

#include "server/route.h"
#include "server/service.h"

namespace coapt {

/// The service must outlive them.
Routes routes_of(const Service& service);

}  // namespace coapt
