// A connection to PostgreSQL; libpq stands behind connection.cpp alone.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/valve/types.h"

struct pg_conn;
struct pg_result;

namespace coapt {

/// An argument as bytes, passed on as they are. Everything else goes as text.
struct Bytes {
  std::string_view bytes;
};
using Argument = std::variant<std::int64_t, double, std::string, Bytes>;

/// "{3,1,2}".
std::string sql_array(const std::vector<std::int64_t>& numbers);
/// @pre words of letters and digits.
std::string sql_array(const std::vector<std::string>& words);

/// What a query answered. Columns are bigint, float8, text or bytea.
class Rows {
 public:
  explicit Rows(pg_result* result);

  int count() const;
  std::int64_t number(int row, int column) const;
  std::string bytes(int row, int column) const;

 private:
  std::unique_ptr<pg_result, void (*)(pg_result*)> result_;
};

/// Errors: Busy if the same call may succeed later (the connection is lost, the database starts up, a lock took too long),
/// NoSpace likewise (disk, quota or memory of the database has no room), Unsupported for another schema, BadReference for
/// what is not there, OutOfRange for what the farm refuses, InputOutput for all else. Messages name the database, never a
/// password. From one thread at a time.
class Connection {
 public:
  /// @param url postgresql://USER@HOST/DATABASE or "host=... dbname=...". Over TCP it is encrypted unless the URL has an
  /// sslmode (or PGSSLMODE is set).
  static Expected<Connection> open(const std::string& url);

  /// With `arguments` for $1, $2, ...; planned once a connection.
  Expected<Rows> call(const std::string& sql, const std::vector<Argument>& arguments = {});
  /// Several statements as one transaction.
  Errors run(const std::string& sql);

  /// Whether calls have a chance; a broken connection comes back by reset() alone.
  bool is_open() const;
  Errors reset();

  /// "database farm at db.example, user anna".
  const std::string& where() const { return where_; }

 private:
  Connection(pg_conn* connection, std::string where);
  Error error_of(const pg_result* result) const;

  std::unique_ptr<pg_conn, void (*)(pg_conn*)> connection_;
  std::string where_;
  std::map<std::string, std::string> planned_;  ///< SQL, then the name of its plan
};

/// Whether to try again what failed so.
inline bool may_pass(const Errors& errors) {
  return !errors.empty() &&
         (errors.front().code == ErrorCode::Busy || errors.front().code == ErrorCode::NoSpace);
}

}  // namespace coapt
