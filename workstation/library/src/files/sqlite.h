#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace ew::sqlite {

/// What a failure of SQLite means for whoever keeps a cache in it.
enum class Trouble {
  damaged,      ///< not a data base, or a broken one
  notWritable,  ///< read-only, full, no such folder
  other         ///< busy for too long, no memory, a statement that is wrong
};

/// Thrown within the library alone: the functions of an index catch it.
struct Failed final : std::runtime_error {
  Failed(Trouble what, const std::string& why) : std::runtime_error(why), trouble(what) {}
  Trouble trouble;
};

class Database;

/// A prepared statement, used again and again. Values are bound from 1 on in the order of the calls.
class Statement {
 public:
  Statement(Database& database, std::string_view sql);
  /// Forgets the bound values; the next bind is the first.
  Statement& again();
  Statement& bind(std::int64_t value);
  Statement& bind(int value) { return bind(static_cast<std::int64_t>(value)); }
  Statement& bind(std::string_view text);
  Statement& bind(const char* text) { return bind(std::string_view(text)); }
  Statement& bind(const std::optional<int>& value);
  /// @return whether there is a row
  bool step();
  /// For statements without rows.
  void run();
  [[nodiscard]] std::int64_t number(int column) const;
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] bool isNull(int column) const;

 private:
  void check(int code) const;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  Database* database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  int bound_ = 0;
};

/// One connection. Waits up to five seconds for others.
class Database {
 public:
  /// @param file empty: in memory
  explicit Database(const std::filesystem::path& file);
  void run(const char* sql);
  [[nodiscard]] sqlite3* handle() const { return handle_.get(); }

 private:
  struct Close {
    void operator()(sqlite3* handle) const;
  };
  std::unique_ptr<sqlite3, Close> handle_;
};

/// Undoes what was not committed.
class Transaction {
 public:
  explicit Transaction(Database& database) : database_(database) { database_.run("BEGIN IMMEDIATE"); }
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool isOpen_ = true;
};

}  // namespace ew::sqlite
