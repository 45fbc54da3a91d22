// The clay as the window shows it: itself, or a smoothed copy with a surface of its own. The clay
// stays as it is.
#pragma once
#include <optional>

#include "bozzetto/sculptor/workbench.hpp"

namespace bozzetto::ui {

enum class Smoothing { none, shown };

class ShownClay {
 public:
  void setSmoothing(Smoothing smoothing);
  /// After everything may have changed.
  void rebuild(const Clay& clay);
  /// What changed of what is shown where that changed of the clay. O(changed).
  SurfaceChanges follow(const Clay& clay, const SurfaceChanges& changes);
  /// The same of the blocks, while the surface waits until `follow` is called again.
  std::vector<KeyRun> followBlocks(const Clay& clay, const std::vector<KeyRun>& blocks);

  const Clay& of(const Clay& clay) const { return copy_ ? copy_->clay : clay; }
  const Surface<8>& of(const Surface<8>& surface) const { return copy_ ? copy_->surface : surface; }

 private:
  struct Copy {
    Clay clay;
    Surface<8> surface;
    std::vector<KeyRun> waiting;  // for the surface
  };
  std::optional<Copy> copy_;
};

}  // namespace bozzetto::ui
