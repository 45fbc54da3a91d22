#include "bozzetto/sculptor/recording.hpp"

#include <gtest/gtest.h>

#include "bozzetto/base/error.hpp"

namespace bozzetto {
namespace {

const std::string kHeader = "{\"bozzetto\":\"recording\",\"version\":1}\n";

Recording parse(const std::string& lines) { return parseRecording(kHeader + lines, "r.jsonl"); }

std::string faultOf(const std::string& lines) {
  try {
    parse(lines);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Recording, everyOperationSurvivesTheRoundTrip) {
  const std::string text =
      kHeader +
      R"({"op":"scene","spacing":0.5,"iso":0.25}
{"op":"fill","shape":"capsule","center":[1,2,3],"radii":[4,5,6],)"
      R"("rotation":[0.5,0.5,0.5,0.5],"colour":"#010203"}
{"op":"tool","shape":"box","profile":"box","radii":[4,5,6],"rotation":[1,0,0,0]}
{"op":"action","name":"paint_soft","strength":0.125,"colour":"#c8643c"}
{"op":"stroke","points":[[0,0,0],[10,0,0,0.5]],"spacing":0.5,"mirror":"xz",)"
      R"("mirror_at":[1,0,0],"radial":{"axis":"z","count":6},"pressure":["strength","size"]}
{"op":"undo","count":3}
{"op":"redo"}
{"op":"import","from":"bust.ply","cells":64,"spacing":0.5,"colour":"#010203"}
{"op":"resample","spacing":0.25}
)";
  const Recording recording = parseRecording(text, "r");
  ASSERT_EQ(recording.operations.size(), 9u);
  const std::string again = toText(recording);
  EXPECT_EQ(toText(parseRecording(again, "again")), again);
  const auto& stroke = std::get<StrokeOperation>(recording.operations[4]).stroke;
  EXPECT_EQ(stroke.points[1].pressure, 0.5);
  EXPECT_TRUE(stroke.symmetry.mirror[0] && !stroke.symmetry.mirror[1] && stroke.symmetry.mirror[2]);
  EXPECT_EQ(stroke.symmetry.radialAxis, Axis::z);
  EXPECT_TRUE(stroke.pressure.size && stroke.pressure.strength);
  EXPECT_EQ(std::get<FillOperation>(recording.operations[1]).primitive.colour, (Colour{1, 2, 3}));
}

TEST(Recording, onlyOpAndWhatHasNoDefaultIsRequired) {
  const Recording recording = parse(
      "{\"op\":\"tool\"}\n\n{\"op\":\"action\",\"name\":\"add\"}\n{\"op\":\"stroke\",\"points\":[["
      "0,0,0]]}\r\n{\"op\":"
      "\"fill\"}\n{\"op\":\"scene\"}");
  EXPECT_EQ(recording.operations.size(), 5u);
  EXPECT_EQ(std::get<ActionOperation>(recording.operations[1]).action.strength, 0.5);
  EXPECT_EQ(std::get<StrokeOperation>(recording.operations[2]).stroke.spacing, 0.25);
}

struct Fault {
  const char* line;
  const char* tells;
};

class RecordingFaults : public ::testing::TestWithParam<Fault> {};

TEST_P(RecordingFaults, nameLineAndReason) {
  const std::string fault = faultOf("{\"op\":\"undo\"}\n" + std::string(GetParam().line) + "\n");
  EXPECT_NE(fault.find("r.jsonl:3"), fault.npos) << fault;
  EXPECT_NE(fault.find(GetParam().tells), fault.npos) << fault;
  EXPECT_EQ(fault.find('\n'), fault.npos);
}

INSTANTIATE_TEST_SUITE_P(
    all, RecordingFaults,
    ::testing::Values(
        Fault{"{\"op\":\"dance\"}", "unknown operation 'dance'"},
        Fault{"{\"op\":\"undo\",\"cuont\":2}", "unknown key 'cuont'"},
        Fault{"{\"op\":\"undo\",\"count\":1.5}", "'count'"},
        Fault{"{\"op\":\"undo\",\"count\":-1}", "'count'"}, Fault{"{\"op\":\"undo\"", "not JSON"},
        Fault{"[]", "an object expected"}, Fault{"7", "an object expected"}, Fault{"{}", "'op'"},
        Fault{"{\"op\":3}", "'op'"}, Fault{"{\"op\":\"action\"}", "'name'"},
        Fault{"{\"op\":\"action\",\"name\":\"dig\"}", "one of add, remove"},
        Fault{"{\"op\":\"stroke\"}", "'points'"},
        Fault{"{\"op\":\"stroke\",\"points\":[]}", "'points'"},
        Fault{"{\"op\":\"stroke\",\"points\":[[0,0]]}", "'points'"},
        Fault{"{\"op\":\"stroke\",\"points\":[[0,0,0,2]]}", "pressure"},
        Fault{"{\"op\":\"stroke\",\"points\":[[0,0,1e999]]}", "not JSON"},
        Fault{"{\"op\":\"stroke\",\"points\":[[0,0,null]]}", "a number expected"},
        Fault{"{\"op\":\"stroke\",\"points\":[[0,0,0]],\"mirror\":\"w\"}", "'mirror'"},
        Fault{"{\"op\":\"stroke\",\"points\":[[0,0,0]],\"radial\":{\"axis\":\"x\",\"n\":2}}",
              "unknown key 'n'"},
        Fault{"{\"op\":\"fill\",\"colour\":\"red\"}", "#rrggbb"},
        Fault{"{\"op\":\"support\",\"shape\":\"blob\"}", "capsule, freeform"},
        Fault{"{\"op\":\"tool\",\"shape\":\"blob\"}", "capsule, freeform"},
        Fault{"{\"op\":\"fill\",\"shape\":\"freeform\"}", "cylinder, capsule"},
        Fault{"{\"op\":\"fill\",\"radii\":[1,2]}", "3 numbers"},
        Fault{"{\"op\":\"scene\",\"spacing\":0}", "'spacing'"},
        Fault{"{\"op\":\"scene\",\"iso\":1}", "'iso'"}, Fault{"{\"op\":\"resample\"}", "'spacing'"},
        Fault{"{\"op\":[[[[[[[[[[[[1]]]]]]]]]]]]}", "nested"}));

TEST(Recording, theHeaderIsRequired) {
  EXPECT_THROW(parseRecording("", "r"), Error);
  EXPECT_THROW(parseRecording("{\"op\":\"undo\"}\n", "r"), Error);
  EXPECT_THROW(parseRecording("{\"bozzetto\":\"scene\",\"version\":1}\n", "r"), Error);
  EXPECT_THROW(parseRecording("{\"bozzetto\":\"recording\",\"version\":2}\n", "r"), Error);
  EXPECT_NO_THROW(parseRecording(kHeader, "r"));
}

TEST(Recording, hostileNestingIsRefusedWithoutRecursion) {
  EXPECT_THROW(parse(std::string(1'000'000, '[')), Error);
  EXPECT_THROW(parse("{\"op\":" + std::string(1'000'000, '[') + std::string(1'000'000, ']') + "}"),
               Error);
}

TEST(Recording, aMissingFileIsNamed) {
  try {
    readRecording("/nonexistent/r.jsonl");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("/nonexistent/r.jsonl"), std::string::npos);
  }
}

TEST(Recording, sayWhatTheyGoOnFrom) {
  const std::string header =
      R"({"bozzetto":"recording","field_hash":"00000000000000ff","from":"bust.bzt","version":1})";
  const Recording recording = parseRecording(header + "\n{\"op\":\"redo\",\"count\":1}\n", "r");
  ASSERT_TRUE(recording.start);
  EXPECT_EQ(*recording.start, (RecordingStart{"bust.bzt", 255}));
  EXPECT_EQ(toText(recording).substr(0, header.size() + 1), header + "\n");
  EXPECT_FALSE(parse("").start);
  for (const char* hash : {"", "00000000000000f", "00000000000000fg", "0x000000000000ff"}) {
    const std::string bad = std::string(R"({"bozzetto":"recording","version":1,"from":"b",)") +
                            R"("field_hash":")" + hash + "\"}\n";
    EXPECT_THROW(parseRecording(bad, "r"), Error) << hash;
  }
}

}  // namespace
}  // namespace bozzetto
