// SQLite's view of the file interface: what it reads and writes goes through a FileSystem, and
// every database page gets its checksum on the way.
#pragma once
#include <sqlite3.h>

#include <optional>
#include <string>

#include "bozzetto/base/file_system.hpp"

namespace bozzetto {

/// Whether others may have the file open. A file under a temporary name needs no locks.
enum class Sharing { locked, nobodyElse };

/// One SQLite file layer (VFS), registered as long as it lives.
class SqliteFiles {
 public:
  SqliteFiles(FileSystem& files, Sharing sharing);
  ~SqliteFiles();
  SqliteFiles(const SqliteFiles&) = delete;
  SqliteFiles& operator=(const SqliteFiles&) = delete;

  const char* name() const { return name_.c_str(); }
  FileSystem& files() const { return *files_; }
  Sharing sharing() const { return sharing_; }

  /// What the disk said last, which SQLite's own messages leave out.
  const std::optional<FileError>& fault() const { return fault_; }
  void remember(const FileError& fault) { fault_ = fault; }

 private:
  FileSystem* files_;
  Sharing sharing_;
  std::string name_;
  std::optional<FileError> fault_;
  sqlite3_vfs layer_{};
};

}  // namespace bozzetto
