// Imports with nothing touched, closed and planned.
//
// Kind "imports": part 0 {"imports": [{"name": valve, "slicerheart": they are such a folder's, "files": [{"name": file, "part": its bytes}, ...]},
// ...], "seed": S, "evaluations": N}.
// An item is one import; its answer two texts, each behind its 64-bit length: its row, and the valve (empty: it was refused).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "farm/work/work.h"
#include "operations/import_request.h"

namespace coapt {

struct ImportTrial {
  int seed = 1;         ///< of chordae that files lack
  int evaluations = 0;  ///< of the search for a plan of each valve that closes; 0: none
};

struct ImportCase {
  std::string name;  ///< of the valve
  std::vector<NamedFile> files;
  bool slicerheart = false;  ///< they are those of such a folder; else their parts are detected
};

/// As large as the files of a command line may be.
ImportRequest as_request(ImportCase one, int seed);

WorkRequest imports_request(const std::vector<ImportCase>& cases, const ImportTrial& trial);
Expected<Work> open_import_work(const WorkRequest& request);

/// How far an import goes, in this order.
inline constexpr const char* kImportStages[] = {"refused", "imported", "closed", "planned"};

struct ImportOutcome {
  Json
      row;  ///< "stage", "reason" it went no further, "looks": sentences; "leak_mm2" if it closed, "plan_leak_mm2" if it has a plan
  std::string valve;  ///< coapt.valve/1; empty: none
};
/// Errors: bytes that are no outcomes.
Expected<std::vector<ImportOutcome>> import_outcomes(std::string_view bytes);

}  // namespace coapt
