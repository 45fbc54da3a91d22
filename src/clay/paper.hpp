// Dewaele & Cani's layers to the letter: the reference that `projected` is measured against. They
// smear and shred bodies of 64 cells and more (src/clay/NOTES.md).
#pragma once
#include "clay/clearing.hpp"
#include "clay/displacement.hpp"

namespace bozzetto::clay {

/// Moves every cell's matter to p + δ, shared among the eight nodes round it (§3.1.2).
void splat(Region& region);

class PaperDisplacement final : public Layer {
 public:
  void run(Work& work) override;

 private:
  Displacement wish_;
};

/// A queue of cells that hold too much; each gives its excess to its neighbours (§3.2).
class PaperConservation final : public Layer {
 public:
  void run(Work& work) override;

 private:
  void queueAll(Region& region);
  void give(Work& work, std::size_t cell);

  Clearing clearing_;  // knows the ways out of tools
  std::vector<std::uint32_t> queue_;
};

/// Thin matter in flat gradients joins denser neighbours (§3.3).
class PaperTension {
 public:
  void run(Work& work);

 private:
  struct Gift {
    std::uint32_t from, to;
    float amount;
  };
  void plan(const Region& region, std::size_t cell);
  std::vector<Gift> gifts_;
};

}  // namespace bozzetto::clay
