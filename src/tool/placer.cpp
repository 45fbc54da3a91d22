#include "tool/placer.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/text.hpp"
#include "bozzetto/tool/sculpture.hpp"

namespace bozzetto {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kMostCopies = 4096;

double smallest(const glm::dvec3& v) { return std::min({v.x, v.y, v.z}); }
double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

// How much larger a tool of these radii, in cells, may become.
double mostGrown(const glm::dvec3& radii) {
  const double corners = 8 * radii.x * radii.y * radii.z;
  return std::min(kLargestToolCells / largest(radii), std::cbrt(kMostToolCorners / corners));
}

// A number in [0, 1) from a seed, a dab and a purpose (SplitMix64).
double chance(std::uint64_t seed, std::int64_t dab, std::uint64_t purpose) {
  std::uint64_t x = seed * 0x9e3779b97f4a7c15u +
                    static_cast<std::uint64_t>(dab) * 0xbf58476d1ce4e5b9u +
                    purpose * 0x94d049bb133111ebu + 0x9e3779b97f4a7c15u;
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
  x = (x ^ x >> 27) * 0x94d049bb133111ebu;
  return static_cast<double>((x ^ x >> 31) >> 11) * 0x1p-53;
}

// The part of `v` across `axis` (length 1), with length 1; nothing where they are parallel.
std::optional<glm::dvec3> across(const glm::dvec3& v, const glm::dvec3& axis) {
  const glm::dvec3 rest = v - glm::dot(v, axis) * axis;
  const double length = glm::length(rest);
  if (!(length > 1e-9 * (1 + glm::length(v)))) return std::nullopt;
  return rest / length;
}

// Right-handed axes with z as given and y as near to `y` as can be.
std::optional<glm::dmat3> axesFrom(const glm::dvec3& z, const glm::dvec3& y) {
  const auto upright = across(y, z);
  if (!upright) return std::nullopt;
  return glm::dmat3(glm::cross(*upright, z), *upright, z);
}

// The least rotation from one direction to another, both of length 1.
glm::dmat3 rotationBetween(const glm::dvec3& from, const glm::dvec3& to) {
  const double cosine = glm::dot(from, to);
  if (cosine < -1 + 1e-12) {  // any half turn across
    const glm::dvec3 helper = std::abs(from.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 axis = *across(helper, from);
    return 2.0 * glm::outerProduct(axis, axis) - glm::dmat3(1);
  }
  return glm::mat3_cast(glm::normalize(glm::dquat(1 + cosine, glm::cross(from, to))));
}

glm::dmat3 turnAbout(const glm::dvec3& axis, double angle) {
  return glm::mat3_cast(glm::angleAxis(angle, axis));
}

void requireIn(double number, double most, const char* what) {
  if (number >= 0 && number <= most) return;
  throw Error(std::string("stroke ") + what + ": " + numberText(number) + " found, a number in 0…" +
              numberText(most) + " expected");
}

}  // namespace

std::optional<glm::dmat3> orientationAlong(const glm::dvec3& contact, const glm::dvec3& outward,
                                           const glm::dvec3& heading) {
  const auto wanted = axesFrom(outward, heading);
  auto own = axesFrom(-contact, {0, 1, 0});
  if (!own) own = axesFrom(-contact, {0, 0, 1});
  if (!wanted) return std::nullopt;
  return *wanted * glm::transpose(*own);
}

void requireValid(const Placement& placement) {
  requireIn(placement.jitter.position, 100, "jitter position");
  requireIn(placement.jitter.size, 1, "jitter size");
  requireIn(placement.jitter.rotation, 180, "jitter rotation");
  requireIn(placement.grid, 1e9, "grid");
  requireIn(std::abs(placement.roll), 1000, "roll");
  double copies = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const int count = placement.copies[std::size_t(axis)];
    const double step = placement.copyStep[axis];
    copies *= count;
    const std::string on = std::string(" found on axis ") + "xyz"[axis];
    if (count < 1)
      throw Error("stroke copies: " + std::to_string(count) + on + ", 1 to 4096 expected");
    if (copies > kMostCopies)
      throw Error("stroke copies: " + numberText(copies) + " found, at most 4096 expected");
    if (!std::isfinite(step))
      throw Error("stroke copies: step " + numberText(step) + on + ", a finite number expected");
    if (count > 1 && step == 0)
      throw Error("stroke copies: step 0" + on +
                  ", another number expected where there is more than one");
  }
}

