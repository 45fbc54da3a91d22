// Springs: known answers, energies whose gradients they are, momenta that stay.
#include "solid/springs.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "bozzetto/base/simd.hpp"
#include "solid/body.hpp"
#include "solid/vectors.hpp"

namespace bozzetto {
namespace {

using testing::Json, testing::number, testing::place, testing::vectors;

Solid solidOf(const std::string& name, Solver solver = Solver::paperImplicit) {
  Solid solid;
  solid.control = testing::lattice(name);
  solid.settings.solver = solver;
  return solid;
}

// Random places near the body's own.
PlaceList shaken(const Body& body, double noise, unsigned seed = 3) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, noise);
  PlaceList d = body.refined.lattice.points;
  for (auto& p : d) p += glm::dvec3(normal(random), normal(random), normal(random));
  return d;
}

PlaceList forcesAt(const Springs& springs, const PlaceList& d) {
  PlaceList force(d.size(), glm::dvec3(0));
  springs.addForces(d, force);
  return force;
}

TEST(Springs, PulledCubeAsKnown) {
  const Json& known = vectors()["physics"]["cube_corner_pulled"];
  const Body body(solidOf("cube"));
  PlaceList p = testing::lattice("cube").points;
  p[known["moved_control_point"].get<std::size_t>()] = place(known["to"]);
  const PlaceList d = body.placesOf(p);
  EXPECT_NEAR(body.springs.normalEnergy(d), number(known["energy_normal"]), 1e-14);
  EXPECT_NEAR(body.springs.angularEnergy(d), number(known["energy_angular"]), 1e-14);
  PlaceList control(8);
  body.toControl.apply(forcesAt(body.springs, d), control);
  for (std::size_t n = 0; n < 8; ++n)
    EXPECT_LT(glm::distance(control[n], place(known["force_on_control_points"][n])), 1e-7);
}

TEST(Springs, CornersAsKnown) {
  for (const Json& known : vectors()["physics"]["angular_corner"]) {
    const auto at = [](const Json& json) {
      const auto part = [](const Json& x) {
        if (x == "sqrt(3)/2") return std::sqrt(3.0) / 2;
        if (x == "-sqrt(3)/2") return -std::sqrt(3.0) / 2;
        return number(x);
      };
      return glm::dvec3(part(json[0]), part(json[1]), part(json[2]));
    };
    ASSERT_EQ(known["theta0"], "pi/2");
    const auto gradient = angleBetween(at(known["a"]), at(known["b"]));
    const double pull = number(known["kappa"]) * (std::acos(-1.0) / 2 - gradient.value);
    EXPECT_LT(glm::distance(pull * gradient.first, place(known["fa"])), 1e-12);
    EXPECT_LT(glm::distance(pull * gradient.second, place(known["fb"])), 1e-12);
  }
}

TEST(Springs, NormalSpringAsKnown) {
  const Json& known = vectors()["physics"]["normal_spring"];
  const Springs springs({{0, 1, number(known["k"]), number(known["L"])}}, {}, AngularLaw::angle);
  const PlaceList force = forcesAt(springs, {place(known["xi"]), place(known["xj"])});
  EXPECT_EQ(force[0], place(known["fi"]));
  EXPECT_EQ(force[1], place(known["fj"]));
}

class Laws : public ::testing::TestWithParam<Solver> {};

TEST_P(Laws, KeepBothMomenta) {
  for (const std::string name : {"block_2x2x2", "pyramid", "cube_split_edge", "edge_joined"}) {
    const Body body(solidOf(name, GetParam()));
    const PlaceList d = shaken(body, 0.05), force = forcesAt(body.springs, d);
    glm::dvec3 sum(0), torque(0);
    double most = 0;
    for (std::size_t n = 0; n < d.size(); ++n) {
      sum += force[n];
      torque += glm::cross(d[n], force[n]);
      most = std::max(most, glm::length(force[n]));
    }
    EXPECT_GT(most, 1e-2) << name;
    EXPECT_LT(glm::length(sum), 1e-13) << name;
    EXPECT_LT(glm::length(torque), 1e-13) << name;
  }
}

