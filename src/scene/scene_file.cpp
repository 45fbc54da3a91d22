#include "bozzetto/scene/scene_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>

#include "bozzetto/base/file.hpp"
#include "scene/database.hpp"
#include "scene/scene_read.hpp"
#include "scene/scene_write.hpp"
#include "scene/tiles.hpp"

namespace bozzetto {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const fs::path& path, const char* what) {
  throw Error(path.string() + ": cannot " + what + ": " + std::strerror(errno));
}

// A new empty file beside `path`; gone again, with SQLite's journal, unless it was put in place.
class NewFile {
 public:
  explicit NewFile(const fs::path& path) : path_(path) {
    static std::atomic<unsigned> counter{0};
    temporary_ =
        path.string() + ".tmp" + std::to_string(::getpid()) + "." + std::to_string(counter++);
    const int fd =
        ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (fd < 0) fail(path, "write");
    ::close(fd);
  }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  ~NewFile() {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
  }
  const fs::path& get() const { return temporary_; }

  void putInPlace() {
    sync(temporary_, O_WRONLY, "sync");
    removeOldJournal();
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail(path_, "rename into place");
    temporary_.clear();
    sync(path_.has_parent_path() ? path_.parent_path() : fs::path("."), O_RDONLY | O_DIRECTORY,
         nullptr);
  }

 private:
  // A journal left by a save that was cut off belongs to the file that goes now; SQLite would play
  // it into the new one. The old file gets its content back first, in case we stop in between.
  void removeOldJournal() const {
    try {
      finishInterruptedSave(path_);
    } catch (const Error&) {
    }
    ::unlink((path_.string() + "-journal").c_str());
  }

  // Without `what`, as for folders, failing is no error.
  void sync(const fs::path& name, int flags, const char* what) const {
    const int fd = ::open(name.c_str(), flags | O_CLOEXEC);
    const bool good = fd >= 0 && ::fsync(fd) == 0;
    const int reason = errno;
    if (fd >= 0) ::close(fd);
    errno = reason;
    if (!good && what != nullptr) fail(path_, what);
  }

  fs::path path_, temporary_;
};

bool samePlace(const fs::path& a, const fs::path& b) {
  return fs::absolute(a).lexically_normal() == fs::absolute(b).lexically_normal();
}

// More than half of the pages hold nothing any more: time for a new file.
bool mostlyFree(Database& database) {
  Statement free(database, "PRAGMA freelist_count"), all(database, "PRAGMA page_count");
  return free.step() && all.step() && 2 * free.number(0) > all.number(0);
}

}  // namespace

std::optional<SceneFile::FileStamp> SceneFile::stampOf(const fs::path& path) {
  struct stat info {};
  if (::lstat(path.c_str(), &info) != 0 || !S_ISREG(info.st_mode)) return std::nullopt;
  return FileStamp{info.st_dev, info.st_ino, info.st_size, info.st_mtim.tv_sec,
                   info.st_mtim.tv_nsec};
}

void SceneFile::remember(const fs::path& path, const Document& document) {
  path_ = path;
  stamp_ = stampOf(path);
  saved_ = document;
}

Document SceneFile::load(const fs::path& path, Progress& progress) {
  LoadedScene loaded = readScene(path, progress);
  rowOfTile_ = std::move(loaded.rowOfTile);
  remember(path, loaded.document);
  return std::move(loaded.document);
}

SaveReport SceneFile::saveWhole(const fs::path& path, const Document& document,
                                Progress& progress) {
  std::map<Key, std::int64_t> rows;
  NewFile file(path);
  SaveReport report;
  {
    Database database = Database::forWriting(file.get(), path.string());
    // The new file is nobody's yet: it is synced as a whole before it gets its name.
    database.run("PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF; PRAGMA locking_mode=EXCLUSIVE");
    makeTables(database);
    report = writeScene(database, document, {tilesOf(document.field.tree), true}, rows, progress);
  }
  file.putInPlace();
  rowOfTile_ = std::move(rows);
  return report;
}

SaveReport SceneFile::saveChanges(const Document& document, Progress& progress) {
  Database database = Database::forWriting(path_, path_.string());
  if (mostlyFree(database)) return saveWhole(path_, document, progress);
  database.run("PRAGMA journal_mode=DELETE; PRAGMA synchronous=FULL");
  const bool sameHead = saved_.field.scale == document.field.scale;
  const TileChanges changes{changedTiles(saved_.field.tree, document.field.tree),
                            !sameHead || !(saved_.parts == document.parts)};
  SaveReport report;
  if (!changes.written.empty() || changes.parts) {
    report = writeScene(database, document, changes, rowOfTile_, progress);
  }
  report.chunks = rowOfTile_.size();
  report.kind = SaveKind::changes;
  return report;
}

SaveReport SceneFile::save(const fs::path& path, const Document& document, Progress& progress) {
  if (isStandardOutput(path)) throw Error("a scene cannot be written to standard output");
  const bool ours = stamp_ && samePlace(path, path_) && stamp_ == stampOf(path);
  SaveReport report = ours ? saveChanges(document, progress) : saveWhole(path, document, progress);
  remember(path, document);
  if (stamp_) report.fileBytes = static_cast<std::uintmax_t>(stamp_->bytes);
  return report;
}

Document loadScene(const fs::path& path, Progress& progress) {
  return readScene(path, progress).document;
}

SaveReport saveScene(const fs::path& path, const Document& document, Progress& progress) {
  return SceneFile().save(path, document, progress);
}

std::optional<std::string> checkScene(const fs::path& path, Progress& progress) {
  try {
    readScene(path, progress);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    return error.what();
  }
  return std::nullopt;
}

}  // namespace bozzetto
