#include "ui/felt_hand.hpp"

namespace bozzetto::ui {
namespace {

constexpr double kGive = 0.005, kLag = 0.02;  // metres a newton, seconds
constexpr double kDamping = 0.5;              // of a mouse on a table, N·s/m
constexpr double kTick = 1e-3;

}  // namespace

FeltHand::FeltHand(const glm::dvec3& at, double metres)
    : origin_(at), place_(at), metres_(metres), device_(kGive, kLag), loop_(device_, kTick) {
  scene_.limits = {haptic::passiveStiffness(kDamping, 0, kTick), kMostForce};
}

void FeltHand::place(const glm::dvec3& at) {
  place_ = at;
  device_.place({inRoom(at), true});
}

void FeltHand::feelRope(const glm::dvec3& grabbed, double stiffness) {
  scene_.grabbed = true;
  scene_.grabbedPoint = inRoom(grabbed);
  scene_.ropeStiffness = stiffness;
  publish();
}

void FeltHand::feelSurface(const Lattice& surface, double stiffness) {
  scene_.surface.clear();
  for (Id n = 0; n < surface.faces.size(); ++n) {
    const auto face = surface.faces[n];
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
      scene_.surface.push_back({inRoom(surface.points[face[0]]), inRoom(surface.points[face[k]]),
                                inRoom(surface.points[face[k + 1]])});
  }
  scene_.surfaceStiffness = stiffness;
  publish();
}

void FeltHand::publish() {
  loop_.scene().draft() = scene_;
  loop_.scene().publish();
}

glm::dvec3 FeltHand::tool() const { return place_ + force() * (kGive / metres_); }

}  // namespace bozzetto::ui
