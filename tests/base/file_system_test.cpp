// The interface's own promises, on the machine's disk and on disks that fail or lose power.
#include "bozzetto/base/file_system.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <set>

#include "bozzetto/base/file.hpp"
#include "bozzetto/base/hash.hpp"
#include "support/crash_file_system.hpp"
#include "support/folder.hpp"

namespace bozzetto {
namespace fs = std::filesystem;
namespace {

using testing::CrashFileSystem;
using testing::failEveryOperation;
using testing::Fault;
using testing::FaultKind;
using testing::FaultyFileSystem;
using testing::Survival;

Bytes bytesOf(std::string_view text) {
  const auto raw = std::as_bytes(std::span(text.data(), text.size()));
  return {raw.begin(), raw.end()};
}

Bytes pattern(std::size_t size, unsigned factor) {
  Bytes bytes(size);
  for (std::size_t n = 0; n < size; ++n) bytes[n] = static_cast<std::byte>(n * factor % 251);
  return bytes;
}

FileFault faultOf(const auto& body) {
  try {
    body();
  } catch (const FileError& error) {
    return error.fault();
  }
  ADD_FAILURE() << "no FileError";
  return FileFault::other;
}

class Disk : public ::testing::Test {
 protected:
  fs::path at(const char* name) const { return folder_ / name; }

