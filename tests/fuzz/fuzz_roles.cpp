// Names of files and what they say, files sorted by names and contents, tables and previews, all within small limits: the first byte
// chooses. Of several files each is its name and its bytes, with a zero byte behind either.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "io/exchange/file_preview.h"
#include "io/exchange/file_roles.h"
#include "io/exchange/landmark_files.h"
#include "io/exchange/part_names.h"
#include "io/mesh/import_readers.h"
#include "io/mesh/papillary_side.h"
#include "io/mesh/source_units.h"

namespace {

using namespace coapt;

constexpr std::size_t kMostFiles = 6;
constexpr MeshLimits kMost = {2000, 2000};

std::string_view up_to_zero(std::string_view& text) {
  const std::string_view part = text.substr(0, text.find('\0'));
  text.remove_prefix(std::min(text.size(), part.size() + 1));
  return part;
}

std::vector<NamedFile> files_in(std::string_view text) {
  std::vector<NamedFile> files;
  while (!text.empty() && files.size() < kMostFiles) {
    const std::string name(up_to_zero(text));
    files.push_back({name, std::string(up_to_zero(text))});
  }
  return files;
}

void sort(const std::vector<NamedFile>& files) {
  if (guessed_roles(files).size() != files.size()) std::abort();
  const Expected<SortedFiles> sorted = sorted_files(files);
  if (!sorted) return;
  for (const auto& [pointer, file] : sorted->places)
    if (file >= files.size()) std::abort();
}

void read_names(std::string_view name) {
  (void)part_named(name);
  (void)side_named(name);
  (void)annulus_side_named(name);
  (void)is_mitral(name);
  (void)is_scallop(name);
  (void)papillary_side(name);
  (void)unit_named(name);
  (void)plain_name(name);
  (void)may_have_role(std::string(name));
  (void)format_of(std::string(name));
}

void read_table(std::string_view text) {
  if (const Expected<CsvTable> table = read_csv(text, {"x", "label", "ins_x"}))
    for (const CsvRow& row : table->rows)
      for (const std::string_view field : row.fields) (void)table->number(field);
  (void)read_tips_csv(text);
  (void)read_labelled_points_csv(text);
  (void)landmarks_in(text, "csv");
}

/// Label maps have their own limits, and fuzz_image.
void preview(std::string_view text) {
  const std::string name(up_to_zero(text));
  if (is_label_map_format(format_of(name))) return;
  const FilePreview seen = preview_file({name, std::string(text)}, kMost);
  const Faces& faces = seen.faces;
  if (faces.rows() > static_cast<Index>(kMost.faces)) std::abort();
  if (faces.rows() > 0 && (faces.minCoeff() < 0 || faces.maxCoeff() >= seen.points.rows()))
    std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(bytes) + 1, size - 1);
  switch (bytes[0] % 4) {
    case 0:
      sort(files_in(text));
      break;
    case 1:
      read_names(text);
      break;
    case 2:
      read_table(text);
      break;
    default:
      preview(text);
      break;
  }
  return 0;
}
