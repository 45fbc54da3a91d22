// Shelf and settings that were not saved come back, as steps do, and supports with their steps.
#include <gtest/gtest.h>

#include "bozzetto/base/file.hpp"
#include "bozzetto/sculptor/session.hpp"
#include "support/folder.hpp"

namespace bozzetto {
namespace {

namespace fs = std::filesystem;

class Kept : public ::testing::Test {
 protected:
  Kept() {
    ::setenv("XDG_STATE_HOME", (folder_ / "state").c_str(), 1);
    Session session = Session::create(scene_);
    session.sculptor().apply(FillOperation{});
    session.sculptor().apply(SupportOperation{});
    session.save();
  }
  // A second support and a setting; the program ends without a save.
  void work() {
    Session session = Session::open(scene_);
    session.sculptor().apply(SupportOperation{});
    session.parts.settings["theme"] = "dusk";
    session.keepParts();
    EXPECT_EQ(session.trouble(), "");
  }
  static std::size_t standing(const Session& session) {
    return session.sculptor().clay().supports.size();
  }

  const testing::Folder folder_;
  const fs::path scene_ = folder_ / "faun.bzt";
  const fs::path file_ = historyFolderOf(scene_) / "parts.bzt";
};

TEST_F(Kept, comesBackAndIsSaved) {
  work();
  {
    const Session looked = Session::look(scene_);
    EXPECT_EQ(standing(looked), 2u);
  }
  {
    Session session = Session::open(scene_);
    EXPECT_TRUE(session.findings().recovered);
    EXPECT_EQ(session.findings().unsavedSteps, 1u) << "the support";
    EXPECT_EQ(session.findings().notices.size(), 1u);
    EXPECT_EQ(standing(session), 2u);
    EXPECT_EQ(session.parts.settings.at("theme"), "dusk");
    EXPECT_FALSE(session.saved());
    session.save();
    EXPECT_TRUE(session.saved());
    EXPECT_FALSE(fs::exists(file_));
  }
  Session session = Session::open(scene_);
  EXPECT_FALSE(session.findings().recovered);
  EXPECT_EQ(standing(session), 2u);
}

TEST_F(Kept, whatIsOlderThanTheFileIsIgnored) {
  work();
  const Bytes old = readFile(file_);
  {
    Session session = Session::open(scene_);
    session.sculptor().apply(SupportOperation{});
    session.save();
  }
  writeFile(file_, old);
  Session session = Session::open(scene_);
  EXPECT_FALSE(session.findings().recovered);
  EXPECT_EQ(standing(session), 3u);
}

TEST_F(Kept, goesWhenTheUserWantsNoneOfIt) {
  work();
  Session::discard(Session::open(scene_));
  Session session = Session::open(scene_);
  EXPECT_FALSE(session.findings().recovered);
  EXPECT_EQ(standing(session), 1u);
  EXPECT_FALSE(session.parts.settings.contains("theme"));
}

TEST_F(Kept, whatIsSavedIsNotKeptTwice) {
  Session session = Session::open(scene_);
  session.keepParts();
  EXPECT_FALSE(fs::exists(file_));
}

TEST_F(Kept, damageIsToldAndHarmsNothing) {
  work();
  Bytes bytes = readFile(file_);
  bytes[bytes.size() / 2] ^= std::byte{1};
  writeFile(file_, bytes);
  Session session = Session::open(scene_);
  ASSERT_EQ(session.findings().notices.size(), 1u);
  EXPECT_NE(session.findings().notices[0].find("parts.bzt"), std::string::npos);
  EXPECT_FALSE(session.parts.settings.contains("theme"));
  EXPECT_EQ(standing(session), 2u) << "a step of history";
}

TEST_F(Kept, alsoWhereTheFileIsLost) {
  work();
  fs::remove(scene_);
  const Session session = Session::open(scene_);
  EXPECT_TRUE(session.findings().recovered);
  EXPECT_EQ(standing(session), 2u);
}

TEST_F(Kept, savedUnderAnotherNameItIsSaved) {
  work();
  const fs::path other = folder_ / "satyr.bzt";
  {
    Session session = Session::open(scene_);
    session.saveAs(other);
    session.sculptor().apply(SupportOperation{});
    session.keepParts();
  }
  EXPECT_EQ(standing(Session::open(other)), 3u);
  EXPECT_EQ(standing(Session::open(scene_)), 2u);
}

TEST_F(Kept, noPlaceOnTheDiskIsTold) {
  Session session = Session::open(scene_);
  session.parts.settings["theme"] = "dusk";
  fs::create_directories(file_ / "in the way");
  session.keepParts();
  EXPECT_NE(session.trouble(), "");
  fs::remove_all(file_);
  session.keepParts();
  EXPECT_EQ(session.trouble(), "");
  EXPECT_TRUE(fs::exists(file_));
}

}  // namespace
}  // namespace bozzetto
