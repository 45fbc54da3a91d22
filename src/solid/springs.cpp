#include "solid/springs.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "solid/quad_kernels.hpp"

namespace bozzetto {
namespace {

constexpr double kStraight = 1e-9;

// Corner c of a quad: arms to the next and to the previous corner.
struct Corner {
  Id centre, first, second;
};
Corner cornerOf(const QuadSprings& quad, std::size_t c) {
  return {quad.points[c], quad.points[(c + 1) % 4], quad.points[(c + 3) % 4]};
}

std::vector<Springs::Batch> batchesOf(const std::vector<QuadSprings>& quads) {
  constexpr std::size_t lanes = Springs::kLanes;
  std::vector<Springs::Batch> batches((quads.size() + lanes - 1) / lanes);
  for (std::size_t n = 0; n < batches.size() * lanes; ++n) {
    const bool real = n < quads.size();
    const QuadSprings& quad = quads[real ? n : 0];  // the rest: somebody else's, without force
    Springs::Batch& batch = batches[n / lanes];
    for (std::size_t c = 0; c < 4; ++c) {
      const double sine = std::sin(quad.angle[c]);
      batch.points[c][n % lanes] = quad.points[c];
      batch.cosine[c][n % lanes] = std::cos(quad.angle[c]);
      batch.stiffness[c][n % lanes] = real ? quad.stiffness[c] / std::max(sine * sine, 0.25) : 0.0;
    }
  }
  return batches;
}

}  // namespace

CornerGradient angleBetween(const glm::dvec3& first, const glm::dvec3& second) {
  const double a = glm::dot(first, first), b = glm::dot(second, second);
  const double t = glm::dot(first, second), c = glm::length(glm::cross(first, second));
  if (c < kStraight * (a + b)) return {std::atan2(c, t), glm::dvec3(0), glm::dvec3(0)};
  return {std::atan2(c, t), (t / a * first - second) / c, (t / b * second - first) / c};
}

Springs::Springs(std::vector<NormalSpring> normal, std::vector<QuadSprings> quads, AngularLaw law)
    : normal_(std::move(normal)),
      quads_(std::move(quads)),
      law_(law),
      batches_(batchesOf(quads_)) {}

double Springs::normalEnergy(Places d) const {
  double sum = 0;
  for (const NormalSpring& spring : normal_) {
    const double stretch = glm::distance(d[spring.a], d[spring.b]) - spring.length;
    sum += 0.5 * spring.stiffness * stretch * stretch;
  }
  return sum;
}

double Springs::angularEnergy(Places d) const {
  double sum = 0;
  for (std::size_t n = 0; n < quads_.size(); ++n) {
    for (std::size_t c = 0; c < 4; ++c) {
      const Corner corner = cornerOf(quads_[n], c);
      const double angle =
          angleBetween(d[corner.first] - d[corner.centre], d[corner.second] - d[corner.centre])
              .value;
      const Batch& batch = batches_[n / kLanes];
      const double off = law_ == AngularLaw::angle ? angle - quads_[n].angle[c]
                                                   : std::cos(angle) - batch.cosine[c][n % kLanes];
      sum += 0.5 * off * off *
             (law_ == AngularLaw::angle ? quads_[n].stiffness[c] : batch.stiffness[c][n % kLanes]);
    }
  }
  return sum;
}

void Springs::addForces(Places d, MutablePlaces force) const {
  addNormalForces(d, force);
  if (law_ == AngularLaw::angle) return addAngleForces(d, force);
  quadForces(batches_, d.data(), force.data());
}

void Springs::addNormalForces(Places d, MutablePlaces force) const {
  for (const NormalSpring& spring : normal_) {
    const glm::dvec3 arm = d[spring.b] - d[spring.a];
    const double length = glm::length(arm);
    const glm::dvec3 pull = arm * (spring.stiffness * (1 - spring.length / length));
    force[spring.a] += pull;
    force[spring.b] -= pull;
  }
}

// f = −κ(θ−θ⁰) ∂θ, the centre takes what balances (solid.md §2, 4).
void Springs::addAngleForces(Places d, MutablePlaces force) const {
  for (const QuadSprings& quad : quads_) {
    for (std::size_t c = 0; c < 4; ++c) {
      const Corner corner = cornerOf(quad, c);
      const CornerGradient gradient =
          angleBetween(d[corner.first] - d[corner.centre], d[corner.second] - d[corner.centre]);
      const double pull = quad.stiffness[c] * (quad.angle[c] - gradient.value);
      force[corner.first] += pull * gradient.first;
      force[corner.second] += pull * gradient.second;
      force[corner.centre] -= pull * (gradient.first + gradient.second);
    }
  }
}

void Springs::creep(Places d, double part) {
  for (NormalSpring& spring : normal_)
    spring.length += part * (glm::distance(d[spring.a], d[spring.b]) - spring.length);
  for (QuadSprings& quad : quads_) {
    for (std::size_t c = 0; c < 4; ++c) {
      const Corner corner = cornerOf(quad, c);
      const double angle =
          angleBetween(d[corner.first] - d[corner.centre], d[corner.second] - d[corner.centre])
              .value;
      quad.angle[c] += part * (angle - quad.angle[c]);
    }
  }
  batches_ = batchesOf(quads_);
}

void Springs::linearise(Places d) {
  normalTangent_.resize(normal_.size());
  for (std::size_t n = 0; n < normal_.size(); ++n) {
    const glm::dvec3 arm = d[normal_[n].b] - d[normal_[n].a];
    const double length = glm::length(arm), k = normal_[n].stiffness;
    normalTangent_[n] = {arm / length, k, k * std::max(0.0, 1 - normal_[n].length / length)};
  }
  batchTangent_.resize(batches_.size());
  quadTangents(batches_, d.data(), batchTangent_);
}

void Springs::addTangent(Places x, MutablePlaces y) const {
  for (std::size_t n = 0; n < normal_.size(); ++n) {
    const NormalTangent& tangent = normalTangent_[n];
    const glm::dvec3 arm = x[normal_[n].b] - x[normal_[n].a];
    const double along = glm::dot(arm, tangent.direction) * (tangent.along - tangent.across);
    const glm::dvec3 pull = along * tangent.direction + tangent.across * arm;
    y[normal_[n].a] -= pull;
    y[normal_[n].b] += pull;
  }
  quadTangentTimes(batches_, batchTangent_, x.data(), y.data());
}

}  // namespace bozzetto
