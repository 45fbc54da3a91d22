// Tools by name: from files, from shelves, from starters; volume operations; what recordings say.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/sculptor/replay.hpp"
#include "bozzetto/sculptor/tool_library.hpp"
#include "support/folder.hpp"

namespace bozzetto {
namespace {

namespace fs = std::filesystem;
const std::string kHeader = "{\"bozzetto\":\"recording\",\"version\":1}\n";

Recording recordingOf(const std::string& lines) { return parseRecording(kHeader + lines, "test"); }
Clay replayed(const std::string& lines) { return replay(recordingOf(lines), {}).field; }

// A folder of its own, and the user's library in it.
class Tools : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "bozzetto/tools");
    ::setenv("XDG_DATA_HOME", folder_.path().c_str(), 1);
  }

  Clay replayHere(const std::string& lines) const {
    Recording recording = recordingOf(lines);
    recording.folder = folder_.path();
    return replay(recording, {}).field;
  }
  const testing::Folder folder_;
};

const char* const kBody =
    "{\"op\":\"fill\",\"radii\":[9,6,5],\"colour\":\"#c04020\"}\n"
    "{\"op\":\"fill\",\"shape\":\"box\",\"center\":[8,2,0],\"radii\":[4,3,3],"
    "\"colour\":\"#2040c0\"}\n";

TEST_F(Tools, aFileAsAToolIsItsScene) {
  saveScene(folder_ / "body.bzt", {replayed(kBody), {}});
  const Clay made = replayHere(
      "{\"op\":\"tool\",\"shape\":\"freeform\",\"from\":\"body.bzt\",\"pivot\":[0,0,0]}\n"
      "{\"op\":\"action\",\"name\":\"add\",\"strength\":1,\"own_colours\":true}\n"
      "{\"op\":\"stroke\",\"points\":[[0,0,0]]}");
  EXPECT_EQ(fieldHash(made), fieldHash(replayed(kBody)));
}

TEST_F(Tools, aLassoCutsAndPutsBack) {
  const std::string cut =
      std::string(kBody) +
      "{\"op\":\"cut\",\"region\":{\"lasso\":[[-4.5,-3.5],[5.5,-3.5],[5.5,2.5],[-4.5,2.5]],"
      "\"view\":{\"eye\":[0,0,0],\"parallel\":true}}}\n";
  const Clay body = replayed(kBody), rest = replayed(cut);
  EXPECT_EQ(rest.value({0, 0, 0}), 0);
  EXPECT_EQ(rest.value({4, 0, 2}), 0) << "as deep as it goes";
  EXPECT_EQ(rest.value({-6, 0, 0}), body.value({-6, 0, 0}));
  EXPECT_EQ(rest.value({-4, 0, 0}), 0.25f) << "its wall slopes as others do";
  EXPECT_EQ(rest.value({-5, 0, 0}), 0.75f);
  EXPECT_EQ(rest.value({0, 4, 0}), body.value({0, 4, 0}));
  // Its pivot is the middle of its bounds: corners -5 … 6, -4 … 3 and -4 … 4 have clay.
  const Clay again = replayed(cut + "{\"op\":\"stroke\",\"points\":[[0.5,-0.5,0]]}");
  EXPECT_EQ(fieldHash(again), fieldHash(body));
  EXPECT_THROW(replayed("{\"op\":\"cut\",\"region\":{\"lasso\":[[0,0],[1,1]],"
                        "\"view\":{\"eye\":[0,0,0]}}}"),
               Error);
}

TEST_F(Tools, aPatchIsWithoutItsPlane) {
  const std::string slab =
      "{\"op\":\"fill\",\"shape\":\"box\",\"center\":[0,0,-6],\"radii\":[20,20,6]}\n"
      "{\"op\":\"fill\",\"shape\":\"box\",\"center\":[0,0,5],\"radii\":[4,4,9]}\n";
  const std::string use =
      "{\"op\":\"action\",\"name\":\"add\",\"strength\":1}\n"
      "{\"op\":\"stroke\",\"points\":[[0,0,100]]}";
  for (const char* patch : {"{}", "{\"at\":[0,0,0],\"normal\":[0,0,2]}"}) {
    const Clay made =
        replayed(slab +
                 "{\"op\":\"tool\",\"shape\":\"freeform\",\"region\":{\"min\":[-20,-20,0],"
                 "\"max\":[20,20,40]},\"patch\":" +
                 patch + "}\n" + use);
    EXPECT_EQ(made.value({0, 0, 108}), 1);
    EXPECT_FLOAT_EQ(made.value({0, 0, 100}), 0.5f) << "its root stands on the stroke";
    EXPECT_EQ(made.value({0, 0, 98}), 0);
    EXPECT_EQ(made.value({12, 0, 100}), 0) << "no sheet of the plane";
  }
  EXPECT_THROW(replayed("{\"op\":\"fill\"}\n{\"op\":\"tool\",\"shape\":\"freeform\",\"patch\":{}}"),
               Error);
}

