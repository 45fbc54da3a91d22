// Every recording of data/recordings replays, to one field on any number of threads, to a closed
// surface, and its ledger balances.
#include <gtest/gtest.h>

#include <filesystem>

#include "bozzetto/mesh/check.hpp"
#include "bozzetto/sculptor/replay.hpp"
#include "bozzetto/surface/statistics.hpp"
#include "bozzetto/surface/welded.hpp"

namespace bozzetto {
namespace {

namespace fs = std::filesystem;

const fs::path kRecordings = fs::path(BOZZETTO_SOURCE_DIR) / "data" / "recordings";

void expectSound(const Clay& clay, const std::string& name) {
  EXPECT_EQ(validate(clay), std::nullopt) << name;
  Surface<8> surface;
  surface.rebuild(clay);
  EXPECT_TRUE(isSolid(checkMesh(weld(surface, clay.scale)))) << name;
}

TEST(Recordings, everyFeatureReplaysTheSameOnAnyThreads) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(kRecordings / "features")) {
    if (entry.path().extension() != ".jsonl") continue;
    const std::string name = entry.path().filename();
    const Recording recording = readRecording(entry.path());
    setThreadCount(1);
    const ReplayResult one = replay(recording, {});
    setThreadCount(3);
    EXPECT_EQ(fieldHash(replay(recording, {}).field), fieldHash(one.field)) << name;
    setThreadCount(0);
    EXPECT_DOUBLE_EQ(totalOf(one.reports).massAfter, statistics(one.field).mass) << name;
    expectSound(one.field, name);
    ++count;
  }
  EXPECT_GE(count, 10);
}

TEST(Recordings, SolidsReplayToSoundClaySlow) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(kRecordings / "solids")) {
    if (entry.path().extension() != ".jsonl") continue;
    const std::string name = entry.path().filename();
    const ReplayResult result = replay(readRecording(entry.path()), {});
    EXPECT_GT(statistics(result.field).corners, 5'000) << name;
    expectSound(result.field, name);
    ++count;
  }
  EXPECT_EQ(count, 7);
}

TEST(Recordings, SlowClayThatIsPulledNecksAndParts) {
  const ReplayResult result = replay(readRecording(kRecordings / "clay" / "neck.jsonl"), {});
  expectSound(result.field, "neck");
  Surface<8> surface;
  surface.rebuild(result.field);
  EXPECT_EQ(statistics(surface, result.field).components, 2u) << "both ends, no thread between";
}

class Sculptures : public ::testing::TestWithParam<const char*> {};

TEST_P(Sculptures, SlowReplayToSolidFigures) {
  const Recording recording = readRecording(kRecordings / GetParam());
  const ReplayResult result = replay(recording, {});
  EXPECT_GT(statistics(result.field).corners, 100'000);
  expectSound(result.field, GetParam());
}

INSTANTIATE_TEST_SUITE_P(all, Sculptures,
                         ::testing::Values("clown.jsonl", "creature.jsonl", "vase.jsonl"));

}  // namespace
}  // namespace bozzetto
