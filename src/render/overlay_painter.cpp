#include "render/overlay_painter.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render/enabled.hpp"
#include "render/overlay_shapes.hpp"
#include "render/stage_textures.hpp"

namespace bozzetto {
namespace {

constexpr std::size_t kMostKept = 32;

void attribute(GLuint location, GLint count, std::size_t floats, std::size_t stride) {
  glVertexAttribPointer(location, count, GL_FLOAT, GL_FALSE, GLsizei(stride),
                        reinterpret_cast<const void*>(floats * sizeof(float)));
  glEnableVertexAttribArray(location);
}

// Opacity of the window's framebuffer stays 1.
void blendOver() { glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE); }

glm::dvec3 toEye(const Frame& frame) { return glm::dvec3(frame.pose.worldFromView[2]); }

}  // namespace

struct OverlayPainter::Glass {
  Ink ink;
  glm::vec4 rim;    // base, rim, exponent, glint
  float solid = 0;  // 1: lit and opaque
  float hidden = .35f;
  bool lines = false;
};

OverlayPainter::OverlayPainter()
    : paint_({"paint.vert"}, {"overlay", "paint.frag"}),
      ring_({"ring.vert"}, {"overlay", "ring.frag"}),
      ghost_({"ghost.vert"}, {"overlay", "ghost.frag"}),
      poster_({"poster.vert"}, {"overlay", "poster.frag"}) {
  glBindVertexArray(inkArray_.get());
  glBindBuffer(GL_ARRAY_BUFFER, inkBuffer_.get());
  constexpr std::size_t stride = sizeof(InkSheet::Vertex);
  attribute(0, 4, 0, stride);
  attribute(1, 4, 4, stride);
  attribute(2, 4, 8, stride);
  attribute(3, 1, 12, stride);
  glBindVertexArray(posterArray_.get());
  glBindBuffer(GL_ARRAY_BUFFER, posterBuffer_.get());
  attribute(0, 4, 0, 6 * sizeof(float));
  attribute(1, 2, 4, 6 * sizeof(float));
  glBindVertexArray(0);
}

void OverlayPainter::place(const gl::Program& program, const Scene& scene) const {
  program.use();
  program.set("place", glm::vec4(scene.place.x, scene.place.y,
                                 float(scene.depthWidth) / float(scene.place.width),
                                 float(scene.depthHeight) / float(scene.place.height)));
}

void OverlayPainter::paint(std::span<const InkSheet::Vertex> vertices, const Scene& scene) {
  if (vertices.empty()) return;
  place(paint_, scene);
  glBindVertexArray(inkArray_.get());
  glBindBuffer(GL_ARRAY_BUFFER, inkBuffer_.get());
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size_bytes()), vertices.data(), GL_STREAM_DRAW);
  glDrawArrays(GL_TRIANGLES, 0, GLsizei(vertices.size()));
}

const gl::Texture& OverlayPainter::uploaded(const std::shared_ptr<const Image>& image) {
  if (posters_.size() > kMostKept) posters_.clear();
  Poster& poster = posters_[image.get()];
  if (poster.source == nullptr) poster = {image, imageTexture(*image)};
  return poster.texture;
}

