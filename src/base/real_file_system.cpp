// The file interface on POSIX calls.
#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "bozzetto/base/file_system.hpp"

namespace bozzetto {
namespace fs = std::filesystem;
namespace {

template <class Result>
std::int64_t counted(Result result) {
  return result < 0 ? -errno : static_cast<std::int64_t>(result);
}

int done(int result) { return result < 0 ? -errno : 0; }

FileInfo infoOf(const struct stat& status) {
  using Kind = FileInfo::Kind;
  FileInfo info;
  info.kind = S_ISREG(status.st_mode)   ? Kind::file
              : S_ISDIR(status.st_mode) ? Kind::folder
              : S_ISLNK(status.st_mode) ? Kind::link
                                        : Kind::other;
  info.bytes = static_cast<std::uint64_t>(status.st_size);
  info.device = status.st_dev;
  info.node = status.st_ino;
  info.seconds = status.st_mtim.tv_sec;
  info.nanoseconds = status.st_mtim.tv_nsec;
  return info;
}

class RealFile : public File {
 public:
  RealFile(fs::path path, int descriptor) : File(std::move(path)), descriptor_(descriptor) {}
  ~RealFile() override { closeOnce(); }

  std::int64_t readOnce(std::uint64_t offset, std::span<std::byte> into) override {
    return counted(::pread(descriptor_, into.data(), into.size(), static_cast<off_t>(offset)));
  }
  std::int64_t writeOnce(std::uint64_t offset, std::span<const std::byte> bytes) override {
    return counted(::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset)));
  }
  int truncateOnce(std::uint64_t bytes) override {
    return done(::ftruncate(descriptor_, static_cast<off_t>(bytes)));
  }
  int syncOnce() override { return done(::fsync(descriptor_)); }
  int infoOnce(FileInfo& info) override {
    struct stat status {};
    const int result = done(::fstat(descriptor_, &status));
    if (result == 0) info = infoOf(status);
    return result;
  }
  int lockOnce() override { return done(::flock(descriptor_, LOCK_EX | LOCK_NB)); }
  int unlockOnce() override { return done(::flock(descriptor_, LOCK_UN)); }
  int closeOnce() override {
    const int descriptor = std::exchange(descriptor_, -1);
    return descriptor < 0 ? 0 : done(::close(descriptor));
  }

 private:
  int descriptor_;
};

int flagsOf(OpenMode mode) {
  switch (mode) {
    case OpenMode::read:
      return O_RDONLY | O_NOFOLLOW;
    case OpenMode::readFollowing:
      return O_RDONLY;
    case OpenMode::update:
      return O_RDWR | O_NOFOLLOW;
    case OpenMode::createNew:
      return O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW;
    case OpenMode::createOrUpdate:
      return O_RDWR | O_CREAT | O_NOFOLLOW;
  }
  return 0;
}

// Takes over a folder that is there only when it is the user's own and no link.
int ownFolder(const fs::path& path) {
  const int folder = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (folder < 0) return -errno;
  struct stat status {};
  int result = done(::fstat(folder, &status));
  if (result == 0 && status.st_uid != ::geteuid()) result = -EPERM;
  if (result == 0 && (status.st_mode & 0777) != 0700) result = done(::fchmod(folder, 0700));
  ::close(folder);
  return result;
}

class RealFileSystem : public FileSystem {
 public:
  int openOnce(const fs::path& path, OpenMode mode, Rights rights,
               std::unique_ptr<File>& file) override {
    const mode_t access = rights == Rights::ownerOnly ? 0600 : 0666;
    const int descriptor = ::open(path.c_str(), flagsOf(mode) | O_CLOEXEC | O_NONBLOCK, access);
    if (descriptor < 0) return -errno;
    auto opened = std::make_unique<RealFile>(path, descriptor);
    FileInfo info;
    if (const int result = opened->infoOnce(info); result != 0) return result;
    if (info.kind != FileInfo::Kind::file) {
      throw Error(path.string() + ": not a regular file");
    }
    file = std::move(opened);
    return 0;
  }

  int infoOnce(const fs::path& path, FileInfo& info) override {
    struct stat status {};
    const int result = done(::lstat(path.c_str(), &status));
    if (result == 0) info = infoOf(status);
    return result;
  }

  int renameOnce(const fs::path& from, const fs::path& to, Existing existing) override {
    if (existing == Existing::replace) return done(::rename(from.c_str(), to.c_str()));
    const int result =
        done(::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE));
    if (result != -EINVAL && result != -ENOSYS) return result;
    // Where the file system knows no such renaming: a second name, then the first one goes.
    if (::link(from.c_str(), to.c_str()) != 0) return -errno;
    return done(::unlink(from.c_str()));
  }

  int removeOnce(const fs::path& path) override {
    const int result = done(::unlink(path.c_str()));
    return result == -EISDIR ? done(::rmdir(path.c_str())) : result;
  }

  int makePrivateFolderOnce(const fs::path& path) override {
    const int result = done(::mkdir(path.c_str(), 0700));
    return result == -EEXIST ? ownFolder(path) : result;
  }

  int listOnce(const fs::path& folder, std::vector<std::string>& names) override {
    DIR* stream = ::opendir(folder.c_str());
    if (stream == nullptr) return -errno;
    errno = 0;
    while (const dirent* entry = ::readdir(stream)) {
      const std::string name = entry->d_name;
      if (name != "." && name != "..") names.push_back(name);
    }
    const int result = -errno;
    ::closedir(stream);
    return result;
  }

  int syncFolderOnce(const fs::path& path) override {
    const int folder = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return -errno;
    const int result = done(::fsync(folder));
    ::close(folder);
    return result;
  }
};

}  // namespace

FileSystem& FileSystem::real() {
  static RealFileSystem system;
  return system;
}

}  // namespace bozzetto
