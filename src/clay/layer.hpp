// A layer edits the densities of a region once a step. Layers know nothing of each other; what they
// share is the region, so they may run in any order and combination (Dewaele §2.2).
#pragma once
#include <algorithm>
#include <functional>
#include <memory>
#include <string>

#include "bozzetto/clay/settings.hpp"
#include "clay/placed_tool.hpp"

namespace bozzetto::clay {

inline bool runs(const Settings& settings, LayerKind layer) {
  return std::ranges::find(settings.layers, layer) != settings.layers.end();
}

/// Matter walks out at once, and nobody asks what moves together.
inline bool onlyWalks(const Settings& settings) {
  return std::ranges::all_of(settings.layers,
                             [](LayerKind layer) { return layer == LayerKind::diffusion; });
}

/// All a layer may look at.
struct Work {
  Region& region;
  const std::vector<PlacedTool>& moving;
  const std::vector<PlacedTool>& supports;
  Key origin;  ///< motions count from here
  const Settings& settings;
  float iso;
  std::int64_t step;  ///< counts over the life of the stroke
  StepReport& report;
  /// Where clay goes on beyond the region: makes sure that this box is in it; true when it was not.
  /// What layers keep between cells of the region is theirs to find again.
  std::function<bool(const KeyBox&)> widen{};

  bool has(LayerKind layer) const { return runs(settings, layer); }
  bool grips() const {
    for (const PlacedTool& tool : moving)
      if (tool.role == Role::grip) return true;
    return false;
  }
};

class Layer {
 public:
  virtual ~Layer() = default;
  virtual void run(Work& work) = 0;
  /// After the last step of a stroke.
  virtual void finish(Work&) {}
  /// What could not be done as it was asked for, after that; may be empty.
  virtual std::string remark() const { return {}; }
};

std::unique_ptr<Layer> makeLayer(LayerKind kind, Scheme scheme);

}  // namespace bozzetto::clay
