// Coin, the living Open Inventor, reads what we write: the format that Ferley's program exports.
#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShape.h>
#include <gtest/gtest.h>

#include "bozzetto/io/inventor.hpp"
#include "bozzetto/mesh/check.hpp"
#include "bozzetto/mesh/weld.hpp"
#include "mesh/shapes.hpp"

namespace bozzetto {
namespace {

glm::dvec3 toVector(const SbVec3f& v) { return {v[0], v[1], v[2]}; }

void addTriangle(void* user, SoCallbackAction* action, const SoPrimitiveVertex* a,
                 const SoPrimitiveVertex* b, const SoPrimitiveVertex* c) {
  auto& mesh = *static_cast<TriangleMesh*>(user);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.triangles.push_back({first, first + 1, first + 2});
  for (const auto* vertex : {a, b, c}) {
    mesh.positions.push_back(toVector(vertex->getPoint()));
    mesh.normals.push_back(glm::vec3(toVector(vertex->getNormal())));
    SbColor ambient, diffuse, specular, emission;
    float shininess = 0, transparency = 0;
    action->getMaterial(ambient, diffuse, specular, emission, shininess, transparency,
                        vertex->getMaterialIndex());
    const auto byte = [&](int n) { return static_cast<std::uint8_t>(diffuse[n] * 255 + 0.5f); };
    mesh.colours.push_back({byte(0), byte(1), byte(2)});
  }
}

TriangleMesh readByCoin(const Bytes& bytes) {
  SoDB::init();
  SoInput input;
  input.setBuffer(bytes.data(), bytes.size());
  TriangleMesh mesh;
  SoSeparator* root = SoDB::readAll(&input);
  if (root == nullptr) return mesh;
  root->ref();
  SoCallbackAction action;
  action.addTriangleCallback(SoShape::getClassTypeId(), addTriangle, &mesh);
  action.apply(root);
  root->unref();
  return mesh;
}

TEST(Inventor, CoinReadsPositionsNormalsAndColours) {
  auto mesh = shapes::torus(24, 12);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.colours.push_back({static_cast<std::uint8_t>(v % 256), 40, 200});
    mesh.normals.push_back(glm::vec3(0, v % 2 == 0 ? 1 : -1, 0));
  }
  const auto found = readByCoin(writeInventor(mesh));
  ASSERT_EQ(found.triangles.size(), mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t n = 0; n < 3; ++n) {
      const auto vertex = mesh.triangles[t][n];
      const auto at = found.triangles[t][n];
      EXPECT_NEAR(found.positions[at].x, mesh.positions[vertex].x, 1e-6);
      EXPECT_EQ(found.normals[at], mesh.normals[vertex]);
      EXPECT_EQ(found.colours[at], mesh.colours[vertex]);
    }
  }
}

TEST(Inventor, CoinSeesTheSameSolid) {
  auto found = readByCoin(writeInventor(shapes::torus(24, 12)));
  weldVertices(found);
  const auto report = checkMesh(found);
  EXPECT_TRUE(isSolid(report));
  EXPECT_EQ(report.genus(), 1);
  EXPECT_NEAR(report.volume, signedVolume(shapes::torus(24, 12)), 1e-4);
}

}  // namespace
}  // namespace bozzetto
