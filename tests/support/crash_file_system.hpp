// A disk in memory that remembers every operation, so that a test can cut the power after any of
// them and look at whatever the disk may hold then.
#pragma once
#include <map>
#include <mutex>
#include <random>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/base/file_system.hpp"
#include "support/faulty_file_system.hpp"

namespace bozzetto::testing {

/// What becomes of operations that no sync made durable. Durable: writes to a file before a sync of
/// it that did well; names in a folder before a sync of the folder.
struct Survival {
  enum class Kind {
    none,    ///< nothing of them
    all,     ///< as if the disk had no cache
    sizes,   ///< names and lengths, but zeros where the bytes should be
    random,  ///< each by chance: whole, torn at sectors, or not; writes in any order
  };
  Kind kind = Kind::none;
  std::uint32_t seed = 0;
  std::size_t sector = 512;  ///< bytes; a sector is old or new, never half
};

/// Folders must be there, as on a real disk; "/" is. Safe to use from several threads.
class CrashFileSystem : public FileSystem {
 public:
  CrashFileSystem() = default;

  /// Operations so far that changed anything.
  std::size_t operations() const;
  /// The disk as it may be found after the first `count` operations and a power cut.
  std::unique_ptr<CrashFileSystem> afterPowerCut(std::size_t count, const Survival& how) const;
  /// What was done, one line each.
  std::vector<std::string> trace() const;

  /// Reads and writes whole files past the log: no operation of the program under test.
  Bytes content(const std::filesystem::path& path) const;
  void setContent(const std::filesystem::path& path, Bytes bytes);
  void addFolder(const std::filesystem::path& path);

  int openOnce(const std::filesystem::path& path, OpenMode mode, Rights rights,
               std::unique_ptr<File>& file) override;
  int infoOnce(const std::filesystem::path& path, FileInfo& info) override;
  int renameOnce(const std::filesystem::path& from, const std::filesystem::path& to,
                 Existing existing) override;
  int removeOnce(const std::filesystem::path& path) override;
  int makePrivateFolderOnce(const std::filesystem::path& path) override;
  int listOnce(const std::filesystem::path& folder, std::vector<std::string>& names) override;
  int syncFolderOnce(const std::filesystem::path& folder) override;

 private:
  friend class CrashFile;
  struct Node {
    Bytes bytes;
    bool folder = false;
    const File* lockedBy = nullptr;
    std::int64_t changed = 0;
  };
  using NodeId = std::size_t;
  /// One change of the disk.
  struct Operation {
    enum class Kind { create, write, truncate, sync, lose, rename, remove, syncFolder };
    Kind kind;
    std::string name, to;      ///< create, rename, remove, syncFolder
    NodeId node = 0;           ///< create, write, truncate, sync, lose
    std::uint64_t offset = 0;  ///< write; truncate: the new length
    Bytes bytes;               ///< write
    bool folder = false;       ///< create
  };
  /// Names and what they stand for.
  struct Disk {
    std::map<std::string, NodeId> names{{"/", 0}};
    std::map<NodeId, Node> nodes{{0, {{}, true, nullptr, 0}}};
    void apply(const Operation& operation);
  };
  enum class Fate : unsigned char { pending, durable, lost };
  std::vector<Fate> fates(std::size_t count) const;
  static void survive(Disk& disk, const std::vector<const Operation*>& pending,
                      const Survival& how);

  int record(Operation operation);
  Node* find(const std::string& name);
  int make(const std::string& name, bool folder);

  mutable std::mutex mutex_;
  Disk start_, now_;
  std::vector<Operation> log_;
  NodeId nextNode_ = 1;
  std::int64_t clock_ = 0;
};

}  // namespace bozzetto::testing
