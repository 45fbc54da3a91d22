// `bozzetto tool` from outside, and what recordings say of tools: what is made, what is refused.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace bozzetto {
namespace {

using testing::CommandFolder;
using testing::infoOf;
using testing::kBall;
using testing::kHeader;
using testing::kProgram;
using testing::Outcome;
using testing::runProgram;
using testing::sceneOf;

// What is said of arguments that are refused.
std::string refusal(const std::string& arguments) {
  const Outcome outcome = runProgram(arguments);
  EXPECT_EQ(outcome.code, 1) << arguments;
  return outcome.err;
}

TEST(Tool, toolsHaveNamesThatFilesCanHave) {
  const CommandFolder folder;
  const std::string scene = sceneOf(folder, kBall), out = " -o " + (folder / "t.bzt");
  for (const char* name : {"../evil", "''", ".hidden", "\"$(printf 'a\\tb')\""}) {
    const Outcome outcome = runProgram("tool make " + scene + " --name " + name + out);
    EXPECT_EQ(outcome.code, 1) << name;
    EXPECT_NE(outcome.err.find("tool name: "), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(runProgram("tool make --text A/B -o " + (folder / "ab.bzt")).code, 0) << "its own file";
  EXPECT_EQ(runProgram("tool make " + scene + " --region nan 1 1 2 2 2" + out).code, 1);
  const std::string thousand(300, 'n');
  EXPECT_EQ(refusal("tool make " + scene + " --name " + thousand + out),
            "bozzetto: tool name: 300 bytes found, 1 to 255 bytes expected\n");
  EXPECT_EQ(
      refusal("tool make " + scene + " --name " + thousand.substr(0, 253) + out),
      "bozzetto: tool name: 253 bytes found, at most 251 expected: files' names hold no more\n");
  EXPECT_EQ(refusal("tool make " + scene + " --name ' '" + out),
            "bozzetto: tool name: ' ' found, one without blanks at its ends expected\n");
  EXPECT_NE(refusal("tool make " + scene + " --name \"$(printf '\\377')\"" + out).find("UTF-8"),
            std::string::npos);
  EXPECT_NE(refusal("tool make " + scene + " --tags \"$(printf '\\377')\"" + out).find("UTF-8"),
            std::string::npos);
  EXPECT_EQ(refusal("tool make --text ''" + out),
            "bozzetto: --text: nothing found, letters expected\n");
  EXPECT_EQ(folder.listing(), "ab.bzt r.jsonl s.bzt");
}

TEST(Tool, placesAndDirectionsAreSome) {
  const CommandFolder folder;
  const std::string make = "tool make " + sceneOf(folder, kBall) + " -o " + (folder / "t.bzt");
  for (const auto& [wrong, told] : {
           std::pair("--pivot nan 0 0", "tool pivot: [nan, 0, 0] found, finite numbers expected"),
           std::pair("--contact 0 0 0", "tool contact: [0, 0, 0] found, a direction expected"),
           std::pair("--plane 0 0 0 0 0 0",
                     "tool plane's normal: [0, 0, 0] found, a direction expected"),
           std::pair("--region 5 5 5 1 1 1",
                     "region: min 5 and max 1 found on axis x, max above min expected"),
           std::pair("--region 0 0 0 9 9 0",
                     "region: min 0 and max 0 found on axis z, max above min expected"),
       })
    EXPECT_EQ(refusal(make + " " + wrong), "bozzetto: " + std::string(told) + "\n") << wrong;
  const std::string air = refusal(make + " --region 1000 1000 1000 1001 1001 1001");
  EXPECT_NE(air.find("s.bzt holds no clay in the region; it has some from ["), std::string::npos)
      << air;
  EXPECT_EQ(folder.listing(), "r.jsonl s.bzt");
}

// The user's library in a folder of its own.
TEST(Tool, startersKeepTheirNamesUnlessTheyAreReplaced) {
  const CommandFolder folder;
  ::setenv("XDG_DATA_HOME", (folder / "").c_str(), 1);
  const std::string scene = sceneOf(folder, kBall), make = "tool make " + scene + " --name leaf";
  const std::string told = refusal(make);
  EXPECT_NE(told.find("leaf: a starter is called so"), std::string::npos) << told;
  EXPECT_EQ(folder.listing(), "r.jsonl s.bzt");
  EXPECT_EQ(runProgram(make + " -o " + (folder / "leaf.bzt")).code, 0) << "not in the library";
  EXPECT_EQ(runProgram(make + " --replace").code, 0);
  EXPECT_EQ(refusal(make + " -o " + (folder / "bozzetto/tools/rake.bzt")).find("rake: a starter"),
            std::string("bozzetto: ").size());
  folder.write("use.jsonl", kHeader + "{\"op\":\"combine\",\"with\":\"shelf:leaf\"}\n");
  const Outcome used = runProgram("replay " + (folder / "use.jsonl") + " -o " + (folder / "u.bzt"));
  EXPECT_EQ(used.code, 0) << used.err;
  EXPECT_NE(used.err.find("shelf:leaf: the user's library has one"), std::string::npos) << used.err;
  ::unsetenv("XDG_DATA_HOME");
}

TEST(Tool, ofTwoThatAreMadeAtOnceOneIsThere) {
  const CommandFolder folder;
  const std::string out = folder / "t.bzt";
  const Outcome both =
      runProgram("tool make --text A -o " + out + " & " + kProgram + " tool make --text B -o " +
                 out + " && echo second; wait $! && echo first");
  EXPECT_NE(both.out.find("first\n") == std::string::npos,
            both.out.find("second\n") == std::string::npos)
      << both.out << both.err;
  EXPECT_NE(both.err.find("exists already"), std::string::npos) << both.err;
  EXPECT_EQ(folder.listing(), "t.bzt");
}

TEST(Tool, whatIsLeftOutOfTheListIsTold) {
  const CommandFolder folder;
  ::setenv("XDG_DATA_HOME", (folder / "").c_str(), 1);
  ASSERT_EQ(runProgram("tool make --text A --name good").code, 0);
  folder.write("bozzetto/tools/broken.bzt", "no scene");
  const Outcome listed = runProgram("tool list leaf");
  EXPECT_EQ(listed.code, 0);
  EXPECT_NE(listed.out.find("leaf"), std::string::npos) << listed.out;
  EXPECT_NE(listed.err.find("left out: "), std::string::npos) << listed.err;
  EXPECT_NE(listed.err.find("broken.bzt"), std::string::npos) << listed.err;
  EXPECT_EQ(listed.err.find("good"), std::string::npos) << listed.err;
  ::unsetenv("XDG_DATA_HOME");
}

TEST(Tool, errorsThatNobodyReadsAreErrors) {
  const Outcome outcome = runProgram("tool make 2>&- >&-");
  EXPECT_EQ(outcome.code, 1);
}

TEST(Tool, presetsHoldWhatReplayTakes) {
  const CommandFolder folder;
  const std::string file = folder / "p.jsonl";
  const std::string make = "tool make --preset " + file + " -o " + (folder / "x.bzt");
  for (const auto& [line, told] : {
           std::pair(R"({"op":"tool","shape":"box","radii":[6,-3,1.5]})",
                     "tool radius: -3 found on axis y, a number above 0 expected"),
           std::pair(R"({"op":"action","name":"add","strength":77})",
                     "action strength: 77 found, a number in 0…1 expected"),
           std::pair(R"({"op":"stroke","points":[[0,0,0]],"spacing":-1})",
                     "stroke spacing: -1 found, a number above 0 expected"),
           std::pair(R"({"op":"action","name":"recall","step":1})",
                     "action recall found, one that every document can do expected"),
       }) {
    folder.write("p.jsonl", kHeader + line + "\n");
    EXPECT_EQ(refusal(make), "bozzetto: " + file + ":2: " + told + "\n");
  }
  EXPECT_EQ(folder.listing(), "p.jsonl");
}

TEST(Tool, toolsAreNotReplacedUnasked) {
  const CommandFolder folder;
  const std::string scene = sceneOf(folder, kBall), tool = folder / "t.bzt";
  const std::string make = "tool make " + scene + " -o ";
  ASSERT_EQ(runProgram(make + tool + " --tags first").code, 0);
  const Outcome again = runProgram(make + tool);
  EXPECT_EQ(again.code, 1);
  EXPECT_NE(again.err.find("--replace"), std::string::npos) << again.err;
  EXPECT_NE(runProgram("tool show " + tool).out.find("first"), std::string::npos);
  EXPECT_EQ(runProgram(make + tool + " --replace --tags second").code, 0);
  EXPECT_NE(runProgram("tool show " + tool).out.find("second"), std::string::npos);
  EXPECT_EQ(runProgram(make + (folder / "t.png")).code, 1) << "no name of a tool";
  for (const std::string& out : {tool, scene, folder / "t.jpg"}) {
    EXPECT_EQ(runProgram("tool render " + tool + " " + out).code, 1) << out;
    EXPECT_EQ(runProgram("render " + scene + " " + out).code, 1) << out;
  }
  EXPECT_EQ(runProgram("check " + tool).code, 0);
  EXPECT_EQ(runProgram("check " + scene).code, 0);
  EXPECT_EQ(folder.listing(), "r.jsonl s.bzt t.bzt");
}

TEST(Tool, toolsHaveSizesThatToolsCanHave) {
  const CommandFolder folder;
  const std::string out = " -o " + (folder / "t.bzt");
  for (const char* wrong : {"--size 1e9", "--size 0", "--depth 1e30", "--depth nan"}) {
    const Outcome outcome = runProgram("tool make --text A " + std::string(wrong) + out);
    EXPECT_EQ(outcome.code, 1) << wrong;
    EXPECT_NE(outcome.err.find("expected"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(folder.listing(), "");
}

TEST(Tool, aPresetStandsAlone) {
  const CommandFolder folder;
  folder.write("p.jsonl", kHeader +
                              "{\"op\":\"tool\",\"shape\":\"box\",\"radii\":[4,2,1]}\n"
                              "{\"op\":\"action\",\"name\":\"remove\",\"strength\":0.25}\n");
  const std::string tool = folder / "chisel.bzt";
  const Outcome made = runProgram("tool make --preset " + (folder / "p.jsonl") + " -o " + tool);
  ASSERT_EQ(made.code, 0) << made.err;
  const auto json = nlohmann::json::parse(runProgram("tool show " + tool).out);
  EXPECT_EQ(json["name"], "p");
  EXPECT_EQ(json["preset"].size(), 2u);
  EXPECT_EQ(json["preset"][0]["shape"], "box");
  EXPECT_FALSE(json.contains("mass"));
  EXPECT_EQ(runProgram("tool make -o " + (folder / "none.bzt")).code, 1);
  folder.write("e.jsonl", kHeader + "{\"op\":\"fill\"}\n");
  EXPECT_EQ(
      runProgram("tool make --preset " + (folder / "e.jsonl") + " -o " + (folder / "x.bzt")).code,
      1);
  // On a shelf of a scene without clay, and of one with.
  for (const char* clay : {"", "{\"op\":\"fill\"}\n"}) {
    folder.write("k.jsonl",
                 kHeader + clay +
                     "{\"op\":\"shelf_keep\",\"name\":\"c\",\"preset\":[{\"op\":\"tool\","
                     "\"shape\":\"capsule\"}]}\n");
    const Outcome kept = runProgram("replay " + (folder / "k.jsonl") + " -o " + (folder / "k.bzt"));
    EXPECT_EQ(kept.code, 0) << kept.err;
  }
}

// A lasso that sees the right half of a ball.
TEST(Tool, toolsAreMadeOfWhatALassoHolds) {
  const CommandFolder folder;
  const std::string scene = sceneOf(folder, kBall), tool = folder / "half.bzt";
  const std::string lasso =
      R"('{"lasso":[[0,-90],[90,-90],[90,90],[0,90]],"view":{"eye":[0,0,99],"parallel":true}}')";
  const Outcome made = runProgram("tool make " + scene + " -o " + tool + " --lasso " + lasso);
  ASSERT_EQ(made.code, 0) << made.err;
  const auto whole = infoOf(scene), half = infoOf(tool);
  EXPECT_NEAR(half["mass"].get<double>(), whole["mass"].get<double>() / 2,
              whole["mass"].get<double>() / 10);
  EXPECT_GT(half["bounds"]["min"][0].get<double>(), -1.5);
  for (const char* wrong : {"'{}'", "nonsense", R"('{"lasso":[[0,0]],"view":{"eye":[0,0,9]}}')"})
    EXPECT_EQ(runProgram("tool make " + scene + " -o " + tool + " --lasso " + wrong).code, 1);
}

}  // namespace
}  // namespace bozzetto
