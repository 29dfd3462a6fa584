#pragma once

#include <string>
#include <vector>

#include "search/population/population_study.h"

namespace coapt {

/// A row per member and candidate that it was offered, with what an echo shows of the member.
std::string population_records_csv(const std::vector<PopulationRecord>& records);
/// A row per group and number: "group,table,row,count,of,value,low,high".
std::string population_findings_csv(const PopulationStudy& study);

}  // namespace coapt
