// What goes out comes back, for every format that is read and written.
#include <gtest/gtest.h>

#include <filesystem>
#include <glm/geometric.hpp>
#include <limits>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/file.hpp"
#include "bozzetto/io/glb.hpp"
#include "bozzetto/io/mesh_file.hpp"
#include "bozzetto/io/obj.hpp"
#include "bozzetto/io/off.hpp"
#include "bozzetto/io/ply.hpp"
#include "bozzetto/io/stl.hpp"
#include "bozzetto/mesh/check.hpp"
#include "io/text_bytes.hpp"
#include "mesh/shapes.hpp"
#include "support/folder.hpp"

namespace bozzetto {
namespace {

TriangleMesh colouredTorus() {
  auto mesh = shapes::torus(24, 12);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const auto byte = static_cast<std::uint8_t>(v);
    mesh.colours.push_back({byte, static_cast<std::uint8_t>(255 - byte), 7});
    mesh.normals.push_back({0, 1, 0});
  }
  return mesh;
}

double farthest(const TriangleMesh& a, const TriangleMesh& b) {
  double worst = 0;
  for (std::size_t v = 0; v < a.positions.size(); ++v) {
    worst = std::max(worst, glm::length(a.positions[v] - b.positions[v]));
  }
  return worst;
}

void expectSame(const TriangleMesh& found, const TriangleMesh& expected, double tolerance) {
  ASSERT_EQ(found.positions.size(), expected.positions.size());
  EXPECT_LE(farthest(found, expected), tolerance);
  EXPECT_EQ(found.triangles, expected.triangles);
  EXPECT_TRUE(found.colours == expected.colours);
}

TEST(MeshFormats, PlyObjAndGlbKeepShapeAndColours) {
  const auto mesh = colouredTorus();
  expectSame(readPly(writePly(mesh), "t"), mesh, 1e-6);
  expectSame(readObj(writeObj(mesh), "t"), mesh, 1e-6);
  expectSame(readGlb(writeGlb(mesh), "t"), mesh, 1e-6);
}

TEST(MeshFormats, PrecisionIsKeptFarFromTheOrigin) {
  auto mesh = colouredTorus();
  for (auto& p : mesh.positions) p += glm::dvec3(1e9, -2e9, 1e9);
  expectSame(readPly(writePly(mesh), "t"), mesh, 0);
  expectSame(readObj(writeObj(mesh), "t"), mesh, 0);
  expectSame(readGlb(writeGlb(mesh), "t"), mesh, 1e-6);
}

TEST(MeshFormats, EveryColourSurvivesGlb) {
  auto mesh = shapes::torus(32, 8);
  for (int n = 0; n < 256; ++n) {
    const auto byte = static_cast<std::uint8_t>(n);
    mesh.colours.push_back({byte, byte, byte});
  }
  EXPECT_TRUE(readGlb(writeGlb(mesh), "t").colours == mesh.colours);
}

TEST(MeshFormats, StlIsWeldedToTheSameSolid) {
  const auto mesh = shapes::torus(24, 12);
  const auto found = readStl(writeStl(mesh), "t");
  const auto report = checkMesh(found);
  EXPECT_TRUE(isSolid(report));
  EXPECT_EQ(report.genus(), 1);
  EXPECT_EQ(found.positions.size(), mesh.positions.size());
  EXPECT_NEAR(report.volume, signedVolume(mesh), 1e-4);
}

TEST(MeshFormats, PlyFacesHoldOnlyVertexIndices) {
  const auto bytes = writePly(colouredTorus());
  const std::string text(reinterpret_cast<const char*>(bytes.data()), 500);
  const auto faces = text.find("element face 576\n");
  ASSERT_NE(faces, std::string::npos);
  EXPECT_EQ(text.substr(faces + 17, 50), "property list uchar int vertex_indices\nend_header\n");
  EXPECT_NE(text.find("property float nx"), std::string::npos);
  EXPECT_NE(text.find("property uchar red"), std::string::npos);
}

TEST(Ply, ReadsEveryFormatSkipsTheUnknownAndFansPolygons) {
  const auto ascii = readPly(textBytes("ply\nformat ascii 1.0\ncomment c\nelement extra 2\n"
                                       "property list uchar float junk\nelement vertex 4\n"
                                       "property double x\nproperty double y\nproperty double z\n"
                                       "property float quality\nproperty float red\n"
                                       "property float green\nproperty float blue\n"
                                       "element face 1\nproperty uchar flags\n"
                                       "property list uchar int vertex_index\nend_header\n"
                                       "2 1 2\n0\n0 0 0 9 1 0 0\n1 0 0 9 0 1 0\n"
                                       "1 1 0 9 0 0 0.5\n0 1 0 9 1 1 1\n5 4 0 1 2 3\n"),
                             "t");
  EXPECT_EQ(ascii.triangles, (std::vector<TriangleMesh::Triangle>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(ascii.colours[2], (Colour{0, 0, 128}));
  const auto big = readMesh(std::string(BOZZETTO_SOURCE_DIR) + "/tests/fuzz/corpus/ply/big.ply");
  EXPECT_EQ(big.positions[1], glm::dvec3(1, 0, 0));
}

TEST(Obj, KnowsNegativeIndicesColoursAndContinuedLines) {
  const auto mesh = readObj(textBytes("# c\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv +1e0 1 \\\n 0 0 0 1\n"
                                      "v 0 1 0 1 1 1\nvn 0 0 1\nf -4//1 -3//1 -2//1 -1//1\n"
                                      "l 1 2\nf 1/1/1 2/2 \\\n 3\n"),
                            "t");
  EXPECT_EQ(mesh.triangles, (std::vector<TriangleMesh::Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}}));
  EXPECT_EQ(mesh.positions[2], glm::dvec3(1, 1, 0));
  EXPECT_EQ(mesh.colours[2], (Colour{0, 0, 255}));
}

TEST(Off, KnowsColoursNormalsAndComments) {
  const auto mesh = readOff(textBytes("CNOFF # c\n# c\n3 1 0\n0 0 0 0 0 1 255 0 0 255\n"
                                      "1 0 0 0 0 1 0.0 1.0 0.0 1.0\n\n0 1 0 0 0 1 1 2 3 255\n"
                                      "3 0 1 2 255 0 0\n"),
                            "t");
  EXPECT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.colours[1], (Colour{0, 255, 0}));
  EXPECT_EQ(mesh.colours[2], (Colour{1, 2, 3}));
}

