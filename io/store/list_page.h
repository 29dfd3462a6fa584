#pragma once

#include <string>
#include <vector>

#include "io/store/transaction.h"

namespace coapt {

/// The number below which a page's rows are: @param before of the first one left out; 0: none
std::int64_t upper_end(std::int64_t before);

/// Rows of a list, the first column its number: `size` of them go to `take`, newest first. Where the next page starts; 0: nowhere.
/// @param sql up to its WHERE clause
std::int64_t read_page(Transaction& reads, const std::string& sql, std::vector<SqlValue> values,
                       int size, const Transaction::OnRow& take);

}  // namespace coapt
