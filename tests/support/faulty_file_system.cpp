#include "support/faulty_file_system.hpp"

namespace bozzetto::testing {
namespace fs = std::filesystem;
namespace {

class FaultyFile : public File {
 public:
  FaultyFile(FaultyFileSystem& files, std::unique_ptr<File> below)
      : File(below->path()), files_(&files), below_(std::move(below)) {}

  std::int64_t readOnce(std::uint64_t offset, std::span<std::byte> into) override {
    const int fault = files_->next();
    return fault != 0 ? fault : below_->readOnce(offset, into);
  }
  std::int64_t writeOnce(std::uint64_t offset, std::span<const std::byte> bytes) override {
    const std::int64_t taken = files_->nextWrite(bytes.size());
    if (taken < 0) return taken;
    return below_->writeOnce(offset, bytes.first(static_cast<std::size_t>(taken)));
  }
  int truncateOnce(std::uint64_t bytes) override {
    const int fault = files_->next();
    return fault != 0 ? fault : below_->truncateOnce(bytes);
  }
  int syncOnce() override {
    const int fault = files_->next();
    if (fault == 0) return below_->syncOnce();
    auto* lossy = dynamic_cast<LosesUnsynced*>(below_.get());
    if (fault != -EINTR && lossy != nullptr) lossy->loseUnsynced();
    return fault;
  }
  int infoOnce(FileInfo& info) override {
    const int fault = files_->next();
    return fault != 0 ? fault : below_->infoOnce(info);
  }
  int lockOnce() override {
    const int fault = files_->next();
    return fault != 0 ? fault : below_->lockOnce();
  }
  int unlockOnce() override {
    const int fault = files_->next();
    return fault != 0 ? fault : below_->unlockOnce();
  }
  // A close that fails has closed all the same.
  int closeOnce() override {
    const int fault = files_->next(), result = below_->closeOnce();
    return fault != 0 ? fault : result;
  }

 private:
  FaultyFileSystem* files_;
  std::unique_ptr<File> below_;
};

}  // namespace

void FaultyFileSystem::start(Fault fault) {
  const std::lock_guard lock(mutex_);
  fault_ = fault;
  count_ = 0;
  failed_ = false;
}

std::size_t FaultyFileSystem::operations() const {
  const std::lock_guard lock(mutex_);
  return count_;
}

bool FaultyFileSystem::failed() const {
  const std::lock_guard lock(mutex_);
  return failed_;
}

std::optional<Fault> FaultyFileSystem::strike() {
  const std::lock_guard lock(mutex_);
  const std::size_t number = ++count_;
  const bool every = fault_.kind == FaultKind::interrupted && (number - fault_.first) % 2 == 0;
  const bool now = number == fault_.first || (number > fault_.first && fault_.forever &&
                                              (fault_.kind != FaultKind::interrupted || every));
  if (!now) return std::nullopt;
  failed_ = true;
  return fault_;
}

int FaultyFileSystem::next() {
  const auto fault = strike();
  if (!fault || fault->kind == FaultKind::shortWrite) return 0;
  return fault->kind == FaultKind::interrupted ? -EINTR : -fault->number;
}

std::int64_t FaultyFileSystem::nextWrite(std::size_t bytes) {
  const auto fault = strike();
  if (!fault) return static_cast<std::int64_t>(bytes);
  if (fault->kind == FaultKind::interrupted) return -EINTR;
  if (fault->kind == FaultKind::error) return -fault->number;
  return static_cast<std::int64_t>((bytes + 1) / 2);
}

int FaultyFileSystem::openOnce(const fs::path& path, OpenMode mode, Rights rights,
                               std::unique_ptr<File>& file) {
  if (const int fault = next(); fault != 0) return fault;
  std::unique_ptr<File> opened;
  const int result = below_->openOnce(path, mode, rights, opened);
  if (result == 0) file = std::make_unique<FaultyFile>(*this, std::move(opened));
  return result;
}

int FaultyFileSystem::infoOnce(const fs::path& path, FileInfo& info) {
  const int fault = next();
  return fault != 0 ? fault : below_->infoOnce(path, info);
}

int FaultyFileSystem::renameOnce(const fs::path& from, const fs::path& to, Existing existing) {
  const int fault = next();
  return fault != 0 ? fault : below_->renameOnce(from, to, existing);
}

int FaultyFileSystem::removeOnce(const fs::path& path) {
  const int fault = next();
  return fault != 0 ? fault : below_->removeOnce(path);
}

int FaultyFileSystem::makePrivateFolderOnce(const fs::path& path) {
  const int fault = next();
  return fault != 0 ? fault : below_->makePrivateFolderOnce(path);
}

int FaultyFileSystem::listOnce(const fs::path& folder, std::vector<std::string>& names) {
  const int fault = next();
  return fault != 0 ? fault : below_->listOnce(folder, names);
}

int FaultyFileSystem::syncFolderOnce(const fs::path& folder) {
  const int fault = next();
  return fault != 0 ? fault : below_->syncFolderOnce(folder);
}

std::size_t failEveryOperation(FaultyFileSystem& files, Fault fault,
                               const std::function<void()>& work,
                               const std::function<void(std::size_t)>& check) {
  for (fault.first = 1;; ++fault.first) {
    files.start(fault);
    work();
    const bool failed = files.failed();
    files.start();
    check(fault.first);
    if (!failed) return fault.first - 1;
  }
}

}  // namespace bozzetto::testing