template <int Side>
Placer<Side>::Placer(const Placement& placement, const ToolShape& tool, const Field<Side>& field,
                     const Repeats& repeats)
    : placement_(placement),
      base_(glm::mat3_cast(tool.rotation)),
      contact_(tool.sculpture ? tool.sculpture->contact() : glm::dvec3(0, 0, -1)),
      radii_(tool.radii),
      repeats_(repeats),
      spacing_(field.scale.spacing) {
  if (placement.toNormal) before_ = field;
  for (int i = 0; i < placement.copies[0]; ++i)
    for (int j = 0; j < placement.copies[1]; ++j)
      for (int k = 0; k < placement.copies[2]; ++k)
        copies_.push_back(glm::dvec3(i, j, k) * placement.copyStep / spacing_);
}

template <int Side>
std::int64_t Placer<Side>::sureOf(std::int64_t dabs) const {
  if (placement_.anchored) return 0;
  const bool wantsHeading = placement_.alongStroke || placement_.roll != 0;
  return wantsHeading && dabs < 2 ? 0 : dabs;  // the first looks at the second
}

template <int Side>
glm::dvec3 Placer<Side>::heading(const StrokePath& path, std::int64_t n) const {
  if (placement_.anchored) return path.last().position - path.at(0).position;
  if (n > 0) return path.at(n).position - path.at(n - 1).position;
  return path.count() < 2 ? glm::dvec3(0) : path.at(1).position - path.at(0).position;
}

// Outward, from the mean change of density round the place.
template <int Side>
std::optional<glm::dvec3> Placer<Side>::normalAt(const glm::dvec3& position) const {
  FieldSampler<Side> sampler(before_);
  const double apart = std::max(1.0, smallest(radii_) / 4);
  glm::dvec3 sum(0);
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      for (int k = -2; k <= 2; ++k)
        sum += glm::dvec3(
            sampler.gradient(cellPoint(repeats_.origin, position + apart * glm::dvec3(i, j, k))));
  const double length = glm::length(sum);
  if (!(length > 1e-6)) return std::nullopt;
  return -sum / length;
}

template <int Side>
glm::dmat3 Placer<Side>::turned(const std::optional<glm::dvec3>& normal,
                                const glm::dvec3& heading) const {
  glm::dvec3 outward = -(base_ * contact_);
  glm::dmat3 orientation = base_;
  if (normal) {
    orientation = rotationBetween(outward, *normal) * base_;
    outward = *normal;
  }
  if (!placement_.alongStroke) return orientation;
  return orientationAlong(contact_, outward, heading).value_or(orientation);
}

template <int Side>
double Placer<Side>::grown(const glm::dvec3& way) const {
  const double length = glm::length(way);
  return placement_.anchored && length > 0 ? length / largest(radii_) : 1;
}

template <int Side>
std::string Placer<Side>::notice(const StrokePath& path) const {
  const double wanted = grown(heading(path, 0)), most = mostGrown(radii_);
  if (wanted <= most) return "";
  return "anchored stroke: a tool of " + numberText(wanted * largest(radii_)) +
         " cells asked for, made as large as tools can be: " + numberText(most * largest(radii_));
}

