// A work request as bytes: a file, and what goes through the pipe to coapt-farm.
//
//   coapt.work/1 KIND PARTS
//   SIZE of the first part, then its bytes; and so on.
#pragma once

#include <string>
#include <string_view>

#include "farm/work/work.h"

namespace coapt {

/// @pre the kind is a word.
std::string write_work(const WorkRequest& request);

/// The form alone is read. Errors have no path.
Expected<WorkRequest> read_work(std::string_view bytes);

}  // namespace coapt
