#include "scene/database.hpp"

namespace bozzetto {

Database::Database(const char* file, int flags, std::unique_ptr<SqliteFiles> layer,
                   std::string name)
    : name_(std::move(name)), layer_(std::move(layer)) {
  sqlite3* opened = nullptr;
  const int result = sqlite3_open_v2(file, &opened, flags | SQLITE_OPEN_NOMUTEX,
                                     layer_ ? layer_->name() : nullptr);
  handle_.reset(opened);
  if (result != SQLITE_OK) fail("open");
  sqlite3_extended_result_codes(get(), 1);
}

Database Database::forWriting(const std::filesystem::path& file, std::string name,
                              FileSystem& files, Sharing sharing) {
  // An absolute name starts with a slash and can be nothing but a file.
  const std::string absolute = std::filesystem::absolute(file).string();
  Database database(absolute.c_str(), SQLITE_OPEN_READWRITE,
                    std::make_unique<SqliteFiles>(files, sharing), std::move(name));
  sqlite3_busy_timeout(database.get(), 2000);
  database.run("PRAGMA trusted_schema=OFF; PRAGMA mmap_size=0; PRAGMA temp_store=MEMORY");
  return database;
}

Database Database::ofImage(std::span<const std::byte> image, std::string name) {
  Database database(":memory:", SQLITE_OPEN_READWRITE, nullptr, std::move(name));
  const auto size = static_cast<sqlite3_int64>(image.size());
  auto* bytes = reinterpret_cast<unsigned char*>(const_cast<std::byte*>(image.data()));
  const int result =
      sqlite3_deserialize(database.get(), "main", bytes, size, size, SQLITE_DESERIALIZE_READONLY);
  if (result != SQLITE_OK) database.fail("read");
  database.run("PRAGMA trusted_schema=OFF; PRAGMA cell_size_check=ON");
  return database;
}

void Database::fail(const std::string& what) const {
  const char* reason = handle_ ? sqlite3_errmsg(get()) : "out of memory";
  const int code = handle_ ? sqlite3_errcode(get()) & 0xff : SQLITE_NOMEM;
  const bool disk = code == SQLITE_IOERR || code == SQLITE_FULL || code == SQLITE_CANTOPEN;
  // The disk's own words say more than SQLite's.
  if (disk && layer_ && layer_->fault()) {
    throw FileError(name_, layer_->fault()->tried(), layer_->fault()->number());
  }
  throw Error(name_ + ": cannot " + what + ": " + reason);
}

void Database::run(const char* sql) {
  if (sqlite3_exec(get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail("work with it");
}

std::string Database::ask(const char* sql) {
  Statement statement(*this, sql);
  return statement.step() ? statement.text(0) : std::string();
}

Statement::Statement(Database& database, const char* sql) : database_(&database) {
  sqlite3_stmt* prepared = nullptr;
  if (sqlite3_prepare_v2(database.get(), sql, -1, &prepared, nullptr) != SQLITE_OK) {
    database.fail("work with it");
  }
  handle_.reset(prepared);
}

Statement& Statement::bind(int parameter, std::int64_t number) {
  sqlite3_bind_int64(handle_.get(), parameter + 1, number);
  return *this;
}

Statement& Statement::bind(int parameter, std::span<const std::byte> bytes) {
  // An empty span may be a null pointer, which would be NULL.
  if (bytes.empty()) {
    sqlite3_bind_zeroblob(handle_.get(), parameter + 1, 0);
  } else if (sqlite3_bind_blob64(handle_.get(), parameter + 1, bytes.data(), bytes.size(),
                                 SQLITE_STATIC) != SQLITE_OK) {
    database_->fail("store " + std::to_string(bytes.size()) + " bytes in it");
  }
  return *this;
}

Statement& Statement::bind(int parameter, std::string_view text) {
  sqlite3_bind_text(handle_.get(), parameter + 1, text.data(), static_cast<int>(text.size()),
                    SQLITE_STATIC);
  return *this;
}

bool Statement::step() {
  const int result = sqlite3_step(handle_.get());
  if (result == SQLITE_ROW) return true;
  if (result != SQLITE_DONE) database_->fail("work with it");
  return false;
}

void Statement::run() {
  while (step()) {
  }
  sqlite3_reset(handle_.get());
}

void Statement::requireKind(int column, int kind, const char* expected) {
  if (sqlite3_column_type(handle_.get(), column) == kind) return;
  throw Error(database_->name() + ": \"" + sqlite3_sql(handle_.get()) + "\", column " +
              std::to_string(column) + ": " + expected + " expected");
}

std::int64_t Statement::number(int column) {
  requireKind(column, SQLITE_INTEGER, "a number");
  return sqlite3_column_int64(handle_.get(), column);
}

std::span<const std::byte> Statement::bytes(int column) {
  requireKind(column, SQLITE_BLOB, "a blob");
  const auto* data = static_cast<const std::byte*>(sqlite3_column_blob(handle_.get(), column));
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column));
  if (data == nullptr && size > 0) throw std::bad_alloc();
  return {data, size};
}

std::string Statement::text(int column) {
  requireKind(column, SQLITE_TEXT, "text");
  const auto* data = sqlite3_column_text(handle_.get(), column);
  if (data == nullptr) throw std::bad_alloc();
  return {reinterpret_cast<const char*>(data),
          static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column))};
}

}  // namespace bozzetto
