#include "bozzetto/solid/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "bozzetto/base/error.hpp"
#include "bozzetto/solid/cells.hpp"
#include "solid/linear.hpp"

namespace bozzetto {
namespace {

constexpr std::size_t kMostFactored = 1500;  // free control points: above, LDLT stops paying
constexpr double kSafety = 0.9;
constexpr int kMostSubSteps = 10000;

const Solid& checked(const Solid& solid) {
  requireValid(solid.settings);
  return solid;
}

// Six times the volume at the middle of a piece: negative when it is turned inside out.
double handedness(const CellPieces::Piece& piece, Places d) {
  const auto p = [&](std::size_t n) { return d[piece.points[n]]; };
  if (piece.kind == PieceKind::tetrahedron)
    return glm::dot(glm::cross(p(1) - p(0), p(2) - p(0)), p(3) - p(0));
  const glm::dvec3 u = p(1) - p(0) + p(3) - p(2) + p(5) - p(4) + p(7) - p(6);
  const glm::dvec3 v = p(2) - p(0) + p(3) - p(1) + p(6) - p(4) + p(7) - p(5);
  const glm::dvec3 w = p(4) - p(0) + p(5) - p(1) + p(6) - p(2) + p(7) - p(3);
  return glm::dot(glm::cross(u, v), w);
}

}  // namespace

struct Simulation::Impl {
  Solid start;
  Body body;
  CellPieces pieces;
  PlaceList p, v, d, force, scratch;
  std::vector<double> lumped;
  double omega = 0;  // of the lumped system at rest, for the live solver
  std::optional<Preconditioner> matrix;

  explicit Impl(const Solid& solid) : start(checked(solid)), body(solid) {
    const std::size_t count = body.free.size();
    p.resize(count);
    v.assign(count, glm::dvec3(0));
    for (std::size_t n = 0; n < count; ++n) {
      p[n] = solid.control.points[body.free[n]];
      if (!solid.matter.velocity.empty()) v[n] = solid.matter.velocity[body.free[n]];
    }
    body.placesOf(p, d);
    pieces = piecesOf(body.refined.lattice);
    if (solid.settings.solver == Solver::live) prepareLive();
    if (solid.settings.solver != Solver::live) prepareMatrix();
  }

  const SolidSettings& settings() const { return start.settings; }

  // Inertia over time squared in Eq. 6: (2 + Δtγ)/(2Δt²).
  double massScale() const {
    const double dt = settings().timeStep;
    return (2 + dt * settings().damping) / (2 * dt * dt);
  }

  void prepareMatrix() {
    using Kind = Preconditioner::Kind;
    const bool implicit = settings().solver != Solver::paperExplicit;
    const Kind kind =
        !implicit || body.free.size() <= kMostFactored ? Kind::factored : Kind::diagonal;
    if (settings().solver == Solver::paperImplicit || body.free.empty()) return;
    matrix.emplace(implicit ? controlMatrix(body, massScale(), WithSprings::yes)
                            : controlMatrix(body, 1, WithSprings::no),
                   kind);
  }

  // Row sums of AᵀMA, and the fastest mode by power iterations.
  void prepareLive() {
    lumped.assign(body.free.size(), 0);
    for (std::size_t n = 0; n < lumped.size(); ++n)
      for (Id k = body.toControl.start[n]; k < body.toControl.start[n + 1]; ++k)
        lumped[n] += body.toControl.weights[k] * body.mass[body.toControl.columns[k]];
    body.springs.linearise(d);
    PlaceList x(body.free.size()), y;
    for (std::size_t n = 0; n < x.size(); ++n)
      x[n] = {1 + double(n % 7), 1 - double(n % 5), double(n % 3) - 0.7};
    double rate = 0;
    for (int step = 0; step < 60 && !x.empty(); ++step) {
      stiffnessTimes(x, y);
      for (std::size_t n = 0; n < y.size(); ++n) y[n] /= lumped[n];
      const double length = std::sqrt(dot(y, y));
      rate = length / std::sqrt(dot(x, x));
      if (length <= 0) break;
      for (std::size_t n = 0; n < y.size(); ++n) x[n] = y[n] / length;
    }
    omega = std::sqrt(rate) * 1.05;  // power iterations come from below
  }

