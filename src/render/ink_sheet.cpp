#include "render/ink_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace bozzetto {
namespace {

constexpr float kFull = 1e6f;  // radius of what has no rim
constexpr int kCircleSides = 96;

}  // namespace

glm::dvec3 InkView::fromAnchor(const glm::dvec3& cells) const {
  return cells - glm::dvec3(anchor.i, anchor.j, anchor.k);
}

glm::dvec4 InkView::clipOf(const glm::dvec3& cells) const {
  return clipFromCells * glm::dvec4(fromAnchor(cells), 1);
}

void spanPlane(const glm::dvec3& normal, glm::dvec3 (&across)[2]) {
  const glm::dvec3 helper = std::abs(normal.y) < .9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  across[0] = glm::normalize(glm::cross(helper, normal));
  across[1] = glm::cross(normal, across[0]);
}

void InkSheet::add(const glm::dvec4& clip, const Ink& ink, const glm::vec4& shape, float hidden) {
  vertices_.push_back({glm::vec4(clip), ink, shape, hidden});
}

glm::dvec2 InkSheet::pixelOf(const glm::dvec4& clip) const {
  return glm::dvec2(clip) / clip.w * .5 * glm::dvec2(view_.width, view_.height);
}

glm::dvec4 InkSheet::clipAt(const glm::dvec2& pixel, double depth) const {
  return {pixel * 2.0 / glm::dvec2(view_.width, view_.height), depth, 1};
}

void InkSheet::fadingLine(const glm::dvec3& from, const glm::dvec3& to, const LineStyle& style,
                          float end) {
  glm::dvec4 a = view_.clipOf(from), b = view_.clipOf(to);
  // What lies before the near plane is cut off.
  const double nearA = a.z + a.w, nearB = b.z + b.w;
  if (nearA <= 0 && nearB <= 0) return;
  Ink inkA = style.ink, inkB(glm::vec3(style.ink), end);
  if (nearA < 0) {
    a = glm::mix(a, b, nearA / (nearA - nearB) + 1e-9);
  } else if (nearB < 0) {
    b = glm::mix(b, a, nearB / (nearB - nearA) + 1e-9);
  }
  const glm::dvec2 pa = pixelOf(a), pb = pixelOf(b);
  const double length = glm::distance(pa, pb);
  if (length < 1e-6) return;
  const float half = style.width / 2, reach = half + 1;
  const glm::dvec2 along = (pb - pa) / length,
                   aside = glm::dvec2(-along.y, along.x) * double(reach);
  const auto put = [&](bool atB, double side) {
    const glm::dvec4& clip = atB ? b : a;
    add(clipAt((atB ? pb : pa) + aside * side, clip.z / clip.w), atB ? inkB : inkA,
        {0, reach * float(side), half, 1}, style.hidden);
  };
  for (const auto& [atB, side] : {std::pair{false, -1.0},
                                  {false, 1.0},
                                  {true, 1.0},
                                  {false, -1.0},
                                  {true, 1.0},
                                  {true, -1.0}}) {
    put(atB, side);
  }
}

void InkSheet::dot(const glm::dvec3& place, float radius, const Ink& ink, float hidden) {
  const glm::dvec4 clip = view_.clipOf(place);
  if (clip.z + clip.w <= 0) return;
  const glm::dvec2 centre = pixelOf(clip);
  const double reach = radius + 1;
  for (const int corner : {0, 1, 3, 0, 3, 2}) {
    const glm::dvec2 away((corner & 1 ? 1 : -1) * reach, (corner & 2 ? 1 : -1) * reach);
    add(clipAt(centre + away, clip.z / clip.w), ink, {away, radius, 1}, hidden);
  }
}

void InkSheet::disk(const glm::dvec3& centre, const glm::dvec3 (&across)[2],
                    glm::vec2 radiusAndSoft, const LineStyle& style) {
  const double reach = radiusAndSoft.x + radiusAndSoft.y;
  for (const int corner : {0, 1, 3, 0, 3, 2}) {
    const glm::dvec2 away((corner & 1 ? 1 : -1) * reach, (corner & 2 ? 1 : -1) * reach);
    add(view_.clipOf(centre + across[0] * away.x + across[1] * away.y), style.ink,
        {away, radiusAndSoft}, style.hidden);
  }
}

void InkSheet::circle(const glm::dvec3& centre, const glm::dvec3 (&across)[2], double radius,
                      const LineStyle& style) {
  const auto at = [&](int n) {
    const double angle = 2 * std::numbers::pi * n / kCircleSides;
    return centre + (across[0] * std::cos(angle) + across[1] * std::sin(angle)) * radius;
  };
  for (int n = 0; n < kCircleSides; ++n) line(at(n), at(n + 1), style);
}

void InkSheet::quad(const glm::dvec3 (&corners)[4], const Ink& ink, float hidden) {
  for (const int n : {0, 1, 2, 0, 2, 3}) {
    add(view_.clipOf(corners[n]), ink, {0, 0, kFull, 1}, hidden);
  }
}

}  // namespace bozzetto
