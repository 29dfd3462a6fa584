// Studies as tables: CSV with a header line, numbers with six digits, empty where there is none.
#pragma once

#include <string>
#include <vector>

#include "search/studies/anchor_question.h"
#include "search/studies/generality.h"
#include "search/studies/model_study.h"

namespace coapt {

/// Rows of a page's table, the first its header.
std::string table_csv(const std::vector<std::vector<std::string>>& rows);
std::string annulus_csv(const AnnulusStudy& study);      ///< a row per height and dilation
std::string papillary_csv(const PapillaryStudy& study);  ///< a row per displacement, with gradient
std::string ring_csv(const RingStudy& study);            ///< a row per ring and displacement
/// A row per displaced configuration and anchor.
std::string approximation_csv(const std::vector<ApproximationStudy>& studies);
std::string anchors_csv(const std::vector<AnchorSummary>& summaries);
/// A row per anatomy, protocol, class and anchor.
std::string anchor_scan_csv(const std::vector<ScannedAnatomy>& scan);
std::string anchor_answers_csv(const std::vector<AnchorAnswer>& answers);
std::string generality_csv(const std::vector<ValveFindings>& studied);
std::string finding_shares_csv(const std::vector<FindingShare>& shares);
std::string model_draws_csv(const ModelStudy& study);  ///< a row per draw, with its factors

}  // namespace coapt