  void toControl(const PlaceList& places, PlaceList& control) const {
    control.resize(body.free.size());
    body.toControl.apply(places, control);
  }

  void stiffnessTimes(const PlaceList& x, PlaceList& y) {
    scratch.resize(d.size());
    body.toMass.apply(x, scratch);
    PlaceList image(d.size(), glm::dvec3(0));
    body.springs.addTangent(scratch, image);
    toControl(image, y);
  }

  // Aᵀ(springs + ropes) at d.
  void controlForces(std::span<const Rope> ropes, PlaceList& out) {
    force.assign(d.size(), glm::dvec3(0));
    body.springs.addForces(d, force);
    for (const Rope& rope : ropes) force[rope.point] += rope.strength * (rope.to - d[rope.point]);
    toControl(force, out);
  }

  // Eq. 6 for δ = p₊ − p, divided by 2Δt².
  CgResult implicitStep(std::span<const Rope> ropes) {
    const double dt = settings().timeStep, scale = massScale();
    const bool paper = settings().solver == Solver::paperImplicit;
    body.springs.linearise(d);
    const auto apply = [&](const PlaceList& x, PlaceList& y) {
      scratch.resize(d.size());
      body.toMass.apply(x, scratch);
      force.resize(d.size());
      for (std::size_t n = 0; n < d.size(); ++n) force[n] = scale * body.mass[n] * scratch[n];
      body.springs.addTangent(scratch, force);
      for (const Rope& rope : ropes) force[rope.point] += rope.strength * scratch[rope.point];
      toControl(force, y);
    };

    PlaceList right, inertia;
    controlForces(ropes, right);
    const double carried = (2 - dt * settings().damping) / (2 * dt);
    PlaceList moving(d.size());
    body.toMass.apply(v, moving);
    for (std::size_t n = 0; n < d.size(); ++n) moving[n] *= carried * body.mass[n];
    toControl(moving, inertia);
    addTimes(1, inertia, right);

    PlaceList delta(v.size(), glm::dvec3(0));
    addTimes(dt, v, delta);
    if (matrix) matrix->setRopes(body, ropes);
    const CgResult result = conjugateGradients(
        apply, right, delta, {10, paper ? 1e-4 : 1e-3, matrix ? &*matrix : nullptr});
    for (std::size_t n = 0; n < p.size(); ++n) {
      v[n] = delta[n] / dt;
      p[n] += delta[n];
    }
    return result;
  }

  // Forward Euler as printed: places move with the old velocity (§5.1).
  void explicitStep(std::span<const Rope> ropes) {
    const double dt = settings().timeStep;
    PlaceList right, acceleration(p.size());
    controlForces(ropes, right);
    matrix->solve(right, acceleration);
    for (std::size_t n = 0; n < p.size(); ++n) {
      const glm::dvec3 old = v[n];
      v[n] += dt * (acceleration[n] - settings().damping * old);
      p[n] += dt * old;
    }
  }

  // Ropes make the fastest mode faster by at most their strength over the mass they hang on.
  double stableStep(std::span<const Rope> ropes) const {
    double squared = omega * omega;
    const WeightRows& rows = body.toMass;
    for (const Rope& rope : ropes)
      for (Id n = rows.start[rope.point]; n < rows.start[rope.point + 1]; ++n)
        squared += rope.strength * rows.weights[n] * rows.weights[n] / lumped[rows.columns[n]];
    const double w = std::sqrt(std::max(squared, 1e-12)), g = settings().damping;
    // Symplectic Euler with damping taken explicitly: h²ω² + 2hγ ≤ 4.
    return (std::sqrt(g * g + 4 * w * w) - g) / (w * w);
  }

  int liveStep(std::span<const Rope> ropes) {
    const double limit = kSafety * stableStep(ropes);
    const int count = static_cast<int>(
        std::clamp(std::ceil(settings().timeStep / limit), 1.0, double(kMostSubSteps)));
    const double h = settings().timeStep / count;
    PlaceList right;
    for (int step = 0; step < count; ++step) {
      controlForces(ropes, right);
      for (std::size_t n = 0; n < p.size(); ++n) {
        v[n] += h * (right[n] / lumped[n] - settings().damping * v[n]);
        p[n] += h * v[n];
      }
      body.placesOf(p, d);
    }
    return count;
  }

