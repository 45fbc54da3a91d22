// Every operation on the disk fails in turn, once and for good, while scenes are saved and loaded:
// no crash, a message, an old or a new file, and a save that succeeds when the disk is well again.
#include <cerrno>

#include "scene/crash_disk.hpp"

namespace bozzetto {
namespace {

using testing::CrashFileSystem;
using testing::expectEqual;
using testing::failEveryOperation;
using testing::Fault;
using testing::FaultKind;
using testing::FaultyFileSystem;
using testing::kScene;
using testing::smallDocument;
using testing::stateOf;
using testing::worked;

struct FaultyDisk : ::testing::TestWithParam<Fault> {
  FaultyDisk() { disk.addFolder("/disk"); }
  CrashFileSystem disk;
  FaultyFileSystem files{disk};

  // Whether it went well.
  bool attempt(const auto& work) {
    try {
      work();
      return true;
    } catch (const Error& error) {
      const std::string text = error.what();
      EXPECT_NE(text.find("/disk"), std::string::npos) << text;
      EXPECT_EQ(text.find('\n'), std::string::npos) << text;
      return false;
    }
  }
  std::uint64_t onDisk() { return stateOf(loadScene(kScene, Progress::none(), disk)); }
  // A save that was cut off may leave its journal, which the next one removes.
  void expectNoLitter(std::size_t failed, bool saved = true) {
    removeLeftovers("/disk", disk);
    if (!saved) disk.remove("/disk/a.bzt-journal");
    for (const std::string& name : disk.list("/disk")) {
      EXPECT_TRUE(name == "a.bzt" || name == "a.bzt~") << name << " after " << failed;
    }
  }
};

TEST_P(FaultyDisk, wholeSaves) {
  const Document old = smallDocument(), next = worked(old, 2);
  saveScene(kScene, old, Progress::none(), disk);
  bool good = false;
  const std::size_t count = failEveryOperation(
      files, GetParam(),
      [&] { good = attempt([&] { saveScene(kScene, next, Progress::none(), files); }); },
      [&](std::size_t failed) {
        const std::uint64_t found = onDisk();
        EXPECT_TRUE(found == stateOf(next) || (found == stateOf(old) && !good)) << failed;
        saveScene(kScene, old, Progress::none(), disk);
        expectNoLitter(failed);
      });
  EXPECT_GT(count, 10u);
  EXPECT_TRUE(good);
}

// The session goes on with the same SceneFile: what it saves next must be right again.
TEST_P(FaultyDisk, savesOfChanges) {
  bool good = false;
  std::optional<SceneFile> file;
  Document old, next;
  std::size_t whole = 0;
  const auto work = [&] {
    next = worked(old, 2);
    good = attempt([&] { file->save(kScene, next); });
  };
  const auto begin = [&] {
    disk.remove(kScene);
    file.emplace(files);
    old = smallDocument();
    file->save(kScene, old);
  };
  begin();
  files.start();
  const std::size_t count = failEveryOperation(files, GetParam(), work, [&](std::size_t failed) {
    const std::uint64_t found = onDisk();
    EXPECT_TRUE(found == stateOf(next) || (found == stateOf(old) && !good)) << failed;
    if (!good) {
      whole += file->save(kScene, next).kind == SaveKind::whole;
      expectEqual(next, loadScene(kScene, Progress::none(), disk));
    }
    expectNoLitter(failed);
    begin();
  });
  EXPECT_GT(count, 10u);
  EXPECT_TRUE(good);
  EXPECT_EQ(whole > 0, GetParam().kind == FaultKind::error);
}

TEST_P(FaultyDisk, loads) {
  const Document document = smallDocument();
  saveScene(kScene, document, Progress::none(), disk);
  const Bytes before = disk.content(kScene);
  SceneFile file(files);
  Document loaded;
  bool good = false;
  failEveryOperation(
      files, GetParam(), [&] { good = attempt([&] { loaded = file.load(kScene); }); },
      [&](std::size_t failed) {
        if (good) expectEqual(document, loaded);
        EXPECT_EQ(disk.content(kScene), before) << failed;
      });
  EXPECT_TRUE(good);
}

TEST_P(FaultyDisk, theFirstSaveOfASessionKeepsThePreviousVersion) {
  const Document old = smallDocument(), next = worked(old, 1);
  bool good = false;
  const auto begin = [&] {
    saveScene(kScene, old, Progress::none(), disk);
    disk.remove("/disk/a.bzt~");
  };
  begin();
  failEveryOperation(
      files, GetParam(),
      [&] {
        good = attempt([&] {
          SceneFile file(files);
          file.load(kScene);
          file.save(kScene, next);
        });
      },
      [&](std::size_t failed) {
        const std::uint64_t found = onDisk();
        EXPECT_TRUE(found == stateOf(next) || (found == stateOf(old) && !good)) << failed;
        if (disk.info("/disk/a.bzt~")) {
          expectEqual(old, loadScene("/disk/a.bzt~", Progress::none(), disk));
        }
        expectNoLitter(failed, good);
        begin();
      });
  EXPECT_TRUE(good);
}

std::string nameOf(const ::testing::TestParamInfo<Fault>& info) {
  const Fault& fault = info.param;
  const std::string kind = fault.kind == FaultKind::shortWrite    ? "short"
                           : fault.kind == FaultKind::interrupted ? "interrupted"
                           : fault.number == EIO                  ? "io"
                                                                  : "full";
  return kind + (fault.forever ? "ForGood" : "Once");
}

INSTANTIATE_TEST_SUITE_P(
    All, FaultyDisk,
    ::testing::Values(Fault{FaultKind::error, EIO, false}, Fault{FaultKind::error, EIO, true},
                      Fault{FaultKind::error, ENOSPC, false}, Fault{FaultKind::error, ENOSPC, true},
                      Fault{FaultKind::shortWrite, 0, false}, Fault{FaultKind::shortWrite, 0, true},
                      Fault{FaultKind::interrupted, 0, true}),
    nameOf);

}  // namespace
}  // namespace bozzetto
