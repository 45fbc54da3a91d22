#include "ui/solid_shown.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>

#include "bozzetto/solid/boundary.hpp"
#include "bozzetto/solid/refine.hpp"

namespace bozzetto::ui {
namespace {

constexpr double kMostCells = 20'000;     // of the refinement that is drawn
constexpr int kPatchCells = 64;           // as wide as the renderer's chunks
constexpr std::size_t kMostWires = 6000;  // more are a veil

Colour between(Colour a, Colour b, double part) {
  const auto mix = [&](std::uint8_t x, std::uint8_t y) {
    return std::uint8_t(std::lround(x + (double(y) - x) * part));
  };
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

// The refined solid's surface with what is drawn on it.
struct Skin {
  Lattice surface;
  std::vector<glm::dvec3> normals;
  std::vector<Colour> colours;
};

std::vector<glm::dvec3> normalsOf(const Lattice& surface) {
  std::vector<glm::dvec3> normals(surface.points.size(), glm::dvec3(0));
  for (Id n = 0; n < surface.faces.size(); ++n) {
    const auto face = surface.faces[n];
    glm::dvec3 area(0);
    const glm::dvec3 first = surface.points[face[0]];
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
      area += glm::cross(surface.points[face[k]] - first, surface.points[face[k + 1]] - first);
    for (const Id point : face) normals[point] += area;
  }
  for (glm::dvec3& normal : normals) {
    const double length = glm::length(normal);
    normal = length > 0 ? normal / length : glm::dvec3(0, 1, 0);
  }
  return normals;
}

// A number for each refined point, as colours between the least and the most.
std::vector<Colour> coloursOf(const std::vector<double>& values, SolidShown& shown) {
  const auto [low, high] = std::ranges::minmax(values);
  shown.low = low;
  shown.high = high;
  std::vector<Colour> colours;
  for (const double value : values)
    colours.push_back(heat(high > low ? (value - low) / (high - low) : .5));
  return colours;
}

Key patchAt(const glm::dvec3& cell) {
  const auto floor = [](double x) { return int(std::floor(x / kPatchCells)) * kPatchCells; };
  // Patches of clay begin at multiples of 8: these names are free.
  return Key{floor(cell.x) + 1, floor(cell.y) + 1, floor(cell.z) + 1};
}

// One patch, its points numbered as they come.
class PatchMaker {
 public:
  explicit PatchMaker(Key origin) : patch_(origin) {}
  bool hasRoom() const { return patch_.positions.size() + 4 < 65'535; }
  void add(const Skin& skin, std::span<const Id> triangle, double spacing) {
    for (const Id point : triangle) {
      const auto [known, isNew] = numbers_.try_emplace(point, patch_.positions.size());
      if (isNew) put(skin, point, spacing);
      patch_.indices.push_back(std::uint16_t(known->second));
    }
  }
  UnpackedPatch take() { return std::move(patch_); }

 private:
  void put(const Skin& skin, Id point, double spacing) {
    const Key origin = patch_.origin;
    const glm::dvec3 cell = skin.surface.points[point] / spacing;
    patch_.positions.emplace_back(cell - glm::dvec3(origin.i, origin.j, origin.k));
    patch_.normals.emplace_back(skin.normals[point]);
    patch_.colours.push_back(skin.colours[point]);
  }

  UnpackedPatch patch_;
  std::map<Id, std::size_t> numbers_;
};

std::vector<UnpackedPatch> patchesOf(const Skin& skin, double spacing) {
  std::map<Key, PatchMaker> makers;
  for (Id n = 0; n < skin.surface.faces.size(); ++n) {
    const auto face = skin.surface.faces[n];
    Key key = patchAt(meanOf(skin.surface, face) / spacing);
    auto maker = makers.try_emplace(key, key).first;
    while (!maker->second.hasRoom()) {
      ++key.i;
      maker = makers.try_emplace(key, key).first;
    }
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
      maker->second.add(skin, std::array{face[0], face[k], face[k + 1]}, spacing);
  }
  std::vector<UnpackedPatch> patches;
  for (auto& [key, maker] : makers) patches.push_back(maker.take());
  return patches;
}

// A little outside, so that the surface does not cut them into dots.
std::vector<std::array<glm::dvec3, 2>> wiresOf(const Lattice& refined, const Skin& skin,
                                               double spacing) {
  constexpr double kLiftCells = 0.25;
  const Topology topology(refined);
  const auto lifted = [&](Id point) {
    return refined.points[point] + skin.normals[point] * (kLiftCells * spacing);
  };
  std::vector<std::array<glm::dvec3, 2>> wires;
  for (Id n = 0; n < topology.edges.size(); ++n) {
    if (!topology.boundaryEdge[n]) continue;
    wires.push_back({lifted(topology.edges[n][0]), lifted(topology.edges[n][1])});
  }
  if (wires.size() > kMostWires) wires.clear();
  return wires;
}

// What takes no part is dark: a point by the part of the cells around it that are trimmed.
void darkenTrimmed(const SolidMatter& matter, const Lattice& refined,
                   std::vector<Colour>& colours) {
  constexpr Colour dark{0x2A, 0x2D, 0x33};
  if (matter.trimmed.size() != refined.cells.size()) return;
  const Topology topology(refined);
  for (Id point = 0; point < colours.size(); ++point) {
    const auto around = topology.pointCells[point];
    double out = 0;
    for (const Id cell : around) out += matter.trimmed[cell] != 0;
    if (out == 0) continue;
    colours[point] = between(colours[point], dark, .4 + .5 * out / double(around.size()));
  }
}

// The level of the physics, whose points maps colour and whose cells are trimmed; smoother where
// there is neither.
int levelsFor(const Solid& solid, SolidMap map) {
  int levels = solid.settings.levels;
  const bool plain = map == SolidMap::none && solid.matter.trimmed.empty();
  if (plain && refinedCellCount(solid.control, levels + 1) <= kMostCells) ++levels;
  while (levels > 0 && refinedCellCount(solid.control, levels) > kMostCells) --levels;
  return levels;
}

}  // namespace

Colour heat(double part) {
  constexpr Colour cold{0x3B, 0x6F, 0xB6}, middle{0xE8, 0xDF, 0xD2}, hot{0xC2, 0x45, 0x2D};
  part = std::clamp(part, 0.0, 1.0);
  return part < .5 ? between(cold, middle, 2 * part) : between(middle, hot, 2 * part - 1);
}

std::shared_ptr<const SolidShown> shownSolid(std::shared_ptr<const Solid> solid,
                                             const SolidStyle& style) {
  const Lattice& control = solid->control;
  auto shown = std::make_shared<SolidShown>(
      SolidShown{solid, Topology(control), {}, {}, style.map, {}, {}, 0, 0, 0, 0});
  const int levels = levelsFor(*solid, style.map);
  const bool asPhysics = levels == solid->settings.levels;
  const Lattice refined = refine(control, levels).lattice;
  Skin skin;
  skin.surface = surfaceOf(refined);
  skin.normals = normalsOf(skin.surface);
  skin.colours.assign(refined.points.size(), style.colour);
  if (style.map != SolidMap::none && asPhysics) {
    const Tint tint = style.map == SolidMap::mass        ? Tint::mass
                      : style.map == SolidMap::stiffness ? Tint::hardness
                                                         : Tint::strain;
    skin.colours = coloursOf(tinted(*solid, tint), *shown);
  }
  if (asPhysics) darkenTrimmed(solid->matter, refined, skin.colours);
  shown->mass =
      asPhysics ? skin.surface : surfaceOf(refine(control, solid->settings.levels).lattice);
  // In a wrap the clay is to be seen, unless something is mapped.
  if (!solid->isWrap() || style.map != SolidMap::none) {
    shown->surface = patchesOf(skin, style.spacing);
    shown->wires = wiresOf(refined, skin, style.spacing);
  }
  shown->refinedCells = refined.cells.size();
  shown->refinedPoints = refined.points.size();
  return shown;
}

}  // namespace bozzetto::ui
