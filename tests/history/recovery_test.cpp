#include "bozzetto/history/recovery.hpp"

#include <gtest/gtest.h>

#include "history/sittings.hpp"
#include "support/crash_file_system.hpp"
#include "support/folder.hpp"

namespace bozzetto {
namespace {

using testing::CrashFileSystem;
using testing::Sitting;

const std::filesystem::path kFolder = "/disk/faun.bzt.history";
constexpr HistoryIdentity kIdentity{1, 2, 3, 4, 5, 6, 7, 8, 9};

class Recovery : public ::testing::Test {
 protected:
  Recovery() { disk_.addFolder("/disk"); }

  OpenedHistory<8> open(HistoryAccess access = HistoryAccess::write, std::size_t steps = 200) {
    HistoryLimits limits;
    limits.steps = steps;
    return openHistory<8>({kFolder, kIdentity, files_}, saved_, access, limits);
  }

  /// Some work with branches, written to the disk.
  std::map<StepNumber, std::uint64_t> work(int events, std::size_t steps = 200) {
    Sitting s(open(HistoryAccess::write, steps));
    for (int n = 0; n < events; ++n) {
      s.anything();
      if (n % 5 == 0) s.history.waitDurable();
    }
    for (int n = 0; n < 100 && s.history.tree().size() > steps; ++n) s.history.waitDurable();
    s.history.waitDurable();
    last_ = s.hash();
    place_ = s.history.place();
    tip_ = s.history.tree().tip();
    return s.hashes;
  }

  void save(Sitting& s) {
    saved_ = SavedScene<8>{s.clay, s.history.savePlace(), s.history.beside()};
    s.history.markSaved(saved_->place);
  }

  /// The disk as it is now, as the one to work on: for damage done to it.
  CrashFileSystem& anotherDisk() {
    other_ = disk_.afterPowerCut(disk_.operations(), {testing::Survival::Kind::all, 0, 512});
    files_ = other_.get();
    return *other_;
  }

