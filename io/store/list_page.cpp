#include "io/store/list_page.h"

#include <sqlite3.h>

#include <limits>

namespace coapt {

std::int64_t upper_end(std::int64_t before) {
  return before == 0 ? std::numeric_limits<std::int64_t>::max() : before;
}

std::int64_t read_page(Transaction& reads, const std::string& sql, std::vector<SqlValue> values,
                       int size, const Transaction::OnRow& take) {
  values.emplace_back(std::int64_t{size} + 1);  // the last tells whether there are more
  int taken = 0;
  std::int64_t last = 0, next = 0;
  reads.run(sql + " ORDER BY number DESC LIMIT ?", values, [&](const Statement& row) {
    if (++taken > size) {
      next = last;
      return;
    }
    last = sqlite3_column_int64(row.get(), 0);
    take(row);
  });
  return next;
}

}  // namespace coapt
