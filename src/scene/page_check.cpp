#include "scene/page_check.hpp"

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <mutex>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/base/hash.hpp"
#include "bozzetto/base/parallel.hpp"

namespace bozzetto {
namespace {

constexpr std::size_t kContentBytes = kPageBytes - kPageCheckBytes;

// Over the page's content and its number (from 1), so that exchanged pages show.
std::uint64_t pageCheck(std::span<const std::byte> page, std::uint64_t number) {
  ByteWriter numbered;
  numbered.put(number);
  Hasher hasher;
  hasher.add(page.first(kContentBytes));
  hasher.add(numbered.bytes());
  return hasher.result();
}

bool holds(std::span<const std::byte> page, std::size_t number) {
  ByteReader check(page.subspan(kContentBytes));
  if (check.get<std::uint64_t>() == pageCheck(page, number)) return true;
  return std::all_of(page.begin(), page.end(), [](std::byte b) { return b == std::byte{0}; });
}

// An SQLite file: this, then the file of the layer below.
struct CheckedFile {
  sqlite3_file base;
  bool database;
};

sqlite3_vfs* below = nullptr;

sqlite3_file* real(sqlite3_file* file) {
  return reinterpret_cast<sqlite3_file*>(reinterpret_cast<CheckedFile*>(file) + 1);
}

template <auto Method>
struct Forward;
template <class... Args, int (*sqlite3_io_methods::*Method)(sqlite3_file*, Args...)>
struct Forward<Method> {
  static int call(sqlite3_file* file, Args... args) {
    return (real(file)->pMethods->*Method)(real(file), args...);
  }
};

int writeChecked(sqlite3_file* file, const void* bytes, int count, sqlite3_int64 offset) {
  const bool page = reinterpret_cast<CheckedFile*>(file)->database &&
                    count == static_cast<int>(kPageBytes) && offset % kPageBytes == 0;
  if (!page) return real(file)->pMethods->xWrite(real(file), bytes, count, offset);
  std::array<std::byte, kPageBytes> copy;
  std::memcpy(copy.data(), bytes, kPageBytes);
  ByteWriter check;
  check.put(pageCheck(copy, static_cast<std::uint64_t>(offset) / kPageBytes + 1));
  std::copy(check.bytes().begin(), check.bytes().end(), copy.begin() + kContentBytes);
  return real(file)->pMethods->xWrite(real(file), copy.data(), count, offset);
}

// Version 1: no shared memory and no mapping, hence no write-ahead log behind our back.
const sqlite3_io_methods kMethods{
    .iVersion = 1,
    .xClose = Forward<&sqlite3_io_methods::xClose>::call,
    .xRead = Forward<&sqlite3_io_methods::xRead>::call,
    .xWrite = writeChecked,
    .xTruncate = Forward<&sqlite3_io_methods::xTruncate>::call,
    .xSync = Forward<&sqlite3_io_methods::xSync>::call,
    .xFileSize = Forward<&sqlite3_io_methods::xFileSize>::call,
    .xLock = Forward<&sqlite3_io_methods::xLock>::call,
    .xUnlock = Forward<&sqlite3_io_methods::xUnlock>::call,
    .xCheckReservedLock = Forward<&sqlite3_io_methods::xCheckReservedLock>::call,
    .xFileControl = Forward<&sqlite3_io_methods::xFileControl>::call,
    .xSectorSize = Forward<&sqlite3_io_methods::xSectorSize>::call,
    .xDeviceCharacteristics = Forward<&sqlite3_io_methods::xDeviceCharacteristics>::call,
    .xShmMap = nullptr,
    .xShmLock = nullptr,
    .xShmBarrier = nullptr,
    .xShmUnmap = nullptr,
    .xFetch = nullptr,
    .xUnfetch = nullptr,
};

int openChecked(sqlite3_vfs*, const char* name, sqlite3_file* file, int flags, int* outFlags) {
  auto* checked = reinterpret_cast<CheckedFile*>(file);
  checked->database = (flags & SQLITE_OPEN_MAIN_DB) != 0;
  checked->base.pMethods = nullptr;
  const int result = below->xOpen(below, name, real(file), flags, outFlags);
  if (real(file)->pMethods != nullptr) checked->base.pMethods = &kMethods;
  return result;
}

}  // namespace

const char* pageCheckLayer() {
  static constexpr const char* kName = "bozzetto";
  static std::once_flag once;
  std::call_once(once, [] {
    sqlite3_initialize();
    below = sqlite3_vfs_find(nullptr);
    static sqlite3_vfs layer = *below;
    layer.pNext = nullptr;
    layer.zName = kName;
    layer.szOsFile = static_cast<int>(sizeof(CheckedFile)) + below->szOsFile;
    layer.xOpen = openChecked;
    sqlite3_vfs_register(&layer, 0);
  });
  return kName;
}

std::optional<std::size_t> firstBadPage(std::span<const std::byte> file) {
  const std::size_t pages = file.size() / kPageBytes;
  std::atomic<std::size_t> first{pages};
  parallelFor(pages, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      if (holds(file.subspan(n * kPageBytes, kPageBytes), n + 1)) continue;
      for (std::size_t least = first; n < least && !first.compare_exchange_weak(least, n);) {
      }
      return;
    }
  });
  return first == pages ? std::nullopt : std::optional(first + 1);
}

}  // namespace bozzetto