TEST(Glb, PlacesMeshesByTheirNodesAndTurnsMirroredOnes) {
  auto bytes = glbWithJson(writeGlb(shapes::cube()), R"("nodes":[{"mesh":0}])",
                           R"("nodes":[{"children":[1,2],"translation":[10,0,0]},)"
                           R"({"mesh":0,"scale":[2,2,2]},{"mesh":0,"scale":[-1,1,1],)"
                           R"("rotation":[0,1,0,0]}])");
  const auto mesh = readGlb(bytes, "t");
  const auto report = checkMesh(mesh);
  EXPECT_TRUE(isSolid(report));
  EXPECT_EQ(report.components, 2u);
  EXPECT_NEAR(report.volume, 9, 1e-9);
  EXPECT_NEAR(report.bounds.max.x, 12, 1e-9);
}

TEST(ReadMesh, BelievesTheContentMoreThanTheExtension) {
  const testing::Folder folder;
  const auto path = folder / "liar.stl";
  writeMesh(path, MeshFormat::ply, colouredTorus());
  EXPECT_EQ(readMesh(path).colours.size(), 288u);
  writeMesh(folder / "torus.GLB", colouredTorus());
  EXPECT_EQ(readMesh(folder / "torus.GLB").colours.size(), 288u);
}

TEST(ReadMesh, ListsWhatItKnows) {
  EXPECT_THROW(meshFormatOf("clay.jpg"), Error);
  EXPECT_THROW(writeMesh("/nonexistent/folder/a.ply", shapes::cube()), Error);
  EXPECT_THROW(readMesh("/nonexistent.ply"), Error);
  EXPECT_THROW(readMesh("/dev/null"), Error);
}

TEST(WriteMesh, RefusesInvalidMeshesAndLeavesTheOldFile) {
  const testing::Folder folder;
  const auto path = folder / "old.obj";
  writeMesh(path, shapes::cube());
  auto broken = shapes::cube();
  broken.positions[0].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(writeMesh(path, broken), Error);
  EXPECT_EQ(readMesh(path).triangles.size(), 12u);
}

}  // namespace
}  // namespace bozzetto
