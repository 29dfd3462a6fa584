#include "io/store/transaction.h"

#include <sqlite3.h>

namespace coapt {
namespace {

void bind(sqlite3_stmt* statement, int parameter, const SqlValue& value) {
  if (const auto* const integer = std::get_if<std::int64_t>(&value)) {
    sqlite3_bind_int64(statement, parameter, *integer);
  } else if (const auto* const number = std::get_if<double>(&value)) {
    sqlite3_bind_double(statement, parameter, *number);
  } else if (const auto* const text = std::get_if<std::string_view>(&value)) {
    sqlite3_bind_text64(statement, parameter, text->data(), text->size(), SQLITE_STATIC,
                        SQLITE_UTF8);
  } else if (const auto* const blob = std::get_if<Blob>(&value)) {
    sqlite3_bind_blob64(statement, parameter, blob->bytes.data(), blob->bytes.size(),
                        SQLITE_STATIC);
  }  // else it stays NULL
}

/// Then what is written would go with this process.
bool has_moved(const StoreDatabase& database) {
  const Statement any = database.prepare("BEGIN");
  int moved = 0;
  if (any)
    sqlite3_file_control(sqlite3_db_handle(any.get()), "main", SQLITE_FCNTL_HAS_MOVED, &moved);
  return moved != 0;
}

}  // namespace

Transaction::Transaction(StoreConnection& connection, Kind kind, std::string problem)
    : database_(connection.database), lock_(connection.mutex), problem_(std::move(problem)) {
  if (kind == Kind::Write && has_moved(database_))
    refuse(ErrorCode::InputOutput,
           database_.file() + ": " + problem_ +
               ": the file has been moved away or removed since it was opened");
  run(kind == Kind::Write ? "BEGIN IMMEDIATE" : "BEGIN");
}

Transaction::~Transaction() {
  // A full disk may have rolled it back already. If this fails, too, the next BEGIN says so.
  if (database_.in_transaction()) sqlite3_step(database_.prepare("ROLLBACK").get());
}

void Transaction::run(const std::string& sql, const std::vector<SqlValue>& values,
                      const OnRow& on_row) {
  if (has_failed()) return;
  const Statement statement = database_.prepare(sql.c_str());
  int step = SQLITE_ERROR;
  if (statement) {
    int parameter = 0;
    for (const SqlValue& value : values) bind(statement.get(), ++parameter, value);
    while ((step = sqlite3_step(statement.get())) == SQLITE_ROW)
      if (on_row) on_row(statement);
  }
  if (step != SQLITE_DONE) errors_.push_back(database_.failure(problem_));
}

int Transaction::changed() const { return has_failed() ? 0 : database_.changed(); }

void Transaction::refuse(ErrorCode code, const std::string& message) {
  if (!has_failed()) errors_.push_back({code, "", message});
}

Errors Transaction::end() {
  run("COMMIT");
  return errors_;
}

Expected<std::optional<std::string>> bytes_of(Transaction reads, const std::string& sql,
                                              const std::vector<SqlValue>& values) {
  std::optional<std::string> bytes;
  reads.run(sql, values, [&bytes](const Statement& row) { bytes = bytes_at(row, 0); });
  return reads.end_with(std::move(bytes));
}

}  // namespace coapt