  FileSystem& files_ = FileSystem::real();
  const testing::Folder folder_;
};

// What both disks promise.
void expectGoodManners(FileSystem& files, const fs::path& folder) {
  const auto file = files.open(folder / "a", OpenMode::createNew);
  file->write(4, bytesOf("efgh"));
  file->write(0, bytesOf("abcd"));
  Bytes read(100);
  EXPECT_EQ(file->read(2, read), 6u);
  EXPECT_EQ(read[0], std::byte{'c'});
  file->truncate(3);
  EXPECT_EQ(file->info().bytes, 3u);
  EXPECT_EQ(file->read(3, read), 0u);
  file->sync();
  EXPECT_EQ(files.info(folder / "a"), file->info());
  EXPECT_EQ(faultOf([&] { files.open(folder / "a", OpenMode::createNew); }), FileFault::exists);
  EXPECT_EQ(faultOf([&] { files.open(folder / "no", OpenMode::update); }), FileFault::missing);
  EXPECT_EQ(faultOf([&] { files.open(folder / "no" / "b", OpenMode::createNew); }),
            FileFault::missing);

  files.open(folder / "b", OpenMode::createOrUpdate)->write(0, bytesOf("b"));
  EXPECT_EQ(faultOf([&] { files.rename(folder / "a", folder / "b", Existing::refuse); }),
            FileFault::exists);
  files.rename(folder / "a", folder / "b");
  files.rename(folder / "b", folder / "c", Existing::refuse);
  EXPECT_EQ(readFile(folder / "c", 10, files), bytesOf("abc"));

  files.makePrivateFolder(folder / "d");
  files.makePrivateFolder(folder / "d");
  writeFile(folder / "d" / "e", bytesOf("e"), files);
  EXPECT_EQ(files.list(folder), (std::vector<std::string>{"c", "d"}));
  EXPECT_EQ(files.list(folder / "d"), std::vector<std::string>{"e"});
  EXPECT_EQ(faultOf([&] { files.remove(folder / "d"); }), FileFault::exists);
  EXPECT_TRUE(files.remove(folder / "d" / "e"));
  EXPECT_TRUE(files.remove(folder / "d"));
  EXPECT_FALSE(files.remove(folder / "d"));
  EXPECT_EQ(files.info(folder / "d"), std::nullopt);
  files.syncFolder(folder);

  auto lock = FileLock::tryTake(folder / "lock", files);
  EXPECT_TRUE(lock.has_value());
  EXPECT_FALSE(FileLock::tryTake(folder / "lock", files).has_value());
  lock.reset();
  EXPECT_TRUE(FileLock::tryTake(folder / "lock", files).has_value());
}

TEST_F(Disk, hasGoodManners) { expectGoodManners(files_, folder_.path()); }

TEST(CrashDisk, hasTheSameManners) {
  CrashFileSystem files;
  files.addFolder("/disk");
  expectGoodManners(files, "/disk");
}

TEST(FaultyDisk, hasTheSameMannersWhenItIsWell) {
  CrashFileSystem disk;
  disk.addFolder("/disk");
  FaultyFileSystem files(disk);
  expectGoodManners(files, "/disk");
}

TEST_F(Disk, plantedLinksAreNotFollowed) {
  writeFile(at("target"), bytesOf("kept"));
  fs::create_symlink(at("target"), at("link"));
  fs::create_directory(at("elsewhere"));
  fs::create_directory_symlink(at("elsewhere"), at("folder"));
  for (const OpenMode mode :
       {OpenMode::read, OpenMode::update, OpenMode::createNew, OpenMode::createOrUpdate}) {
    EXPECT_THROW(files_.open(at("link"), mode), FileError);
  }
  EXPECT_EQ(files_.open(at("link"), OpenMode::readFollowing)->info().bytes, 4u);
  EXPECT_THROW(files_.makePrivateFolder(at("folder")), FileError);
  EXPECT_THROW(FileLock::tryTake(at("link")), FileError);
  EXPECT_EQ(readFile(at("target")), bytesOf("kept"));
}

TEST_F(Disk, privateMeansPrivate) {
  fs::create_directory(at("open"));
  fs::permissions(at("open"), fs::perms::all);
  for (const char* name : {"open", "new"}) {
    files_.makePrivateFolder(at(name));
    EXPECT_EQ(fs::status(at(name)).permissions(), fs::perms::owner_all) << name;
  }
  files_.open(at("mine"), OpenMode::createNew, Rights::ownerOnly);
  EXPECT_EQ(fs::status(at("mine")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  writeFile(at("plain"), {});
  EXPECT_THROW(files_.makePrivateFolder(at("plain")), FileError);
}

TEST_F(Disk, aKilledOwnersLockIsFree) {
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const auto lock = FileLock::tryTake(at("lock"));
    const char done = lock ? 'y' : 'n';
    if (::write(ready[1], &done, 1) != 1) ::_exit(1);
    ::pause();
  }
  char held = 0;
  ASSERT_EQ(::read(ready[0], &held, 1), 1);
  EXPECT_EQ(held, 'y');
  EXPECT_FALSE(FileLock::tryTake(at("lock")).has_value());
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(FileLock::tryTake(at("lock")).has_value());
  ::close(ready[0]);
  ::close(ready[1]);
}

TEST_F(Disk, leftoversGoFilesInUseStay) {
  writeFile(at(".bozzetto-1-0.tmp"), bytesOf("from a program that died"));
  writeFile(at("bozzetto.tmp"), bytesOf("somebody's"));
  NewFile used(at("x"));
  removeLeftovers(folder_.path());
  EXPECT_EQ(files_.list(folder_.path()),
            (std::vector<std::string>{used.temporaryName().filename(), "bozzetto.tmp"}));
  used.putInPlace();
  EXPECT_EQ(files_.list(folder_.path()), (std::vector<std::string>{"bozzetto.tmp", "x"}));
}

TEST_F(Disk, namesOfFullLength) {
  const fs::path path = folder_ / std::string(255, 'n');
  writeFile(path, bytesOf("long"));
  EXPECT_EQ(readFile(path), bytesOf("long"));
}

// A disk with an old file, and what replacing it leaves.
class Replacing : public ::testing::Test {
 protected:
  static constexpr const char* kPath = "/disk/a";
  void SetUp() override {
    disk_.addFolder("/disk");
    disk_.setContent(kPath, old_);
  }
  void replace() {
    try {
      writeFile(kPath, new_, files_);
      done_ = true;
    } catch (const FileError& error) {
      done_ = false;
      EXPECT_NE(std::string(error.what()).find("/disk"), std::string::npos) << error.what();
    }
  }

  const Bytes old_ = pattern(3000, 7), new_ = pattern(5000, 11);
  CrashFileSystem disk_;
  FaultyFileSystem files_{disk_};
  bool done_ = false;
};

TEST_F(Replacing, survivesTheFailureOfAnyOperation) {
  for (const FaultKind kind : {FaultKind::error, FaultKind::shortWrite, FaultKind::interrupted}) {
    for (const int number : {EIO, ENOSPC, EDQUOT, EROFS}) {
      for (const bool forever : {false, true}) {
        const auto check = [&](std::size_t failed) {
          const Bytes found = disk_.content(kPath);
          EXPECT_TRUE(found == old_ || found == new_) << "operation " << failed;
          EXPECT_TRUE(!done_ || found == new_) << "operation " << failed;
          EXPECT_TRUE(done_ || kind == FaultKind::error) << "operation " << failed;
          writeFile(kPath, old_, disk_);
        };
        const std::size_t count = failEveryOperation(
            files_, {kind, number, forever}, [&] { replace(); }, check);
        EXPECT_GE(count, 6u) << "open, lock, look, write, sync, close, rename, sync";
      }
    }
  }
}

TEST_F(Replacing, survivesAPowerCutAtAnyMoment) {
  replace();
  ASSERT_TRUE(done_);
  std::set<std::uint64_t> seen;
  for (std::size_t count = 0; count <= disk_.operations(); ++count) {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
      const auto kind = static_cast<Survival::Kind>(std::min(seed, 3u));
      const auto after = disk_.afterPowerCut(count, {kind, seed, seed % 2 ? 512u : 4096u});
      const Bytes found = after->content(kPath);
      EXPECT_TRUE(found == old_ || found == new_) << count << ", seed " << seed;
      EXPECT_TRUE(count < disk_.operations() || found == new_) << "durable when it returns";
      seen.insert(hash64(found));
    }
  }
  EXPECT_EQ(seen.size(), 2u);
}

// The disk's own law: without the sync, the simulation must find the half-written file.
TEST_F(Replacing, aRenameWithoutSyncIsCaught) {
  files_.open("/disk/t", OpenMode::createNew)->write(0, new_);
  files_.rename("/disk/t", kPath);
  files_.syncFolder("/disk");
  std::set<std::uint64_t> seen;
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const auto kind = static_cast<Survival::Kind>(std::min(seed, 3u));
    const auto after = disk_.afterPowerCut(disk_.operations(), {kind, seed, 512});
    seen.insert(hash64(after->content(kPath)));
  }
  EXPECT_GT(seen.size(), 10u) << "empty, zeros, torn in many ways, whole";
  EXPECT_FALSE(seen.contains(hash64(old_))) << "the name was made durable";
}

TEST_F(Replacing, whatAFailedSyncLostNoLaterSyncBringsBack) {
  const auto file = files_.open(kPath, OpenMode::update);
  file->write(0, new_);
  files_.start({FaultKind::error, EIO, false, 1});
  EXPECT_EQ(faultOf([&] { file->sync(); }), FileFault::io);
  file->sync();
  const auto after = disk_.afterPowerCut(disk_.operations(), {});
  EXPECT_EQ(after->content(kPath), old_);
}

}  // namespace
}  // namespace bozzetto
