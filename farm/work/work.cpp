#include "farm/work/work.h"

#include <gnu/libc-version.h>

#include "farm/work/import_work.h"
#include "farm/work/orifice_work.h"
#include "farm/work/plan_work.h"
#include "farm/work/population_work.h"
#include "io/json/subject.h"
#include "io/store/sha256.h"

namespace coapt {
namespace {

struct WorkKind {
  std::string_view name;
  Expected<Work> (*open)(const WorkRequest&, OrificeTables*);
};

/// Of a kind whose works share nothing.
template <Expected<Work> (*Open)(const WorkRequest&)>
Expected<Work> open_alone(const WorkRequest& request, OrificeTables* /*tables*/) {
  return Open(request);
}

constexpr WorkKind kKinds[] = {{"orifices", open_orifice_work},
                               {"plans", open_alone<open_plan_work>},
                               {"members", open_alone<open_members_work>},
                               {"records", open_alone<open_records_work>},
                               {"imports", open_alone<open_import_work>}};

// Raise it with every change of how answers are packed, or of what an answer holds besides closures.
constexpr int kAnswerRevision = 1;

Expected<Work> open_sharing(const WorkRequest& request, OrificeTables* tables) {
  if (request.parts.empty())
    return Error{ErrorCode::MissingField, "", "has no parts, must have the document at least"};
  std::string names;
  for (const WorkKind& kind : kKinds) {
    if (kind.name == request.kind) return kind.open(request, tables);
    names += (names.empty() ? "" : ", ") + std::string(kind.name);
  }
  return Error{ErrorCode::Unsupported, "",
               "kind of work is " + request.kind + ", must be one of " + names};
}

}  // namespace

Expected<Work> open_work(const WorkRequest& request) { return open_sharing(request, nullptr); }

std::function<Expected<Work>(const WorkRequest&)> make_work_opener() {
  return [tables = std::make_shared<OrificeTables>()](const WorkRequest& request) {
    return open_sharing(request, tables.get());
  };
}

std::string work_id(const WorkRequest& request) {
  std::vector<std::string> names;
  for (const std::string& part : request.parts) names.push_back(sha256(part));
  return work_id(request.kind, names);
}

std::string work_id(const std::string& kind, const std::vector<std::string>& part_names) {
  // As the farm's database makes it (work_id_of in coordinators.sql).
  std::string text = kind + '\n';
  for (std::size_t i = 0; i < part_names.size(); ++i) text += (i > 0 ? "\n" : "") + part_names[i];
  return sha256(text);
}

std::string work_revision() {
  // The compiler and the C library's mathematics decide last bits, too.
  return closures_revision() + " answers " + std::to_string(kAnswerRevision) + ", compiler " +
         __VERSION__ + ", libc " + gnu_get_libc_version();
}

}  // namespace coapt