template <int Side>
void Placer<Side>::roll(const Dab& dab, Stance& stance) const {
  const glm::dvec3 outward = -(stance.orientation * contact_);
  const glm::dvec3 axis = glm::cross(outward, dab.heading);
  const double length = glm::length(axis);
  if (!(length > 1e-9)) return;
  const double radius = glm::dot(radii_, glm::abs(contact_));
  stance.orientation =
      turnAbout(axis / length, placement_.roll * dab.along / radius) * stance.orientation;
}

template <int Side>
void Placer<Side>::scatter(std::int64_t n, Stance& stance) const {
  const Jitter& jitter = placement_.jitter;
  const glm::dvec3 outward = -(stance.orientation * contact_);
  const auto number = [&](std::uint64_t purpose) { return chance(jitter.seed, n, purpose); };
  if (jitter.position > 0) {
    auto axes = axesFrom(outward, {0, 1, 0});
    if (!axes) axes = axesFrom(outward, {0, 0, 1});
    const double far = jitter.position * smallest(radii_) * std::sqrt(number(0));
    const double angle = 2 * kPi * number(1);
    stance.position += far * (std::cos(angle) * (*axes)[0] + std::sin(angle) * (*axes)[1]);
  }
  if (jitter.rotation > 0) {
    const double angle = (2 * number(3) - 1) * jitter.rotation * kPi / 180;
    stance.orientation = turnAbout(outward, angle) * stance.orientation;
  }
}

template <int Side>
glm::dvec3 Placer<Side>::snapped(const glm::dvec3& position) const {
  const glm::dvec3 corner(repeats_.origin.i, repeats_.origin.j, repeats_.origin.k);
  const double cells = placement_.grid / spacing_;
  return glm::round((position + corner) / cells) * cells - corner;
}

template <int Side>
Stance Placer<Side>::stance(const Dab& dab, const std::optional<glm::dvec3>& normal) const {
  Stance stance{dab.position, turned(normal, dab.heading)};
  if (placement_.roll != 0) roll(dab, stance);
  scatter(dab.n, stance);
  return stance;
}

// Each faces the clay where it stands. What differs by rounding only is as the first, so symmetric
// clay stays so to the bit; so is what stands in the air.
template <int Side>
std::vector<Stance> Placer<Side>::stances(const Dab& dab, const Stance& first) const {
  std::vector<Stance> each;
  for (const glm::dvec3& copy : copies_) {
    for (const glm::dmat3& turn : repeats_.turns) {
      const glm::dvec3& centre = repeats_.centre;
      auto normal = normalAt(centre + turn * (dab.position + copy - centre));
      if (normal) normal = glm::transpose(turn) * *normal;
      const bool alike = !normal || (dab.normal && glm::length(*normal - *dab.normal) < 1e-5);
      each.push_back(alike ? first : stance(dab, normal));
      each.back().position += copy;
    }
  }
  return each;
}

template <int Side>
Standing Placer<Side>::at(const StrokePath& path, std::int64_t n) const {
  Standing standing{path.at(n).position, base_};
  if (placement_.plain()) return standing;
  if (placement_.grid > 0) {
    standing.position = snapped(standing.position);
    standing.skipped = n > 0 && snapped(path.at(n - 1).position) == standing.position;
  }
  const glm::dvec3 way = heading(path, n);
  Dab dab{n, standing.position, way, static_cast<double>(n) * path.step(), {}};
  if (placement_.toNormal) dab.normal = normalAt(dab.position);
  const Stance first = stance(dab, dab.normal);
  if (placement_.toNormal && copies_.size() * repeats_.turns.size() > 1)
    standing.each = stances(dab, first);
  standing.position = first.position;
  standing.orientation = first.orientation;
  if (placement_.anchored) standing.factor = std::min(grown(way), mostGrown(radii_));
  if (placement_.jitter.size > 0)
    standing.factor *= 1 - placement_.jitter.size * chance(placement_.jitter.seed, n, 2);
  return standing;
}

template class Placer<1>;
template class Placer<8>;

}  // namespace bozzetto
