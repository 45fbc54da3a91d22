// What a hand feels in solid mode: the rope it pulls, the surface it touches (McDonnell & Qin §6.1,
// §6.2). The force is drawn as an arrow, and the tool lags behind the pointer by it.
#include <algorithm>
#include <glm/geometric.hpp>

#include "ui/atelier.hpp"

namespace bozzetto::ui {
namespace {

constexpr double kRoomMetres = 0.2;      // of the device, as high as the view
constexpr double kRopeNewtons = 10;      // a metre, for a rope of strength 1
constexpr double kSurfaceNewtons = 200;  // a metre, for springs of stiffness 1
constexpr double kPressMetres = 0.012;   // how deep a touch goes where nothing resists
constexpr double kArrowHeight = 0.22;    // of the view, for the greatest force

}  // namespace

void Atelier::beginFelt() {
  const double height = unitsPerPixel(view, extent_, solidHit_.place) * extent_.height;
  handTo_ = solidHit_.place;
  felt_ = std::make_unique<FeltHand>(solidHit_.place, kRoomMetres / height);
}

// Every frame while something is felt.
void Atelier::feel(const Publication& fresh) {
  if (fresh.touched) touched_ = *fresh.touched;
  if (!felt_ || !solidShown_) return;
  if (rowOf(solid.tool).grip == SolidGrip::touch) {
    if (fresh.touched) felt_->feelSurface(solidShown_->mass, kSurfaceNewtons * *fresh.touched);
    return;
  }
  const double rope = kRopeNewtons * solidShown_->solid->settings.ropeStrength;
  if (fresh.solid && solidHit_.element < solidShown_->mass.points.size())
    felt_->feelRope(solidShown_->mass.points[solidHit_.element], rope);
  followHand();
}

// The hand presses into the surface, as hard as the pen does.
void Atelier::touchSolid() {
  const Ray ray = rayThrough(view, extent_, pointer_);
  const SolidHit hit = massUnder();
  if (hit.element == kNoId) {
    felt_->place(onFacingPlane(view, ray, solidHit_.place) - 2.0 * solid.radius * ray.direction);
    return;
  }
  solidHit_ = hit;
  const double height = unitsPerPixel(view, extent_, hit.place) * extent_.height;
  const double depth = kPressMetres / kRoomMetres * height * pressure_;
  felt_->place(hit.place + ray.direction * depth);
  worker_.post(
      [at = hit.place, radius = solid.radius](ClayDesk& desk) { desk.touchSolid(at, radius); });
}

// A drag's preview goes where the tool is, one at a time.
void Atelier::followHand() {
  const glm::dvec3 at = felt_ ? felt_->tool() : handTo_;
  const double pixel = unitsPerPixel(view, extent_, at);
  if (glm::distance(at, dragged_) < (felt_ ? 0.5 * pixel : 1e-12) || previewing_) return;
  dragged_ = at;
  previewing_ = true;
  worker_.post([drag = solidDrag()](ClayDesk& desk) { desk.previewSolid(drag); });
}

glm::dvec3 Atelier::feltArrow() const {
  if (!felt_) return glm::dvec3(0);
  const double height = unitsPerPixel(view, extent_, solidHit_.place) * extent_.height;
  return felt_->force() * (kArrowHeight * height / FeltHand::kMostForce);
}

}  // namespace bozzetto::ui
