#include "farm/database/connection.h"

#include <libpq-fe.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>
#include <initializer_list>
#include <type_traits>
#include <utility>

#include "core/valve/number_text.h"

namespace coapt {
namespace {

// A query for which nobody answers (a cable that was pulled) ends so; what the kernel gives up by itself takes hours.
constexpr const char* kConnectTimeout_s = "10";
constexpr const char* kTcpTimeout_ms = "30000";
// A lock that somebody holds longer is worth another try, not a worker that hangs.
constexpr const char* kSession = "SET lock_timeout = '20s'; SET client_min_messages = warning";

std::string one_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

bool starts_with(std::string_view state, std::initializer_list<std::string_view> classes) {
  return std::any_of(classes.begin(), classes.end(),
                     [&](std::string_view begin) { return state.starts_with(begin); });
}

/// Of an SQLSTATE (PostgreSQL's appendix A); CF... are raised by the farm's own functions.
ErrorCode code_of(std::string_view state) {
  if (starts_with(state, {"53"})) return ErrorCode::NoSpace;
  // Connections, conflicts of transactions, locks, and a database that is stopped or starts up.
  if (state.empty() || starts_with(state, {"08", "40", "55P03", "57P"})) return ErrorCode::Busy;
  if (starts_with(state, {"CF001"})) return ErrorCode::BadReference;
  if (starts_with(state, {"CF"})) return ErrorCode::OutOfRange;
  if (starts_with(state, {"3F000", "42883", "42P01"})) return ErrorCode::Unsupported;
  return ErrorCode::InputOutput;
}

std::string where_of(const PGconn* connection) {
  const auto word = [](const char* text) { return std::string(text == nullptr ? "" : text); };
  const std::string host = word(PQhost(connection)), port = word(PQport(connection));
  return "database " + word(PQdb(connection)) + " at " + host +
         (port.empty() || port == "5432" ? "" : ":" + port) + ", user " + word(PQuser(connection));
}

std::uint64_t big_endian(const char* bytes) {
  std::uint64_t number = 0;
  for (int i = 0; i < 8; ++i) number = number << 8 | static_cast<unsigned char>(bytes[i]);
  return number;
}

template <class T>
std::string array_text(const std::vector<T>& elements) {
  std::string text = "{";
  for (const T& element : elements) {
    if (text.size() > 1) text += ',';
    if constexpr (std::is_same_v<T, std::string>)
      text += element;
    else
      text += std::to_string(element);
  }
  return text + '}';
}

using ResultHandle = std::unique_ptr<pg_result, void (*)(pg_result*)>;

/// Arguments as libpq takes them; bytes are not copied.
struct Sent {
  explicit Sent(const std::vector<Argument>& arguments) {
    texts.reserve(arguments.size());
    for (const Argument& argument : arguments) {
      const auto* const raw = std::get_if<Bytes>(&argument);
      if (raw == nullptr) texts.push_back(text_of(argument));
      // Not a null pointer, which would be NULL.
      values.push_back(raw == nullptr       ? texts.back().c_str()
                       : raw->bytes.empty() ? ""
                                            : raw->bytes.data());
      lengths.push_back(raw == nullptr ? 0 : static_cast<int>(raw->bytes.size()));
      formats.push_back(raw == nullptr ? 0 : 1);
    }
  }
  Sent(const Sent&) = delete;
  Sent& operator=(const Sent&) = delete;
  int count() const { return static_cast<int>(values.size()); }

  static std::string text_of(const Argument& argument) {
    if (const auto* number = std::get_if<std::int64_t>(&argument)) return std::to_string(*number);
    if (const auto* real = std::get_if<double>(&argument)) return significant(*real, 17);
    return std::get<std::string>(argument);
  }

