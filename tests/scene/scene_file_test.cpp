// Saving and loading as a sculptor meets it.
#include "bozzetto/scene/scene_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "bozzetto/base/file.hpp"
#include "scene/database.hpp"
#include "scene/scenes.hpp"

namespace bozzetto {
namespace {

using testing::expectEqual;
using testing::Folder;
using testing::sampleDocument;

// What stands in a folder, by name.
std::set<std::string> namesIn(const Folder& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

void dab(Document& document, Key at, float value = 0.7f) {
  testing::fill<8>(document.field, {at, at + Key{3, 3, 3}}, [&](Key) { return value; });
}

TEST(SceneFile, comesBackBitForBit) {
  const Folder folder;
  const Document document = sampleDocument();
  const SaveReport report = saveScene(folder / "a.bzt", document);
  EXPECT_EQ(report.kind, SaveKind::whole);
  EXPECT_EQ(report.fileBytes, std::filesystem::file_size(folder / "a.bzt"));
  const Document back = loadScene(folder / "a.bzt");
  expectEqual(document, back);
  EXPECT_EQ(validate(back.field), std::nullopt);
  EXPECT_EQ(checkScene(folder / "a.bzt"), std::nullopt);
  EXPECT_EQ(namesIn(folder), std::set<std::string>{"a.bzt"});
}

TEST(SceneFile, holdsAnEmptyScene) {
  const Folder folder;
  const Document document;
  saveScene(folder / "a.bzt", document);
  expectEqual(document, loadScene(folder / "a.bzt"));
}

TEST(SceneFile, holdsClayFarOutAndLongRuns) {
  const Folder folder;
  Document document;
  constexpr std::int32_t rim = kWorkspaceRim / 8;
  document.field.tree.put({1 - rim, rim - 1, -rim}, 2 * rim - 1,
                          CornerBlock<8>::uniform(0.25f, 0xff010203));
  testing::fill<8>(document.field,
                   {{kWorkspaceRim, 0, -kWorkspaceRim}, {kWorkspaceRim, 9, 2 - kWorkspaceRim}},
                   [](Key) { return 2047.5f; });
  saveScene(folder / "a.bzt", document);
  expectEqual(document, loadScene(folder / "a.bzt"));
}

TEST(SceneFile, sameBytesForAnyNumberOfThreads) {
  const Folder folder;
  const Document document = sampleDocument();
  for (const int threads : {1, 4}) {
    setThreadCount(threads);
    saveScene(folder / std::to_string(threads), document);
  }
  setThreadCount(0);
  EXPECT_EQ(readFile(folder / "1"), readFile(folder / "4"));
}

TEST(SceneFile, namesAreOnlyNames) {
  const Folder folder;
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  const Document document = sampleDocument();
  for (const std::string name : {":memory:", "file:x?mode=memory", "a b%20?.bzt"}) {
    saveScene(name, document);
    EXPECT_TRUE(std::filesystem::is_regular_file(folder / name)) << name;
    expectEqual(document, loadScene(name));
  }
  std::filesystem::current_path(before);
}

TEST(SceneFile, savesOnlyWhatChanged) {
  const Folder folder;
  SceneFile file;
  Document document;
  document.field = testing::ball<8>(70);
  const SaveReport first = file.save(folder / "a.bzt", document);
  EXPECT_EQ(first.chunksWritten, first.chunks);
  EXPECT_GT(first.chunks, 20u);
  dab(document, {68, 5, 5});
  const SaveReport second = file.save(folder / "a.bzt", document);
  EXPECT_EQ(second.kind, SaveKind::changes);
  EXPECT_EQ(second.chunksWritten, 1u);
  EXPECT_EQ(second.chunks, first.chunks);
  EXPECT_LT(second.bytesWritten, first.bytesWritten / 5);
  expectEqual(document, loadScene(folder / "a.bzt"));
  EXPECT_EQ(checkScene(folder / "a.bzt"), std::nullopt);
  EXPECT_EQ(file.save(folder / "a.bzt", document).chunksWritten, 0u);
}

TEST(SceneFile, randomEditsSavedInPlaceEqualTheDocument) {
  const Folder folder;
  std::mt19937 random(3);
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  SceneFile file;
  Document document = sampleDocument();
  file.save(folder / "a.bzt", document);
  for (int step = 0; step < 40; ++step) {
    const Key low{pick(160) - 80, pick(160) - 80, pick(160) - 80};
    const float value = static_cast<float>(pick(3)) / 2.0f;
    testing::fill<8>(document.field, {low, low + Key{pick(40), pick(40), pick(70)}},
                     [&](Key) { return value; });
    if (pick(3) == 0) document.parts.settings["step"] = std::to_string(step);
    if (pick(6) == 0) document.parts.shelf.pop_back();
    if (document.parts.shelf.empty()) document.parts.shelf = sampleDocument().parts.shelf;
    if (pick(8) == 0) document = file.load(folder / "a.bzt");
    file.save(folder / "a.bzt", document);
    ASSERT_EQ(checkScene(folder / "a.bzt"), std::nullopt);
    expectEqual(document, loadScene(folder / "a.bzt"));
  }
  document.field.tree.clear();
  file.save(folder / "a.bzt", document);
  EXPECT_TRUE(loadScene(folder / "a.bzt").field.tree.empty());
}

TEST(SceneFile, aFileThatIsMostlyFreeIsWrittenAnew) {
  const Folder folder;
  SceneFile file;
  Document document = sampleDocument();
  const auto large = file.save(folder / "a.bzt", document).fileBytes;
  document.field.tree.clear();
  EXPECT_EQ(file.save(folder / "a.bzt", document).fileBytes, large);
  document.parts.settings["name"] = "Nothing";
  const SaveReport report = file.save(folder / "a.bzt", document);
  EXPECT_EQ(report.kind, SaveKind::whole);
  EXPECT_LT(report.fileBytes, large / 2);
  expectEqual(document, loadScene(folder / "a.bzt"));
}

TEST(SceneFile, aFileThatSomebodyElseTouchedIsWrittenWhole) {
  const Folder folder;
  SceneFile file;
  Document document = sampleDocument();
  file.save(folder / "a.bzt", document);
  writeFile(folder / "a.bzt", testing::bytesOf("not a scene"));
  EXPECT_EQ(file.save(folder / "a.bzt", document).kind, SaveKind::whole);
  expectEqual(document, loadScene(folder / "a.bzt"));
  EXPECT_EQ(file.save(folder / "b.bzt", document).kind, SaveKind::whole);
  expectEqual(document, loadScene(folder / "b.bzt"));
}

TEST(SceneFile, theFirstSaveOfASessionKeepsThePreviousVersion) {
  const Folder folder;
  const Document old = sampleDocument();
  saveScene(folder / "a.bzt", old);
  EXPECT_EQ(namesIn(folder), std::set<std::string>{"a.bzt"});
  SceneFile file;
  Document document = file.load(folder / "a.bzt");
  for (int n = 0; n < 3; ++n) {
    dab(document, {n * 10, 0, 0});
    EXPECT_EQ(file.save(folder / "a.bzt", document).kind, SaveKind::changes);
    expectEqual(document, loadScene(folder / "a.bzt"));
    expectEqual(old, loadScene(previousVersionOf(folder / "a.bzt")));
  }
  EXPECT_EQ(namesIn(folder), (std::set<std::string>{"a.bzt", "a.bzt~"}));
}

TEST(SceneFile, numberedCopiesGoOnFromTheLastOne) {
  const Folder folder;
  Document document = sampleDocument();
  saveScene(folder / "faun.bzt", document);
  for (const char* other : {"faun.x07.bzt", "faun.007.obj", "faun.bzt.009.bzt", "fau.010.bzt"}) {
    writeFile(folder / other, {});
  }
  EXPECT_EQ(saveNumberedCopy(folder / "faun.bzt", document), folder / "faun.001.bzt");
  const Document first = document;
  dab(document, {0, 0, 0});
  EXPECT_EQ(saveNumberedCopy(folder / "faun.bzt", document), folder / "faun.002.bzt");
  expectEqual(document, loadScene(folder / "faun.002.bzt"));
  writeFile(folder / "faun.1204.bzt", {});
  EXPECT_EQ(saveNumberedCopy(folder / "faun.bzt", document), folder / "faun.1205.bzt");
  expectEqual(first, loadScene(folder / "faun.001.bzt"));
}

TEST(SceneFile, namesOfAnyLength) {
  const Folder folder;
  for (const std::size_t length : {246u, 247u, 248u, 254u, 255u}) {
    const auto path = folder / std::string(length, 'n');
    Document document = sampleDocument();
    saveScene(path, document);
    SceneFile file;
    document = file.load(path);
    dab(document, {0, 0, 0});
    const SaveKind kind = file.save(path, document).kind;
    EXPECT_EQ(kind, length > 247 ? SaveKind::whole : SaveKind::changes) << length;
    expectEqual(document, loadScene(path));
  }
}

TEST(SceneFile, refusesWhatIsNoFile) {
  const Folder folder;
  ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
  for (const auto& name : {folder / "missing", folder.path(), folder / "fifo"}) {
    EXPECT_THROW(loadScene(name), Error) << name;
    EXPECT_TRUE(checkScene(name).has_value()) << name;
  }
  EXPECT_THROW(saveScene(folder / "no" / "folder.bzt", Document()), Error);
  EXPECT_THROW(saveScene("-", Document()), Error);
}

TEST(SceneFile, refusesToSaveWhatItCouldNotLoad) {
  const Folder folder;
  Document document = sampleDocument();
  document.parts.view.camera.fieldOfView = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(saveScene(folder / "a.bzt", document), Error);
  document = sampleDocument();
  document.parts.thumbnail = testing::bytesOf("no picture");
  EXPECT_THROW(saveScene(folder / "a.bzt", document), Error);
  document = sampleDocument();
  dab(document, {0, 0, 90}, 1e9f);
  EXPECT_THROW(saveScene(folder / "a.bzt", document), Error);
  EXPECT_TRUE(namesIn(folder).empty());
}

// A save that was cut off while SQLite had already changed pages of the file.
TEST(SceneFile, anInterruptedSaveIsTakenBackWhenLoading) {
  const Folder folder;
  Document document = sampleDocument();
  document.parts.shelf[0].payload.assign(200000, std::byte{3});
  saveScene(folder / "a.bzt", document);
  {
    Database database = Database::forWriting(folder / "a.bzt", "a.bzt");
    database.run(
        "PRAGMA cache_size=1; BEGIN; UPDATE shelf SET content = zeroblob(200000); "
        "UPDATE chunks SET content = zeroblob(50000)");
    for (const std::string name : {"a.bzt", "a.bzt-journal"}) {
      std::filesystem::copy_file(folder / name, folder / ("b" + name.substr(1)));
    }
  }
  ASSERT_NE(readFile(folder / "b.bzt"), readFile(folder / "a.bzt"));
  ASSERT_GT(std::filesystem::file_size(folder / "b.bzt-journal"), 0u);
  std::filesystem::copy(folder.path(), folder.path().string() + "-copy");
  expectEqual(document, loadScene(folder / "b.bzt"));
  // Saving over such a file must not have the old journal played into the new one.
  const std::filesystem::path copy = folder.path().string() + "-copy";
  saveScene(copy / "b.bzt", Document{});
  EXPECT_TRUE(loadScene(copy / "b.bzt").field.tree.empty());
  std::filesystem::remove_all(copy);
}

struct StopAt : Progress {
  double limit = 0;
  bool report(std::string_view, double done) override { return done < limit; }
};

TEST(SceneFile, cancelledSavesLeaveTheOldFile) {
  const Folder folder;
  SceneFile file;
  Document document = sampleDocument();
  file.save(folder / "a.bzt", document);
  const Bytes before = readFile(folder / "a.bzt");
  const Document old = document;
  dab(document, {0, 0, 0});
  StopAt progress;
  EXPECT_THROW(file.save(folder / "a.bzt", document, progress), Cancelled);
  EXPECT_THROW(file.save(folder / "b.bzt", document, progress), Cancelled);
  EXPECT_THROW(loadScene(folder / "a.bzt", progress), Cancelled);
  EXPECT_EQ(readFile(folder / "a.bzt"), before);
  EXPECT_EQ(namesIn(folder), std::set<std::string>{"a.bzt"});
  file.save(folder / "a.bzt", document);
  expectEqual(document, loadScene(folder / "a.bzt"));
}

// Lets no file of this process grow beyond a number of bytes.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    set(bytes);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() { set(before_.rlim_cur); }

 private:
  void set(rlim_t bytes) const {
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  rlimit before_{};
};

TEST(SceneFile, aFullDiskLeavesTheOldFile) {
  const Folder folder;
  SceneFile file;
  Document document = sampleDocument();
  file.save(folder / "a.bzt", document);
  const Document old = document;
  for (int n = 0; n < 10; ++n) dab(document, {n * 64, 0, 0}, 0.1f * static_cast<float>(n + 1));
  document.parts.shelf[0].payload.assign(300000, std::byte{7});
  for (rlim_t bytes = 0; bytes < 200000; bytes += 9000) {
    const FileSizeLimit limit(bytes);
    EXPECT_THROW(file.save(folder / "a.bzt", document), Error) << bytes;
    EXPECT_THROW(saveScene(folder / "b.bzt", document), Error) << bytes;
  }
  expectEqual(old, loadScene(folder / "a.bzt"));
  EXPECT_EQ(namesIn(folder), std::set<std::string>{"a.bzt"});
  file.save(folder / "a.bzt", document);
  expectEqual(document, loadScene(folder / "a.bzt"));
}

TEST(SceneFile, aReadOnlyFolderIsAnError) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  const Folder folder;
  std::filesystem::permissions(
      folder.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  EXPECT_THROW(saveScene(folder / "a.bzt", Document()), Error);
}

}  // namespace
}  // namespace bozzetto
