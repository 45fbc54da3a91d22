// A disk that fails: hands everything on to another file system, but the n-th operation, or all
// from it on, go wrong.
#pragma once
#include <cerrno>
#include <functional>
#include <limits>
#include <mutex>
#include <optional>

#include "bozzetto/base/file_system.hpp"

namespace bozzetto::testing {

enum class FaultKind {
  error,       ///< fails with `number`
  shortWrite,  ///< a write takes only half of what it is given; other operations are well
  interrupted  ///< every other call, from the n-th on, is interrupted by a signal
};

struct Fault {
  FaultKind kind = FaultKind::error;
  int number = EIO;  ///< as in <cerrno>
  bool forever = false;
  std::size_t first = std::numeric_limits<std::size_t>::max();  ///< counted from 1
};

/// Files that can be told that a sync failed: what was written since the last one is lost.
class LosesUnsynced {
 public:
  virtual ~LosesUnsynced() = default;
  virtual void loseUnsynced() = 0;
};

class FaultyFileSystem : public FileSystem {
 public:
  explicit FaultyFileSystem(FileSystem& below) : below_(&below) {}

  /// Counts from 0 again, with another fault (none: a good disk).
  void start(Fault fault = {});
  std::size_t operations() const;
  /// Whether the fault has come.
  bool failed() const;

  int openOnce(const std::filesystem::path& path, OpenMode mode, Rights rights,
               std::unique_ptr<File>& file) override;
  int infoOnce(const std::filesystem::path& path, FileInfo& info) override;
  int renameOnce(const std::filesystem::path& from, const std::filesystem::path& to,
                 Existing existing) override;
  int removeOnce(const std::filesystem::path& path) override;
  int makePrivateFolderOnce(const std::filesystem::path& path) override;
  int listOnce(const std::filesystem::path& folder, std::vector<std::string>& names) override;
  int syncFolderOnce(const std::filesystem::path& folder) override;

  /// Counts one operation: 0, or the −errno it shall fail with.
  int next();
  /// Counts one write: how many of `bytes` it shall take, or −errno.
  std::int64_t nextWrite(std::size_t bytes);

 private:
  /// Counts one operation: the fault that hits it.
  std::optional<Fault> strike();

  FileSystem* below_;
  mutable std::mutex mutex_;  // a history's writer works while a test changes the disk's luck
  Fault fault_;
  std::size_t count_ = 0;
  bool failed_ = false;
};

/// Does `work` with the first operation failing, then the second, … until nothing fails any more;
/// calls `check` after each. Returns how many operations there were.
std::size_t failEveryOperation(FaultyFileSystem& files, Fault fault,
                               const std::function<void()>& work,
                               const std::function<void(std::size_t failed)>& check);

}  // namespace bozzetto::testing