  std::vector<std::string> texts;
  std::vector<const char*> values;
  std::vector<int> lengths, formats;
};

}  // namespace

std::string sql_array(const std::vector<std::int64_t>& numbers) { return array_text(numbers); }
std::string sql_array(const std::vector<std::string>& words) { return array_text(words); }

Rows::Rows(pg_result* result) : result_(result, PQclear) {}

int Rows::count() const { return PQntuples(result_.get()); }

std::int64_t Rows::number(int row, int column) const {
  assert(PQgetlength(result_.get(), row, column) == 8);
  return static_cast<std::int64_t>(big_endian(PQgetvalue(result_.get(), row, column)));
}

std::string Rows::bytes(int row, int column) const {
  return {PQgetvalue(result_.get(), row, column),
          static_cast<std::size_t>(PQgetlength(result_.get(), row, column))};
}

Connection::Connection(pg_conn* connection, std::string where)
    : connection_(connection, PQfinish), where_(std::move(where)) {}

Expected<Connection> Connection::open(const std::string& url) {
  char* complaint = nullptr;
  PQconninfoOption* const read = PQconninfoParse(url.c_str(), &complaint);
  PQfreemem(complaint);  // may hold the password
  if (read == nullptr)
    return Error{ErrorCode::OutOfRange, "",
                 "is not a database address; must be like "
                 "postgresql://user@host/database or postgresql:///database?host=/run/postgresql"};
  PQconninfoFree(read);
  // What stands before the URL is taken where the URL does not say otherwise; sockets of Unix need no encryption and ignore it.
  const char* const sslmode = std::getenv("PGSSLMODE") == nullptr ? "require" : nullptr;
  const std::array<const char*, 7> names = {"connect_timeout",
                                            "tcp_user_timeout",
                                            "fallback_application_name",
                                            "sslmode",
                                            "dbname",
                                            "client_encoding",
                                            nullptr};
  const std::array<const char*, 7> values = {
      kConnectTimeout_s, kTcpTimeout_ms, "coapt-farm", sslmode, url.c_str(), "UTF8", nullptr};
  constexpr int kReadUrl = 1;
  Connection made(PQconnectdbParams(names.data(), values.data(), kReadUrl), "");
  if (made.connection_ == nullptr) return Error{ErrorCode::NoSpace, "", "no memory to connect"};
  made.where_ = where_of(made.connection_.get());
  if (!made.is_open()) return made.error_of(nullptr);
  if (Errors errors = made.run(kSession); !errors.empty()) return errors;
  return made;
}

bool Connection::is_open() const { return PQstatus(connection_.get()) == CONNECTION_OK; }

Errors Connection::reset() {
  planned_.clear();
  PQreset(connection_.get());
  if (!is_open()) return {error_of(nullptr)};
  return run(kSession);
}

Expected<Rows> Connection::call(const std::string& sql, const std::vector<Argument>& arguments) {
  if (!is_open()) return error_of(nullptr);
  const Sent sent(arguments);
  std::string& name = planned_[sql];
  if (name.empty()) {
    const ResultHandle planned(
        PQprepare(connection_.get(), ("call" + std::to_string(planned_.size())).c_str(),
                  sql.c_str(), sent.count(), nullptr),
        PQclear);
    if (PQresultStatus(planned.get()) != PGRES_COMMAND_OK) {
      planned_.erase(sql);
      return error_of(planned.get());
    }
    name = "call" + std::to_string(planned_.size());
  }
  constexpr int kBinary = 1;
  ResultHandle answer(
      PQexecPrepared(connection_.get(), name.c_str(), sent.count(), sent.values.data(),
                     sent.lengths.data(), sent.formats.data(), kBinary),
      PQclear);
  const ExecStatusType status = PQresultStatus(answer.get());
  if (status != PGRES_TUPLES_OK && status != PGRES_COMMAND_OK) return error_of(answer.get());
  return Rows(answer.release());
}

Errors Connection::run(const std::string& sql) {
  if (!is_open()) return {error_of(nullptr)};
  const ResultHandle answer(PQexec(connection_.get(), sql.c_str()), PQclear);
  const ExecStatusType status = PQresultStatus(answer.get());
  if (status != PGRES_TUPLES_OK && status != PGRES_COMMAND_OK) return {error_of(answer.get())};
  return {};
}

Error Connection::error_of(const pg_result* result) const {
  const char* const state =
      result == nullptr ? nullptr : PQresultErrorField(result, PG_DIAG_SQLSTATE);
  const char* const primary =
      result == nullptr ? nullptr : PQresultErrorField(result, PG_DIAG_MESSAGE_PRIMARY);
  const ErrorCode code = is_open() ? code_of(state == nullptr ? "" : state) : ErrorCode::Busy;
  if (code == ErrorCode::Unsupported)
    return {code, "", where_ + ": has no farm of this version; create one with coapt-farm init"};
  return {
      code, "",
      where_ + ": " + one_line(primary == nullptr ? PQerrorMessage(connection_.get()) : primary)};
}

}  // namespace coapt
