#include "io/json/json.h"

template class nlohmann::basic_json<nlohmann::ordered_map>;
template class nlohmann::detail::serializer<coapt::Json>;
template class std::vector<coapt::Json>;
