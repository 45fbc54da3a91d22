// Whether the pointer keeps its pace while the clay is worked on: frames of a stroke against frames
// in which only the camera moves, in one run, drawn off-screen at 1280 × 800.
#include <chrono>
#include <cstdio>
#include <thread>

#include "ui/offscreen_window.hpp"

namespace bozzetto::ui {
namespace {

// 500,000 triangles.
class Pace : public Offscreen {
 protected:
  Pace() : Offscreen(116) { atelier_.options.quality = Quality::light; }

  // Milliseconds of a frame on average, without waiting for the clay.
  template <class Move>
  double frames(int count, Move move) {
    const auto began = std::chrono::steady_clock::now();
    for (int n = 0; n < count; ++n) {
      move(n);
      frame();
      most_ = std::max(most_, std::size_t(interface_.figures.viewport.uploadedBytes));
    }
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - began;
    return took.count() / count;
  }

  void expectPace();

  std::size_t most_ = 0;
};

void Pace::expectPace() {
  ASSERT_GT(atelier_.patches().triangles(), 480000u);
  atelier_.sculpt.size = 16;
  constexpr int kFrames = 40;
  moveTo(middle());
  frame();
  interface_.post(ButtonChanged{Button::middle, true});
  const double camera = frames(kFrames, [&](int n) { moveTo(middle() + glm::dvec2(3 * n, 0)); });
  interface_.post(ButtonChanged{Button::middle, false});
  settle();
  moveTo(middle());
  frame();
  interface_.post(ButtonChanged{Button::left, true});
  most_ = 0;
  const double stroke =
      frames(kFrames, [&](int n) { moveTo(middle() + glm::dvec2(4 * n, 2 * n)); });
  const std::size_t most = most_;
  interface_.post(ButtonChanged{Button::left, false});
  do {
    frame();
  } while (interface_.hasEvents());
  // The last dab is computed; from now on frames are counted.
  while (!atelier_.worker().isIdle()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  int after = 0;
  do {
    frame();
    ++after;
  } while (atelier_.status().inStroke || canvas_.hasUploads());
  std::printf("camera %.1f ms, stroke %.1f ms a frame (%.2f), last dab seen after %d, %zu kB\n",
              camera, stroke, stroke / camera, after, most / 1000);
  EXPECT_GT(atelier_.status().last.dabs, 10);
  EXPECT_LE(stroke, 1.25 * camera);
  EXPECT_LE(after, 2);
  EXPECT_LE(most, 12u << 20);
}

TEST_F(Pace, SlowAStrokeKeepsThePaceOfTheCamera) { expectPace(); }

TEST_F(Pace, SlowSmoothedClayKeepsItToo) {
  atelier_.options.smoothed = true;
  settle();
  expectPace();
}

}  // namespace
}  // namespace bozzetto::ui
