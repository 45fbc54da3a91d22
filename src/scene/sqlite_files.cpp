#include "scene/sqlite_files.hpp"

#include <array>
#include <atomic>
#include <cstring>
#include <new>

#include "scene/page_check.hpp"

namespace bozzetto {
namespace {

// SQLite gives the memory for this and calls no constructor.
struct OpenFile {
  sqlite3_file base;
  File* file;
  SqliteFiles* layer;
  bool database;
  bool nameToSync;  // a new journal, whose name is not on the disk before its folder is synced
};

OpenFile& of(sqlite3_file* file) { return *reinterpret_cast<OpenFile*>(file); }

std::span<std::byte> view(void* bytes, int count) {
  return {static_cast<std::byte*>(bytes), static_cast<std::size_t>(count)};
}

// Does something with files; what it throws becomes an SQLite code.
template <class Work>
int guarded(SqliteFiles& layer, int code, const Work& work) {
  try {
    return work();
  } catch (const FileError& error) {
    layer.remember(error);
    return error.fault() == FileFault::full || error.fault() == FileFault::tooLarge ? SQLITE_FULL
                                                                                    : code;
  } catch (const std::bad_alloc&) {
    return SQLITE_NOMEM;
  } catch (...) {
    return code;
  }
}

int closeFile(sqlite3_file* handle) {
  OpenFile& open = of(handle);
  const std::unique_ptr<File> file(open.file);
  open.file = nullptr;
  return guarded(*open.layer, SQLITE_IOERR_CLOSE, [&] {
    file->close();
    return SQLITE_OK;
  });
}

int readFile(sqlite3_file* handle, void* into, int count, sqlite3_int64 offset) {
  OpenFile& open = of(handle);
  return guarded(*open.layer, SQLITE_IOERR_READ, [&] {
    const auto bytes = view(into, count);
    const std::size_t got = open.file->read(static_cast<std::uint64_t>(offset), bytes);
    if (got == bytes.size()) return SQLITE_OK;
    std::memset(bytes.data() + got, 0, bytes.size() - got);
    return SQLITE_IOERR_SHORT_READ;
  });
}

int writeFile(sqlite3_file* handle, const void* from, int count, sqlite3_int64 offset) {
  OpenFile& open = of(handle);
  return guarded(*open.layer, SQLITE_IOERR_WRITE, [&] {
    const auto place = static_cast<std::uint64_t>(offset);
    const std::span bytes(static_cast<const std::byte*>(from), static_cast<std::size_t>(count));
    if (open.database && bytes.size() == kPageBytes && place % kPageBytes == 0) {
      std::array<std::byte, kPageBytes> page;
      std::copy(bytes.begin(), bytes.end(), page.begin());
      sealPage(page, place / kPageBytes + 1);
      open.file->write(place, page);
    } else {
      open.file->write(place, bytes);
    }
    return SQLITE_OK;
  });
}

int truncateFile(sqlite3_file* handle, sqlite3_int64 size) {
  OpenFile& open = of(handle);
  return guarded(*open.layer, SQLITE_IOERR_TRUNCATE, [&] {
    open.file->truncate(static_cast<std::uint64_t>(size));
    return SQLITE_OK;
  });
}

int syncFile(sqlite3_file* handle, int) {
  OpenFile& open = of(handle);
  return guarded(*open.layer, SQLITE_IOERR_FSYNC, [&] {
    open.file->sync();
    if (open.nameToSync) open.layer->files().syncFolder(folderOf(open.file->path()));
    open.nameToSync = false;
    return SQLITE_OK;
  });
}

int sizeOfFile(sqlite3_file* handle, sqlite3_int64* size) {
  OpenFile& open = of(handle);
  return guarded(*open.layer, SQLITE_IOERR_FSTAT, [&] {
    *size = static_cast<sqlite3_int64>(open.file->info().bytes);
    return SQLITE_OK;
  });
}

// Any of SQLite's locks is the one lock we have: nobody but us reads or writes through SQLite.
int lockFile(sqlite3_file* handle, int) {
  OpenFile& open = of(handle);
  if (open.layer->sharing() == Sharing::nobodyElse) return SQLITE_OK;
  return guarded(*open.layer, SQLITE_IOERR_LOCK,
                 [&] { return open.file->tryLock() ? SQLITE_OK : SQLITE_BUSY; });
}

int unlockFile(sqlite3_file* handle, int level) {
  OpenFile& open = of(handle);
  if (open.layer->sharing() == Sharing::nobodyElse || level != SQLITE_LOCK_NONE) return SQLITE_OK;
  return guarded(*open.layer, SQLITE_IOERR_UNLOCK, [&] {
    open.file->unlock();
    return SQLITE_OK;
  });
}

int nobodyHasReserved(sqlite3_file*, int* reserved) {
  *reserved = 0;
  return SQLITE_OK;
}

int noControl(sqlite3_file*, int, void*) { return SQLITE_NOTFOUND; }
int sectorSize(sqlite3_file*) { return 4096; }
int noPromises(sqlite3_file*) { return 0; }

// Version 1: no shared memory and no mapping, hence no write-ahead log behind our back.
const sqlite3_io_methods kMethods{
    .iVersion = 1,
    .xClose = closeFile,
    .xRead = readFile,
    .xWrite = writeFile,
    .xTruncate = truncateFile,
    .xSync = syncFile,
    .xFileSize = sizeOfFile,
    .xLock = lockFile,
    .xUnlock = unlockFile,
    .xCheckReservedLock = nobodyHasReserved,
    .xFileControl = noControl,
    .xSectorSize = sectorSize,
    .xDeviceCharacteristics = noPromises,
    .xShmMap = nullptr,
    .xShmLock = nullptr,
    .xShmBarrier = nullptr,
    .xShmUnmap = nullptr,
    .xFetch = nullptr,
    .xUnfetch = nullptr,
};

SqliteFiles& layerOf(sqlite3_vfs* layer) { return *static_cast<SqliteFiles*>(layer->pAppData); }

// Only databases that are there, and their journals; temporary files stay in memory.
int openFile(sqlite3_vfs* vfs, const char* name, sqlite3_file* handle, int flags, int* outFlags) {
  OpenFile& open = of(handle);
  open = {{nullptr}, nullptr, &layerOf(vfs), (flags & SQLITE_OPEN_MAIN_DB) != 0, false};
  const bool journal = (flags & SQLITE_OPEN_MAIN_JOURNAL) != 0;
  if (name == nullptr || (!open.database && !journal)) return SQLITE_CANTOPEN;
  return guarded(*open.layer, SQLITE_CANTOPEN, [&] {
    const bool create = journal && (flags & SQLITE_OPEN_CREATE) != 0;
    const bool update = (flags & SQLITE_OPEN_READWRITE) != 0;
    const OpenMode mode = create   ? OpenMode::createOrUpdate
                          : update ? OpenMode::update
                                   : OpenMode::read;
    open.file = open.layer->files().open(name, mode).release();
    open.nameToSync = create;
    open.base.pMethods = &kMethods;
    if (outFlags != nullptr) *outFlags = flags;
    return SQLITE_OK;
  });
}

int removeFile(sqlite3_vfs* vfs, const char* name, int syncFolder) {
  SqliteFiles& layer = layerOf(vfs);
  return guarded(layer, SQLITE_IOERR_DELETE, [&] {
    if (!layer.files().remove(name)) return SQLITE_IOERR_DELETE_NOENT;
    if (syncFolder != 0) layer.files().syncFolder(folderOf(name));
    return SQLITE_OK;
  });
}

// As SQLite's own layer: a file without content does not exist.
int isThere(sqlite3_vfs* vfs, const char* name, int, int* result) {
  SqliteFiles& layer = layerOf(vfs);
  return guarded(layer, SQLITE_IOERR_ACCESS, [&] {
    const auto info = layer.files().info(name);
    *result = info && info->bytes > 0;
    return SQLITE_OK;
  });
}

int fullName(sqlite3_vfs*, const char* name, int room, char* full) {
  if (std::strlen(name) >= static_cast<std::size_t>(room)) return SQLITE_CANTOPEN;
  std::strcpy(full, name);
  return SQLITE_OK;
}

std::string newName() {
  static std::atomic<unsigned> counter{0};
  return "bozzetto-" + std::to_string(counter++);
}

}  // namespace

SqliteFiles::SqliteFiles(FileSystem& files, Sharing sharing)
    : files_(&files), sharing_(sharing), name_(newName()) {
  sqlite3_initialize();
  // Clock, sleep and randomness are the machine's.
  layer_ = *sqlite3_vfs_find(nullptr);
  layer_.iVersion = 2;
  layer_.pNext = nullptr;
  layer_.zName = name_.c_str();
  layer_.szOsFile = sizeof(OpenFile);
  layer_.pAppData = this;
  layer_.xOpen = openFile;
  layer_.xDelete = removeFile;
  layer_.xAccess = isThere;
  layer_.xFullPathname = fullName;
  sqlite3_vfs_register(&layer_, 0);
}

SqliteFiles::~SqliteFiles() { sqlite3_vfs_unregister(&layer_); }

}  // namespace bozzetto
