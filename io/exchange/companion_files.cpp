#include "io/exchange/companion_files.h"

#include <algorithm>

#include "core/valve/counted.h"
#include "core/valve/problem_list.h"
#include "io/exchange/import_files.h"
#include "io/image/detached.h"
#include "io/json/json_reader.h"
#include "io/mesh/gltf.h"
#include "io/mesh/vtk_xml.h"

namespace coapt {
namespace {

constexpr std::size_t kMostPieces = 100;

/// A piece of a multi-block: its file, and what its block is called.
struct Piece {
  std::string file, name;
};

Expected<std::vector<Piece>> pieces_of(std::string_view vtm) {
  const Expected<VtkXml> document = read_vtk_xml(vtm, "vtkMultiBlockDataSet");
  if (!document) return document.errors();
  std::vector<Piece> pieces;
  std::string block;
  for (const XmlElement& element : document->elements) {
    if (element.name == "Block") block = element.attribute("name");
    if (element.name != "DataSet") continue;
    Piece piece{element.attribute("file"), element.attribute("name")};
    if (piece.name.empty()) piece.name = block;
    if (piece.file.empty()) continue;
    if (piece.file.starts_with('/') || piece.file.find("..") != std::string::npos ||
        piece.file.find('\\') != std::string::npos)
      return Error{ErrorCode::Unsupported, "",
                   "names a piece in another folder; must be in its own or below"};
    pieces.push_back(std::move(piece));
  }
  if (pieces.empty() || pieces.size() > kMostPieces)
    return Error{ErrorCode::OutOfRange, "",
                 "names " + std::to_string(pieces.size()) + " pieces, must name 1 to 100"};
  return pieces;
}

std::string_view last_part(std::string_view path) { return path.substr(path.rfind('/') + 1); }

}  // namespace

Expected<std::vector<std::string>> companions_of(const NamedFile& file) {
  std::vector<std::string> names;
  const std::string format = format_of(file.name);
  if (format == "vtm") {
    const Expected<std::vector<Piece>> pieces = pieces_of(file.bytes);
    if (!pieces) return pieces.errors();
    for (const Piece& piece : *pieces) names.push_back(piece.file);
  } else if (is_label_map_format(format)) {
    const Expected<std::optional<std::string>> data = data_file_of(file.bytes);
    if (!data) return data.errors();
    if (*data) names.push_back(**data);
  } else if (format == "gltf") {
    const Expected<std::optional<std::string>> buffer = gltf_buffer_file(file.bytes);
    if (!buffer) return buffer.errors();
    if (*buffer) names.push_back(**buffer);
  }
  return names;
}

Expected<CompleteFiles> completed(std::vector<NamedFile> files) {
  CompleteFiles complete;
  ProblemList problems;
  std::vector<bool> gone(files.size(), false);
  const auto named = [&](std::string_view name, std::size_t but) {
    std::size_t found = files.size();
    for (std::size_t i = 0; i < files.size(); ++i)
      if (i != but && last_part(files[i].name) == last_part(name)) found = i;
    return found;
  };
  const auto called = [&](std::size_t i) { return "file " + std::to_string(i + 1); };
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string path = "/files/" + std::to_string(i);
    const Expected<std::vector<std::string>> companions = companions_of(files[i]);
    if (!companions) {
      add_below(problems, path, companions.errors());
      continue;
    }
    if (companions->empty()) continue;
    std::vector<std::size_t> found;
    for (const std::string& name : *companions)
      if (const std::size_t at = named(name, i); at < files.size()) found.push_back(at);
    if (found.size() < companions->size()) {
      problems.add(ErrorCode::MissingField, path,
                   "names " + counted(companions->size() - found.size(), "other file") +
                       " not provided; provide every file together with it");
      continue;
    }
    if (format_of(files[i].name) == "vtm") {
      const std::vector<Piece> pieces = *pieces_of(files[i].bytes);
      for (std::size_t k = 0; k < pieces.size(); ++k)
        if (!pieces[k].name.empty())
          files[found[k]].name = pieces[k].name + '.' + format_of(files[found[k]].name);
      gone[i] = true;
      complete.decisions.push_back(
          {"files",
           called(i) + " (.vtm) names the contents of " + counted(pieces.size(), "other file"),
           "it is a VTK multi-block file"});
    } else {
      const bool gltf = format_of(files[i].name) == "gltf";
      files[i].bytes = gltf ? gltf_with_buffer(files[i].bytes, files[found[0]].bytes)
                            : attached(files[i].bytes, files[found[0]].bytes);
      gone[found[0]] = true;
      complete.decisions.push_back({"files",
                                    called(found[0]) +
                                        (gltf ? " holds the meshes of " : " holds the voxels of ") +
                                        called(i),
                                    "stated in its header"});
    }
  }
  if (!problems.empty()) return std::move(problems).take();
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (gone[i]) continue;
    complete.files.push_back(std::move(files[i]));
    complete.given.push_back(i);
  }
  return complete;
}

}  // namespace coapt
