#include "io/image/detached.h"

#include <algorithm>
#include <array>

#include "io/mesh/text_scan.h"

namespace coapt {
namespace {

constexpr std::size_t kMostHeader = 1 << 20;

/// The line that names the file.
struct NamingLine {
  std::size_t begin = 0, end = 0;  ///< of its bytes, the end of the line not among them
  std::string value;
};

std::optional<NamingLine> naming_line(std::string_view header, std::size_t begin = 0) {
  const bool nrrd = header.starts_with("NRRD000");
  const std::array<std::string_view, 2> keys = {nrrd ? "data file:" : "ElementDataFile",
                                                nrrd ? "datafile:" : "ElementDataFile"};
  while (begin < std::min(header.size(), kMostHeader)) {
    const std::size_t end = std::min(header.find('\n', begin), header.size());
    const std::string_view line = trimmed(header.substr(begin, end - begin));
    if (nrrd && line.empty()) return {};
    for (const std::string_view key : keys) {
      if (!line.starts_with(key)) continue;
      std::string_view value = trimmed(line.substr(key.size()));
      if (!nrrd && value.starts_with('=')) value = trimmed(value.substr(1));
      if (value == "LOCAL") return {};
      return NamingLine{begin, end, std::string(value)};
    }
    if (!nrrd && line.find('=') == std::string_view::npos) return {};
    begin = end + 1;
  }
  return {};
}

}  // namespace

Expected<std::optional<std::string>> data_file_of(std::string_view header) {
  const std::optional<NamingLine> line = naming_line(header);
  if (!line) return std::optional<std::string>();
  const std::string& name = line->value;
  if (name.empty() || name == "LIST" || name.starts_with("LIST ") ||
      name.find('%') != std::string::npos || naming_line(header, line->end + 1))
    return Error{ErrorCode::Unsupported, "",
                 "names several voxel files, must name one; save as .nrrd or .mha"};
  if (name.find_first_of("/\\") != std::string::npos)
    return Error{ErrorCode::Unsupported, "",
                 "names a voxel file in another folder, must be in the same folder"};
  return std::optional<std::string>(name);
}

std::string attached(std::string_view header, std::string_view data) {
  const NamingLine line = *naming_line(header);
  std::string file(header.substr(0, line.begin));
  if (header.starts_with("NRRD000")) {
    // The empty line that ends the header must stand right before the voxels; what a header has behind it is none of it.
    for (std::size_t begin = line.end + 1; begin < header.size();) {
      const std::size_t end = std::min(header.find('\n', begin), header.size());
      const std::string_view more = header.substr(begin, end - begin);
      if (trimmed(more).empty()) break;
      file.append(more) += '\n';
      begin = end + 1;
    }
    file += '\n';
  } else {
    file += "ElementDataFile = LOCAL\n";
  }
  return file.append(data);
}

}  // namespace coapt
