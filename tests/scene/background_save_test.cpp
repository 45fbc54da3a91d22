// What is saved is the document of the moment the save began, however much is sculpted meanwhile.
#include "bozzetto/scene/background_save.hpp"

#include <gtest/gtest.h>

#include "scene/scenes.hpp"

namespace bozzetto {
namespace {

using testing::expectEqual;
using testing::Folder;
using testing::sampleDocument;

void sculpt(Document& document, int step) {
  const int at = step * 11 % 60 - 30;
  testing::fill<8>(document.field, {{at, at, 0}, {at + 9, at + 9, 9}},
                   [&](Key) { return static_cast<float>(step % 7) / 7.0f; });
}

TEST(BackgroundSave, sculptingGoesOn) {
  const Folder folder;
  SceneFile file;
  Document document = sampleDocument();
  int step = 0;
  for (int save = 0; save < 6; ++save) {
    const Document begun = document;
    BackgroundSave job(file, folder / "a.bzt", document);
    do {
      sculpt(document, ++step);
    } while (!job.finished() && step < 100000);
    EXPECT_EQ(job.result().kind, save == 0 ? SaveKind::whole : SaveKind::changes);
    expectEqual(begun, loadScene(folder / "a.bzt"));
    EXPECT_NE(fieldHash(begun.field), fieldHash(document.field));
  }
}

TEST(BackgroundSave, tellsFailures) {
  const Folder folder;
  SceneFile file;
  BackgroundSave job(file, folder / "none" / "a.bzt", sampleDocument());
  EXPECT_THROW(job.result(), FileError);
}

TEST(BackgroundSave, canBeStopped) {
  const Folder folder;
  SceneFile file;
  Document document = sampleDocument();
  for (int n = 0; n < 20; ++n) sculpt(document, n);
  BackgroundSave job(file, folder / "a.bzt", document);
  job.cancel();
  try {
    job.result();
    expectEqual(document, loadScene(folder / "a.bzt"));
  } catch (const Cancelled&) {
    EXPECT_FALSE(std::filesystem::exists(folder / "a.bzt"));
  }
}

}  // namespace
}  // namespace bozzetto
