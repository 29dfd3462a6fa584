// A transaction of a connection that several threads share: the one place where statements are bound,
// stepped and given up.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "io/store/database.h"

namespace coapt {

struct StoreConnection {
  explicit StoreConnection(StoreDatabase opened) : database(std::move(opened)) {}

  StoreDatabase database;
  std::mutex mutex;  ///< held by a Transaction
};

struct Blob {
  std::string_view bytes;
};
/// For a parameter of a statement; texts and blobs with every byte.
using SqlValue = std::variant<std::nullptr_t, std::int64_t, double, std::string_view, Blob>;

/// Statements that hold together or not at all. After a failure the others are passed over, so that
/// only the end needs to ask.
class Transaction {
 public:
  enum class Kind {
    Read,  ///< all of one state of the file
    Write  ///< from its beginning the only one that writes: waits for others
  };
  using OnRow = std::function<void(const Statement& row)>;

  /// Waits for the connection. @param problem for messages: "a job cannot be kept"
  Transaction(StoreConnection& connection, Kind kind, std::string problem);
  /// Rolls back what was not ended.
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  void run(const std::string& sql, const std::vector<SqlValue>& values = {},
           const OnRow& on_row = {});

  /// Rows that the last statement changed; 0 after a failure.
  int changed() const;

  /// A failure that the caller sees.
  void refuse(ErrorCode code, const std::string& message);

  bool has_failed() const { return !errors_.empty(); }

  /// Commits if nothing failed. Why it is not kept, or nothing.
  Errors end();

  template <class T>
  Expected<T> end_with(T value) {
    if (Errors errors = end(); !errors.empty()) return errors;
    return value;
  }

 private:
  const StoreDatabase& database_;
  std::lock_guard<std::mutex> lock_;
  std::string problem_;
  Errors errors_;
};

/// The first column of the row that `sql` finds; none if it finds no row.
Expected<std::optional<std::string>> bytes_of(Transaction reads, const std::string& sql,
                                              const std::vector<SqlValue>& values);

}  // namespace coapt
