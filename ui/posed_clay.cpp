#include "ui/posed_clay.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "bozzetto/base/parallel.hpp"
#include "bozzetto/solid/wrap.hpp"

namespace bozzetto::ui {
namespace {

Lattice atRest(const Solid& wrap) {
  Lattice rest = wrap.control;
  rest.points = wrap.wrapRest;
  return rest;
}

glm::dvec3 place(Key key) { return {key.i, key.j, key.k}; }

}  // namespace

PosedClay::PosedClay(const Solid& wrap, double spacing)
    : rest_(wrap.wrapRest),
      spacing_(spacing),
      map_(bozzetto::ui::atRest(wrap), WrapOptions{}.levels, spacing) {}

bool PosedClay::isOf(const Solid& wrap, double spacing) const {
  return rest_ == wrap.wrapRest && spacing_ == spacing;
}

PosedClay::Places PosedClay::placesOf(const UnpackedPatch& patch) const {
  Places places;
  WrapPlace last;
  for (const glm::vec3& position : patch.positions) {
    places.push_back(map_.find(place(patch.origin) + glm::dvec3(position), last));
    if (places.back().isInside()) last = places.back();
  }
  if (std::ranges::none_of(places, &WrapPlace::isInside)) places.clear();
  return places;
}

PatchRef PosedClay::carried(const PatchRef& patch, const Places& places) const {
  if (places.empty()) return patch;
  UnpackedPatch moved = patch->data;
  const glm::dvec3 origin = place(moved.origin);
  for (std::size_t n = 0; n < places.size(); ++n) {
    if (!places[n].isInside()) continue;
    moved.positions[n] = glm::vec3(map_.carried(places[n]) - origin);
    moved.normals[n] = glm::vec3(map_.turned(places[n], glm::dvec3(moved.normals[n])));
  }
  return std::make_shared<const ShownPatch>(std::move(moved), Lies::anywhere);
}

void PosedClay::carry(std::map<Key, PatchRef>& patches) {
  std::erase_if(known_, [](const auto& entry) { return entry.first.use_count() == 1; });
  std::vector<std::pair<PatchRef*, Places*>> work;
  for (auto& [key, patch] : patches)
    if (patch) work.emplace_back(&patch, &known_[patch]);
  parallelFor(work.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      auto& [patch, places] = work[n];
      if (places->empty()) *places = placesOf((*patch)->data);
      *patch = carried(*patch, *places);
    }
  });
}

}  // namespace bozzetto::ui
