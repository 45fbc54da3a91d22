#include "clay/stepper.hpp"

#include "clay/automaton.hpp"
#include "clay/clearing.hpp"
#include "clay/diffusion.hpp"
#include "clay/displacement.hpp"
#include "clay/drawing.hpp"
#include "clay/paper.hpp"
#include "clay/projection.hpp"
#include "clay/tidying.hpp"
#include "clay/transport.hpp"

namespace bozzetto::clay {
namespace {

constexpr int kCrumbInterval = 8;  // steps

// Clearing, projection and sharp transport (clay.md §3.2 – 3.4).
class Conservation final : public Layer {
 public:
  void run(Work& work) override {
    clearing_.run(work);
    projection_.run(work);
    transport(work);
    drawing_.run(work);
  }

 private:
  Clearing clearing_;
  Projection projection_;
  Drawing drawing_;
};

class Tension final : public Layer {
 public:
  explicit Tension(Scheme scheme) : scheme_(scheme) {}
  void run(Work& work) override {
    if (scheme_ != Scheme::projected)
      paper_.run(work);
    else
      sweepDust(work);
    if (work.step % kCrumbInterval == kCrumbInterval - 1) crumbs_.run(work, Eaten::isPressedOut);
  }
  void finish(Work& work) override { crumbs_.run(work, Eaten::findsRoom); }

 private:
  Scheme scheme_;
  PaperTension paper_;
  CrumbEater crumbs_;
};

}  // namespace

std::unique_ptr<Layer> makeLayer(LayerKind kind, Scheme scheme) {
  const bool paper = scheme != Scheme::projected;
  switch (kind) {
    case LayerKind::displacement:
      if (paper) return std::make_unique<PaperDisplacement>();
      return std::make_unique<Displacement>();
    case LayerKind::conservation:
      if (paper) {
        const bool sweeps = scheme == Scheme::paperSweeps;
        return std::make_unique<PaperConservation>(sweeps ? Giving::sweeps : Giving::queue);
      }
      return std::make_unique<Conservation>();
    case LayerKind::tension:
      return std::make_unique<Tension>(scheme);
    case LayerKind::diffusion:
      return std::make_unique<Diffusion>();
    case LayerKind::automaton:
      return std::make_unique<Automaton>();
  }
  return nullptr;
}

Stepper::Stepper(const Settings& settings)
    : banded_(!onlyWalks(settings)),
      travels_(runs(settings, LayerKind::diffusion) || runs(settings, LayerKind::automaton)),
      crumbles_(travels_ && settings.scheme == Scheme::projected &&
                !runs(settings, LayerKind::tension)) {
  for (const LayerKind kind : settings.layers) layers_.push_back(makeLayer(kind, settings.scheme));
}

void Stepper::begin(Region& region, const std::vector<PlacedTool>& supports) {
  region.refreshRows();
  region.takeChanged();  // only loaded
  painter_.paintStatic(region, supports);
}

void Stepper::leave(Work& work) {
  if (crumbles_) crumbs_.run(work, Eaten::findsRoom);
}

void Stepper::finish(Work& work) {
  leave(work);
  for (const auto& layer : layers_) layer->finish(work);
  work.region.refreshRows();
}

std::string Stepper::remark() const {
  std::string all;
  for (const auto& layer : layers_) {
    const std::string one = layer->remark();
    if (!one.empty()) all += (all.empty() ? "" : "; ") + one;
  }
  return all;
}

void Stepper::paint(Region& region, const std::vector<PlacedTool>& moving) {
  // Of a large tool what no clay can come to is left out.
  KeyBox within = region.inner();
  if (!travels_) {
    const Key most{kClearingSweeps, kClearingSweeps, kClearingSweeps};
    within = {region.clayBox().low - most, region.clayBox().high + most};
  }
  painter_.paintMoving(region, moving, within);
  if (banded_) region.listBand();
}

void Stepper::step(Work& work) {
  Region& region = work.region;
  paint(region, work.moving);
  for (const auto& layer : layers_) layer->run(work);
  if (region.wished) {
    followWish(work);
    transport(work);
  }
  region.refreshRows();
  work.report.clayCells = region.clayCells();
  for (const Row& row : region.rows()) work.report.cells += row.count;
}

}  // namespace bozzetto::clay
