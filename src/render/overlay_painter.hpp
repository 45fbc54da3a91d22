// Draws overlays over a picture of the clay whose depth is at hand.
#pragma once
#include <map>
#include <memory>

#include "bozzetto/render/overlays.hpp"
#include "render/frame.hpp"
#include "render/gl.hpp"
#include "render/ink_sheet.hpp"

namespace bozzetto {

class OverlayPainter {
 public:
  OverlayPainter();

  struct Scene {
    const Frame* frame = nullptr;
    const gl::Texture* clayDepth = nullptr;
    int depthWidth = 0, depthHeight = 0;
    PixelRect place;  // of the bound framebuffer
    bool perspective = true;
  };
  /// What stands still while a cursor moves: grid, box, pictures behind the clay.
  void drawStanding(const Overlays& overlays, const Scene& scene);
  /// All else.
  void drawMoving(const Overlays& overlays, const Scene& scene);

 private:
  struct Mesh {
    std::shared_ptr<const ToolMesh> source;
    gl::VertexArray array;
    gl::Buffer vertices, indices;
  };
  struct Poster {
    std::shared_ptr<const Image> source;
    gl::Texture texture;
  };

  InkView begin(const Scene& scene);
  void place(const gl::Program& program, const Scene& scene) const;
  void paint(std::span<const InkSheet::Vertex> vertices, const Scene& scene);
  void drawPosters(const Overlays& overlays, const InkView& view, const Scene& scene, bool behind);
  void drawRing(const RingCursor& ring, const InkView& view, const Scene& scene);
  void drawTools(const Overlays& overlays, const Scene& scene);
  struct Glass;
  void drawTool(const ToolMesh& mesh, const glm::dmat4& cellsFromTool, const Scene& scene,
                const Glass& glass);
  const Mesh& uploaded(const std::shared_ptr<const ToolMesh>& mesh);
  const gl::Texture& uploaded(const std::shared_ptr<const Image>& image);

  gl::Program paint_, ring_, ghost_, poster_;
  gl::VertexArray inkArray_ = gl::newVertexArray(), nothing_ = gl::newVertexArray();
  gl::VertexArray posterArray_ = gl::newVertexArray();
  gl::Buffer inkBuffer_ = gl::newBuffer(), posterBuffer_ = gl::newBuffer();
  std::map<const void*, Mesh> meshes_;
  std::map<const void*, Poster> posters_;
};

}  // namespace bozzetto
