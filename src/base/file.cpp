#include "bozzetto/base/file.hpp"

#include <unistd.h>

#include <atomic>
#include <cerrno>

namespace bozzetto {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kTemporaryStart = ".bozzetto-", kTemporaryEnd = ".tmp";

// Short whatever the real name, which may have all 255 bytes that names can have.
fs::path temporaryIn(const fs::path& folder) {
  static std::atomic<unsigned> counter{0};
  return folder / (std::string(kTemporaryStart) + std::to_string(::getpid()) + "-" +
                   std::to_string(counter++) + std::string(kTemporaryEnd));
}

bool isTemporary(std::string_view name) {
  return name.starts_with(kTemporaryStart) && name.ends_with(kTemporaryEnd);
}

void writeToStandardOutput(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw FileError("standard output", "write", errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

}  // namespace

bool isStandardOutput(const fs::path& path) { return path == "-" || path == "/dev/stdout"; }

Bytes readFile(const fs::path& path, std::size_t limit, FileSystem& files) {
  const auto file = files.open(path, OpenMode::readFollowing);
  const std::uint64_t size = file->info().bytes;
  if (size > limit) {
    throw Error(path.string() + ": " + std::to_string(size) + " bytes, at most " +
                std::to_string(limit) + " expected");
  }
  Bytes bytes(static_cast<std::size_t>(size));
  bytes.resize(file->read(0, bytes));
  return bytes;
}

void writeFile(const fs::path& path, std::span<const std::byte> bytes, FileSystem& files) {
  if (isStandardOutput(path)) return writeToStandardOutput(bytes);
  NewFile file(path, files);
  file.file().write(0, bytes);
  file.putInPlace();
}

NewFile::NewFile(fs::path path, FileSystem& files, Nameless)
    : files_(&files), path_(std::move(path)) {}

// Delegates, so that the destructor tidies up when this fails half way.
NewFile::NewFile(fs::path path, FileSystem& files) : NewFile(std::move(path), files, Nameless{}) {
  // Again where another program has the name, or just took ours for a leftover.
  while (!file_ || !file_->tryLock() || files.info(temporary_) != file_->info()) {
    temporary_ = temporaryIn(folderOf(path_));
    try {
      file_ = files.open(temporary_, OpenMode::createNew);
      file_->callIt(path_);
    } catch (const FileError& error) {
      temporary_.clear();
      if (error.fault() != FileFault::exists) throw FileError(path_, "write", error.number());
    }
  }
}

NewFile::~NewFile() {
  if (file_) file_->closeOnce();
  if (!temporary_.empty()) files_->removeOnce(temporary_);
}

void NewFile::putInPlace(Existing existing) { putInPlaceAs(path_, existing); }

void NewFile::putInPlaceAs(const fs::path& path, Existing existing) {
  file_->sync();
  file_->close();
  files_->rename(temporary_, path, existing);
  temporary_.clear();
  files_->syncFolder(folderOf(path));
}

void removeLeftovers(const fs::path& folder, FileSystem& files) {
  for (const std::string& name : files.list(folder)) {
    if (!isTemporary(name)) continue;
    try {
      if (files.open(folder / name, OpenMode::update)->tryLock()) files.remove(folder / name);
    } catch (const Error&) {
    }
  }
}

}  // namespace bozzetto
