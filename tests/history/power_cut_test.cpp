// The power goes at any moment, and operations fail one by one: what was durable is there, what was
// not is there whole or not at all, and opening again finds the same.
#include <gtest/gtest.h>

#include "history/sittings.hpp"
#include "support/crash_file_system.hpp"

namespace bozzetto {
namespace {

using testing::CrashFileSystem;
using testing::FaultKind;
using testing::FaultyFileSystem;
using testing::Sitting;
using testing::Survival;

const std::filesystem::path kFolder = "/disk/faun.bzt.history";
constexpr HistoryIdentity kIdentity{1, 2, 3};

HistoryLimits fewSteps() {
  HistoryLimits limits;
  limits.steps = 8;
  return limits;
}

/// What a sitting went through: after so many operations of the disk this state was durable.
struct Event {
  std::size_t operations;
  std::uint64_t hash;
  std::optional<SavedScene<8>> saved;
};

class PowerCut : public ::testing::Test {
 protected:
  PowerCut() { disk_.addFolder("/disk"); }

  /// Works, saves now and then, and notes when what was durable. `patient`: waits after each.
  void work(Sitting& s, int events, bool patient) {
    std::optional<SavedScene<8>> saved;
    note(s, saved);
    for (int n = 0; n < events; ++n) {
      s.anything();
      if (patient || n % 7 == 0) s.history.waitDurable();
      note(s, saved);
      if (n % 13 != 12) continue;
      s.history.waitDurable();
      note(s, saved);
      saved = SavedScene<8>{s.clay, s.history.savePlace(), s.history.beside()};
      note(s, saved);
      s.history.markSaved(saved->place);
    }
    s.history.waitDurable();
    note(s, saved);
  }

  void note(Sitting& s, const std::optional<SavedScene<8>>& saved) {
    const bool durable = s.history.durableMoment() >= s.history.moment();
    events_.push_back({durable ? disk_.operations() : SIZE_MAX, s.hash(), saved});
  }

  /// The last event that was durable for sure when so many operations were done.
  std::size_t lastDurable(std::size_t operations) const {
    std::size_t last = 0;
    for (std::size_t n = 0; n < events_.size(); ++n) {
      if (events_[n].operations <= operations) last = n;
    }
    return last;
  }

  static std::uint64_t hashAfter(CrashFileSystem& disk, const Event& event) {
    const auto opened =
        openHistory<8>({kFolder, kIdentity, &disk}, event.saved, HistoryAccess::read, fewSteps());
    EXPECT_EQ(validate(opened.field), std::nullopt);
    return testing::stateHash(opened);
  }

