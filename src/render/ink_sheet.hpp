// Lines, dots and fills of overlays, turned into triangles on the screen: GL's own lines are one
// pixel wide in core profiles. Counted per frame in hundreds, so the processor does it.
#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "bozzetto/grid/key.hpp"
#include "bozzetto/render/overlays.hpp"

namespace bozzetto {

/// Where overlays are drawn: the frame's camera over so many pixels.
struct InkView {
  Key anchor;
  glm::dmat4 clipFromCells{1};  // cells from the anchor
  int width = 0, height = 0;

  glm::dvec4 clipOf(const glm::dvec3& cells) const;
  glm::dvec3 fromAnchor(const glm::dvec3& cells) const;
};

struct LineStyle {
  Ink ink{1};
  float width = 1;      // pixels
  float hidden = .25f;  // part of the opacity behind clay
};

class InkSheet {
 public:
  struct Vertex {
    glm::vec4 clip, ink, shape;
    float hidden;
  };

  explicit InkSheet(const InkView& view) : view_(view) {}

  void line(const glm::dvec3& a, const glm::dvec3& b, const LineStyle& style) {
    fadingLine(a, b, style, style.ink.a);
  }
  /// The opacity runs from the style's at `a` to `end` at `b`.
  void fadingLine(const glm::dvec3& a, const glm::dvec3& b, const LineStyle& style, float end);
  void dot(const glm::dvec3& place, float radius, const Ink& ink, float hidden);
  /// A disk of `radius` with a rim `soft` cells wide, across two perpendicular vectors of length 1.
  void disk(const glm::dvec3& centre, const glm::dvec3 (&across)[2], glm::vec2 radiusAndSoft,
            const LineStyle& style);
  void circle(const glm::dvec3& centre, const glm::dvec3 (&across)[2], double radius,
              const LineStyle& style);
  void quad(const glm::dvec3 (&corners)[4], const Ink& ink, float hidden);

  std::span<const Vertex> vertices() const { return vertices_; }

 private:
  void add(const glm::dvec4& clip, const Ink& ink, const glm::vec4& shape, float hidden);
  glm::dvec2 pixelOf(const glm::dvec4& clip) const;
  glm::dvec4 clipAt(const glm::dvec2& pixel, double depth) const;

  const InkView& view_;
  std::vector<Vertex> vertices_;
};

/// Two vectors of length 1 that with `normal` make a frame.
void spanPlane(const glm::dvec3& normal, glm::dvec3 (&across)[2]);

}  // namespace bozzetto
