#include "clients/cli/ring_option.h"

#include <charconv>
#include <optional>

#include "io/command_line/files.h"
#include "io/json/ring_json.h"

namespace coapt {
namespace {

struct RingArgument {
  std::string file;
  std::optional<double> size_mm{};
};

/// What follows the last colon is a size if it is a number.
RingArgument split(const std::string& argument) {
  const std::size_t colon = argument.rfind(':');
  if (colon == std::string::npos) return {argument};
  double size = 0.0;
  const char *begin = argument.data() + colon + 1, *end = argument.data() + argument.size();
  const auto [stopped, error] = std::from_chars(begin, end, size);
  if (begin == end || stopped != end || error != std::errc()) return {argument};
  return {argument.substr(0, colon), size};
}

}  // namespace

Expected<RingDesign> read_ring_argument(const std::string& argument) {
  const std::string file = split(argument).file;
  const auto from_file = [&file](Errors errors) {
    for (Error& error : errors)
      error.message = file + ": " + error.path + (error.path.empty() ? "" : ": ") + error.message;
    for (Error& error : errors) error.path.clear();
    return errors;
  };
  const Expected<std::string> text = read_input(file);
  if (!text) return from_file(text.errors());
  const Expected<RingDesign> design = read_ring(*text);
  if (!design) return from_file(design.errors());
  return *design;
}

Expected<RepairStep> read_ring_step(const std::string& argument, const Valve* valve) {
  const Expected<RingDesign> design = read_ring_argument(argument);
  if (!design) return design.errors();
  const RingArgument ring = split(argument);
  if (ring.size_mm) return RepairStep(Annuloplasty{DesignedRing{design->shape, *ring.size_mm}});
  if (valve == nullptr)
    return Error{
        ErrorCode::MissingField, "",
        "--ring: the ring cannot be sized here because the valve is stored on the service; write " +
            argument + ":SIZE (mm)"};
  return RepairStep(sized_ring(*design, *valve));
}

}  // namespace coapt
