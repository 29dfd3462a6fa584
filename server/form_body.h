// Bodies of multipart/form-data (RFC 7578), as `curl -F` and forms of browsers send files.
#pragma once

#include <string>
#include <string_view>

#include "core/valve/types.h"

namespace coapt {

bool is_form(std::string_view content_type);

/// The same as a JSON object: a file is {"name", "base64"}; the fields leaflets, slicerheart and files are lists of them; "fit.side" is
/// the field side of fit; what is no file is JSON where it can be read as such, else a string. Errors without a path: it is not
/// whole, a part has no name, two parts have one. What of names and fields is not
/// UTF-8 becomes U+FFFD.
Expected<std::string> json_of_form(std::string_view body, std::string_view content_type);

}  // namespace coapt
