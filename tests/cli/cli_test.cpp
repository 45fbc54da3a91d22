// The command line from outside: what it prints, what it leaves, how it refuses.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bozzetto/io/mesh_file.hpp"
#include "bozzetto/mesh/check.hpp"
#include "cli/program.hpp"

namespace bozzetto {
namespace {

using testing::CommandFolder;
using testing::infoOf;
using testing::kBall;
using testing::kHeader;
using testing::Outcome;
using testing::runProgram;
using testing::sceneOf;

// A cube of side 2 in OFF.
const std::string kCube =
    "OFF\n8 6 0\n-1 -1 -1\n1 -1 -1\n1 1 -1\n-1 1 -1\n-1 -1 1\n1 -1 1\n1 1 1\n-1 1 1\n"
    "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 2 3 7 6\n4 1 2 6 5\n4 0 4 7 3\n";

TEST(Cli, importsACubeWhereItIs) {
  const CommandFolder folder;
  const std::string mesh = folder.write("cube.off", kCube), scene = folder / "s.bzt";
  const Outcome outcome = runProgram("import " + mesh + " -o " + scene + " --cells 40");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto info = infoOf(scene);
  EXPECT_DOUBLE_EQ(info["spacing"].get<double>(), 0.05);
  EXPECT_NEAR(info["volume"].get<double>(), 8, 0.08);
  EXPECT_NEAR(info["mass"].get<double>(), 8, 0.16);
  EXPECT_NEAR(info["bounds"]["max"][1].get<double>(), 1, 0.03);
  EXPECT_NEAR(info["bounds"]["min"][2].get<double>(), -1, 0.03);
  EXPECT_EQ(info["components"], 1);
  EXPECT_EQ(runProgram("check " + scene).code, 0);
}

TEST(Cli, infoHasAllItPromises) {
  const CommandFolder folder;
  const auto info = infoOf(sceneOf(folder, kBall));
  for (const char* key :
       {"corners",    "bricks",        "cubes",    "crossing_cubes",  "edges",
        "triangles",  "components",    "mass",     "volume",          "area",
        "bounds",     "spacing",       "iso",      "field_hash",      "bytes_memory",
        "bytes_file", "history_steps", "supports", "bytes_thumbnail", "ledger"}) {
    EXPECT_TRUE(info.contains(key)) << key;
  }
  EXPECT_EQ(info["field_hash"].get<std::string>().size(), 16u);
  EXPECT_GT(info["cubes"].get<int>(), info["crossing_cubes"].get<int>());
  const auto empty = infoOf(sceneOf(folder, kHeader));
  EXPECT_TRUE(empty["bounds"].is_null());
  EXPECT_EQ(empty["corners"], 0);
  EXPECT_GT(info["bytes_thumbnail"].get<int>(), 1000);
  EXPECT_EQ(empty["bytes_thumbnail"], 0);
}

TEST(Cli, infoTellsTheLedger) {
  const CommandFolder folder;
  const std::string push = std::string(kBall) +
                           "{\"op\":\"action\",\"name\":\"push\"}\n"
                           "{\"op\":\"stroke\",\"points\":[[0,20,0],[0,10,0]]}\n";
  const std::string scene = sceneOf(folder, push);
  const auto info = infoOf(scene);
  const double mass = info["mass"];
  EXPECT_EQ(info["ledger"]["before"], 0);
  EXPECT_EQ(info["ledger"]["moves"], 1);
  EXPECT_NEAR(info["ledger"]["added"].get<double>(), mass, 1e-6 * mass);
  EXPECT_LT(std::abs(info["ledger"]["drift"].get<double>()), 1e-6 * mass);
  const std::string told = runProgram("info " + scene).out;
  for (const char* line : {"mass before", "mass added", "mass removed", "mass drift", "mass moves"})
    EXPECT_NE(told.find(line), told.npos) << line;
  // Another sitting goes on with it.
  const std::string more = folder.write(
      "more.jsonl", push.substr(0, push.find('\n') + 1) + "{\"op\":\"relax\",\"steps\":2}\n");
  const std::string later = folder / "later.bzt";
  ASSERT_EQ(runProgram("replay " + more + " --from " + scene + " -o " + later).code, 0);
  EXPECT_EQ(infoOf(later)["ledger"]["moves"], 2);
  EXPECT_EQ(infoOf(later)["ledger"]["added"], info["ledger"]["added"]);
}

TEST(Cli, withoutOpenGlThereIsNoThumbnailAndNoComplaint) {
  const CommandFolder folder;
  const std::string recording = folder.write("r.jsonl", kBall), scene = folder / "s.bzt";
  ASSERT_EQ(::setenv("__EGL_VENDOR_LIBRARY_DIRS", "/nowhere", 1), 0);
  const Outcome outcome = runProgram("replay " + recording + " -o " + scene);
  ::unsetenv("__EGL_VENDOR_LIBRARY_DIRS");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(outcome.err.empty()) << outcome.err;
  EXPECT_EQ(infoOf(scene)["bytes_thumbnail"], 0);
}

TEST(Cli, threadsDoNotShowInTheField) {
  const CommandFolder folder;
  const auto one = infoOf(sceneOf(folder, kBall, "--threads 1"));
  const auto three = infoOf(sceneOf(folder, kBall, "--threads 3"));
  EXPECT_EQ(one["field_hash"], three["field_hash"]);
}

TEST(Cli, exportsClosedMeshesInEveryFormat) {
  const CommandFolder folder;
  const std::string scene = sceneOf(folder, kBall);
  const auto info = infoOf(scene);
  for (const char* format : {"obj", "ply", "stl", "glb"}) {
    const std::string file = folder / (std::string("m.") + format);
    ASSERT_EQ(runProgram("export " + scene + " " + file).code, 0) << format;
    const TriangleMesh mesh = readMesh(file);
    EXPECT_EQ(mesh.triangles.size(), info["triangles"].get<std::size_t>()) << format;
    EXPECT_NEAR(signedVolume(mesh), info["volume"].get<double>(), 1) << format;
  }
  EXPECT_EQ(runProgram("export " + scene + " " + (folder / "m.iv")).code, 0);
  const std::string fewer = folder / "fewer.ply";
  ASSERT_EQ(runProgram("export " + scene + " " + fewer + " --decimate 0.2").code, 0);
  EXPECT_LT(checkMesh(readMesh(fewer)).triangles, info["triangles"].get<std::size_t>() / 4);
}

TEST(Cli, writesToStandardOutput) {
  const CommandFolder folder;
  const Outcome outcome = runProgram("export " + sceneOf(folder, kBall) + " -");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out.substr(0, 4), "ply\n");
}

TEST(Cli, statisticsTellThePapersCounts) {
  const CommandFolder folder;
  const std::string stats = folder / "stats.json";
  sceneOf(folder, kBall, "--stats " + stats);
  const auto json = nlohmann::json::parse(testing::textOf(stats));
  ASSERT_EQ(json["operations"].size(), 3u);
  const auto& stroke = json["operations"][2];
  EXPECT_EQ(stroke["op"], "stroke");
  EXPECT_GT(stroke["visited"], stroke["dirty"]);
  EXPECT_GE(stroke["visited"], stroke["computed"]);
  EXPECT_GT(stroke["treated"], 0);
  EXPECT_GT(stroke["mass_after"], stroke["mass_before"]);
}

TEST(Cli, replaysOnAFinerGridAndFromAScene) {
  const CommandFolder folder;
  const std::string scene = sceneOf(folder, kBall);
  const double volume = infoOf(scene)["volume"];
  const std::string more =
      folder.write("more.jsonl", kHeader + "{\"op\":\"action\",\"name\":\"erase\"}\n" +
                                     "{\"op\":\"stroke\",\"points\":[[0,0,-16]]}\n");
  const std::string fine = folder / "fine.bzt";
  ASSERT_EQ(runProgram("replay " + more + " --from " + scene + " --spacing 0.5 -o " + fine).code,
            0);
  const auto info = infoOf(fine);
  EXPECT_EQ(info["spacing"], 0.5);
  EXPECT_LT(info["volume"].get<double>(), volume - 100);
  EXPECT_GT(info["volume"].get<double>(), volume - 3000);
}

TEST(Cli, SlowRendersWithoutADisplay) {
  const CommandFolder folder;
  const std::string picture = folder / "p.png";
  const Outcome outcome =
      runProgram("render " + sceneOf(folder, kBall) + " " + picture + " --size 96x64 --view iso");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(testing::textOf(picture).substr(1, 3), "PNG");
}

TEST(Cli, SlowTurntablesGiveNumberedPictures) {
  const CommandFolder folder;
  const std::string picture = folder / "turn.png";
  const Outcome outcome = runProgram("render " + sceneOf(folder, kBall) + " " + picture +
                                     " --size 48x32 --turntable 2 --structure cubes --yaw 30"
                                     " --pitch 20 --zoom 2 --stereo anaglyph --environment dusk");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string first = testing::textOf(folder / "turn-000.png");
  EXPECT_EQ(first.substr(1, 3), "PNG");
  EXPECT_NE(testing::textOf(folder / "turn-001.png"), first);
}

struct Refusal {
  const char* arguments;  ///< FOLDER stands for the test's folder
  int code;
  const char* tells;