  std::size_t inverted() const {
    const auto places = pieces.places(d);
    return static_cast<std::size_t>(std::ranges::count_if(
        pieces.pieces, [&](const auto& piece) { return !(handedness(piece, places) > 0); }));
  }

  bool finite() const {
    return std::ranges::all_of(d, [](const glm::dvec3& x) {
      return std::abs(x.x) < 1e12 && std::abs(x.y) < 1e12 && std::abs(x.z) < 1e12;
    });
  }
};

Simulation::Simulation(const Solid& solid) : impl_(std::make_unique<Impl>(solid)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

StepReport Simulation::step(std::span<const Rope> ropes) {
  Impl& s = *impl_;
  for (const Rope& rope : ropes)
    if (rope.point >= s.d.size()) throw Error("rope: found a point that is none of the solid's");
  StepReport report;
  const PlaceList before = s.p;
  const std::size_t invertedBefore = s.inverted();
  if (s.settings().solver == Solver::paperExplicit) {
    if (s.matrix) s.explicitStep(ropes);
  } else if (s.settings().solver == Solver::live) {
    report.iterations = s.liveStep(ropes);
  } else {
    const CgResult result = s.implicitStep(ropes);
    report.iterations = result.iterations;
    report.residual = result.residual;
  }
  s.body.placesOf(s.p, s.d);

  // A state that cannot be shown is never shown.
  report.inverted = s.finite() ? s.inverted() : s.pieces.pieces.size();
  if (!s.finite() || report.inverted > invertedBefore) {
    s.p = before;
    s.v.assign(s.v.size(), glm::dvec3(0));
    s.body.placesOf(s.p, s.d);
    report.rolledBack = true;
  } else if (s.settings().creep > 0) {
    s.body.springs.creep(s.d, 1 - std::exp(-s.settings().creep * s.settings().timeStep));
  }
  return report;
}

Solid Simulation::solid() const {
  const Impl& s = *impl_;
  Solid result = s.start;
  if (result.matter.lengths.empty())
    result.matter.lengths = lengthsOf(s.body.topology, s.body.refined.lattice.points);
  if (result.matter.angles.empty())
    result.matter.angles = anglesOf(s.body.refined.lattice, s.body.refined.lattice.points);
  result.matter.velocity.assign(result.control.points.size(), glm::dvec3(0));
  for (std::size_t n = 0; n < s.p.size(); ++n) {
    result.control.points[s.body.free[n]] = s.p[n];
    result.matter.velocity[s.body.free[n]] = s.v[n];
  }
  const Springs& springs = s.body.springs;
  for (std::size_t n = 0; n < springs.normal().size(); ++n)
    result.matter.lengths[s.body.springEdges[n]] = springs.normal()[n].length;
  for (std::size_t n = 0; n < springs.quads().size(); ++n)
    for (std::size_t c = 0; c < 4; ++c)
      result.matter.angles[s.body.refined.lattice.faces.startOf(s.body.quadFaces[n]) + c] =
          springs.quads()[n].angle[c];
  return result;
}

const Lattice& Simulation::refined() const { return impl_->body.refined.lattice; }
std::span<const glm::dvec3> Simulation::points() const { return impl_->d; }
double Simulation::energy() const { return impl_->body.springs.energy(impl_->d); }
std::size_t Simulation::invertedCells() const { return impl_->inverted(); }

std::vector<glm::dvec3> Simulation::controlForces(std::span<const Rope> ropes) const {
  PlaceList result;
  impl_->controlForces(ropes, result);
  return result;
}

double Simulation::stableStep() const {
  if (impl_->settings().solver != Solver::live)
    throw Error("solid: found another solver, expected live to ask for its stable step");
  return impl_->stableStep({});
}

double Simulation::compliance(Id point) const {
  if (!impl_->matrix) throw Error("solid: found a solver without a matrix, expected standard");
  return impl_->matrix->give(impl_->body, point);
}

}  // namespace bozzetto