void OverlayPainter::drawPosters(const Overlays& overlays, const InkView& view, const Scene& scene,
                                 bool behind) {
  for (const ReferencePicture& picture : overlays.pictures) {
    if (picture.behind != behind || !picture.image) continue;
    float vertices[4][6];
    for (int n = 0; n < 4; ++n) {
      const double u = n & 1, v = n >> 1;
      const glm::vec4 clip =
          view.clipOf(picture.centre + picture.right * (2 * u - 1) + picture.up * (2 * v - 1));
      std::copy_n(&clip.x, 4, vertices[n]);
      vertices[n][4] = float(u);
      vertices[n][5] = float(1 - v);
    }
    gl::bindTexture(gl::source, uploaded(picture.image));
    place(poster_, scene);
    poster_.set("opacity", picture.opacity);
    poster_.set("hidden", behind ? 0.f : 1.f);
    glBindVertexArray(posterArray_.get());
    glBindBuffer(GL_ARRAY_BUFFER, posterBuffer_.get());
    glBufferData(GL_ARRAY_BUFFER, sizeof(vertices), vertices, GL_STREAM_DRAW);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
}

// The rectangle around the ball and its halo.
void OverlayPainter::drawRing(const RingCursor& ring, const InkView& view, const Scene& scene) {
  constexpr double kHaloPixels = 24;
  const glm::dvec2 margin(2 * kHaloPixels / view.width, 2 * kHaloPixels / view.height);
  glm::dvec2 low(1), high(-1);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 step(corner & 4 ? 1 : -1, corner & 2 ? 1 : -1, corner & 1 ? 1 : -1);
    const glm::dvec4 clip = view.clipOf(ring.centre + step * ring.radius);
    const glm::dvec2 at = clip.w > 1e-6 ? glm::dvec2(clip) / clip.w : glm::dvec2(0);
    low = clip.w > 1e-6 ? glm::min(low, at - margin) : glm::dvec2(-1);
    high = clip.w > 1e-6 ? glm::max(high, at + margin) : glm::dvec2(1);
    if (clip.w <= 1e-6) break;
  }
  place(ring_, scene);
  low = glm::max(low, glm::dvec2(-1));
  high = glm::min(high, glm::dvec2(1));
  ring_.set("bounds", glm::vec4(low, high));
  ring_.set("cellsFromClip", glm::mat4(glm::inverse(view.clipFromCells)));
  ring_.set("ball", glm::vec4(glm::vec3(view.fromAnchor(ring.centre)), ring.radius));
  ring_.set("ink", ring.ink);
  ring_.set("weight", ring.weight);
  ring_.set("view", glm::vec4(scene.place.x, scene.place.y, view.width, view.height));
  glBindVertexArray(nothing_.get());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

const OverlayPainter::Mesh& OverlayPainter::uploaded(const std::shared_ptr<const ToolMesh>& mesh) {
  if (meshes_.size() > kMostKept) meshes_.clear();
  Mesh& kept = meshes_[mesh.get()];
  if (kept.source != nullptr) return kept;
  kept = {mesh, gl::newVertexArray(), gl::newBuffer(), gl::newBuffer()};
  std::vector<glm::vec3> vertices;
  vertices.reserve(2 * mesh->positions.size());
  for (std::size_t n = 0; n < mesh->positions.size(); ++n) {
    vertices.push_back(mesh->positions[n]);
    vertices.push_back(mesh->normals[n]);
  }
  glBindVertexArray(kept.array.get());
  glBindBuffer(GL_ARRAY_BUFFER, kept.vertices.get());
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(glm::vec3)), vertices.data(),
               GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, kept.indices.get());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh->indices.size() * 4), mesh->indices.data(),
               GL_STATIC_DRAW);
  attribute(0, 3, 0, 2 * sizeof(glm::vec3));
  attribute(1, 3, 3, 2 * sizeof(glm::vec3));
  glBindVertexArray(0);
  return kept;
}

