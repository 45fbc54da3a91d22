// The figures of Ferley's paper that show what tools do, sculpted again by recordings: a print, a
// print that is dragged, a head made with a finger, a tool used at several scales.
#include <gtest/gtest.h>

#include <cstdlib>

#include "bozzetto/render/png.hpp"
#include "bozzetto/sculptor/recording.hpp"
#include "bozzetto/sculptor/replay.hpp"
#include "loaded.hpp"

namespace bozzetto {
namespace {

struct Figure {
  int number;
  double yaw, pitch;  ///< radians
};
void PrintTo(const Figure& figure, std::ostream* out) { *out << "figure " << figure.number; }

class FerleySlow : public ::testing::TestWithParam<Figure> {};

// BOZZETTO_UPDATE_GOLDEN=1 writes them anew, to be looked at again.
TEST_P(FerleySlow, looksAsItDid) {
  const std::string source = BOZZETTO_SOURCE_DIR;
  const std::string name = "ferley_figure_" + std::to_string(GetParam().number);
  const Recording recording = readRecording(source + "/data/recordings/" + name + ".jsonl");
  const ReplayResult made = replay(recording, Clay{});
  Surface<8> surface;
  surface.rebuild(made.field);
  PictureOptions options;
  options.width = 320;
  options.height = 240;
  options.slices = 2;
  options.yaw = GetParam().yaw;
  options.pitch = GetParam().pitch;
  const Image image = renderPicture(surface, made.field, options);
  const std::string golden = source + "/tests/golden/render/" + name + ".png";
  if (std::getenv("BOZZETTO_UPDATE_GOLDEN") != nullptr) writePng(golden, image);
  EXPECT_LT(test::meanDifference(image, readPng(golden)), 1.5);
}

INSTANTIATE_TEST_SUITE_P(Figures, FerleySlow,
                         ::testing::Values(Figure{3, 0.15, 0.15}, Figure{4, 0.4, 0.3},
                                           Figure{15, 0.45, 0.15}, Figure{19, 0.5, 0.35}));

}  // namespace
}  // namespace bozzetto
