#include "bozzetto/base/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>

namespace bozzetto {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const fs::path& path, const char* what) {
  throw Error(path.string() + ": cannot " + what + ": " + std::strerror(errno));
}

// A file descriptor that closes itself; a temporary name that unlinks itself unless it was kept.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const { return fd_; }
  bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_;
};

class TemporaryName {
 public:
  explicit TemporaryName(fs::path path) : path_(std::move(path)) {}
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;
  ~TemporaryName() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  const fs::path& get() const { return path_; }
  void keep() { path_.clear(); }

 private:
  fs::path path_;
};

void writeAll(int fd, std::span<const std::byte> bytes, const fs::path& name) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(name, "write");
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

fs::path temporaryBeside(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  return fs::path(path.string() + ".tmp" + std::to_string(::getpid()) + "." +
                  std::to_string(counter++));
}

void syncFolderOf(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const Descriptor fd(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (fd.get() >= 0) ::fsync(fd.get());
}

}  // namespace

bool isStandardOutput(const fs::path& path) { return path == "-" || path == "/dev/stdout"; }

Bytes readFile(const fs::path& path, std::size_t limit) {
  const Descriptor fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (fd.get() < 0) fail(path, "open");
  struct stat info {};
  if (::fstat(fd.get(), &info) != 0) fail(path, "read");
  if (!S_ISREG(info.st_mode)) throw Error(path.string() + ": not a regular file");
  const auto size = static_cast<std::size_t>(info.st_size);
  if (size > limit) {
    throw Error(path.string() + ": " + std::to_string(size) + " bytes, at most " +
                std::to_string(limit) + " expected");
  }
  Bytes bytes(size);
  std::size_t done = 0;
  while (done < size) {
    const ssize_t got = ::read(fd.get(), bytes.data() + done, size - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path, "read");
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  bytes.resize(done);
  return bytes;
}

void writeFile(const fs::path& path, std::span<const std::byte> bytes) {
  if (isStandardOutput(path)) {
    writeAll(STDOUT_FILENO, bytes, "standard output");
    return;
  }
  TemporaryName temporary(temporaryBeside(path));
  Descriptor fd(
      ::open(temporary.get().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
  if (fd.get() < 0) fail(path, "write");
  writeAll(fd.get(), bytes, path);
  if (::fsync(fd.get()) != 0) fail(path, "sync");
  if (!fd.close()) fail(path, "write");
  if (::rename(temporary.get().c_str(), path.c_str()) != 0) fail(path, "rename into place");
  temporary.keep();
  syncFolderOf(path);
}

}  // namespace bozzetto
