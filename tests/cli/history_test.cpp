// Documents that are worked on in place: journal, recovery, the tree of steps, from outside.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace bozzetto {
namespace {

using testing::CommandFolder;
using testing::infoOf;
using testing::jsonOf;
using testing::kHeader;
using testing::Outcome;
using testing::runProgram;

const std::string kWork = kHeader +
                          "{\"op\":\"fill\",\"radii\":[12,12,12]}\n"
                          "{\"op\":\"tool\",\"radii\":[4,4,4]}\n"
                          "{\"op\":\"stroke\",\"points\":[[12,0,0],[0,12,0]]}\n"
                          "{\"op\":\"action\",\"name\":\"remove\"}\n"
                          "{\"op\":\"stroke\",\"points\":[[0,0,12],[0,12,0]]}\n";

std::string hashOf(const std::string& scene) { return infoOf(scene)["field_hash"]; }

class InPlace : public ::testing::Test {
 protected:
  std::string play(const std::string& recording, const std::string& options = "") {
    const std::string file = folder_.write("r.jsonl", recording);
    const Outcome outcome = runProgram("replay " + file + " --on " + scene_ + " " + options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.out;
  }
  /// The same from an empty scene, without a history.
  std::string hashOfPlayed(const std::string& recording) {
    const std::string file = folder_.write("p.jsonl", recording), out = folder_ / "p.bzt";
    EXPECT_EQ(runProgram("replay " + file + " -o " + out).code, 0);
    return hashOf(out);
  }
  /// The first `count` operations of the work.
  static std::string firstOf(int count) {
    std::size_t end = 0;
    for (int line = 0; line <= count; ++line) end = kWork.find('\n', end) + 1;
    return kWork.substr(0, end);
  }

  CommandFolder folder_;
  const std::string scene_ = folder_ / "s.bzt";
};

TEST_F(InPlace, twoStepsCompare) {
  play(kWork, "--new");
  const auto found = jsonOf("history " + scene_ + " --compare 1 3");
  EXPECT_GT(found["corners"], 1000);
  EXPECT_GT(found["blocks"], 10);
  EXPECT_EQ(found["bounds"]["max"].size(), 3u);
  EXPECT_EQ(found["mass_difference"].get<double>(),
            found["mass_after"].get<double>() - found["mass_before"].get<double>());
  EXPECT_EQ(found["mass_after"], jsonOf("info " + scene_)["mass"]);
  const auto back = jsonOf("history " + scene_ + " --compare 3 1");
  EXPECT_EQ(back["corners"], found["corners"]);
  EXPECT_EQ(back["mass_before"], found["mass_after"]);
  const auto same = jsonOf("history " + scene_ + " --compare 2 2");
  EXPECT_EQ(same["corners"], 0);
  EXPECT_TRUE(same["bounds"].is_null());
  EXPECT_EQ(runProgram("history " + scene_ + " --compare 2 9").code, 1);
  EXPECT_EQ(runProgram("history " + scene_ + " --compare 2").code, 2);
  EXPECT_NE(runProgram("history " + scene_ + " --compare 0 3").out.find("corners in"),
            std::string::npos);
}

TEST_F(InPlace, solidsComeBackWithTheirSteps) {
  play(kHeader + "{\"op\":\"solid\",\"edge\":20}\n" +
           "{\"op\":\"solid_move\",\"point\":[2,2,2],\"by\":[5,6,7]}\n{\"op\":\"bake\"}\n",
       "--new");
  const std::string baked = hashOf(scene_);
  play(kHeader + "{\"op\":\"undo\",\"count\":2}\n{\"op\":\"redo\"}\n{\"op\":\"bake\"}\n");
  EXPECT_EQ(hashOf(scene_), baked);
  play(kHeader + "{\"op\":\"undo\",\"count\":2}\n{\"op\":\"bake\"}\n");
  EXPECT_NE(hashOf(scene_), baked);
  play(kHeader + "{\"op\":\"goto\",\"step\":2}\n{\"op\":\"bake\"}\n");
  EXPECT_EQ(hashOf(scene_), baked);
}

TEST_F(InPlace, tellsOfEachOperationAndSavesAtTheEnd) {
  EXPECT_EQ(play(kWork, "--new"), "done 1\ndone 2\ndone 3\ndone 4\ndone 5\n");
  EXPECT_EQ(hashOf(scene_), hashOfPlayed(kWork));
  EXPECT_EQ(jsonOf("info " + scene_)["history_steps"], 3);
  EXPECT_EQ(runProgram("check " + scene_).code, 0);
}

TEST_F(InPlace, historySurvivesFromOneSittingToTheNext) {
  play(kWork, "--new");
  play(kHeader + "{\"op\":\"undo\",\"count\":2}\n");
  EXPECT_EQ(hashOf(scene_), hashOfPlayed(firstOf(1)));
  play(kHeader + "{\"op\":\"redo\"}\n");
  EXPECT_EQ(hashOf(scene_), hashOfPlayed(firstOf(3)));
  play(kHeader + "{\"op\":\"fill\",\"center\":[30,0,0]}\n");
  const auto history = jsonOf("history " + scene_);
  ASSERT_EQ(history["steps"].size(), 4u);
  EXPECT_EQ(history["steps"][3]["parent"], 2) << "a branch";
  EXPECT_EQ(history["steps"][3]["label"], "fill");
  EXPECT_GT(history["steps"][3]["corners"], 1000);
  EXPECT_GT(history["steps"][3]["bytes"], 100);
  EXPECT_EQ(history["place"], 4);
  EXPECT_EQ(history["saved"], true);
  play(kHeader + "{\"op\":\"goto\",\"step\":3}\n");
  EXPECT_EQ(hashOf(scene_), hashOfPlayed(kWork));
  const Outcome text = runProgram("history " + scene_);
  EXPECT_NE(text.out.find("branches off 2"), std::string::npos) << text.out;
}

TEST_F(InPlace, otherStatesGoToOtherFiles) {
  play(kWork, "--new");
  const std::string out = folder_ / "o.bzt", before = folder_.listing();
  ASSERT_EQ(runProgram("history " + scene_ + " --undo 1 -o " + out).code, 0);
  EXPECT_EQ(hashOf(out), hashOfPlayed(firstOf(3)));
  EXPECT_EQ(jsonOf("info " + out)["history_steps"], 0);
  EXPECT_EQ(jsonOf("history " + scene_)["place"], 3) << "the scene stays where it is";
  play(kHeader + "{\"op\":\"undo\",\"count\":99}\n");
  ASSERT_EQ(runProgram("history " + scene_ + " --redo 1 -o " + out).code, 0);
  EXPECT_EQ(hashOf(out), hashOfPlayed(firstOf(1)));
}

TEST_F(InPlace, whatWasNotSavedIsRecovered) {
  play(kWork, "--new");
  play(kHeader + "{\"op\":\"fill\",\"center\":[30,0,0]}\n{\"op\":\"undo\"}\n{\"op\":\"undo\"}\n");
  const std::string hash = hashOfPlayed(firstOf(3));
  // As if the program had ended before it saved: the file never changed.
  std::filesystem::remove(scene_);
  const std::string out = folder_ / "o.bzt";
  const Outcome copy = runProgram("recover " + scene_ + " -o " + out);
  ASSERT_EQ(copy.code, 0) << copy.err;
  EXPECT_NE(copy.out.find("come back"), std::string::npos) << copy.out;
  EXPECT_EQ(hashOf(out), hash);
  EXPECT_FALSE(std::filesystem::exists(scene_));
  ASSERT_EQ(runProgram("recover " + scene_).code, 0);
  EXPECT_EQ(hashOf(scene_), hash);
  const Outcome again = runProgram("recover " + scene_);
  EXPECT_NE(again.out.find("nothing was lost"), std::string::npos) << again.out;
  EXPECT_EQ(hashOf(scene_), hash);
  play(kHeader + "{\"op\":\"redo\"}\n");
  EXPECT_EQ(hashOf(scene_), hashOfPlayed(kWork));
}

TEST_F(InPlace, anotherScenesHistoryIsIgnoredWithAWarning) {
  play(kWork, "--new");
  const std::string file = folder_.write("q.jsonl", kHeader + "{\"op\":\"fill\"}\n");
  ASSERT_EQ(runProgram("replay " + file + " -o " + scene_).code, 0) << "another scene by that name";
  const Outcome outcome = runProgram("history " + scene_ + " --json");
  EXPECT_NE(outcome.err.find("another scene"), std::string::npos) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["steps"].size(), 0u);
  play(kHeader + "{\"op\":\"undo\"}\n");
  EXPECT_EQ(hashOf(scene_), hashOfPlayed(kHeader + "{\"op\":\"fill\"}\n"));
}

TEST_F(InPlace, refusals) {
  const std::string file = folder_.write("r.jsonl", kWork);
  EXPECT_EQ(runProgram("replay " + file).code, 2);
  EXPECT_EQ(runProgram("replay " + file + " --on " + scene_ + " -o x").code, 2);
  EXPECT_EQ(runProgram("replay " + file + " --new -o x").code, 2);
  EXPECT_EQ(runProgram("replay " + file + " --on " + scene_).code, 1) << "no such scene";
  EXPECT_EQ(folder_.listing(), "r.jsonl");
  play(kWork, "--new");
  EXPECT_EQ(runProgram("replay " + file + " --on " + scene_ + " --new").code, 1) << "is there";
  EXPECT_EQ(runProgram("history " + scene_ + " --undo 1").code, 2) << "where to?";
  EXPECT_EQ(runProgram("history " + scene_ + " -o x").code, 2) << "what?";
  EXPECT_EQ(runProgram("recover " + (folder_ / "none.bzt")).code, 1);
  const std::string bad = folder_.write("bad.jsonl", kHeader + "{\"op\":\"goto\",\"step\":77}\n");
  const Outcome outcome = runProgram("replay " + bad + " --on " + scene_);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.err.find("step 77"), std::string::npos) << outcome.err;
}

