// The law: which module may include which, and where other people's headers stop.
#pragma once
#include "arch/source_tree.hpp"

namespace bozzetto::arch {

using Arrows = std::map<std::string, Names>;

/// Module → the modules it names; what those may include it may include too.
inline const Arrows kArrows{
    {"base", {}},
    {"grid", {"base"}},
    {"field", {"grid"}},
    {"tool", {"field"}},
    {"clay", {"tool"}},
    {"mesh", {"base"}},
    {"surface", {"grid", "field", "mesh"}},
    {"solid", {"field", "mesh"}},
    {"haptic", {"field", "solid"}},
    {"history", {"field", "solid"}},
    {"scene", {"grid", "tool", "clay", "solid", "history"}},
    {"io", {"grid", "field", "mesh"}},
    {"render", {"grid", "field", "mesh", "surface"}},
    {"sculptor", {"clay", "surface", "haptic", "scene", "io"}},
    {"cli", {"sculptor", "render", "ui"}},
    {"ui", {"sculptor", "render"}},
};

/// Headers of others → the modules that may include them. Public headers: GLM, and Boost.Container
/// in grid's, only.
inline const std::map<std::string, Names> kThirdParty{
    {"glm/",
     {"base", "grid", "field", "tool", "clay", "mesh", "surface", "solid", "haptic", "history",
      "scene", "io", "render", "sculptor", "cli", "ui"}},
    {"boost/container/", {"grid"}},
    {"boost/intrusive/", {"grid"}},
    {"boost/move/", {"grid"}},
    {"tbb/", {"base"}},
    {"oneapi/tbb/", {"base"}},
    {"xxhash.h", {"base"}},
    {"zstd.h", {"history", "scene"}},
    {"sqlite3.h", {"scene"}},
    {"nlohmann/", {"io", "scene", "sculptor", "cli", "ui"}},
    {"fmt/", {"sculptor", "cli", "ui"}},
    {"CLI/", {"cli"}},
    {"png.h", {"io", "render"}},
    {"ft2build.h", {"io"}},
    {"epoxy/", {"render", "ui"}},
    {"GLFW/", {"ui"}},
    {"imgui", {"ui"}},
    {"backends/imgui", {"ui"}},
    {"X11/", {"ui"}},
    {"fontconfig/", {"ui"}},
    {"spnav.h", {"ui"}},
    {"Eigen/", {"clay", "solid", "haptic"}},
    {"meshoptimizer.h", {"mesh", "io", "render"}},
};

/// All that the named modules may include, themselves with them.
inline Names reach(const Arrows& arrows, const Names& from) {
  Names seen = from;
  for (std::size_t before = 0; before != seen.size();) {
    before = seen.size();
    for (const std::string& module : Names(seen))
      if (const auto found = arrows.find(module); found != arrows.end())
        seen.insert(found->second.begin(), found->second.end());
  }
  return seen;
}

/// The arrows between the modules that are there already.
inline Arrows withoutFuture(const Arrows& there) {
  Arrows arrows;
  for (const auto& [module, uses] : kArrows) {
    if (!there.contains(module)) continue;
    for (const std::string& used : uses)
      if (there.contains(used)) arrows[module].insert(used);
  }
  return arrows;
}

}  // namespace bozzetto::arch
