#include "io/exchange/import_files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "core/valve/problem_list.h"
#include "io/exchange/chorda_trees.h"
#include "io/exchange/markups.h"

namespace coapt {
namespace {

/// Into `target`, or its problems below `pointer`.
template <class T>
void take(Expected<T> read, const std::string& pointer, ProblemList& problems, T& target) {
  if (read) {
    target = *std::move(read);
  } else {
    for (const Error& error : read.errors()) {
      const bool below = error.path.starts_with(pointer + "/");
      problems.add(error.code, below ? error.path : pointer + error.path, error.message);
    }
  }
}

}  // namespace

std::string format_of(const std::string& file_name) {
  std::string extension = std::filesystem::path(file_name).extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

Expected<Points> read_closed_loop(std::string_view text, const std::string& format) {
  if (format != "json") return read_points_csv(text);
  const Expected<std::vector<Markup>> markups = read_markups(text);
  if (!markups) return markups.errors();
  for (const Markup& markup : *markups)
    if (markup.type == MarkupType::ClosedCurve) return markup.points_mm;
  return Error{ErrorCode::MissingField, "/markups", "has no ClosedCurve"};
}

Expected<std::vector<ImportedTip>> read_tips(std::string_view text, const std::string& format) {
  if (format != "json") return read_tips_csv(text);
  const Expected<std::vector<Markup>> markups = read_markups(text);
  if (!markups) return markups.errors();
  std::vector<LabelledTip> labelled;
  for (const Markup& markup : *markups)
    for (Eigen::Index i = 0; i < markup.points_mm.rows(); ++i)
      labelled.push_back(
          {Vec3(markup.points_mm.row(i)), markup.labels[static_cast<std::size_t>(i)], {}});
  std::vector<ImportedTip> tips = imported_tips(labelled);
  if (tips.empty())
    return Error{ErrorCode::MissingField, "/markups", "has no point labelled AL or PM"};
  return tips;
}

Expected<ImportSource> read_import_files(const ImportFiles& files) {
  ImportSource source;
  ProblemList problems;
  for (std::size_t i = 0; i < files.leaflets.size(); ++i)
    take(read_mesh(files.leaflets[i].bytes, format_of(files.leaflets[i].name)),
         "/leaflets/" + std::to_string(i), problems, source.leaflets.emplace_back());
  if (files.annulus)
    take(read_closed_loop(files.annulus->bytes, format_of(files.annulus->name)), "/annulus",
         problems, source.annulus_mm);
  if (files.chordae)
    take(read_chordae(files.chordae->bytes, format_of(files.chordae->name)), "/chordae", problems,
         source.chordae);
  if (files.tips)
    take(read_tips(files.tips->bytes, format_of(files.tips->name)), "/tips", problems, source.tips);
  if (!problems.empty()) return std::move(problems).take();
  return source;
}

}  // namespace coapt
