// From a shot to the numbers the shaders share.
#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "bozzetto/render/look.hpp"
#include "bozzetto/render/occlusion.hpp"
#include "bozzetto/render/shot.hpp"
#include "render/studio.hpp"

namespace bozzetto {

/// Where inside the pixel and inside the key's soft box a slice is taken.
struct Slice {
  glm::dvec2 pixel{0};  ///< −½…½ pixels
  glm::dvec2 light{0};  ///< −1…1 of the box's half sides
  int index = 0;
  bool one = true;  ///< the only one of its picture: its own shadow must be soft
  int taps = 16;    ///< where the shadow map is read, at most 16
};

/// The n-th slice of a still: evenly spread in the pixel and in the box.
Slice sliceAt(int n);

/// std140 layout of frame.glsl.
struct FrameBlock {
  glm::mat4 clipFromCells, viewFromCells, shadowFromCells, worldFromView;
  glm::vec4 viewport, part, stage, shadowing, floorPlane, extra;
  glm::vec4 taps[16];
};

/// What one slice needs. `anchor` is the lattice point next to the eye: the GPU sees positions
/// counted from there, exact in float for 2²⁴ cells around.
struct Frame {
  Key anchor;
  FrameBlock block;
  glm::dmat4 clipFromCells{1};
  StudioPose pose;
  bool floorInSight = true;
  int width = 0, height = 0;  // of the part drawn
};
Frame makeFrame(const Shot& shot, const Look& look, const Slice& slice);

}  // namespace bozzetto
