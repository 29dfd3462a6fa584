// Which subjects of a store were used last, and the removal of those that nobody has used for long.
//
// A subject's closures go together: what is left of a subject is all of it, unless the process dies meanwhile, and
// closures that are missing are only made again. The places of removed rows are used again; the file itself does not
// shrink.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <set>
#include <string>

#include "io/store/transaction.h"

namespace coapt {

/// What stays of the closures in a store.
struct ClosureLimits {
  std::int64_t closures = std::numeric_limits<std::int64_t>::max();  ///< in all
  double days = 0.0;  ///< since a subject was used; 0: without limit
};

/// Subjects whose closures stay whatever the limits say: asked for only if something is to go.
using SubjectsInUse = std::function<Expected<std::set<std::string>>()>;

/// How a store holds its subjects. SQL; ?1 is a subject's name.
struct SubjectTables {
  const char* subjects;  ///< rows: the names of all of them
  const char* count;     ///< a row: closures of a subject
  const char* remove;    ///< some ten thousand of its closures, or what is left of them
  const char* forget;    ///< what is left of a subject without closures; may be empty
  const char* tidy;      ///< what no closure refers to any more; may be empty
};

/// Makes the table that the functions below need, if it is not there: in files of an earlier coapt, too.
Errors add_uses(const StoreDatabase& database);

/// The subject was used now, after all others; its closures are counted. Failures as of every Transaction.
Errors note_use(StoreConnection& store, const SubjectTables& tables, const std::string& subject,
                std::int64_t now_ms);

/// Removes whole subjects, the one used least recently first, until the limits hold or only those in use are left. A
/// subject that was never noted counts as used before all that were, and its age as from now. `in_use` may fail: then
/// nothing is removed.
Errors retain_subjects(StoreConnection& store, const SubjectTables& tables,
                       const ClosureLimits& limits, const SubjectsInUse& in_use,
                       std::int64_t now_ms);

}  // namespace coapt