  friend std::ostream& operator<<(std::ostream& out, const Refusal& refusal) {
    return out << refusal.arguments;
  }
};

class Refusals : public ::testing::TestWithParam<Refusal> {};

TEST_P(Refusals, areOneLineAndLeaveNothing) {
  const CommandFolder folder;
  folder.write("empty", "");
  folder.write("text.bzt", "no scene at all");
  folder.write("bad.jsonl", kHeader + "{\"op\":\"fill\"}\n{\"op\":\"dance\"}\n");
  folder.write("thin.jsonl", kHeader + "{\"op\":\"fill\"}\n{\"op\":\"tool\",\"radii\":[0,1,1]}\n");
  folder.write("wide.jsonl",
               kHeader + "{\"op\":\"fill\"}\n{\"op\":\"tool\",\"radii\":[9000,1,1]}\n");
  folder.write("far.jsonl", kHeader + "{\"op\":\"stroke\",\"points\":[[1e15,0,0]]}\n");
  folder.write("many.jsonl", kHeader +
                                 "{\"op\":\"stroke\",\"points\":[[0,0,0],[1e8,0,0]],\"spacing\":"
                                 "1e-6}\n");
  folder.write("good.jsonl", kBall);
  folder.write("cube.off", kCube);
  folder.write("nan.off", "OFF\n3 1 0\nnan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  folder.write("flat.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  folder.write("short.stl", std::string(80, ' ') + std::string("\xff\xff\xff\x7f", 4));
  const std::string before = folder.listing();
  std::string arguments = GetParam().arguments;
  for (std::size_t at; (at = arguments.find("FOLDER")) != std::string::npos;) {
    arguments.replace(at, 6, folder / "");
  }
  const Outcome outcome = runProgram(arguments);
  EXPECT_EQ(outcome.code, GetParam().code) << outcome.err;
  EXPECT_NE(outcome.err.find(GetParam().tells), std::string::npos) << outcome.err;
  if (outcome.code == 1) {
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
  EXPECT_EQ(folder.listing(), before);
}

INSTANTIATE_TEST_SUITE_P(
    all, Refusals,
    ::testing::Values(
        Refusal{"--dance", 2, ""}, Refusal{"import FOLDERcube.off", 2, "--out"},
        Refusal{"replay FOLDERgood.jsonl -o FOLDERo.bzt --threads -3", 2, "threads"},
        Refusal{"import FOLDERmissing.off -o FOLDERo.bzt", 1, "missing.off"},
        Refusal{"import FOLDERempty -o FOLDERo.bzt", 1, "empty"},
        Refusal{"import FOLDERnan.off -o FOLDERo.bzt", 1, "nan.off"},
        Refusal{"import FOLDERflat.off -o FOLDERo.bzt", 1, "volume"},
        Refusal{"import FOLDERshort.stl -o FOLDERo.bzt", 1, "short.stl"},
        Refusal{"import FOLDERcube.off -o FOLDERo.bzt --cells 0", 1, ""},
        Refusal{"import FOLDERcube.off -o FOLDERo.bzt --spacing -1", 1, ""},
        Refusal{"import FOLDERcube.off -o FOLDERo.bzt --spacing nan", 1, ""},
        Refusal{"import FOLDERcube.off -o FOLDERo.bzt --spacing 1e-12", 1, ""},
        Refusal{"import FOLDERcube.off -o FOLDERnowhere/o.bzt", 1, "nowhere"},
        Refusal{"import FOLDERcube.off -o FOLDERo.bzt --colour red", 1, "#rrggbb"},
        Refusal{"replay FOLDERbad.jsonl -o FOLDERo.bzt", 1, "bad.jsonl:3"},
        Refusal{"replay FOLDERthin.jsonl -o FOLDERo.bzt", 1, "thin.jsonl:3: tool radius"},
        Refusal{"replay FOLDERwide.jsonl -o FOLDERo.bzt", 1, "operation 2"},
        Refusal{"replay FOLDERfar.jsonl -o FOLDERo.bzt", 1, "workspace"},
        Refusal{"replay FOLDERmany.jsonl -o FOLDERo.bzt", 1, "dabs"},
        Refusal{"replay FOLDERgood.jsonl --from FOLDERtext.bzt -o FOLDERo.bzt", 1, "text.bzt"},
        Refusal{"info FOLDERtext.bzt", 1, "text.bzt"}, Refusal{"info FOLDERempty", 1, "empty"},
        Refusal{"info /dev/zero", 1, "/dev/zero"}, Refusal{"check FOLDERtext.bzt", 1, "text.bzt"},
        Refusal{"export FOLDERtext.bzt FOLDERm.ply", 1, "text.bzt"},
        Refusal{"export FOLDERtext.bzt FOLDERm.xyz", 1, "xyz"},
        Refusal{"export FOLDERtext.bzt FOLDERm.ply --decimate 2", 2, "decimate"},
        Refusal{"render FOLDERtext.bzt FOLDERp.png --size 10", 1, "size"},
        Refusal{"render FOLDERtext.bzt FOLDERp.png --view inside", 1, "inside"},
        Refusal{"render FOLDERtext.bzt FOLDERp.png --mode gold", 1, "gold"},
        Refusal{"render FOLDERtext.bzt FOLDERp.png --environment moon", 1, "moon"},
        Refusal{"render FOLDERtext.bzt FOLDERp.png --stereo smell", 1, "smell"},
        Refusal{"render FOLDERtext.bzt FOLDERp.png --structure bones", 1, "bones"},
        Refusal{"render FOLDERtext.bzt FOLDERp.png --matcap FOLDERno.png", 1, "no.png"},
        Refusal{"render FOLDERtext.bzt FOLDERp.png --zoom 0", 2, "zoom"},
        Refusal{"render FOLDERtext.bzt FOLDERp.png --turntable 0", 2, "turntable"}));

TEST(Cli, helpIsThereForEveryCommand) {
  for (const char* command :
       {"", "import", "replay", "export", "render", "info", "check", "history", "recover"}) {
    const Outcome outcome = runProgram(std::string(command) + " --help");
    EXPECT_EQ(outcome.code, 0) << command;
    EXPECT_NE(outcome.out.find("--help"), std::string::npos) << command;
  }
}

// A fill of this radius onto a scene that is there, where there is too little of something.
void expectTheOldSceneStays(double radius, const char* reason,
                            Outcome (*run)(const std::string&, int), int kibibytes) {
  const CommandFolder folder;
  const std::string scene = sceneOf(folder, kBall);
  const auto hash = infoOf(scene)["field_hash"];
  const std::string r = std::to_string(radius);
  const std::string larger = folder.write(
      "large.jsonl", kHeader + "{\"op\":\"fill\",\"radii\":[" + r + "," + r + "," + r + "]}\n");
  const Outcome outcome = run("replay " + larger + " -o " + scene, kibibytes);
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_EQ(infoOf(scene)["field_hash"], hash);
  EXPECT_EQ(folder.listing(), "large.jsonl r.jsonl s.bzt");
}

#ifndef BOZZETTO_SANITIZED  // they take terabytes of address space
TEST(Cli, memoryThatEndsLeavesTheOldScene) {
  expectTheOldSceneStays(1500, "not enough memory", testing::runCramped, 1 << 20);
}
#endif

TEST(Cli, aDiskThatFillsLeavesTheOldScene) {
  expectTheOldSceneStays(90, "large", testing::runLimited, 16);
}

}  // namespace
}  // namespace bozzetto
