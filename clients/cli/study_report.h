// A study as files: tables, figures, and the sections of its page.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "io/picture/study_page.h"

namespace coapt {

struct StudyReport {
  std::vector<std::pair<std::string, std::string>> files;  ///< name, content
  std::vector<Finding> findings;
  std::vector<PageSection> figures;
};

/// Add files and figures; findings are the caller's.
void add_to_report(StudyReport& report, const AnnulusStudy& study);
void add_to_report(StudyReport& report, const PapillaryStudy& study);
void add_to_report(StudyReport& report, const RingStudy& study);
void add_to_report(StudyReport& report, const AnchorStudies& studies);

}  // namespace coapt
