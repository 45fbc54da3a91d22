// SQLite, as far as scenes need it: every failure becomes an Error that names the file.
#pragma once
#include <sqlite3.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "bozzetto/base/bytes.hpp"
#include "scene/sqlite_files.hpp"

namespace bozzetto {

class Database {
 public:
  /// An existing file to write, through the layer that checks pages. The name is taken as it is: no
  /// URI, no ":memory:". Errors call it `name`.
  static Database forWriting(const std::filesystem::path& file, std::string name,
                             FileSystem& files = FileSystem::real(),
                             Sharing sharing = Sharing::locked);

  /// A database image in memory, read-only, which must outlive the database. Careful settings for
  /// images from strangers.
  static Database ofImage(std::span<const std::byte> image, std::string name);

  void run(const char* sql);
  /// The first column of the first row, as text; empty when there is none.
  std::string ask(const char* sql);
  sqlite3* get() const { return handle_.get(); }
  const std::string& name() const { return name_; }
  [[noreturn]] void fail(const std::string& what) const;

 private:
  struct Close {
    void operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }
  };
  Database(const char* file, int flags, std::unique_ptr<SqliteFiles> layer, std::string name);

  std::string name_;
  std::unique_ptr<SqliteFiles> layer_;  // outlives the handle
  std::unique_ptr<sqlite3, Close> handle_;
};

/// One prepared statement, used again and again. Columns and parameters count from 0.
class Statement {
 public:
  Statement(Database& database, const char* sql);

  Statement& bind(int parameter, std::int64_t number);
  Statement& bind(int parameter, std::span<const std::byte> bytes);  ///< not copied
  Statement& bind(int parameter, std::string_view text);             ///< not copied

  /// True when there is a row to read.
  bool step();
  /// Steps to the end and makes ready for the next use.
  void run();

  /// These throw Error where the column is of another kind.
  std::int64_t number(int column);
  std::span<const std::byte> bytes(int column);
  std::string text(int column);

 private:
  void requireKind(int column, int kind, const char* expected);
  struct Finalise {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  Database* database_;
  std::unique_ptr<sqlite3_stmt, Finalise> handle_;
};

}  // namespace bozzetto
