#include "bozzetto/render/viewport.hpp"

#include <gtest/gtest.h>

#include "head_view.hpp"

namespace bozzetto {
namespace {

using namespace test;
using ClayFrame = FrameReport::Clay;

constexpr PixelRect kPlace{24, 16, 160, 120};

// A window of a kind: a framebuffer larger than the view, with a renderer that has the head.
struct Window : HeadView {
  Window() : HeadView(kPlace, 200, 150) {}
  void rest() {
    for (int n = 0; n < 1000 && !draw().settled; ++n) frame.now += .5;
  }
};

Overlays ringAt(const glm::dvec3& place, double radius = 6) {
  Overlays overlays;
  RingCursor ring;
  ring.centre = place;
  ring.radius = radius;
  overlays.rings.push_back(ring);
  return overlays;
}

glm::dvec3 frontOfHead() {
  const Loaded& head = theHead();
  const Ray ray = rayThrough(head.shot(), {80, 60});
  return pick(head.scene.clay, ray, 1e4)->place;
}

TEST(Viewport, DrawsIntoItsPlaceOnly) {
  Window window;
  EXPECT_EQ(window.draw().clay, ClayFrame::drawn);
  window.target.bind();
  const Image all = readBack({0, 0, 200, 150});
  int magenta = 0;
  for (const Image::Pixel& p : all.pixels) magenta += p == Image::Pixel{255, 0, 255, 255};
  EXPECT_EQ(magenta, 200 * 150 - kPlace.width * kPlace.height);
}

TEST(Viewport, AMovingCursorDrawsNoClay) {
  Window window;
  window.draw();
  const glm::dvec3 place = frontOfHead();
  for (int n = 0; n < 5; ++n) {
    const FrameReport report = window.draw(ringAt(place + glm::dvec3(n, 0, 0)));
    EXPECT_EQ(report.clay, ClayFrame::kept);
    EXPECT_EQ(report.triangles, 0u);
    EXPECT_EQ(report.uploadedBytes, 0);
  }
}

TEST(Viewport, RingLeavesNoTrace) {
  Window window;
  window.draw();
  const Image plain = window.picture();
  window.draw(ringAt(frontOfHead()));
  const Image ringed = window.picture();
  EXPECT_GT(pixelsThatDiffer(plain, ringed, 30), 60);
  EXPECT_LT(pixelsThatDiffer(plain, ringed), 160 * 120 / 2);
  window.draw();
  EXPECT_EQ(pixelsThatDiffer(window.picture(), plain), 0);
}

// Grid and box are kept with the clay's picture; what changes shows all the same.
TEST(Viewport, StandingOverlaysAreKeptTruly) {
  Window window;
  const Loaded& head = theHead();
  Overlays overlays = ringAt(frontOfHead());
  overlays.grid = FloorGrid{{0, window.frame.stage.floor, 0}, 8, 12, .3f};
  overlays.box = BoxOutline{head.bounds.low, head.bounds.high, true, {}, 1};
  const auto sameAsFresh = [&] {
    window.draw(overlays);
    const Image kept = window.picture();
    Viewport fresh(window.renderer);
    fresh.fixQuality(Quality::light);
    window.target.bind();
    fresh.draw(window.frame, overlays);
    return pixelsThatDiffer(window.picture(), kept) == 0;
  };
  EXPECT_TRUE(sameAsFresh());
  overlays.rings[0].centre.x += 4;
  EXPECT_TRUE(sameAsFresh());
  overlays.box->active = 1;
  EXPECT_TRUE(sameAsFresh());
  overlays.box.reset();
  EXPECT_TRUE(sameAsFresh());
  window.frame.camera.yaw += .3;
  window.frame.now += 1;
  EXPECT_TRUE(sameAsFresh());
  overlays.grid.reset();
  EXPECT_TRUE(sameAsFresh());
}

TEST(Viewport, NothingIsDrawnIntoNothing) {
  Window window;
  window.frame.place = {0, 0, 3, 0};
  EXPECT_TRUE(window.draw().settled);
}

// Half the head's patches away and back: pieces redrawn are the same as all redrawn.
TEST(Viewport, PatchedPicturesEqualWholeOnes) {
  Window window;
  window.draw();
  const Image before = window.picture();
  const auto& patches = theHead().patches;
  const UnpackedPatch& some = patches[patches.size() / 3];
  window.renderer.removePatch(some.origin, some.fineness);
  const FrameReport report = window.draw();
  EXPECT_EQ(report.clay, ClayFrame::patched);
  EXPECT_GT(report.uploadedBytes, 0);
  EXPECT_LT(report.triangles, window.renderer.triangleCount() + 1);
  const Image patched = window.picture();

  Viewport fresh(window.renderer);
  fresh.fixQuality(Quality::light);
  window.target.bind();
  fresh.draw(window.frame, {});
  EXPECT_EQ(pixelsThatDiffer(window.picture(), patched), 0);

  window.renderer.uploadPatch(some.view());
  EXPECT_EQ(window.draw().clay, ClayFrame::patched);
  EXPECT_EQ(pixelsThatDiffer(window.picture(), before), 0);
}

TEST(Viewport, UploadedBytesAreThoseOfThePatch) {
  Window window;
  window.draw();
  const UnpackedPatch& patch = theHead().patches.front();
  window.renderer.uploadPatch(patch.view());
  const auto bytes = std::int64_t(patch.positions.size() * 32 + patch.indices.size() * 4);
  const FrameReport report = window.draw();
  EXPECT_GE(report.uploadedBytes, bytes);
  EXPECT_LE(report.uploadedBytes, bytes + std::int64_t(patch.indices.size() * 4));
}

TEST(Viewport, RefinesAtRestAndThenSleeps) {
  Window window;
  FrameReport report = window.draw();
  EXPECT_FALSE(report.settled);
  const Image moving = window.picture();
  window.frame.lastInput = window.frame.now = 1;
  EXPECT_EQ(window.draw().clay, ClayFrame::kept) << "right after input";
  window.rest();
  report = window.draw();
  EXPECT_TRUE(report.settled);
  EXPECT_EQ(report.clay, ClayFrame::kept);
  EXPECT_EQ(report.slices, 12);
  const double difference = meanDifference(moving, window.picture());
  EXPECT_GT(difference, .05);
  EXPECT_LT(difference, 8);
}

// The refined view is the still of the same shot.
TEST(Viewport, RefinedEqualsTheStill) {
  Window window;
  window.rest();
  const Image refined = window.picture();
  Look look = window.frame.look;
  window.renderer.restart();
  for (int n = 0; n < 12; ++n) window.renderer.addSlice(shotOf(window.frame), look);
  EXPECT_EQ(pixelsThatDiffer(window.renderer.mean(shotOf(window.frame)), refined), 0);
}

TEST(Viewport, CoarseClayWhileTheCameraMovesOnly) {
  Window window;
  window.viewport.fixQuality(Quality::least);
  window.draw();
  window.frame.camera.yaw += .1;
  window.frame.now += .02;
  const FrameReport moving = window.draw();
  // The head is too small to be worth a coarse copy.
  EXPECT_EQ(moving.triangles, window.renderer.triangleCount());
  EXPECT_GT(window.renderer.triangleCount(Fineness::coarse), 0u);
  EXPECT_LT(window.renderer.triangleCount(Fineness::coarse), window.renderer.triangleCount() / 3);
}

TEST(Viewport, LeastQualityRestsInFullResolution) {
  Window window;
  window.rest();
  const Image refined = window.picture();
  Window poor;
  poor.viewport.fixQuality(Quality::least);
  poor.draw();
  const double moving = meanDifference(refined, poor.picture());
  poor.rest();
  EXPECT_LT(meanDifference(refined, poor.picture()), .3 * moving);
  poor.frame.lastInput = poor.frame.now += .01;
  EXPECT_EQ(poor.draw().clay, FrameReport::Clay::kept) << "a hand that hovers changes nothing";
  poor.frame.camera.yaw += .1;
  EXPECT_EQ(poor.draw().clay, FrameReport::Clay::drawn);
}

TEST(Viewport, StereoShowsDepth) {
  Window window;
  window.draw();
  const Image flat = window.picture();
  for (const StereoMode mode :
       {StereoMode::sideBySide, StereoMode::rowInterlaced, StereoMode::anaglyph}) {
    window.frame.stereo.mode = mode;
    window.draw(ringAt(frontOfHead()));
    EXPECT_GT(meanDifference(flat, window.picture()), .5);
  }
  // Eyes that stand in one place see one picture.
  window.frame.stereo = {StereoMode::rowInterlaced, 0, 1};
  window.draw();
  EXPECT_LT(meanDifference(flat, window.picture()), .01);
}

TEST(QualityLadder, StepsByWhatFramesCost) {
  QualityLadder ladder("llvmpipe (LLVM 15.0.6, 256 bits)");
  EXPECT_TRUE(ladder.onProcessor());
  EXPECT_EQ(ladder.quality(), Quality::light);
  double now = 0;
  const auto frames = [&](int count, double ms) {
    for (int n = 0; n < count; ++n) ladder.measured(ms, now += ms / 1000);
  };
  frames(40, 30);  // within the budget: stays
  EXPECT_EQ(ladder.quality(), Quality::light);
  ladder.setStroke(true);
  frames(20, 80);
  EXPECT_EQ(ladder.quality(), Quality::light) << "never within a stroke";
  ladder.setStroke(false);
  frames(1, 80);
  EXPECT_EQ(ladder.quality(), Quality::least);
  frames(100, 80);
  EXPECT_EQ(ladder.quality(), Quality::least) << "nothing below";
  frames(210, 10);
  EXPECT_EQ(ladder.quality(), Quality::light);
  frames(1000, 10);
  EXPECT_EQ(ladder.quality(), Quality::middle) << "a processor goes no higher";
}

TEST(QualityLadder, CardsStartHigher) {
  QualityLadder ladder("NVIDIA GeForce");
  EXPECT_EQ(ladder.quality(), Quality::good);
  double now = 0;
  for (int n = 0; n < 500; ++n) ladder.measured(4, now += .008);
  EXPECT_EQ(ladder.quality(), Quality::best);
}

}  // namespace
}  // namespace bozzetto