TEST_F(Tools, whatIsWrongIsToldWithItsLine) {
  for (const std::string line :
       {"{\"op\":\"cut\",\"region\":{\"lasso\":[[0,0],[1,1]],\"view\":{\"eye\":[0,0,0]}}}",
        "{\"op\":\"tool\",\"shape\":\"freeform\",\"text\":\"A\",\"size\":1e9}",
        "{\"op\":\"tool\",\"shape\":\"freeform\",\"from\":\"a.png\",\"width\":1e30}",
        "{\"op\":\"stroke\",\"points\":[[0,0,0]],\"roll\":1e300}",
        "{\"op\":\"cut\",\"region\":{\"lasso\":[[0,0],[1,1],[3,3]],\"view\":{\"eye\":[0,0,0]}}}",
        "{\"op\":\"cut\",\"region\":{\"lasso\":[[0,0],[1,1],[0,1]],\"view\":{\"eye\":[0,0,0],"
        "\"rotation\":[0,0,0,0]}}}",
        "{\"op\":\"cut\",\"region\":{\"min\":[0,0,0],\"max\":[1,0,1]}}",
        "{\"op\":\"tool\",\"shape\":\"freeform\",\"contact\":[0,0,0]}",
        "{\"op\":\"tool\",\"shape\":\"freeform\",\"scale\":[1,0,1]}",
        "{\"op\":\"tool\",\"rotation\":[0,0,0,0]}",
        "{\"op\":\"combine\",\"with\":\"a.bzt\",\"text\":\"A\"}",
        "{\"op\":\"action\",\"name\":\"add\",\"strength\":1.5}",
        "{\"op\":\"stroke\",\"points\":[[0,0,0]],\"rotations\":[[1,0,0,0],[1,0,0,0]]}",
        "{\"op\":\"shelf_keep\",\"name\":\" \"}",
        "{\"op\":\"shelf_keep\",\"name\":\"c\",\"preset\":[]}",
        "{\"op\":\"shelf_keep\",\"name\":\"c\",\"preset\":[{\"op\":\"fill\"}]}",
        "{\"op\":\"stroke\",\"points\":[[0,0,0]],\"array\":{\"count\":[0,1,1],\"step\":[1,1,1]}}",
        "{\"op\":\"stroke\",\"points\":[[0,0,0]],\"array\":{\"count\":[1.5,1,1],\"step\":[1,1,1]}}",
        "{\"op\":\"stroke\",\"points\":[[0,0,0]],\"array\":{\"count\":[2,1,1],\"step\":[0,1,1]}"
        "}"}) {
    try {
      recordingOf("{\"op\":\"fill\"}\n" + line);
      ADD_FAILURE() << line;
    } catch (const Error& error) {
      const std::string text = error.what();
      EXPECT_TRUE(text.starts_with("test:3: ")) << text;
      EXPECT_LT(text.size(), 160u) << text;
    }
  }
}

TEST_F(Tools, aRegionOfTheClayAtHand) {
  const Clay made =
      replayed(std::string(kBody) +
               "{\"op\":\"tool\",\"shape\":\"freeform\",\"pivot\":[0,0,0],"
               "\"region\":{\"min\":[0,-20,-20],\"max\":[20,20,20]}}\n"
               "{\"op\":\"action\",\"name\":\"add\",\"strength\":1,\"own_colours\":true}\n"
               "{\"op\":\"stroke\",\"points\":[[0,40,0]]}");
  const Clay body = replayed(kBody);
  EXPECT_EQ(made.value({5, 41, 1}), body.value({5, 1, 1}));
  EXPECT_EQ(made.attributes({10, 42, 0}), body.attributes({10, 2, 0}));
  EXPECT_EQ(made.value({-3, 40, 0}), 0);
}

