// Files as other applications leave them, and what every store says of them.
#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "core/valve/types.h"
#include "tests/io/store/store_scene.h"

namespace coapt {

inline std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

inline void write(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// As another application would.
class Database {
 public:
  explicit Database(const std::string& path) { sqlite3_open(path.c_str(), &database_); }
  ~Database() { sqlite3_close_v2(database_); }
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  void run(const std::string& sql) const {
    ASSERT_EQ(sqlite3_exec(database_, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(database_);
  }

 private:
  sqlite3* database_ = nullptr;
};

template <class Store>
void expect_store_refused(const std::string& path, const std::string& problem) {
  const Expected<Store> store = Store::open(path);
  ASSERT_FALSE(store);
  ASSERT_EQ(store.errors().size(), 1u);
  const std::string& message = store.errors()[0].message;
  const bool is_foreign = message.find("is not a store") != std::string::npos ||
                          message.find("is a store of schema") != std::string::npos;
  EXPECT_EQ(store.errors()[0].code, is_foreign ? ErrorCode::Unsupported : ErrorCode::InputOutput);
  EXPECT_NE(store.errors()[0].message.find(path), std::string::npos) << store.errors()[0].message;
  EXPECT_NE(store.errors()[0].message.find(problem), std::string::npos)
      << store.errors()[0].message;
}

/// Refused, and the file and its folder are as before.
template <class Store>
void expect_store_refused_and_untouched(const TemporaryFolder& folder, const std::string& path,
                                        const std::string& problem) {
  const auto content = [&folder] {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
      files[entry.path()] = bytes_of(entry.path());
    return files;
  };
  const auto before = content();
  expect_store_refused<Store>(path, problem);
  EXPECT_TRUE(content() == before) << path << " was changed";
}

}  // namespace coapt
