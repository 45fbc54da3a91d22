// Saving on the machine's own disk while programs are killed and disks are full.
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <random>

#include "scene/crash_disk.hpp"

namespace bozzetto {
namespace {

using testing::bytesOf;
using testing::expectEqual;
using testing::Folder;
using testing::smallDocument;
using testing::worked;

constexpr const char* kFolderVariable = "BOZZETTO_CHILD_FOLDER";

std::filesystem::path childFolder() {
  const char* folder = std::getenv(kFolderVariable);
  return folder == nullptr ? "" : folder;
}

// Another process of this program, started anew: a fork alone would lack the threads for loops.
class Child {
 public:
  Child(const char* test, const Folder& folder) {
    int pipe[2];
    if (::pipe(pipe) != 0) throw Error("no pipe");
    process_ = ::fork();
    if (process_ == 0) {
      ::dup2(pipe[1], STDERR_FILENO);
      ::setenv(kFolderVariable, folder.path().c_str(), 1);
      const std::string filter = "--gtest_filter=Child.DISABLED_" + std::string(test);
      ::execl("/proc/self/exe", "child", filter.c_str(), "--gtest_also_run_disabled_tests",
              "--gtest_brief=1", static_cast<char*>(nullptr));
      ::_exit(127);
    }
    ::close(pipe[1]);
    words_ = ::fdopen(pipe[0], "r");
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    kill();
    ::fclose(words_);
  }

  /// The next number that the child said; nothing when it is dead.
  std::optional<long> next() {
    long number = 0;
    return ::fscanf(words_, "%ld", &number) == 1 ? std::optional(number) : std::nullopt;
  }
  /// Its exit code; −1 after a signal.
  int kill() {
    if (process_ > 0) ::kill(process_, SIGKILL);
    return wait();
  }
  int wait() {
    int status = 0;
    if (process_ > 0) ::waitpid(std::exchange(process_, -1), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t process_ = -1;
  FILE* words_ = nullptr;
};

// Saves without end; says the number of each save when it has returned.
TEST(Child, DISABLED_savesWithoutEnd) {
  ASSERT_FALSE(childFolder().empty());
  const auto path = childFolder() / "a.bzt";
  SceneFile file;
  Document document = FileSystem::real().info(path) ? file.load(path) : testing::smallDocument();
  for (long n = std::stol("0" + document.parts.settings["n"]);;) {
    document = worked(document, static_cast<int>(++n % 12));
    document.parts.settings["n"] = std::to_string(n);
    document.parts.settings["hash"] = hexDigits(fieldHash(document.field));
    file.save(path, document);
    ::dprintf(STDERR_FILENO, "%ld\n", n);
  }
}

TEST(RealDiskSlow, threeHundredKillsLoseNothing) {
  const Folder folder(Folder::quick());
  const auto path = folder / "a.bzt";
  std::mt19937 source(1);
  const auto random = [&] { return static_cast<unsigned>(source()); };
  long acknowledged = 0;
  for (int kill = 0; kill < 300; ++kill) {
    Child child("savesWithoutEnd", folder);
    const unsigned patience = random() % 5;
    for (unsigned n = 0; n <= patience; ++n) acknowledged = child.next().value_or(acknowledged);
    ::usleep(random() % 3000);
    child.kill();
    while (const auto more = child.next()) acknowledged = *more;

    Document found = loadScene(path);
    const long number = std::stol(found.parts.settings["n"]);
    ASSERT_GE(number, acknowledged) << "kill " << kill;
    ASSERT_LE(number, acknowledged + 1) << "kill " << kill;
    ASSERT_EQ(found.parts.settings["hash"], hexDigits(fieldHash(found.field)));
    acknowledged = number;
  }
  EXPECT_GE(acknowledged, 300);
  removeLeftovers(folder.path());
  for (const std::string& name : FileSystem::real().list(folder.path())) {
    EXPECT_TRUE(name == "a.bzt" || name == "a.bzt~" || name == "a.bzt-journal") << name;
  }
}

constexpr int kNotAllowed = 77;

// On a disk of its own with little room, where the system lets us have one.
TEST(Child, DISABLED_fillsASmallDisk) {
  const auto folder = childFolder();
  ASSERT_FALSE(folder.empty());
  if (::unshare(CLONE_NEWNS | (::geteuid() == 0 ? 0 : CLONE_NEWUSER)) != 0 ||
      ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
      ::mount("tmpfs", folder.c_str(), "tmpfs", 0, "size=512k") != 0) {
    ::_exit(kNotAllowed);
  }
  const auto path = folder / "a.bzt";
  SceneFile file;
  const Document old = smallDocument();
  Document next = worked(old, 2);
  next.parts.shelf[0].payload.assign(150000, std::byte{7});
  file.save(path, old);
  writeFile(folder / "filler", Bytes(340000));
  for (int attempt = 0; attempt < 3; ++attempt) {
    try {
      file.save(path, next);
      ADD_FAILURE() << "saved on a full disk";
    } catch (const FileError& error) {
      EXPECT_EQ(error.fault(), FileFault::full) << error.what();
      EXPECT_NE(std::string(error.what()).find("a.bzt"), std::string::npos) << error.what();
    }
    expectEqual(old, loadScene(path));
  }
  FileSystem::real().remove(folder / "filler");
  file.save(path, next);
  expectEqual(next, loadScene(path));
}

TEST(RealDisk, aFullOneKeepsTheOldFileAndIsSavedToWhenThereIsRoomAgain) {
  const Folder folder;
  Child child("fillsASmallDisk", folder);
  const int code = child.wait();
  if (code == kNotAllowed) GTEST_SKIP() << "no mounting here";
  EXPECT_EQ(code, 0);
}

}  // namespace
}  // namespace bozzetto
