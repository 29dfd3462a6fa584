// Which part of a valve a file holds, guessed from its name and from what is in it. The page guesses by the same names
// (clients/web/src/valve/parts.ts).
#pragma once

#include "io/exchange/import_files.h"

namespace coapt {

enum class FileRole { Labels, Anterior, Posterior, Annulus, Chordae, Tips, Landmarks, None };

/// Whether a file with such a name or path is one that can be a part of a valve (and says not whose it is, as LICENSE.txt does), named by one (.vtm, .raw), or a model of one (.inp).
bool may_have_role(const std::string& name);

struct GuessedRole {
  FileRole role = FileRole::None;
  std::string reason;
};

/// For each file. Label maps by extension; markups and tables by what they hold; meshes by name, several of one leaflet if
/// they are its scallops; of two without names leaflet_order.h tells which is which; one alone holds both (Anterior).
std::vector<GuessedRole> guessed_roles(const std::vector<NamedFile>& files);

struct SortedFiles {
  ImportFiles files;
  std::vector<ImportDecision>
      decisions;  ///< "file 2 of 3 (.stl) is ...": no names, which may be a person's
  std::vector<std::pair<std::string, std::size_t>>
      places;  ///< pointer into ImportFiles, index of the file
};

/// Errors at "/files/I": a role that nothing tells, two files of one role.
Expected<SortedFiles> sorted_files(std::vector<NamedFile> files);

}  // namespace coapt
