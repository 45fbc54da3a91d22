// The power is cut at every moment of a session, and the disk keeps of what was not synced whatever
// it likes: the scene is as it was saved last, or as it was being saved.
#include <set>

#include "scene/crash_disk.hpp"

namespace bozzetto {
namespace {

using testing::CrashFileSystem;
using testing::Fault;
using testing::FaultKind;
using testing::FaultyFileSystem;
using testing::kScene;
using testing::smallDocument;
using testing::stateOf;
using testing::Survival;
using testing::worked;

#ifdef BOZZETTO_SANITIZED
constexpr std::uint32_t kSeeds = 6;
#else
constexpr std::uint32_t kSeeds = 40;
#endif

Survival survival(std::uint32_t seed) {
  const auto kind = static_cast<Survival::Kind>(std::min(seed, 3u));
  return {kind, seed, seed % 2 == 0 ? 512u : 4096u};
}

std::optional<std::uint64_t> stateOn(CrashFileSystem& disk) {
  if (!disk.info(kScene)) return std::nullopt;
  return stateOf(loadScene(kScene, Progress::none(), disk));
}

// What was saved when: after so many operations of the disk the state is durable.
struct Saved {
  std::size_t operations;
  std::optional<std::uint64_t> state;
};

class PowerCuts : public ::testing::Test {
 protected:
  PowerCuts() {
    disk_.addFolder("/disk");
    saved_.push_back({0, std::nullopt});
  }
  void save(SceneFile& file, const Document& document) {
    file.save(kScene, document);
    saved_.push_back({disk_.operations(), stateOf(document)});
  }
  // Two sittings with whole saves, saves of changes, and a previous version.
  void session() {
    Document document = smallDocument();
    {
      SceneFile file(disk_);
      for (int step = 0; step < 3; ++step) save(file, document = worked(document, step));
    }
    SceneFile file(disk_);
    document = file.load(kScene);
    for (int step = 3; step < 6; ++step) save(file, document = worked(document, step));
    document.field.tree.clear();
    save(file, document);
    save(file, document = worked(document, 6));
  }
  // States that the disk may have after so many operations: saved last, being saved.
  std::set<std::optional<std::uint64_t>> allowed(std::size_t operations) const {
    std::set<std::optional<std::uint64_t>> states;
    for (std::size_t n = 0; n < saved_.size(); ++n) {
      const bool over = n + 1 < saved_.size() && saved_[n + 1].operations <= operations;
      const bool begun = n == 0 || saved_[n - 1].operations < operations;
      if (!over && begun) states.insert(saved_[n].state);
    }
    return states;
  }

  CrashFileSystem disk_;
  std::vector<Saved> saved_;
};

TEST_F(PowerCuts, atAnyMomentLeaveTheOldOrTheNew) {
  session();
  std::size_t cuts = 0;
  std::set<std::optional<std::uint64_t>> seen;
  for (std::size_t count = 0; count <= disk_.operations(); ++count) {
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed, ++cuts) {
      const auto after = disk_.afterPowerCut(count, survival(seed));
      const auto state = stateOn(*after);
      ASSERT_TRUE(allowed(count).contains(state)) << count << " operations, seed " << seed;
      seen.insert(state);
    }
  }
  EXPECT_EQ(seen.size(), saved_.size());
  EXPECT_GE(cuts, kSeeds * 130);
  RecordProperty("cuts", static_cast<int>(cuts));
}

// And again while what the first cut left is being put right, as often as one likes.
TEST_F(PowerCuts, whileRecoveringChangeNothing) {
  session();
  std::size_t cuts = 0;
  for (std::size_t count = 0; count <= disk_.operations(); count += 3) {
    const auto after = disk_.afterPowerCut(count, survival(3 + static_cast<std::uint32_t>(count)));
    const auto state = stateOn(*after);
    for (std::size_t again = 0; again <= after->operations(); ++again) {
      for (std::uint32_t seed = 0; seed < kSeeds / 2; ++seed, ++cuts) {
        const auto twice = after->afterPowerCut(again, survival(seed));
        ASSERT_EQ(stateOn(*twice), state) << count << ", " << again << ", seed " << seed;
      }
    }
    SceneFile file(*after);
    Document document = state ? file.load(kScene) : smallDocument();
    file.save(kScene, document = worked(document, 9));
    EXPECT_EQ(stateOn(*after->afterPowerCut(after->operations(), {})), stateOf(document));
  }
  RecordProperty("cuts", static_cast<int>(cuts));
}

// A disk whose sync fails once: what is called saved afterwards is on the disk all the same.
TEST_F(PowerCuts, afterAFailedOperationSavedMeansSaved) {
  for (std::size_t failing = 1;; ++failing) {
    CrashFileSystem disk;
    disk.addFolder("/disk");
    FaultyFileSystem files(disk);
    SceneFile file(files);
    Document document = smallDocument();
    file.save(kScene, document);
    files.start({FaultKind::error, EIO, false, failing});
    for (int step = 1; step < 4; ++step) {
      document = worked(document, step);
      try {
        file.save(kScene, document);
      } catch (const Error&) {
        file.save(kScene, document);
      }
      for (std::uint32_t seed = 0; seed < 4; ++seed) {
        const auto after = disk.afterPowerCut(disk.operations(), survival(seed));
        ASSERT_EQ(stateOn(*after), stateOf(document))
            << "operation " << failing << ", seed " << seed;
      }
    }
    if (!files.failed()) break;
  }
}

}  // namespace
}  // namespace bozzetto
