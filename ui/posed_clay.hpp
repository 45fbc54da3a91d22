// The clay's own surface as a posed wrap would carry it: patches for the window, made anew with
// every pose, so that clay is seen to follow before it does.
#pragma once
#include <map>

#include "bozzetto/solid/solid.hpp"
#include "bozzetto/solid/wrap_map.hpp"
#include "ui/patch_set.hpp"

namespace bozzetto::ui {

class PosedClay {
 public:
  /// `spacing` of the clay's grid, world units.
  PosedClay(const Solid& wrap, double spacing);
  bool isOf(const Solid& wrap, double spacing) const;

  void pose(std::span<const glm::dvec3> control) { map_.pose(control); }
  /// Puts carried patches in the place of those that lie in the lattice, whole or in part. Vertices
  /// are looked up once a patch; in parallel.
  void carry(std::map<Key, PatchRef>& patches);

 private:
  using Places = std::vector<WrapPlace>;
  Places placesOf(const UnpackedPatch& patch) const;
  PatchRef carried(const PatchRef& patch, const Places& places) const;

  std::vector<glm::dvec3> rest_;
  double spacing_;
  WrapMap map_;
  std::map<PatchRef, Places> known_;
};

}  // namespace bozzetto::ui
