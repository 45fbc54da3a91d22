// What the window draws over the clay: cursor, tools, planes, boxes, lights. Values for one frame;
// places are in cells. Things behind the clay show faintly or not at all, each as fits it.
#pragma once
#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "bozzetto/render/camera.hpp"
#include "bozzetto/render/image.hpp"
#include "bozzetto/render/shot.hpp"

namespace bozzetto {

/// sRGB 0…1 and opacity.
using Ink = glm::vec4;

/// A ring where a ball cuts the clay (it hugs the form), and a flat one across the normal where
/// there is no clay under it.
struct RingCursor {
  enum class On { clay, air };
  glm::dvec3 centre{0};
  glm::dvec3 normal{0, 1, 0};
  double radius = 8;            ///< cells
  Ink ink{1, .725f, .541f, 1};  ///< of the inside; the line is white. #FFB98A
  On on = On::clay;
  float weight = 1;  ///< 1 the cursor itself; .5 its mirror partners, thinner
};

/// Triangles of a tool in its own frame; kept on the graphics card while the same pointer comes.
struct ToolMesh {
  std::vector<glm::vec3> positions, normals;
  std::vector<std::uint32_t> indices;
};
/// Unit shapes: ball of radius 1, box of half side 1, cylinder of radius and half height 1 along y.
enum class UnitShape { ball, box, cylinder };
/// Round for the eye, or so few triangles that their edges can be told apart.
enum class Rounding { smooth, wires };
std::shared_ptr<const ToolMesh> unitMesh(UnitShape shape, Rounding rounding = Rounding::smooth);
/// Along y, so that radii keep their ends round: radii as a tool's, cells.
std::shared_ptr<const ToolMesh> capsuleMesh(const glm::vec3& radii,
                                            Rounding rounding = Rounding::smooth);

enum class ToolDisplay { hidden, solid, transparent, wire };
struct ToolGhost {
  std::shared_ptr<const ToolMesh> mesh;
  std::shared_ptr<const ToolMesh> limit;  ///< its limit of influence; may be null
  glm::dmat4 cellsFromTool{1};
  glm::dmat4 cellsFromLimit{1};
  ToolDisplay display = ToolDisplay::transparent;
  Ink ink{1, .725f, .541f, 1};
  float hidden = .42f;  ///< how much of a transparent one is seen behind clay
};

/// Where the tool works in empty air: a faint plane, and its shadow on the floor below.
struct WorkingPlane {
  glm::dvec3 centre{0}, normal{0, 0, 1};
  double radius = 24;      ///< cells; fades towards it
  double toolRadius = 8;   ///< cells, of the shadow
  double shadowFloor = 0;  ///< height of what the shadow falls on, cells
  Ink ink{.373f, .722f, .788f, .5f};
};

struct FloorGrid {
  glm::dvec3 centre{0};  ///< of the grid; lines run through its whole multiples of `step`
  double step = 8;       ///< cells
  int lines = 12;        ///< each way
  float opacity = .2f;
  friend bool operator==(const FloorGrid&, const FloorGrid&) = default;
};

/// The workspace box; handles are drawn at the middles of its sides.
struct BoxOutline {
  glm::dvec3 low{0}, high{0};
  bool handles = false;
  std::optional<int> active;  ///< the handle under the pointer: 2·axis + (1 on the high side)
  float opacity = 1;
  friend bool operator==(const BoxOutline&, const BoxOutline&) = default;
};
/// The handle of `box` within 9 pixels of `pixel` and nearest to the eye.
std::optional<int> handleAt(const Shot& shot, const BoxOutline& box, glm::dvec2 pixel);

struct LightMark {
  glm::dvec3 place{0};
  glm::dvec3 target{0};  ///< a line runs there
  Ink ink{1, 1, 1, 1};
  bool active = false;
};
/// Where the mark of a far light belongs: on a ball around the stage. `towards` in the world.
glm::dvec3 lightMarkPlace(const Stage& stage, const glm::dvec3& towards, double distance = 0);

/// A picture standing in the scene: `right` and `up` are half its sides, cells.
struct ReferencePicture {
  std::shared_ptr<const Image> image;  ///< kept on the graphics card while the pointer is the same
  glm::dvec3 centre{0}, right{1, 0, 0}, up{0, 1, 0};
  float opacity = .6f;
  bool behind = true;  ///< the clay hides it; otherwise it lies over everything
  friend bool operator==(const ReferencePicture&, const ReferencePicture&) = default;
};

struct Polyline {
  std::vector<glm::dvec3> points;
  Ink ink{1, 1, 1, .8f};
  float width = 1.5f;   ///< pixels
  float hidden = .25f;  ///< part of its opacity behind clay
  bool closed = false;
};

struct Overlays {
  std::vector<RingCursor> rings;
  std::vector<ToolGhost> tools;
  std::vector<Polyline> lines;
  std::vector<LightMark> lights;
  std::vector<ReferencePicture> pictures;
  std::optional<WorkingPlane> plane;
  std::optional<FloorGrid> grid;
  std::optional<BoxOutline> box;
};

/// The axis ball in a corner of the view: ends of the six half axes, farthest first. For the window
/// to draw and to hit; clicking one looks from there.
struct AxisEnd {
  int axis = 0;  ///< 0 x, 1 y, 2 z
  bool positive = true;
  glm::dvec2 at{0};  ///< in the unit disk, y down as pixels are
  double depth = 0;  ///< −1 far … 1 near
};
std::array<AxisEnd, 6> axisEnds(const Camera& camera);
/// The camera that looks from that end at the same target.
Camera lookingFrom(const AxisEnd& end, Camera camera);

}  // namespace bozzetto
