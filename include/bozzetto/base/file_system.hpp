// All that the program does with files, in one small interface: what must not be lost is written
// through it, so that tests can fail every single operation and cut the power after any of them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bozzetto/base/error.hpp"

namespace bozzetto {

enum class FileFault { missing, exists, full, tooLarge, denied, io, unsupported, other };

/// An operation on a file failed. The text names the file, what was tried and the system's reason.
class FileError : public Error {
 public:
  /// `number` as in <cerrno>.
  FileError(const std::filesystem::path& path, const std::string& tried, int number);
  FileFault fault() const;
  const std::string& tried() const { return tried_; }  ///< "write", "sync" …
  int number() const { return number_; }

 private:
  std::string tried_;
  int number_;
};

struct FileInfo {
  enum class Kind { file, folder, link, other };
  Kind kind = Kind::file;
  std::uint64_t bytes = 0;
  std::uint64_t device = 0, node = 0;         ///< together: which file it is, whatever its name
  std::int64_t seconds = 0, nanoseconds = 0;  ///< of the last change
  friend bool operator==(const FileInfo&, const FileInfo&) = default;
};

enum class OpenMode {
  read,           ///< a symbolic link at the name is refused
  readFollowing,  ///< for names that people give: links are followed
  update,         ///< an existing file, to read and write; no link
  createNew,      ///< to read and write; an error when anything has the name
  createOrUpdate  ///< to read and write; no link
};

/// Who may read a file or folder that is made.
enum class Rights { usual, ownerOnly };

/// An open regular file; closed with the object. Bytes have places, there is no current position.
/// Not for use by several threads at once. Everything throws FileError.
class File {
 public:
  explicit File(std::filesystem::path path) : path_(std::move(path)) {}
  virtual ~File() = default;
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// What errors shall call it: the name it will have one day.
  void callIt(std::filesystem::path path) { path_ = std::move(path); }
  /// Bytes read: less than asked for only at the end of the file.
  std::size_t read(std::uint64_t offset, std::span<std::byte> into);
  /// All of them; beyond the end the file grows.
  void write(std::uint64_t offset, std::span<const std::byte> bytes);
  void truncate(std::uint64_t bytes);
  /// Returns when all is on the disk. After an error what was written since the last sync must be
  /// taken for lost, whatever a later sync says: write it anew, into another file.
  void sync();
  FileInfo info();
  /// Nobody else has this file locked from now on until unlock, close or the process's end, however
  /// that comes. False when somebody has. Locks bind only those who ask.
  bool tryLock();
  void unlock();
  /// To hear of errors that come late. The destructor does not tell.
  void close();

  /// What an implementation provides: one system call each, a count (or 0) or −errno.
  virtual std::int64_t readOnce(std::uint64_t offset, std::span<std::byte> into) = 0;
  virtual std::int64_t writeOnce(std::uint64_t offset, std::span<const std::byte> bytes) = 0;
  virtual int truncateOnce(std::uint64_t bytes) = 0;
  virtual int syncOnce() = 0;
  virtual int infoOnce(FileInfo& info) = 0;
  virtual int lockOnce() = 0;
  virtual int unlockOnce() = 0;
  virtual int closeOnce() = 0;

 private:
  std::filesystem::path path_;
};

/// What stands where a file is to be renamed to.
enum class Existing { replace, refuse };

class FileSystem {
 public:
  virtual ~FileSystem() = default;
  /// The machine's.
  static FileSystem& real();

  /// Never blocks; refuses what is not a regular file.
  std::unique_ptr<File> open(const std::filesystem::path& path, OpenMode mode,
                             Rights rights = Rights::usual);
  /// Of the name itself, not of what a link points to; nothing when there is none.
  std::optional<FileInfo> info(const std::filesystem::path& path);
  /// At once: everybody sees the old or the new. Durable after syncFolder.
  void rename(const std::filesystem::path& from, const std::filesystem::path& to,
              Existing existing = Existing::replace);
  /// False when there was none. A folder must be empty.
  bool remove(const std::filesystem::path& path);
  /// A folder for its owner only. One that is there is taken over when it is the user's own and no
  /// link; others lose their access to it.
  void makePrivateFolder(const std::filesystem::path& path);
  /// Names in a folder, in alphabetical order, without "." and "..".
  std::vector<std::string> list(const std::filesystem::path& folder);
  /// Makes durable which names a folder has. File systems that cannot are taken at their word.
  void syncFolder(const std::filesystem::path& folder);

  /// What an implementation provides: one operation each, 0 or −errno.
  virtual int openOnce(const std::filesystem::path& path, OpenMode mode, Rights rights,
                       std::unique_ptr<File>& file) = 0;
  virtual int infoOnce(const std::filesystem::path& path, FileInfo& info) = 0;
  virtual int renameOnce(const std::filesystem::path& from, const std::filesystem::path& to,
                         Existing existing) = 0;
  virtual int removeOnce(const std::filesystem::path& path) = 0;
  virtual int makePrivateFolderOnce(const std::filesystem::path& path) = 0;
  virtual int listOnce(const std::filesystem::path& folder, std::vector<std::string>& names) = 0;
  virtual int syncFolderOnce(const std::filesystem::path& folder) = 0;
};

/// The folder a file stands in; "." for a bare name.
std::filesystem::path folderOf(const std::filesystem::path& file);

/// Holds a lock file as long as it lives. The file stays where it is: what counts is who has it
/// open and locked, so a lock whose owner died, killed or not, is free.
class FileLock {
 public:
  /// Nothing when somebody else holds it. The file is made when there is none, for its owner only.
  static std::optional<FileLock> tryTake(const std::filesystem::path& path,
                                         FileSystem& files = FileSystem::real());

 private:
  explicit FileLock(std::unique_ptr<File> file) : file_(std::move(file)) {}
  std::unique_ptr<File> file_;
};

}  // namespace bozzetto