// Nearest layer only: depth first, then colour where nothing is nearer.
void OverlayPainter::drawTool(const ToolMesh& mesh, const glm::dmat4& cellsFromTool,
                              const Scene& scene, const Glass& glass) {
  const Frame& frame = *scene.frame;
  glm::dmat4 fromAnchor = cellsFromTool;
  fromAnchor[3] -= glm::dvec4(frame.anchor.i, frame.anchor.j, frame.anchor.k, 0);
  const glm::dmat4 viewFromTool = glm::dmat4(frame.block.viewFromCells) * fromAnchor;
  place(ghost_, scene);
  ghost_.set("clipFromTool", glm::mat4(frame.clipFromCells * fromAnchor));
  ghost_.set("viewFromTool", glm::mat4(viewFromTool));
  const glm::dmat3 normals = glm::transpose(glm::inverse(glm::dmat3(viewFromTool)));
  ghost_.set("viewNormalFromTool", glm::mat4(glm::mat3(normals)));
  ghost_.set("ink", glass.ink);
  ghost_.set("glass", glass.rim);
  ghost_.set("solid", glm::vec4(glass.solid, glass.hidden, 0, 0));
  ghost_.set("straight", scene.perspective ? 0.f : 1.f);
  const auto count = GLsizei(mesh.indices.size());
  const auto drawOnce = [&] { glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr); };
  if (glass.lines) {
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    drawOnce();
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    return;
  }
  const gl::Enabled test(GL_DEPTH_TEST), cull(GL_CULL_FACE);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  drawOnce();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthFunc(GL_LEQUAL);
  drawOnce();
  glDepthFunc(GL_LESS);
}

void OverlayPainter::drawTools(const Overlays& overlays, const Scene& scene) {
  const gl::Enabled scissor(GL_SCISSOR_TEST);
  glScissor(scene.place.x, scene.place.y, scene.place.width, scene.place.height);
  const auto draw = [&](const std::shared_ptr<const ToolMesh>& mesh, const glm::dmat4& pose,
                        const Glass& glass) {
    if (mesh == nullptr || mesh->indices.empty()) return;
    glBindVertexArray(uploaded(mesh).array.get());
    glClear(GL_DEPTH_BUFFER_BIT);
    drawTool(*mesh, pose, scene, glass);
  };
  for (const ToolGhost& tool : overlays.tools) {
    if (tool.display == ToolDisplay::hidden) continue;
    draw(tool.limit, tool.cellsFromLimit, {tool.ink, {.02f, .42f, 3.5f, 0}, 0, .3f, false});
    Glass glass{tool.ink, {.14f, .68f, 2.2f, .8f}, 0, tool.hidden, false};
    glass.solid = tool.display == ToolDisplay::solid;
    glass.lines = tool.display == ToolDisplay::wire;
    if (glass.solid > 0) glass.hidden = .16f;
    if (glass.lines) glass.rim = {.5f, 0, 1, 0};
    draw(tool.mesh, tool.cellsFromTool, glass);
  }
}

InkView OverlayPainter::begin(const Scene& scene) {
  glViewport(scene.place.x, scene.place.y, scene.place.width, scene.place.height);
  glCullFace(GL_BACK);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  gl::bindTexture(gl::clayDepth, *scene.clayDepth);
  blendOver();
  return {scene.frame->anchor, scene.frame->clipFromCells, scene.place.width, scene.place.height};
}

void OverlayPainter::drawStanding(const Overlays& overlays, const Scene& scene) {
  const gl::KeepTarget keep;
  const gl::Enabled blend(GL_BLEND);
  const InkView view = begin(scene);
  drawPosters(overlays, view, scene, true);
  InkSheet sheet(view);
  drawSurroundings(overlays, toEye(*scene.frame), sheet);
  paint(sheet.vertices(), scene);
  glBindVertexArray(0);
}

void OverlayPainter::drawMoving(const Overlays& overlays, const Scene& scene) {
  const gl::KeepTarget keep;
  const gl::Enabled blend(GL_BLEND);
  const InkView view = begin(scene);
  InkSheet under(view), over(view);
  if (overlays.plane) drawPlane(*overlays.plane, under);
  paint(under.vertices(), scene);
  drawTools(overlays, scene);
  for (const RingCursor& ring : overlays.rings) {
    if (ring.on == RingCursor::On::clay) drawRing(ring, view, scene);
  }
  drawMarks(overlays, over);
  paint(over.vertices(), scene);
  drawPosters(overlays, view, scene, false);
  glBindVertexArray(0);
}

}  // namespace bozzetto