  CrashFileSystem disk_;
  std::unique_ptr<CrashFileSystem> other_;
  FileSystem* files_ = &disk_;
  std::optional<SavedScene<8>> saved_;
  std::uint64_t last_ = 0;
  StepNumber place_ = 0, tip_ = 0;
};

TEST_F(Recovery, aDocumentThatWasNeverSavedComesBackWithItsHistory) {
  const auto hashes = work(60);
  for (int again = 0; again < 2; ++again) {
    auto opened = open();
    EXPECT_TRUE(opened.recovered);
    EXPECT_TRUE(opened.notices.empty()) << opened.notices[0];
    EXPECT_EQ(testing::stateHash(opened), last_);
    EXPECT_EQ(validate(opened.field), std::nullopt);
    Sitting s(std::move(opened));
    EXPECT_EQ(s.history.place(), place_);
    EXPECT_EQ(s.history.tree().tip(), tip_);
    EXPECT_EQ(s.history.tree().validate(), std::nullopt);
  }
  Sitting s(open());
  s.hashes = hashes;
  for (const Step& step : s.history.steps()) {
    EXPECT_EQ(step.note.label, "stroke");
    EXPECT_GT(step.bytes, 0u);
    EXPECT_GT(step.time, 1'700'000'000'000);
    s.goTo(step.number);
    ASSERT_TRUE(s.asItWas()) << step.number;
  }
}

// Without clay: what comes back is the solid.
TEST_F(Recovery, solidsComeBackWithTheirSteps) {
  std::vector<SolidRef> solids{nullptr};
  const auto nothing = std::make_shared<const Delta<testing::Block>>();
  {
    Sitting s(open());
    for (int n = 0; n < 30; ++n) {
      solids.push_back(testing::changedSolid(solids.back(), s.random));
      s.history.push(nothing, {"solid_move", {}, {}}, solids.back());
      if (n == 20) save(s);
    }
  }
  Sitting s(open());
  for (const StepNumber state : {30u, 0u, 17u, 3u, 21u, 30u, 1u}) {
    ASSERT_EQ(s.goTo(state), "");
    ASSERT_EQ(encodeSolid(s.history.solid()), encodeSolid(solids[state])) << state;
  }
}

TEST_F(Recovery, aCheckpointHoldsTheSolid) {
  HistoryLimits limits;
  limits.steps = 3;
  std::uint64_t hash = 0;
  {
    Sitting s(openHistory<8>({kFolder, kIdentity, &disk_}, {}, HistoryAccess::write, limits));
    for (int n = 0; n < 40 && (n < 20 || !s.history.solid()); ++n) {
      s.change();
      s.history.waitDurable();
    }
    ASSERT_NE(s.history.solid(), nullptr);
    hash = s.hash();
  }
  const auto opened = open();
  EXPECT_NE(opened.history.tree().root(), 0u);
  EXPECT_EQ(testing::stateHash(opened), hash);
}

TEST_F(Recovery, historySurvivesSavingAndReopening) {
  {
    Sitting s(open());
    for (int n = 0; n < 5; ++n) s.change();
    s.undo();
    save(s);
    EXPECT_TRUE(s.history.atSaved());
    last_ = s.hash();
  }
  auto opened = open();
  EXPECT_FALSE(opened.recovered);
  EXPECT_EQ(opened.unsavedSteps, 0u);
  EXPECT_EQ(testing::stateHash(opened), last_);
  Sitting s(std::move(opened));
  EXPECT_TRUE(s.history.atSaved());
  EXPECT_EQ(s.history.undoDepth(), 4u);
  EXPECT_EQ(s.history.redoDepth(), 1u);
  s.undo(9);
  EXPECT_TRUE(s.clay.tree.empty());
  EXPECT_FALSE(s.history.atSaved());
}

TEST_F(Recovery, tellsWhatWasNotSaved) {
  {
    Sitting s(open());
    for (int n = 0; n < 5; ++n) s.change();
    save(s);
    for (int n = 0; n < 3; ++n) s.change();
  }
  const auto opened = open();
  EXPECT_TRUE(opened.recovered);
  EXPECT_EQ(opened.unsavedSteps, 3u);
  EXPECT_EQ(opened.history.place(), 8u);
}

TEST_F(Recovery, anOlderFilePutBackIsShownAndItsHistoryStays) {
  std::optional<SavedScene<8>> old;
  {
    Sitting s(open());
    for (int n = 0; n < 5; ++n) s.change();
    save(s);
    old = saved_;
    for (int n = 0; n < 3; ++n) s.change();
    save(s);
  }
  saved_ = old;
  const auto opened = open();
  EXPECT_FALSE(opened.recovered);
  EXPECT_EQ(opened.history.place(), 5u);
  EXPECT_EQ(opened.history.redoDepth(), 3u);
}

TEST_F(Recovery, rotationKeepsTheNewestAndWhatRecoveryNeeds) {
  const auto hashes = work(400, 12);
  std::size_t undoFiles = 0;
  for (const std::string& name : disk_.list(kFolder)) undoFiles += name.ends_with(".undo") ? 1 : 0;
  EXPECT_LE(undoFiles, 20u);
  EXPECT_GE(undoFiles, 12u);
  auto opened = open(HistoryAccess::write, 12);
  EXPECT_TRUE(opened.notices.empty()) << opened.notices[0];
  EXPECT_EQ(testing::stateHash(opened), last_);
  Sitting s(std::move(opened));
  s.hashes = hashes;
  for (const Step& step : s.history.steps()) {
    if (s.history.tree().has(step.number)) s.goTo(step.number);
    ASSERT_TRUE(s.asItWas()) << step.number;
  }
}

TEST_F(Recovery, aDeepHistoryIsNotHeldInMemory) {
  Sitting s(open(HistoryAccess::write, 0));
  std::size_t thousand = 0;
  for (int n = 1; n <= 1500; ++n) {
    s.change();
    if (n % 50 == 0) s.history.waitDurable();
    if (n == 1000) thousand = s.history.memoryBytes();
  }
  EXPECT_LT(s.history.memoryBytes(), thousand + thousand / 4);
  EXPECT_EQ(s.history.undoDepth(), 1500u);
  s.goTo(3);
  EXPECT_TRUE(s.asItWas()) << "from the disk";
}

TEST_F(Recovery, aDiskBudgetIsKept) {
  HistoryLimits limits;
  limits.steps = 0;
  limits.diskBytes = 100'000;
  Sitting s(openHistory<8>({kFolder, kIdentity, &disk_}, {}, HistoryAccess::write, limits));
  for (int n = 0; n < 400; ++n) {
    s.change();
    if (n % 10 == 0) s.history.waitDurable();
  }
  s.history.waitDurable();
  s.change();
  s.history.waitDurable();
  std::uint64_t bytes = 0;
  for (const Step& step : s.history.steps()) bytes += step.bytes;
  EXPECT_LT(bytes, 200'000u);
  EXPECT_GT(bytes, 50'000u);
}

TEST_F(Recovery, aDamagedOrMissingFileCutsTheHistoryThereOnly) {
  const auto hashes = work(40);
  const auto names = disk_.list(kFolder);
  for (const std::string& name : names) {
    if (name == "lock") continue;
    const Bytes good = disk_.content(kFolder / name);
    for (int damage = 0; damage < 4; ++damage) {
      CrashFileSystem& disk = anotherDisk();
      Bytes bad = good;
      if (damage == 0) bad[bad.size() / 2] ^= std::byte{16};
      if (damage == 1) bad.resize(bad.size() / 2);
      if (damage == 2) bad.clear();
      if (damage == 3) {
        disk.remove(kFolder / name);
      } else {
        disk.setContent(kFolder / name, bad);
      }
      auto opened = open(HistoryAccess::read);
      const auto known = hashes.find(opened.history.place());
      ASSERT_NE(known, hashes.end()) << name;
      ASSERT_EQ(testing::stateHash(opened), known->second) << name;
      const bool told = opened.notices.size() == 1;
      EXPECT_TRUE(told || damage == 0 || damage == 3) << name << damage;
      Sitting s(std::move(opened));
      s.hashes = hashes;
      s.undo(99);
      EXPECT_TRUE(s.asItWas());
      s.redo(99);
      EXPECT_TRUE(s.asItWas());
    }
  }
  files_ = &disk_;
  EXPECT_EQ(testing::stateHash(open()), last_) << "nothing else was harmed";
}

TEST_F(Recovery, damageFoundOnTheWayCutsThere) {
  {
    Sitting s(open());
    for (int n = 0; n < 8; ++n) s.change();
    save(s);
  }
  const auto name = kFolder / "0000000004.undo";
  Bytes bad = disk_.content(name);
  bad[bad.size() - 3] ^= std::byte{1};
  anotherDisk().setContent(name, bad);
  Sitting s(open());
  EXPECT_EQ(s.history.undoDepth(), 8u) << "heads are sound";
  const std::string trouble = s.goTo(0);
  EXPECT_NE(trouble.find("0000000004.undo"), std::string::npos);
  EXPECT_EQ(s.history.place(), 4u);
  EXPECT_EQ(s.history.undoDepth(), 0u);
  EXPECT_EQ(s.history.redoDepth(), 4u);
  EXPECT_EQ(s.history.tree().validate(), std::nullopt);
  s.change();
  s.history.waitDurable();
  const auto hash = s.hash();
  s = Sitting();
  EXPECT_EQ(testing::stateHash(open()), hash);
}

TEST_F(Recovery, theSecondInstanceOnlyReads) {
  Sitting first(open());
  first.change();
  first.history.waitDurable();
  {
    auto opened = open();
    EXPECT_TRUE(opened.readOnly);
    EXPECT_FALSE(opened.history.onDisk());
    EXPECT_EQ(opened.history.place(), 1u);
    Sitting second(std::move(opened));
    second.change();
    second.undo(5);
    EXPECT_TRUE(second.clay.tree.empty());
  }
  first.change();
  first.history.waitDurable();
  const auto hash = first.hash();
  first = Sitting();
  const auto opened = open();
  EXPECT_FALSE(opened.readOnly);
  EXPECT_EQ(testing::stateHash(opened), hash);
}

TEST_F(Recovery, anotherScenesHistoryIsLeftAlone) {
  const testing::Folder real;
  const auto folder = real / "faun.bzt.history";
  {
    Sitting s(openHistory<8>({folder, kIdentity}, {}, HistoryAccess::write));
    for (int n = 0; n < 5; ++n) s.change();
  }
  const HistoryFolder other{folder, {9, 9, 9}};
  const auto looked = openHistory<8>(other, {}, HistoryAccess::read);
  EXPECT_EQ(looked.history.tree().size(), 0u);
  ASSERT_EQ(looked.notices.size(), 1u);
  EXPECT_NE(looked.notices[0].find("another scene"), std::string::npos);
  EXPECT_EQ(identityOf(folder), kIdentity);
  {
    Sitting s(openHistory<8>(other, {}, HistoryAccess::write));
    s.change();
  }
  EXPECT_EQ(identityOf(folder), other.identity);
  EXPECT_EQ(identityOf(folder.string() + ".01020304"), kIdentity);
}

TEST_F(Recovery, aSceneThatFitsNoStepIsTakenAsItIs) {
  work(10);
  Clay clay = testing::ball<8>(9);
  saved_ = SavedScene<8>{clay, {77, 77, 1234, 9999}};
  const auto opened = open(HistoryAccess::read);
  EXPECT_EQ(testing::stateHash(opened), fieldHash(clay));
  EXPECT_EQ(opened.history.undoDepth(), 0u);
}

TEST_F(Recovery, thumbnailsComeBack) {
  const Bytes picture(100, std::byte{7});
  {
    Sitting s(open());
    auto delta =
        std::make_shared<const Delta<testing::Block>>(testing::randomChange(s.clay, s.random));
    s.history.push(std::move(delta), {"stroke", {}, {}}, {}, picture);
  }
  EXPECT_EQ(open().history.thumbnail(1), picture);
  EXPECT_TRUE(open().history.thumbnail(2).empty());
}

}  // namespace
}  // namespace bozzetto
