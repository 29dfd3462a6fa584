// A study as files: tables, figures, and the sections of its page.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "io/json/json.h"
#include "io/picture/study_page.h"
#include "search/studies/thesis_study.h"

namespace coapt {

/// The studies of chapter 4 of the thesis; Thesis is all of them.
enum class StudyKind { Annulus, Papillary, Ring, Approximation, Thesis };
const char* to_string(StudyKind kind);  ///< "annulus", ...
inline constexpr std::array kStudyKinds = {StudyKind::Annulus, StudyKind::Papillary,
                                           StudyKind::Ring, StudyKind::Approximation,
                                           StudyKind::Thesis};

ThesisStudyOptions default_options(StudyKind kind);

struct StudyReport {
  std::vector<std::pair<std::string, std::string>> files;  ///< name, content
  std::vector<Finding> findings;
  std::vector<PageSection> figures;
};

/// Closes what the table does not know.
StudyReport run_study(StudyKind kind, OrificeTable& table, const ThesisStudyOptions& options);

/// How many configurations were closed in what time, a sentence or two.
/// @param study what complete() returns
std::string study_timing(const Json& study);

/// Adds study.json, findings.json and index.html. Returns what study.json holds, and besides "closures_known" and "seconds",
/// which are of this run alone: no file depends on them.
Json complete(StudyReport& report, StudyKind kind, OrificeTable& table, double seconds);

}  // namespace coapt
