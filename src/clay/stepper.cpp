#include "clay/stepper.hpp"

#include "clay/clearing.hpp"
#include "clay/displacement.hpp"
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
    project(work);
    transport(work);
  }

 private:
  Clearing clearing_;
};

class Tension final : public Layer {
 public:
  void run(Work& work) override {
    sweepDust(work);
    if (work.step % kCrumbInterval == kCrumbInterval - 1) crumbs_.run(work);
  }

 private:
  CrumbEater crumbs_;
};

}  // namespace

std::unique_ptr<Layer> makeLayer(LayerKind kind, Scheme) {
  switch (kind) {
    case LayerKind::displacement:
      return std::make_unique<Displacement>();
    case LayerKind::conservation:
      return std::make_unique<Conservation>();
    default:
      return std::make_unique<Tension>();
  }
}

Stepper::Stepper(const Settings& settings) {
  for (const LayerKind kind : settings.layers) layers_.push_back(makeLayer(kind, settings.scheme));
}

void Stepper::begin(Region& region, const std::vector<PlacedTool>& supports) {
  region.refreshRows(true);
  painter_.paintStatic(region, supports);
}

void Stepper::step(Work& work) {
  Region& region = work.region;
  painter_.paintMoving(region, work.moving);
  for (const auto& layer : layers_) layer->run(work);
  if (region.wished) {
    followWish(work);
    transport(work);
  }
  region.refreshRows();
  work.report.clayCells = region.clayCells();
}

}  // namespace bozzetto::clay
