// Takai's layer: blocks of 2×2×2 cells, at even keys and odd ones in turn (Margolus), in which
// cells that hold too much give to those that do not.
#pragma once
#include "clay/fairing.hpp"
#include "clay/layer.hpp"
#include "clay/pulling.hpp"
#include "clay/swelling.hpp"

namespace bozzetto::clay {

struct Sharing {
  float rate;  ///< α
  SharingRule rule;
};

/// One block. `limit` per cell: the most it may hold, negative for obstacles; `full` what the
/// capped rule leaves at least. True when anything was given.
bool shareBlock(Region& region, const std::array<std::size_t, 8>& cells,
                const std::array<float, 8>& limit, const std::array<float, 8>& full,
                const Sharing& sharing);

class Automaton final : public Layer {
 public:
  void run(Work& work) override;
  void finish(Work& work) override { swelling_.finish(work); }
  std::string remark() const override { return swelling_.remark(); }

 private:
  void sweepOut(Work& work);
  void findHot(Work& work);
  void listHot(Work& work);
  bool sweep(Work& work, int parity);
  bool sweepTile(Work& work, Key tile, int parity);
  void spreadHeat(Region& region);
  bool widen(Work& work);
  void note(Region& region, Key tile);
  template <class Callback>
  void forMoved(const Region& region, const Callback& callback) const;
  void listMoved(Region& region);

  Pulling pulling_;
  Swelling swelling_;
  Fairing fairing_;
  MovedCells moved_;
  std::vector<Key> tiles_;            // to be visited
  std::vector<std::uint32_t> given_;  // first cells of tiles where matter moved in this step
  std::vector<std::uint8_t> hot_;     // of these: had something to give
};

}  // namespace bozzetto::clay
