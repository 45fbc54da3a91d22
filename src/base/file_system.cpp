#include "bozzetto/base/file_system.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace bozzetto {
namespace fs = std::filesystem;
namespace {

// Repeats what a signal interrupted; anything else that failed is told by name.
template <class Call>
auto must(const fs::path& path, const char* what, const Call& call) {
  for (;;) {
    const auto result = call();
    if (result >= 0) return result;
    if (result != -EINTR) throw FileError(path, what, static_cast<int>(-result));
  }
}

}  // namespace

FileError::FileError(const fs::path& path, const std::string& tried, int number)
    : Error(path.string() + ": cannot " + tried + ": " + std::strerror(number)),
      tried_(tried),
      number_(number) {}

FileFault FileError::fault() const {
  switch (number_) {
    case ENOENT:
    case ENOTDIR:
      return FileFault::missing;
    case EEXIST:
    case ENOTEMPTY:
      return FileFault::exists;
    case ENOSPC:
    case EDQUOT:
      return FileFault::full;
    case EFBIG:
      return FileFault::tooLarge;
    case EACCES:
    case EPERM:
    case EROFS:
      return FileFault::denied;
    case EIO:
      return FileFault::io;
    case EINVAL:
    case ENOTSUP:
      return FileFault::unsupported;
    default:
      return FileFault::other;
  }
}

std::size_t File::read(std::uint64_t offset, std::span<std::byte> into) {
  std::size_t done = 0;
  while (done < into.size()) {
    const auto got =
        must(path_, "read", [&] { return readOnce(offset + done, into.subspan(done)); });
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

void File::write(std::uint64_t offset, std::span<const std::byte> bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const auto put =
        must(path_, "write", [&] { return writeOnce(offset + done, bytes.subspan(done)); });
    if (put == 0) throw FileError(path_, "write", ENOSPC);
    done += static_cast<std::size_t>(put);
  }
}

void File::truncate(std::uint64_t bytes) {
  must(path_, "change its length", [&] { return truncateOnce(bytes); });
}

void File::sync() {
  must(path_, "sync", [&] { return syncOnce(); });
}

FileInfo File::info() {
  FileInfo info;
  must(path_, "look at it", [&] { return infoOnce(info); });
  return info;
}

bool File::tryLock() {
  return must(path_, "lock", [&] {
           const int result = lockOnce();
           return result == -EWOULDBLOCK ? 1 : result;
         }) == 0;
}

void File::unlock() {
  must(path_, "unlock", [&] { return unlockOnce(); });
}

void File::close() {
  // An interrupted close has closed: to repeat it could close somebody else's file.
  const int result = closeOnce();
  if (result < 0 && result != -EINTR) throw FileError(path_, "close", -result);
}

std::unique_ptr<File> FileSystem::open(const fs::path& path, OpenMode mode, Rights rights) {
  const bool reads = mode == OpenMode::read || mode == OpenMode::readFollowing;
  std::unique_ptr<File> file;
  must(path, reads ? "open" : "write", [&] { return openOnce(path, mode, rights, file); });
  return file;
}

std::optional<FileInfo> FileSystem::info(const fs::path& path) {
  FileInfo info;
  const int result = must(path, "look at it", [&] {
    const int code = infoOnce(path, info);
    // A name that is too long is nobody's.
    return code == -ENOENT || code == -ENOTDIR || code == -ENAMETOOLONG ? 1 : code;
  });
  return result == 0 ? std::optional(info) : std::nullopt;
}

void FileSystem::rename(const fs::path& from, const fs::path& to, Existing existing) {
  must(to, "rename into place", [&] { return renameOnce(from, to, existing); });
}

bool FileSystem::remove(const fs::path& path) {
  return must(path, "remove", [&] {
           const int code = removeOnce(path);
           return code == -ENOENT ? 1 : code;
         }) == 0;
}

void FileSystem::makePrivateFolder(const fs::path& path) {
  must(path, "make a folder for its owner only", [&] { return makePrivateFolderOnce(path); });
}

std::vector<std::string> FileSystem::list(const fs::path& folder) {
  std::vector<std::string> names;
  must(folder, "list", [&] {
    names.clear();
    return listOnce(folder, names);
  });
  std::sort(names.begin(), names.end());
  return names;
}

void FileSystem::syncFolder(const fs::path& folder) {
  must(folder, "sync", [&] {
    const int code = syncFolderOnce(folder);
    return code == -EINVAL || code == -ENOTSUP || code == -EACCES ? 0 : code;
  });
}

fs::path folderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

std::optional<FileLock> FileLock::tryTake(const fs::path& path, FileSystem& files) {
  auto file = files.open(path, OpenMode::createOrUpdate, Rights::ownerOnly);
  if (!file->tryLock()) return std::nullopt;
  return FileLock(std::move(file));
}

}  // namespace bozzetto