// Killed at random moments, again and again: what was said to be done is there.
TEST_F(InPlace, SlowKilledAnytimeLosesNothingThatWasDone) {
  const std::string recording = folder_.write("r.jsonl", kWork);
  std::vector<std::string> hashes;
  for (int n = 0; n <= 5; ++n) hashes.push_back(hashOfPlayed(firstOf(n)));
  const std::string out = folder_ / "o.bzt";
  for (int round = 0; round < 30; ++round) {
    std::filesystem::remove(scene_);
    std::filesystem::remove_all(scene_ + ".history");
    const double seconds = 0.004 * round;
    const Outcome killed = testing::runKilled(
        "replay " + recording + " --on " + scene_ + " --new --threads 1", seconds);
    const auto done = std::count(killed.out.begin(), killed.out.end(), '\n');
    if (done == 0) continue;
    const Outcome recovered = runProgram("recover " + scene_ + " -o " + out);
    ASSERT_EQ(recovered.code, 0) << recovered.err;
    const std::string hash = hashOf(out);
    bool found = false;
    for (auto n = done; n <= std::min<std::ptrdiff_t>(done + 2, 5); ++n) found |= hash == hashes[n];
    EXPECT_TRUE(found) << "killed after " << seconds << " s, done " << done;
  }
}

}  // namespace
}  // namespace bozzetto
