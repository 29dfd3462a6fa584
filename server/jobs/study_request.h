// The "study" object of a request.
#pragma once

#include "io/json/json_reader.h"
#include "io/picture/study_report.h"

namespace coapt {

struct StudyRequest {
  StudyKind kind = StudyKind::Thesis;
  ThesisStudyOptions options;
};

/// {"name", "protocols", "displacement_step_mm", "region_points", "scan_sites"}: all but the name may be left out;
/// those after it are for the studies "approximation" and "thesis" alone.
StudyRequest read_study(const JsonPlace& place);

Json to_json(const StudyRequest& request);

}  // namespace coapt
