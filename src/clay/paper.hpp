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

/// One after the other from a queue, as §3.2 has it, or all that hold too much at once.
enum class Giving { queue, sweeps };

/// Cells that hold too much give their excess to their neighbours (§3.2).
class PaperConservation final : public Layer {
 public:
  /// `over`: in the open that many times the excess, for a part of it comes back.
  explicit PaperConservation(Giving giving = Giving::queue, float over = 1.2f)
      : giving_(giving), over_(over) {}
  void run(Work& work) override;

 private:
  struct Gift {
    float share;
    std::uint8_t ways;  // none: the cell keeps what it has
  };
  void queueAll(Region& region);
  std::uint8_t waysFrom(const Work& work, std::size_t cell);
  Gift giftOf(const Work& work, std::size_t cell);
  void give(Region& region, std::size_t cell, const Gift& gift);
  void runQueue(Work& work);
  void runSweeps(Work& work);

  Giving giving_;
  float over_;
  Clearing clearing_;  // knows the ways out of tools
  std::vector<std::uint32_t> queue_, now_;
  std::vector<Gift> gifts_;
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
