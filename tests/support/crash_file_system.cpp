#include "support/crash_file_system.hpp"

#include <algorithm>
#include <cassert>
#include <cerrno>

namespace bozzetto::testing {
namespace fs = std::filesystem;
namespace {

std::string nameOf(const fs::path& path) { return fs::absolute(path).lexically_normal().string(); }
std::string folderName(const std::string& name) { return fs::path(name).parent_path().string(); }

void putBytes(Bytes& file, std::uint64_t offset, std::span<const std::byte> bytes) {
  if (file.size() < offset + bytes.size()) file.resize(offset + bytes.size());
  std::copy(bytes.begin(), bytes.end(), file.begin() + static_cast<std::ptrdiff_t>(offset));
}

}  // namespace

class CrashFile : public File, public LosesUnsynced {
 public:
  using Kind = CrashFileSystem::Operation::Kind;
  CrashFile(fs::path path, CrashFileSystem& files, std::size_t node)
      : File(std::move(path)), files_(&files), node_(node) {}
  ~CrashFile() override { closeOnce(); }

  std::int64_t readOnce(std::uint64_t offset, std::span<std::byte> into) override {
    const std::lock_guard lock(files_->mutex_);
    const Bytes& bytes = here().bytes;
    if (offset >= bytes.size()) return 0;
    const std::size_t count = std::min<std::size_t>(into.size(), bytes.size() - offset);
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(offset), count, into.begin());
    return static_cast<std::int64_t>(count);
  }
  std::int64_t writeOnce(std::uint64_t offset, std::span<const std::byte> bytes) override {
    record({Kind::write, "", "", node_, offset, {bytes.begin(), bytes.end()}, false});
    return static_cast<std::int64_t>(bytes.size());
  }
  int truncateOnce(std::uint64_t bytes) override {
    return record({Kind::truncate, "", "", node_, bytes, {}, false});
  }
  int syncOnce() override { return record({Kind::sync, "", "", node_, 0, {}, false}); }
  void loseUnsynced() override { record({Kind::lose, "", "", node_, 0, {}, false}); }

  int infoOnce(FileInfo& info) override {
    const std::lock_guard lock(files_->mutex_);
    info = {FileInfo::Kind::file, here().bytes.size(), 1, node_, here().changed, 0};
    return 0;
  }
  int lockOnce() override {
    const std::lock_guard lock(files_->mutex_);
    if (here().lockedBy != nullptr && here().lockedBy != this) return -EWOULDBLOCK;
    here().lockedBy = this;
    return 0;
  }
  int unlockOnce() override {
    const std::lock_guard lock(files_->mutex_);
    if (here().lockedBy == this) here().lockedBy = nullptr;
    return 0;
  }
  int closeOnce() override { return unlockOnce(); }

 private:
  CrashFileSystem::Node& here() { return files_->now_.nodes.at(node_); }
  int record(CrashFileSystem::Operation operation) {
    operation.name = path().string();
    const std::lock_guard lock(files_->mutex_);
    return files_->record(std::move(operation));
  }

  CrashFileSystem* files_;
  std::size_t node_;
};

void CrashFileSystem::Disk::apply(const Operation& operation) {
  using Kind = Operation::Kind;
  switch (operation.kind) {
    case Kind::create:
      nodes[operation.node].folder = operation.folder;
      names[operation.name] = operation.node;
      break;
    case Kind::write:
      putBytes(nodes[operation.node].bytes, operation.offset, operation.bytes);
      break;
    case Kind::truncate:
      nodes[operation.node].bytes.resize(operation.offset);
      break;
    case Kind::rename:
      names.erase(operation.name);
      names[operation.to] = operation.node;
      break;
    case Kind::remove:
      names.erase(operation.name);
      break;
    case Kind::sync:
    case Kind::lose:
    case Kind::syncFolder:
      break;
  }
}

int CrashFileSystem::record(Operation operation) {
  now_.apply(operation);
  if (operation.kind == Operation::Kind::write || operation.kind == Operation::Kind::truncate) {
    now_.nodes[operation.node].changed = ++clock_;
  }
  log_.push_back(std::move(operation));
  return 0;
}

CrashFileSystem::Node* CrashFileSystem::find(const std::string& name) {
  const auto found = now_.names.find(name);
  return found == now_.names.end() ? nullptr : &now_.nodes.at(found->second);
}

int CrashFileSystem::make(const std::string& name, bool folder) {
  const Node* parent = find(folderName(name));
  if (parent == nullptr) return -ENOENT;
  if (!parent->folder) return -ENOTDIR;
  return record({Operation::Kind::create, name, "", nextNode_++, 0, {}, folder});
}

