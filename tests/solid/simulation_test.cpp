// Solids in motion: energy, momentum, stability, ropes, pins, creep, rollback.
#include "bozzetto/solid/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "bozzetto/base/error.hpp"

namespace bozzetto {
namespace {

Solid block(Key cells, Solver solver, double timeStep) {
  Solid solid;
  NamedLattice made = makeBlock({cells, glm::dvec3(1), glm::dvec3(0), {}});
  solid.control = std::move(made.lattice);
  solid.names = std::move(made.names);
  solid.settings.solver = solver;
  solid.settings.timeStep = timeStep;
  return solid;
}

// Stretched along x from its rest, about to swing.
Solid stretched(Key cells, Solver solver, double timeStep, double damping) {
  Solid solid = Simulation(block(cells, Solver::live, 0.1)).solid();
  solid.settings.solver = solver;
  solid.settings.timeStep = timeStep;
  solid.settings.damping = damping;
  for (auto& p : solid.control.points) p.x *= 1.1;
  return solid;
}

glm::dvec3 middle(std::span<const glm::dvec3> points) {
  glm::dvec3 sum(0);
  for (const auto& p : points) sum += p;
  return sum / double(points.size());
}

Id cornerOf(const Simulation& simulation) {
  Id best = 0;
  for (Id n = 0; n < simulation.points().size(); ++n)
    if (glm::dot(simulation.points()[n], glm::dvec3(1)) >
        glm::dot(simulation.points()[best], glm::dvec3(1)))
      best = n;
  return best;
}

TEST(Simulation, LiveEnergySwingsWithoutTrend) {
  Simulation simulation(stretched({2, 2, 2}, Solver::live, 0.1, 0));
  const double start = simulation.energy();
  double mostEarly = 0, mostLate = 0;
  for (int step = 0; step < 2000; ++step) {
    simulation.step();
    const double energy = simulation.energy();
    ASSERT_LT(energy, 1.3 * start);
    if (step < 500) mostEarly = std::max(mostEarly, energy);
    if (step >= 1500) mostLate = std::max(mostLate, energy);
  }
  EXPECT_NEAR(mostLate / mostEarly, 1, 0.35);
}

TEST(Simulation, LiveSubStepsKeepAnyStepStable) {
  Simulation simulation(stretched({3, 3, 3}, Solver::live, 50, 0.1));
  const double start = simulation.energy();
  const StepReport report = simulation.step();
  EXPECT_GT(report.iterations, 10);
  EXPECT_FALSE(report.rolledBack);
  EXPECT_LT(simulation.energy(), start);
}

TEST(Simulation, StableStepIsAsMeasured) {
  // Notes: ω_max of 4³ cells, k_a 0.5, lumped: 0.79, limit 2.52.
  Solid solid = block({4, 4, 4}, Solver::live, 0.1);
  solid.settings.damping = 0;
  EXPECT_NEAR(Simulation(solid).stableStep(), 2.52 / 1.05, 0.15);
}

TEST(Simulation, EqSixIsBoundedAtAnyStepAndComesToRest) {
  for (const Solver solver : {Solver::standard, Solver::paperImplicit}) {
    for (const double timeStep : {0.1, 1.0, 10.0, 100.0}) {
      Simulation simulation(stretched({2, 2, 2}, solver, timeStep, 0));
      const double start = simulation.energy();
      for (int step = 0; step < 40; ++step) simulation.step();
      EXPECT_LT(simulation.energy(), start) << toText(solver) << " " << timeStep;
    }
  }
}

TEST(Simulation, SolversAgreeOnSmallSteps) {
  std::vector<glm::dvec3> ends;
  for (const Solver solver : {Solver::standard, Solver::paperImplicit, Solver::paperExplicit}) {
    Simulation simulation(stretched({2, 2, 2}, solver, 0.002, 1));
    for (int step = 0; step < 500; ++step) simulation.step();
    ends.push_back(simulation.points()[cornerOf(simulation)]);
  }
  EXPECT_LT(glm::distance(ends[0], ends[1]), 2e-3);
  EXPECT_LT(glm::distance(ends[0], ends[2]), 2e-3);
}

TEST(Simulation, MomentumStaysWithoutRopes) {
  for (const Solver solver : {Solver::standard, Solver::live, Solver::paperExplicit}) {
    Simulation simulation(stretched({2, 1, 2}, solver, 0.05, 0));
    const glm::dvec3 before = middle(simulation.solid().control.points);
    for (int step = 0; step < 100; ++step) simulation.step();
    EXPECT_LT(glm::distance(middle(simulation.solid().control.points), before), 1e-3)
        << toText(solver);
  }
}

TEST(Simulation, RopePullsItsPointAndLittleElse) {
  for (const Solver solver : {Solver::standard, Solver::live, Solver::paperImplicit}) {
    Solid solid = block({3, 3, 3}, solver, 0.5);
    solid.settings.damping = 2;
    Simulation simulation(solid);
    const Id corner = cornerOf(simulation);
    const glm::dvec3 from = simulation.points()[corner], to = from + glm::dvec3(0.5, 0.5, 0.5);
    const Rope rope{corner, to, 10};
    for (int step = 0; step < 60; ++step) {
      const auto report = simulation.step(std::span(&rope, 1));
      EXPECT_FALSE(report.rolledBack);
    }
    EXPECT_LT(glm::distance(simulation.points()[corner], to), 0.25) << toText(solver);
    EXPECT_EQ(simulation.invertedCells(), 0u);
  }
}

TEST(Simulation, StiffRopesNeedFewIterations) {
  for (const double strength : {1.0, 100.0, 10000.0}) {
    Solid solid = block({3, 3, 3}, Solver::standard, 0.5);
    Simulation simulation(solid);
    const Id corner = cornerOf(simulation);
    const Rope rope{corner, simulation.points()[corner] + glm::dvec3(0.3, 0, 0.2), strength};
    double iterations = 0;
    for (int step = 0; step < 20; ++step)
      iterations += simulation.step(std::span(&rope, 1)).iterations;
    EXPECT_LT(iterations / 20, 8) << strength;
  }
}

TEST(Simulation, FixedPointsStayAndTheRestHangsOnThem) {
  Solid solid = block({1, 4, 1}, Solver::standard, 0.5);
  solid.matter.fixed.assign(solid.control.points.size(), 0);
  for (std::size_t n = 0; n < solid.names.size(); ++n)
    solid.matter.fixed[n] = solid.names[n].j <= 1 ? 1 : 0;
  Simulation simulation(solid);
  const Id corner = cornerOf(simulation);
  const Rope rope{corner, simulation.points()[corner] + glm::dvec3(2, 0, 0), 1};
  for (int step = 0; step < 50; ++step) simulation.step(std::span(&rope, 1));
  const Solid after = simulation.solid();
  double moved = 0;
  for (std::size_t n = 0; n < solid.names.size(); ++n) {
    const double distance = glm::distance(after.control.points[n], solid.control.points[n]);
    if (solid.matter.fixed[n] != 0) {
      EXPECT_EQ(distance, 0);
    }
    moved = std::max(moved, distance);
  }
  EXPECT_GT(moved, 0.2);
}

TEST(Simulation, ClayKeepsWhatItWasPulledTo) {
  const auto pulled = [](double creep) {
    Solid solid = block({2, 2, 2}, Solver::standard, 0.5);
    solid.settings.creep = creep;
    Simulation simulation(solid);
    const Id corner = cornerOf(simulation);
    const glm::dvec3 from = simulation.points()[corner];
    const Rope rope{corner, from + glm::dvec3(0.6, 0.6, 0.6), 10};
    const glm::dvec3 opposite = from * -1.0;
    Rope hold{0, opposite, 10};
    for (Id n = 0; n < simulation.points().size(); ++n)
      if (glm::distance(simulation.points()[n], opposite) <
          glm::distance(simulation.points()[hold.point], opposite))
        hold.point = n;
    const Rope ropes[]{rope, hold};
    for (int step = 0; step < 40; ++step) simulation.step(ropes);
    for (int step = 0; step < 200; ++step) simulation.step();
    return glm::distance(simulation.points()[corner], simulation.points()[hold.point]);
  };
  EXPECT_GT(pulled(0.5), pulled(0) + 0.2);
}

TEST(Simulation, WhatWouldExplodeIsTakenBack) {
  Solid solid = stretched({2, 2, 2}, Solver::paperExplicit, 50, 0);
  Simulation simulation(solid);
  bool rolledBack = false;
  for (int step = 0; step < 50; ++step) rolledBack |= simulation.step().rolledBack;
  EXPECT_TRUE(rolledBack);
  EXPECT_EQ(simulation.invertedCells(), 0u);
  for (const auto& p : simulation.points()) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
}

TEST(Simulation, GoesOnFromItsOwnSolid) {
  Solid solid = stretched({2, 2, 2}, Solver::standard, 0.5, 1);
  Simulation whole(solid), first(solid);
  for (int step = 0; step < 10; ++step) whole.step();
  for (int step = 0; step < 5; ++step) first.step();
  Simulation second(first.solid());
  for (int step = 0; step < 5; ++step) second.step();
  for (std::size_t n = 0; n < whole.points().size(); ++n)
    EXPECT_LT(glm::distance(whole.points()[n], second.points()[n]), 1e-3);
}

TEST(Simulation, BadInputIsRefused) {
  Solid solid = block({1, 1, 1}, Solver::standard, -1);
  EXPECT_THROW(Simulation{solid}, Error);
  solid.settings.timeStep = 0.1;
  solid.matter.mass = {1, 2, 3};
  EXPECT_THROW(Simulation{solid}, Error);
  solid.matter.mass.clear();
  Simulation simulation(solid);
  const Rope rope{1000, glm::dvec3(0), 1};
  EXPECT_THROW(simulation.step(std::span(&rope, 1)), Error);
}

}  // namespace
}  // namespace bozzetto
