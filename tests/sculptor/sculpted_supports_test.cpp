// Supports that are sculptures: they belong to the document, whatever becomes of where they came
// from.
#include <gtest/gtest.h>

#include <cstdlib>

#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/sculptor/session.hpp"
#include "sculptor/fill_at.hpp"
#include "support/folder.hpp"

namespace bozzetto {
namespace {

namespace fs = std::filesystem;

using testing::fillAt;

// Two boxes at a right angle.
Clay angle() {
  Sculptor sculptor;
  FillOperation fill;
  fill.primitive.shape = Shape::box;
  fill.primitive.radii = {6, 2, 4};
  sculptor.apply(fill);
  fill.primitive.centre = {4, 5, 0};
  fill.primitive.radii = {2, 6, 4};
  sculptor.apply(fill);
  return sculptor.field();
}

class SculptedSupports : public ::testing::Test {
 protected:
  SculptedSupports() { ::setenv("XDG_STATE_HOME", (folder_ / "state").c_str(), 1); }

  const testing::Folder folder_;
  const fs::path scene_ = folder_ / "faun.bzt";
};

// A sculpted support stands in the document: no file, and no shelf, is needed any more.
TEST_F(SculptedSupports, standWithoutTheirFile) {
  const auto sculptureIn = [](const Session& session, std::size_t n) {
    return session.sculptor().clay().supports.at(n).sculpture;
  };
  saveScene(folder_ / "angle.bzt", {angle(), {}});
  {
    Session session = Session::create(scene_);
    Sculptor& sculptor = session.sculptor();
    sculptor.tools().folder = folder_.path();
    sculptor.apply(fillAt(0));
    for (const char* line :
         {"{\"op\":\"support\",\"shape\":\"freeform\",\"from\":\"angle.bzt\","
          "\"center\":[0,-20,0],\"scale\":[2,2,2],\"rotation\":[1,0,0,1]}",
          "{\"op\":\"support\",\"shape\":\"freeform\",\"from\":\"angle.bzt\","
          "\"center\":[0,20,0],\"radii\":[9,9,9]}",
          "{\"op\":\"support_move\",\"number\":0,\"shape\":\"freeform\",\"center\":[1,-20,0]}"})
      sculptor.apply(parseOperation(line, "test"));
    ASSERT_TRUE(sculptureIn(session, 0));
    EXPECT_EQ(sculptureIn(session, 0), sculptureIn(session, 1)) << "read once";
    EXPECT_EQ(sculptor.clay().supports[0].radii,
              freeformRadii(*sculptureIn(session, 0), glm::dvec3(1)));
    sculptor.apply(fillAt(9));
    sculptor.apply(ReleaseOperation{});
    sculptor.apply(UndoOperation{2});
    EXPECT_EQ(sculptor.clay().supports.size(), 2u) << "as of before the release";
    EXPECT_TRUE(sculptureIn(session, 1));
    session.keepParts();
  }
  fs::remove(folder_ / "angle.bzt");
  {
    Session session = Session::open(scene_);
    EXPECT_TRUE(session.findings().recovered) << "a crash would have left the same";
    EXPECT_EQ(fieldHash(sculptureIn(session, 1)->clay()), fieldHash(angle()));
    session.save();
    EXPECT_TRUE(session.saved());
  }
  Session session = Session::open(scene_);
  EXPECT_TRUE(session.saved());
  ASSERT_EQ(session.sculptor().clay().supports.size(), 2u);
  EXPECT_EQ(session.sculptor().clay().supports[0].centre, glm::dvec3(1, -20, 0));
  EXPECT_EQ(sculptureIn(session, 0), sculptureIn(session, 1));
  EXPECT_EQ(fieldHash(sculptureIn(session, 0)->clay()), fieldHash(angle()));
  // Strokes meet it.
  session.sculptor().apply(parseOperation("{\"op\":\"action\",\"name\":\"push\"}", "test"));
  StrokeOperation push;
  push.stroke.points = {{{0, 14, 0}, 1}, {{0, 10, 0}, 1}};
  session.sculptor().apply(push);
}

TEST_F(SculptedSupports, withoutASculptureAreRefused) {
  Session session = Session::create(scene_);
  Sculptor& sculptor = session.sculptor();
  sculptor.apply(SupportOperation{});
  for (const char* line :
       {"{\"op\":\"support\",\"shape\":\"freeform\"}",
        "{\"op\":\"support\",\"shape\":\"freeform\",\"from\":\"nowhere.bzt\"}",
        "{\"op\":\"support\",\"shape\":\"freeform\",\"from\":\"shelf:leaf\",\"scale\":[0,1,1]}",
        "{\"op\":\"support_move\",\"number\":0,\"shape\":\"freeform\"}"})
    EXPECT_THROW(sculptor.apply(parseOperation(line, "test")), Error) << line;
  ASSERT_EQ(sculptor.clay().supports.size(), 1u);
  EXPECT_EQ(sculptor.clay().supports[0].shape, Shape::box);
}

}  // namespace
}  // namespace bozzetto