int CrashFileSystem::openOnce(const fs::path& path, OpenMode mode, Rights,
                              std::unique_ptr<File>& file) {
  const std::lock_guard lock(mutex_);
  const std::string name = nameOf(path);
  const Node* node = find(name);
  if (node != nullptr && mode == OpenMode::createNew) return -EEXIST;
  if (node != nullptr && node->folder) return -EISDIR;
  if (node == nullptr) {
    if (mode != OpenMode::createNew && mode != OpenMode::createOrUpdate) return -ENOENT;
    if (const int result = make(name, false); result != 0) return result;
  }
  file = std::make_unique<CrashFile>(path, *this, now_.names.at(name));
  return 0;
}

int CrashFileSystem::infoOnce(const fs::path& path, FileInfo& info) {
  const std::lock_guard lock(mutex_);
  const std::string name = nameOf(path);
  const Node* node = find(name);
  if (node == nullptr) return -ENOENT;
  info = {node->folder ? FileInfo::Kind::folder : FileInfo::Kind::file,
          node->bytes.size(),
          1,
          now_.names.at(name),
          node->changed,
          0};
  return 0;
}

int CrashFileSystem::renameOnce(const fs::path& from, const fs::path& to, Existing existing) {
  const std::lock_guard lock(mutex_);
  const Node *source = find(nameOf(from)), *target = find(nameOf(to));
  if (source == nullptr) return -ENOENT;
  assert(!source->folder && "renaming folders is not played");
  if (target != nullptr && existing == Existing::refuse) return -EEXIST;
  if (target != nullptr && target->folder) return -EISDIR;
  return record({Operation::Kind::rename,
                 nameOf(from),
                 nameOf(to),
                 now_.names.at(nameOf(from)),
                 0,
                 {},
                 false});
}

int CrashFileSystem::removeOnce(const fs::path& path) {
  const std::lock_guard lock(mutex_);
  const std::string name = nameOf(path);
  const Node* node = find(name);
  if (node == nullptr) return -ENOENT;
  const auto next = now_.names.upper_bound(name + "/");
  if (node->folder && next != now_.names.end() && next->first.starts_with(name + "/")) {
    return -ENOTEMPTY;
  }
  return record({Operation::Kind::remove, name, "", now_.names.at(name), 0, {}, false});
}

int CrashFileSystem::makePrivateFolderOnce(const fs::path& path) {
  const std::lock_guard lock(mutex_);
  const Node* node = find(nameOf(path));
  if (node != nullptr) return node->folder ? 0 : -ENOTDIR;
  return make(nameOf(path), true);
}

int CrashFileSystem::listOnce(const fs::path& folder, std::vector<std::string>& names) {
  const std::lock_guard lock(mutex_);
  const std::string name = nameOf(folder);
  const Node* node = find(name);
  if (node == nullptr) return -ENOENT;
  if (!node->folder) return -ENOTDIR;
  for (const auto& [each, ignored] : now_.names) {
    if (each != "/" && folderName(each) == name) names.push_back(fs::path(each).filename());
  }
  return 0;
}

int CrashFileSystem::syncFolderOnce(const fs::path& folder) {
  const std::lock_guard lock(mutex_);
  const Node* node = find(nameOf(folder));
  if (node == nullptr) return -ENOENT;
  return record({Operation::Kind::syncFolder, nameOf(folder), "", 0, 0, {}, false});
}

std::size_t CrashFileSystem::operations() const {
  const std::lock_guard lock(mutex_);
  return log_.size();
}

std::vector<std::string> CrashFileSystem::trace() const {
  static constexpr const char* kNames[] = {"create", "write",  "truncate", "sync",
                                           "lose",   "rename", "remove",   "sync folder"};
  const std::lock_guard lock(mutex_);
  std::vector<std::string> lines;
  for (const Operation& each : log_) {
    lines.push_back(std::string(kNames[static_cast<int>(each.kind)]) + " " + each.name +
                    (each.to.empty() ? "" : " to " + each.to));
  }
  return lines;
}

Bytes CrashFileSystem::content(const fs::path& path) const {
  const std::lock_guard lock(mutex_);
  const auto found = now_.names.find(nameOf(path));
  if (found == now_.names.end()) throw FileError(path, "open", ENOENT);
  return now_.nodes.at(found->second).bytes;
}

void CrashFileSystem::setContent(const fs::path& path, Bytes bytes) {
  const std::lock_guard lock(mutex_);
  assert(log_.empty() && "only before the first operation");
  const auto there = now_.names.find(nameOf(path));
  const NodeId node = there == now_.names.end() ? nextNode_++ : there->second;
  for (Disk* disk : {&start_, &now_}) {
    disk->apply({Operation::Kind::create, nameOf(path), "", node, 0, {}, false});
    disk->nodes[node].bytes = bytes;
  }
}

void CrashFileSystem::addFolder(const fs::path& path) {
  const std::lock_guard lock(mutex_);
  assert(log_.empty() && "only before the first operation");
  const NodeId node = nextNode_++;
  for (Disk* disk : {&start_, &now_}) {
    disk->apply({Operation::Kind::create, nameOf(path), "", node, 0, {}, true});
  }
}

}  // namespace bozzetto::testing
