// The tables of a service's database.
#pragma once

#include "io/store/transaction.h"

namespace coapt {

StoreFormat job_format();

/// Those that files of an earlier coapt lack.
void add_tables(Transaction& change);

/// Reads nothing: a failure if a table is missing.
void look_for_tables(Transaction& reads);

}  // namespace coapt
