// Raffin's layer: matter that a tool overlaps walks along the axes of the tool's normal to the
// nearest room, the exit, and may be spread round it.
#pragma once
#include <optional>

#include "clay/fairing.hpp"
#include "clay/full_lines.hpp"
#include "clay/layer.hpp"

namespace bozzetto::clay {

/// Height of the spreading curve at `u` in 0 … 1 of its radius: a quadratic Bézier from (0, 1) to
/// (1, 0) by a control point; all 1 for kUniform (Raffin §3).
float spreadAt(float u, const std::array<double, 2>& control);

/// How far from a tool of this radius matter may come to lie, in cells.
double diffusionReach(const Settings& settings, double radius);

class Diffusion final : public Layer {
 public:
  void run(Work& work) override;
  void finish(Work& work) override;

 private:
  struct Neighbour {
    std::ptrdiff_t step;
    float weight;
  };
  struct Walk {
    std::size_t from, at;
    std::size_t axis;
    glm::dvec3 normal;
    int turn;                         // from the third on it goes the other way round
    std::optional<std::size_t> exit;  // the first cell outside the tool
  };
  void prepareStencil(const Region& region, const Settings& settings);
  void push(Work& work, std::size_t cell);
  bool walk(Work& work, Walk& walk, float& amount);
  bool walkAside(Work& work, Walk& walk, float& amount);
  void leave(Region& region, const Walk& walk, float& amount);
  void spread(Region& region, const Walk& walk, float& amount);

  FullLines lines_;
  Fairing fairing_;
  MovedCells moved_;  // since they were faired
  int longest_ = 0;   // walk of this step, in cells
  std::vector<std::uint32_t> overlapped_;
  std::vector<std::size_t> passed_;  // outside tools, by the walk on its way
  std::vector<Neighbour> stencil_, open_;
};

}  // namespace bozzetto::clay