TEST_F(Tools, aRecordingAsATool) {
  std::ofstream(folder_ / "body.jsonl") << kHeader << kBody;
  const Clay made = replayHere(
      "{\"op\":\"tool\",\"shape\":\"freeform\",\"from\":\"body.jsonl\",\"pivot\":[0,0,0]}\n"
      "{\"op\":\"action\",\"name\":\"add\",\"strength\":1,\"own_colours\":true}\n"
      "{\"op\":\"stroke\",\"points\":[[0,0,0]]}");
  EXPECT_EQ(fieldHash(made), fieldHash(replayed(kBody)));
}

// Once, not at each of its turns.
TEST_F(Tools, aRecordingThatUsesItselfIsRefusedInOneSentence) {
  const std::string toolOf = "{\"op\":\"tool\",\"shape\":\"freeform\",\"from\":";
  std::ofstream(folder_ / "self.jsonl") << kHeader << toolOf << "\"self.jsonl\"}\n";
  std::ofstream(folder_ / "egg.jsonl") << kHeader << toolOf << "\"hen.jsonl\"}\n";
  std::ofstream(folder_ / "hen.jsonl") << kHeader << toolOf << "\"egg.jsonl\"}\n";
  const auto refusal = [&](const std::string& lines) -> std::string {
    try {
      replayHere(lines);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const std::string in = folder_.path().string() + "/", first = "test:2: operation 1: ";
  EXPECT_EQ(refusal(toolOf + "\"self.jsonl\"}"),
            first + in + "self.jsonl is made with itself as a tool");
  EXPECT_EQ(refusal(toolOf + "\"egg.jsonl\"}"),
            first + in + "egg.jsonl is made with the tool " + in +
                "hen.jsonl, which is made with the first as a tool");
  EXPECT_EQ(refusal("{\"op\":\"combine\",\"with\":\"self.jsonl\"}"),
            first + in + "self.jsonl is made with itself as a tool");
}

ShelfTool sample() {
  ShelfTool tool;
  tool.name = "Knob";
  tool.tags = {"round", "Handle"};
  tool.clay = replayed(kBody);
  tool.pivot = glm::dvec3(1, 2, 3);
  tool.contact = glm::dvec3(0, -1, 0);
  tool.preset = recordingOf("{\"op\":\"action\",\"name\":\"stamp\",\"strength\":0.75}").operations;
  tool.thumbnail = {std::byte{0x89}, std::byte{'P'}, std::byte{'N'}};
  return tool;
}

void expectSame(const ShelfTool& a, const ShelfTool& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.tags, b.tags);
  EXPECT_EQ(fieldHash(a.clay), fieldHash(b.clay));
  EXPECT_EQ(a.clay.scale, b.clay.scale);
  EXPECT_EQ(a.pivot, b.pivot);
  EXPECT_EQ(a.contact, b.contact);
  ASSERT_EQ(a.preset.size(), b.preset.size());
  for (std::size_t n = 0; n < a.preset.size(); ++n)
    EXPECT_EQ(toText(a.preset[n]), toText(b.preset[n]));
}

TEST_F(Tools, shelfItemsAndFilesKeepEverything) {
  const ShelfTool tool = sample();
  expectSame(fromItem(toItem(tool)), tool);
  EXPECT_EQ(fromItem(toItem(tool)).thumbnail, tool.thumbnail);
  ShelfTool plain = tool;
  plain.thumbnail.clear();
  saveTool(folder_ / "knob.bzt", plain);
  expectSame(loadTool(folder_ / "knob.bzt"), plain);
}

// As files from strangers may be.
TEST_F(Tools, presetsThatNoReplayWouldTakeAreNotRead) {
  ShelfTool tool = sample();
  tool.thumbnail.clear();
  for (const auto& [line, told] : {
           std::pair("{\"op\":\"action\",\"name\":\"add\",\"strength\":0.25}", ""),
           std::pair("{\"op\":\"fill\"}", "fill found, tool, action, stroke or clay expected"),
       }) {
    tool.preset.push_back(parseOperation(line, "test"));
    saveTool(folder_ / "t.bzt", tool);
    const std::string start = (folder_ / "t.bzt").string() + ": operation 3 of the preset: ";
    try {
      EXPECT_EQ(loadTool(folder_ / "t.bzt").preset.size(), 2u);
      EXPECT_EQ(fromItem(toItem(tool)).preset.size(), 2u);
      EXPECT_EQ(std::string(told), "");
    } catch (const Error& error) {
      EXPECT_EQ(error.what(), start + told);
    }
  }
  tool.preset = {StrokeOperation{}};
  EXPECT_THROW(fromItem(toItem(tool)), Error) << "a stroke without points";
}

TEST_F(Tools, anchoredStrokesBeyondTheLargestToolSaySo) {
  struct Notes final : Progress {
    void note(std::string_view text) override { last = text; }
    std::string last;
  } notes;
  Sculptor sculptor;
  StrokeOperation stroke;
  stroke.stroke.placement.anchored = true;
  stroke.stroke.points = {{{0, 0, 0}, 1}, {{20, 0, 0}, 1}};
  sculptor.apply(stroke, notes);
  EXPECT_EQ(notes.last, "");
  const auto thin = parseOperation("{\"op\":\"tool\",\"radii\":[64,2,2]}", "test");
  sculptor.apply(thin, notes);
  stroke.stroke.points[1].position.x = 5000;
  EXPECT_EQ(sculptor.begin(stroke.stroke)->notice(),
            "anchored stroke: a tool of 5000 cells asked for, made as large as tools can be: 4096");
}

TEST_F(Tools, damagedShelfItemsAreRefused) {
  const ShelfItem item = toItem(sample());
  for (std::size_t size = 0; size < item.payload.size(); size += 7) {
    ShelfItem cut = item;
    cut.payload.resize(size);
    try {
      EXPECT_TRUE(fromItem(cut).clay.tree.empty());  // cut right after the notes: a preset
    } catch (const Error&) {
    }
  }
}

TEST_F(Tools, namesLeadToDocumentUserAndStarters) {
  ToolLibrary library;
  EXPECT_THROW(library.find("Knob"), Error);
  ShelfTool user = sample();
  user.thumbnail.clear();
  saveTool(userToolFolder() / "Knob.bzt", user);
  EXPECT_EQ(fieldHash(library.find("Knob").clay), fieldHash(user.clay));
  ShelfTool own = sample();
  own.clay = replayed("{\"op\":\"fill\"}");
  library.shelf.push_back(toItem(own));
  EXPECT_EQ(fieldHash(library.find("Knob").clay), fieldHash(own.clay));
  EXPECT_THROW(library.find("../Knob"), Error);

  EXPECT_EQ(library.list("handle ROUND").size(), 2U);
  EXPECT_EQ(library.list("nothing like it").size(), 0U);
  EXPECT_GE(library.list().size(), 14U);
  EXPECT_EQ(library.list("knob").front().place, ToolEntry::Place::document);
}

TEST_F(Tools, atLeastTwelveStartersAreTools) {
  const auto starters = starterTools();
  EXPECT_GE(starters.size(), 12U);
  for (const ToolEntry& entry : starters) {
    if (entry.name.starts_with("letter ") && entry.name != "letter Q") continue;
    const ShelfTool tool = makeStarter(entry.name);
    EXPECT_FALSE(tool.tags.empty()) << entry.name;
    EXPECT_FALSE(tool.preset.empty()) << entry.name;
    EXPECT_EQ(validate(tool.clay), std::nullopt) << entry.name;
    EXPECT_GT(statistics(tool.clay).corners, 1000) << entry.name;
    EXPECT_NO_THROW(sculptureOf(tool, {})) << entry.name;
  }
}

// Led along a surface as they come: what presses, carves or cuts goes into it.
TEST_F(Tools, startersThatPressOrCutGoIntoTheClay) {
  for (const std::string name : {"finger", "thumb", "loop", "rake", "knife", "star tip", "screw"}) {
    Recording recording = recordingOf(
        "{\"op\":\"fill\",\"shape\":\"box\",\"center\":[0,-20,0],\"radii\":[30,20,20]}\n"
        "{\"op\":\"tool\",\"shape\":\"freeform\",\"from\":\"shelf:" +
        name + "\"}");
    for (Operation operation : ToolLibrary().find(name).preset) {
      if (auto* drawn = std::get_if<StrokeOperation>(&operation))
        drawn->stroke.points = {{{-8, 0, 0}, 1}, {{8, 0, 0}, 1}};
      recording.operations.push_back(operation);
      recording.places.emplace_back();
    }
    const Clay made = replay(recording, {}).field;
    EXPECT_LT(made.value({-8, -1, 0}), 0.5) << name;
    EXPECT_GT(made.value({-8, -10, 0}), 0.5) << name;
  }
}

// What lies on a surface sinks in to print, though its smoothed edges fade below its root.
TEST_F(Tools, aBrickPressedOncePrints) {
  const Clay made = replayed(
      "{\"op\":\"fill\",\"shape\":\"box\",\"center\":[0,-20,0],\"radii\":[30,20,20]}\n"
      "{\"op\":\"tool\",\"shape\":\"freeform\",\"from\":\"shelf:brick\"}\n"
      "{\"op\":\"action\",\"name\":\"stamp\",\"strength\":1}\n"
      "{\"op\":\"stroke\",\"points\":[[0,0,0]],\"orient\":[\"normal\"]}");
  EXPECT_LT(made.value({0, -1, 0}), 0.5);
  EXPECT_GT(made.value({0, -5, 0}), 0.5);
}

TEST_F(Tools, startersStandOnSurfaces) {
  const Clay made = replayed(
      "{\"op\":\"fill\",\"radii\":[30,30,30]}\n"
      "{\"op\":\"tool\",\"shape\":\"freeform\",\"from\":\"shelf:eye\"}\n"
      "{\"op\":\"action\",\"name\":\"add\",\"strength\":1,\"own_colours\":true}\n"
      "{\"op\":\"stroke\",\"points\":[[0,0,30]],\"orient\":[\"normal\"]}");
  EXPECT_GT(made.value({0, 0, 36}), 0.9f);
}

TEST_F(Tools, combineUnitesSubtractsIntersects) {
  saveScene(folder_ / "cube.bzt", {replayed("{\"op\":\"fill\",\"shape\":\"box\",\"radii\":[6,6,6],"
                                            "\"colour\":\"#00ff00\"}"),
                                   {}});
  const auto combined = [&](const std::string& how) {
    return replayHere(
        "{\"op\":\"fill\",\"radii\":[10,10,10],\"colour\":\"#ff0000\"}\n"
        "{\"op\":\"combine\",\"with\":\"cube.bzt\",\"how\":\"" +
        how + "\",\"pose\":{\"at\":[8,0,0]}}");
  };
  const Clay all = combined("union"), cut = combined("subtract"), both = combined("intersect");
  for (const Clay* clay : {&all, &cut, &both}) EXPECT_EQ(validate(*clay), std::nullopt);
  const Key ball{-8, 0, 0}, shared{5, 0, 0}, cube{13, 4, 4};
  EXPECT_EQ(all.value(ball), 1);
  EXPECT_EQ(all.value(cube), 1);
  EXPECT_EQ(all.attributes(cube), packAttributes({0, 255, 0}));
  EXPECT_EQ(all.attributes(shared), packAttributes({255, 0, 0}));
  EXPECT_EQ(cut.value(ball), 1);
  EXPECT_EQ(cut.value(shared), 0);
  EXPECT_EQ(cut.value(cube), 0);
  EXPECT_EQ(both.value(ball), 0);
  EXPECT_EQ(both.value(shared), 1);
  EXPECT_EQ(both.value(cube), 0);
}

TEST_F(Tools, whatIsCutAndPastedIsThereAgain) {
  const std::string cut =
      std::string(kBody) + "{\"op\":\"cut\",\"region\":{\"min\":[2,-30,-30],\"max\":[30,30,30]}}\n";
  const Clay without = replayed(cut);
  EXPECT_EQ(without.value({4, 0, 0}), 0);
  EXPECT_EQ(without.value({0, 0, 0}), 1);
  const Clay body = replayed(kBody);
  ToolSource source;
  source.region = WorldRegion{{2, -30, -30}, {30, 30, 30}, {}};
  ShelfTool at;
  at.clay = body;
  const glm::dvec3 pivot = sculptureOf(at, source)->centre();
  const auto point = "[" + std::to_string(pivot.x) + "," + std::to_string(pivot.y) + "," +
                     std::to_string(pivot.z) + "]";
  const Clay pasted = replayed(cut + "{\"op\":\"stroke\",\"points\":[" + point + "]}");
  EXPECT_EQ(fieldHash(pasted), fieldHash(body));
  EXPECT_EQ(fieldHash(replayed(cut + "{\"op\":\"undo\"}")), fieldHash(body));
}

TEST_F(Tools, textStandsOnThePlane) {
  const Clay made = replayed("{\"op\":\"text\",\"text\":\"I\",\"size\":40,\"depth\":6}");
  EXPECT_EQ(validate(made), std::nullopt);
  EXPECT_EQ(made.value({0, 0, 3}), 1);
  EXPECT_EQ(made.value({0, 0, 8}), 0);
  EXPECT_EQ(made.value({12, 0, 3}), 0);
  EXPECT_THROW(replayed("{\"op\":\"text\",\"text\":\"\"}"), Error);
  EXPECT_THROW(replayed("{\"op\":\"text\",\"text\":\"A\",\"font\":\"none.ttf\"}"), Error);
}

TEST_F(Tools, recordingsSayEverything) {
  const char* const lines[] = {
      "{\"op\":\"tool\",\"shape\":\"freeform\",\"from\":\"shelf:leaf\",\"scale\":[1,2,3],"
      "\"region\":{\"min\":[0,0,0],\"max\":[1,2,3]},\"pivot\":[1,1,1],\"contact\":[0,1,0],"
      "\"cells\":50,\"width\":3,\"height\":2}",
      "{\"op\":\"action\",\"name\":\"stamp\",\"strength\":0.5,\"bulge\":{\"height\":0.2,"
      "\"rise\":0.1,\"fall\":0.4,\"slope\":0.5,\"profile\":\"paper\"},\"conserving\":true}",
      "{\"op\":\"action\",\"name\":\"add\",\"own_colours\":true}",
      "{\"op\":\"stroke\",\"points\":[[0,0,0]],\"orient\":[\"normal\",\"stroke\"],"
      "\"jitter\":{\"position\":0.5,\"size\":0.25,\"rotation\":30,\"seed\":7},\"roll\":1,"
      "\"grid\":4,\"anchored\":true,\"array\":{\"count\":[3,1,2],\"step\":[5,0,6]}}",
      "{\"op\":\"combine\",\"with\":\"shelf:eye\",\"how\":\"subtract\",\"pose\":{\"at\":[1,2,3],"
      "\"rotation\":[0,1,0,0],\"scale\":[2,2,2]}}",
      "{\"op\":\"cut\",\"region\":{\"min\":[0,0,0],\"max\":[1,2,3]}}",
      "{\"op\":\"cut\",\"region\":{\"lasso\":[[-0.1,-0.1],[0.1,-0.1],[0,0.15]],"
      "\"view\":{\"eye\":[0,0,120],\"rotation\":[1,0,0,0],\"parallel\":false}}}",
      "{\"op\":\"text\",\"text\":\"Ä\",\"size\":9,\"depth\":2,\"colour\":\"#102030\"}"};
  for (const char* line : lines) {
    const std::string once = toText(parseOperation(line, "test"));
    EXPECT_EQ(toText(parseOperation(once, "test")), once);
    EXPECT_GE(once.size() + 8, std::string(line).size()) << once;  // nothing was forgotten
  }
  EXPECT_THROW(parseOperation("{\"op\":\"cut\",\"region\":{\"min\":[0,0,0],\"max\":[-1,2,3]}}", ""),
               Error);
  EXPECT_THROW(parseOperation("{\"op\":\"action\",\"name\":\"add\",\"bulge\":{}}", ""), Error);
}

TEST_F(Tools, theShelfIsFilledAndEmptiedByOperations) {
  const std::string keep = std::string(kBody) +
                           "{\"op\":\"shelf_keep\",\"name\":\"arm\",\"tags\":[\"limb\"],"
                           "\"region\":{\"min\":[4,-20,-20],\"max\":[20,20,20]},\"pivot\":[0,0,0],"
                           "\"preset\":[{\"op\":\"action\",\"name\":\"add\",\"strength\":1}]}\n";
  const auto shelfAfter = [&](const std::string& lines) {
    return replay(recordingOf(keep + lines), {}).shelf;
  };
  const auto shelf = shelfAfter("");
  ASSERT_EQ(shelf.size(), 1u);
  const ShelfTool tool = fromItem(shelf[0]);
  EXPECT_EQ(tool.name, "arm");
  EXPECT_EQ(tool.tags, std::vector<std::string>{"limb"});
  EXPECT_EQ(tool.preset.size(), 1u);
  const auto renamed = shelfAfter(
      "{\"op\":\"shelf_rename\",\"name\":\"arm\",\"to\":\"leg\",\"tags\":[\"low\"]}\n"
      "{\"op\":\"tool\",\"shape\":\"freeform\",\"from\":\"shelf:leg\"}\n");
  EXPECT_EQ(renamed[0].name, "leg");
  EXPECT_EQ(fieldHash(fromItem(renamed[0]).clay), fieldHash(tool.clay));
  EXPECT_EQ(fromItem(renamed[0]).tags, std::vector<std::string>{"low"});
  EXPECT_TRUE(shelfAfter("{\"op\":\"shelf_drop\",\"name\":\"arm\"}").empty());
  EXPECT_THROW(shelfAfter("{\"op\":\"shelf_drop\",\"name\":\"nose\"}"), Error);
  EXPECT_THROW(shelfAfter(keep + "{\"op\":\"shelf_rename\",\"name\":\"arm\",\"to\":\"\"}"), Error);
}

TEST_F(Tools, aNameThatIsKeptAgainMeansTheNewTool) {
  const Clay made =
      replayed(std::string(kBody) +
               "{\"op\":\"shelf_keep\",\"name\":\"it\"}\n"
               "{\"op\":\"tool\",\"shape\":\"freeform\",\"from\":\"shelf:it\"}\n"
               "{\"op\":\"undo\",\"count\":2}\n{\"op\":\"fill\",\"radii\":[5,5,5]}\n"
               "{\"op\":\"shelf_keep\",\"name\":\"it\"}\n{\"op\":\"undo\",\"count\":1}\n"
               "{\"op\":\"tool\",\"shape\":\"freeform\",\"from\":\"shelf:it\",\"pivot\":[0,0,0]}\n"
               "{\"op\":\"action\",\"name\":\"add\",\"strength\":1,\"own_colours\":true}\n"
               "{\"op\":\"stroke\",\"points\":[[0,0,0]]}");
  EXPECT_EQ(fieldHash(made), fieldHash(replayed("{\"op\":\"fill\",\"radii\":[5,5,5]}")));
}

TEST_F(Tools, lettersAreASource) {
  const auto shelf =
      replay(recordingOf("{\"op\":\"shelf_keep\",\"name\":\"hi\",\"text\":\"Hi\",\"size\":8}"), {})
          .shelf;
  ASSERT_EQ(shelf.size(), 1u);
  const Clay letters = fromItem(shelf[0]).clay;
  EXPECT_DOUBLE_EQ(letters.scale.spacing, 0.125);
  const KeyBox box = boundsOf(letters);
  EXPECT_GT(box.high.i - box.low.i, 40);
  EXPECT_LE((box.high.k - box.low.k) * 0.125, 4.5);
}

TEST_F(Tools, shelfOperationsComeBackFromTheirText) {
  for (const char* line :
       {"{\"op\":\"shelf_keep\",\"name\":\"a\",\"from\":\"shelf:leaf\",\"tags\":[\"x\"],"
        "\"preset\":[{\"op\":\"action\",\"name\":\"stamp\"}]}",
        "{\"op\":\"tool\",\"shape\":\"freeform\",\"text\":\"Ab\",\"size\":9}",
        "{\"op\":\"shelf_rename\",\"name\":\"a\",\"to\":\"b\"}",
        "{\"op\":\"shelf_drop\",\"name\":\"b\"}",
        "{\"op\":\"support_move\",\"number\":2,\"shape\":\"box\",\"center\":[1,2,3]}",
        "{\"op\":\"support\",\"shape\":\"freeform\",\"from\":\"a.bzt\",\"scale\":[1,2,1]}",
        "{\"op\":\"support\",\"shape\":\"freeform\",\"from\":\"shelf:leaf\",\"radii\":[1,2,1]}",
        "{\"op\":\"support_move\",\"number\":0,\"shape\":\"freeform\",\"radii\":[1,2,1]}",
        "{\"op\":\"support_drop\",\"number\":0}"}) {
    const std::string text = toText(parseOperation(line, "test"));
    EXPECT_EQ(toText(parseOperation(text, "test")), text) << line;
  }
}

TEST_F(Tools, whatCannotBeDoneIsNamedByFileAndLine) {
  const Recording recording = parseRecording(
      "{\"bozzetto\":\"recording\",\"version\":1}\n\n{\"op\":\"support_drop\",\"number\":0}\n",
      "there.jsonl");
  try {
    replay(recording, {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()),
              "there.jsonl:3: operation 1: support_drop: support 0 found, but there are no "
              "supports");
  }
}

}  // namespace
}  // namespace bozzetto