  CrashFileSystem disk_;
  std::vector<Event> events_;
};

TEST_F(PowerCut, SlowLosesNothingThatWasDurable) {
  std::size_t tried = 0;
  {
    Sitting s(openHistory<8>({kFolder, kIdentity, &disk_}, {}, HistoryAccess::write, fewSteps()));
    work(s, 60, true);
  }
  for (std::size_t count = 0; count <= disk_.operations(); ++count) {
    const std::size_t known = lastDurable(count);
    for (std::uint32_t seed = 0; seed < 14; ++seed) {
      const auto kind = static_cast<Survival::Kind>(std::min(seed, 3u));
      const auto after = disk_.afterPowerCut(count, {kind, seed, seed % 2 ? 512u : 4096u});
      const std::uint64_t hash = hashAfter(*after, events_[known]);
      bool expected = false;
      for (std::size_t n = known; n < std::min(known + 3, events_.size()); ++n) {
        expected |= hash == events_[n].hash;
      }
      ASSERT_TRUE(expected) << "after " << count << " operations, seed " << seed;
      ++tried;
    }
  }
  EXPECT_GT(tried, 5000u);
}

TEST_F(PowerCut, withStrokesWaitingStillGivesAStateThatWas) {
  std::set<std::uint64_t> hashes;
  {
    Sitting s(openHistory<8>({kFolder, kIdentity, &disk_}, {}, HistoryAccess::write, fewSteps()));
    work(s, 40, false);
  }
  for (const Event& event : events_) hashes.insert(event.hash);
  for (std::size_t count = 0; count <= disk_.operations(); ++count) {
    const Event& known = events_[lastDurable(count)];
    const auto kind = static_cast<Survival::Kind>(count % 4);
    const auto seed = static_cast<std::uint32_t>(count);
    const auto after = disk_.afterPowerCut(count, {kind, seed, 512});
    ASSERT_TRUE(hashes.contains(hashAfter(*after, known))) << count;
  }
}

// Cut, opened again, cut in the middle of that, and so on: always goes on from where it was.
TEST_F(PowerCut, comesBackAgainAndAgain) {
  std::unique_ptr<CrashFileSystem> disk;
  CrashFileSystem* now = &disk_;
  std::mt19937 random(3);
  for (int life = 0; life < 60; ++life) {
    std::size_t durable = 0;
    std::uint64_t hash = 0;
    {
      Sitting s(openHistory<8>({kFolder, kIdentity, now}, {}, HistoryAccess::write, fewSteps()));
      s.random.seed(static_cast<unsigned>(life));
      const auto events = random() % 8u;
      for (unsigned n = 0; n < events; ++n) s.anything();
      s.history.waitDurable();
      durable = now->operations();
      hash = s.hash();
      s.change();
    }
    const std::size_t count = durable + random() % (now->operations() - durable + 1);
    const auto kind = static_cast<Survival::Kind>(random() % 4u);
    auto next = now->afterPowerCut(count, {kind, static_cast<std::uint32_t>(random()), 512});
    const auto found = hashAfter(*next, {0, 0, {}});
    ASSERT_TRUE(found == hash || count > durable) << life;
    ASSERT_EQ(hashAfter(*next, {0, 0, {}}), found);
    disk = std::move(next);
    now = disk.get();
  }
}

class Failing : public ::testing::TestWithParam<std::tuple<FaultKind, int, bool>> {};

TEST_P(Failing, everyOperationInTurnLosesNothing) {
  const auto [kind, number, forever] = GetParam();
  CrashFileSystem disk;
  FaultyFileSystem files(disk);
  disk.addFolder("/disk");
  std::filesystem::path folder;
  std::optional<Sitting> sitting;
  int round = 0;
  const auto work = [&] {
    sitting.reset();
    folder = "/disk/" + std::to_string(++round);
    try {
      sitting.emplace(
          openHistory<8>({folder, kIdentity, &files}, {}, HistoryAccess::write, fewSteps()));
      for (int n = 0; n < 14; ++n) {
        sitting->anything();
        try {
          sitting->history.waitDurable();
        } catch (const Error&) {
        }
      }
    } catch (const Error&) {
    }
  };
  const auto check = [&](std::size_t failed) {
    files.start();
    if (!sitting) return;
    ASSERT_TRUE(sitting->asItWas()) << "operation " << failed;
    sitting->change();
    sitting->history.waitDurable();
    const auto hash = sitting->hash();
    const std::size_t depth = sitting->history.undoDepth();
    sitting.reset();
    auto opened = openHistory<8>({folder, kIdentity, &disk}, {}, HistoryAccess::read);
    ASSERT_EQ(testing::stateHash(opened), hash) << "operation " << failed;
    ASSERT_GE(opened.history.undoDepth(), depth) << "operation " << failed;
    ASSERT_TRUE(opened.notices.empty()) << opened.notices[0];
  };
  testing::failEveryOperation(files, {kind, number, forever}, work, check);
}

INSTANTIATE_TEST_SUITE_P(faults, Failing,
                         ::testing::Values(std::tuple{FaultKind::error, EIO, false},
                                           std::tuple{FaultKind::error, ENOSPC, true},
                                           std::tuple{FaultKind::error, EDQUOT, false},
                                           std::tuple{FaultKind::shortWrite, 0, true},
                                           std::tuple{FaultKind::interrupted, 0, true}));

}  // namespace
}  // namespace bozzetto