TEST_P(Laws, AreGradientsOfTheirEnergies) {
  const Body body(solidOf("L_three_cubes", GetParam()));
  PlaceList d = shaken(body, 0.05);
  const PlaceList force = forcesAt(body.springs, d);
  for (std::size_t n = 0; n < d.size(); n += 5) {
    for (int axis = 0; axis < 3; ++axis) {
      constexpr double h = 1e-6;
      d[n][axis] += h;
      const double more = body.springs.energy(d);
      d[n][axis] -= 2 * h;
      const double less = body.springs.energy(d);
      d[n][axis] += h;
      EXPECT_NEAR(-(more - less) / (2 * h), force[n][axis], 2e-9);
    }
  }
}

TEST_P(Laws, RestAndRigidMotionWithoutForce) {
  const Body body(solidOf("cube_plus_pyramid", GetParam()));
  PlaceList d = body.refined.lattice.points;
  const glm::dquat turn = glm::normalize(glm::dquat(0.3, 0.5, -0.7, 0.2));
  for (auto& p : d) p = turn * p + glm::dvec3(5, -3, 2);
  for (const auto& force : forcesAt(body.springs, d)) EXPECT_LT(glm::length(force), 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Both, Laws, ::testing::Values(Solver::paperImplicit, Solver::standard),
                         [](const auto& each) { return std::string(toText(each.param)); });

TEST(Springs, TangentIsSymmetricPositiveAndTheForcesOwnAtRest) {
  Body body(solidOf("block_2x2x2", Solver::standard));
  const PlaceList rest = body.refined.lattice.points;
  body.springs.linearise(rest);
  const PlaceList x = shaken(body, 1e-6, 5), y = shaken(body, 1e-6, 6);
  PlaceList dx(x.size()), dy(x.size()), kx(x.size(), glm::dvec3(0)), ky = kx;
  for (std::size_t n = 0; n < x.size(); ++n) dx[n] = x[n] - rest[n], dy[n] = y[n] - rest[n];
  body.springs.addTangent(dx, kx);
  body.springs.addTangent(dy, ky);
  double xky = 0, ykx = 0, xkx = 0;
  const PlaceList force = forcesAt(body.springs, x);
  for (std::size_t n = 0; n < x.size(); ++n) {
    xky += glm::dot(dx[n], ky[n]);
    ykx += glm::dot(dy[n], kx[n]);
    xkx += glm::dot(dx[n], kx[n]);
    EXPECT_LT(glm::distance(force[n], -kx[n]), 1e-9);
  }
  EXPECT_NEAR(xky, ykx, 1e-9 * std::abs(xkx));
  EXPECT_GT(xkx, 0);
}

TEST(Springs, PlainAndVectorKernelsGiveTheSameBits) {
  Body body(solidOf("ring_3x3x1_hole", Solver::standard));
  const PlaceList d = shaken(body, 0.05), x = shaken(body, 0.1, 9);
  const auto both = [&] {
    PlaceList all = forcesAt(body.springs, d);
    body.springs.linearise(d);
    body.springs.addTangent(x, all);
    return all;
  };
  const PlaceList fast = both();
  forbidSimd(true);
  const PlaceList plain = both();
  forbidSimd(false);
  EXPECT_EQ(fast, plain);
}

TEST(Springs, MassMatrixAsKnown) {
  const Json& known = vectors()["physics"]["mass_matrix_cube_unit_masses"];
  const Body body(solidOf("cube"));
  const Lattice cube = testing::lattice("cube");
  PlaceList unit(8, glm::dvec3(0)), image(27), column(8);
  unit[0] = glm::dvec3(1, 1, 1);
  body.toMass.apply(unit, image);
  body.toControl.apply(image, column);
  const char* names[]{"same", "edge", "face_diagonal", "body_diagonal"};
  double sum = 0;
  for (std::size_t n = 0; n < 8; ++n) {
    const glm::dvec3 away = cube.points[n] - cube.points[0];
    const auto steps = static_cast<std::size_t>(std::lround(glm::dot(away, away)));
    EXPECT_NEAR(column[n].x, number(known[names[steps]]), 1e-15);
    sum += column[n].x;
  }
  EXPECT_NEAR(sum, number(known["row_sum"]), 1e-14);
}

}  // namespace
}  // namespace bozzetto
