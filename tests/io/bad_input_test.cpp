// Strangers' files give a mesh or an Error of one line that says where, in little memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>

#include "bozzetto/base/error.hpp"
#include "bozzetto/io/glb.hpp"
#include "bozzetto/io/mesh_file.hpp"
#include "bozzetto/io/obj.hpp"
#include "bozzetto/io/off.hpp"
#include "bozzetto/io/ply.hpp"
#include "bozzetto/io/stl.hpp"
#include "bozzetto/mesh/check.hpp"
#include "io/text_bytes.hpp"
#include "mesh/shapes.hpp"

namespace bozzetto {
namespace {

using Reader = std::function<TriangleMesh(std::span<const std::byte>)>;

Reader reader(TriangleMesh (*read)(std::span<const std::byte>, std::string_view, Progress&)) {
  return [read](std::span<const std::byte> bytes) { return read(bytes, "t", Progress::none()); };
}

std::string errorOf(const Reader& read, std::span<const std::byte> bytes) {
  try {
    read(bytes);
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return error.what();
  }
  return "no error";
}

std::string errorOf(const Reader& read, std::string_view text) {
  return errorOf(read, textBytes(text));
}

const Reader kStl = reader(readStl), kPly = reader(readPly), kObj = reader(readObj),
             kOff = reader(readOff), kGlb = reader(readGlb);

std::string plyOf(const std::string& counts, const std::string& body) {
  return "ply\nformat ascii 1.0\nelement vertex " + counts +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
         "property list uchar int vertex_indices\nend_header\n" +
         body;
}

TEST(BadInput, ErrorsSayWhereWhatAndWhatWasExpected) {
  EXPECT_EQ(errorOf(kObj, "v 0 0 0\nv 1 0 zero\n"), "t: line 2: found 'zero', expected a number");
  EXPECT_EQ(errorOf(kObj, "v 0 0 0\nf 1 2 3\n"),
            "t: line 2: found '2', expected an integer from -1 to 1");
  EXPECT_EQ(errorOf(kOff, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
            "t: line 6: found '3', expected an integer from 0 to 2");
  EXPECT_EQ(errorOf(kStl, "solid\nfacet\nvertex 0 0 0\nvertex 1 0 0\nendloop\n"),
            "t: line 5: found 'endloop', expected three vertices before it");
  EXPECT_EQ(errorOf(kPly, plyOf("3", "0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n")),
            "t: triangle 0 uses vertex 9, less than 3 expected");
}

TEST(BadInput, NumbersThatAreNoneAreRefusedEverywhere) {
  for (const std::string bad : {"nan", "inf", "-inf", "1e999", "0x10", "1,5", "--1", "+"}) {
    EXPECT_NE(errorOf(kObj, "v 0 0 " + bad + "\n"), "no error") << bad;
    EXPECT_NE(errorOf(kOff, "OFF\n3 1 0\n0 0 " + bad + "\n1 0 0\n0 1 0\n3 0 1 2\n"), "no error");
    EXPECT_NE(errorOf(kPly, plyOf("3", "0 0 " + bad + "\n1 0 0\n0 1 0\n3 0 1 2\n")), "no error");
    EXPECT_NE(errorOf(kStl, "solid\nvertex 0 0 " + bad + "\n"), "no error");
  }
  auto stl = writeStl(shapes::cube());
  for (int n = 0; n < 4; ++n) stl[84 + 12 + n] = std::byte{0xff};  // a nan
  EXPECT_NE(errorOf(kStl, stl).find("byte 96"), std::string::npos);
}

TEST(BadInput, TinyNumbersAreZeroAndHugeOnesFine) {
  const auto mesh = readObj(textBytes("v 1e-999 0 0\nv 1e300 0 0\nv 0 1 0\nf 1 2 3\n"), "t");
  EXPECT_EQ(mesh.positions[0].x, 0);
  EXPECT_EQ(mesh.positions[1].x, 1e300);
}

TEST(BadInput, AbsurdCountsAreRefusedBeforeAllocating) {
  EXPECT_NE(errorOf(kPly, plyOf("99999999999", "")).find("99999999999"), std::string::npos);
  EXPECT_NE(errorOf(kOff, "OFF\n4000000000 1 0\n"), "no error");
  EXPECT_NE(errorOf(kOff, "OFF\n0 4000000000 0\n"), "no error");
  EXPECT_NE(errorOf(kOff, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n"), "no error");
  auto stl = writeStl(shapes::cube());
  stl[83] = std::byte{0x7f};
  EXPECT_NE(errorOf(kStl, stl).find("byte 80"), std::string::npos);
  EXPECT_NE(errorOf(kPly,
                    "ply\nformat binary_little_endian 1.0\nelement nothing 9999999999\n"
                    "end_header\n"),
            "no error");
}

TEST(BadInput, EmptyAndPointsOnlyFilesHaveNoTriangles) {
  for (const auto& read : {kStl, kPly, kObj, kOff, kGlb}) EXPECT_NE(errorOf(read, ""), "no error");
  EXPECT_NE(errorOf(kObj, "v 0 0 0\nv 1 1 1\n").find("no triangles"), std::string::npos);
}

TEST(BadInput, GlbRefusesWhatWeDoNotFollow) {
  const auto good = writeGlb(shapes::cube());
  const auto with = [&](std::string_view from, std::string_view to) {
    return errorOf(kGlb, glbWithJson(good, from, to));
  };
  EXPECT_EQ(with(R"("mesh":0)", R"("mesh":0,"x":1)"), "no error");
  EXPECT_NE(with(R"("buffers":[{)", R"("buffers":[{"uri":"/etc/passwd",)").find("outside"),
            std::string::npos);
  EXPECT_NE(with(R"("scene":0)", R"("scene":0,"extensionsRequired":["KHR_draco_mesh_compression"])")
                .find("KHR_draco"),
            std::string::npos);
  EXPECT_NE(with(R"("type":"VEC3")", R"("type":"VEC3","sparse":{"count":1})").find("sparse"),
            std::string::npos);
  EXPECT_NE(with(R"("count":8)", R"("count":9)").find("beyond"), std::string::npos);
  EXPECT_NE(with(R"("count":8)", R"("count":18446744073709551615)").find("beyond"),
            std::string::npos);
  EXPECT_NE(with(R"("nodes":[{"mesh":0}])", R"("nodes":[{"mesh":0,"children":[0]}])").find("twice"),
            std::string::npos);
  EXPECT_NE(with(R"("mesh":0)", R"("mesh":1)"), "no error");
  EXPECT_NE(with(R"("mesh":0)", R"("mesh":-1)"), "no error");
}

TEST(BadInput, DeepJsonDoesNotOverflowTheStack) {
  EXPECT_NE(errorOf(kGlb, makeGlb(std::string(1 << 20, '['))).find("nested"), std::string::npos);
  EXPECT_NE(
      errorOf(kGlb, makeGlb(R"({"a":")" + std::string(1000, '[') + R"("})")).find("no triangles"),
      std::string::npos);
}

TEST(BadInput, ManyPlacesOfOneMeshAreBounded) {
  std::string nodes = R"("nodes":[{"mesh":0}])", scenes, many;
  for (int n = 0; n < 50000; ++n) {
    many += (n ? "," : "") + std::string(R"({"mesh":0})");
    scenes += (n ? "," : "") + std::to_string(n);
  }
  auto bytes = glbWithJson(writeGlb(shapes::torus(40, 20)), nodes, "\"nodes\":[" + many + "]");
  bytes = glbWithJson(bytes, R"("nodes":[0])", "\"nodes\":[" + scenes + "]");
  EXPECT_NE(errorOf(kGlb, bytes).find("repetition"), std::string::npos);
}

// Every beginning of a good file, and every good file with one byte changed.
TEST(BadInput, TruncatedAndDamagedFilesGiveAMeshOrAnError) {
  auto mesh = shapes::cube();
  mesh.colours.assign(8, Colour{1, 2, 3});
  const std::pair<Reader, Bytes> cases[] = {
      {kStl, writeStl(mesh)},
      {kPly, writePly(mesh)},
      {kObj, writeObj(mesh)},
      {kGlb, writeGlb(mesh)},
      {kOff, textBytes("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")}};
  for (const auto& [read, bytes] : cases) {
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      errorOf(read, std::span(bytes).first(size));
      auto damaged = bytes;
      damaged[size] ^= std::byte{0x5a};
      errorOf(read, damaged);
    }
  }
}

// Scans, CAD parts and the broken files of another importer's tests; see tests/fetch_meshes.sh.
TEST(BadInput, StrangersFilesGiveAMeshOrAnErrorInTime) {
  const char* folder = std::getenv("BOZZETTO_TEST_MESHES");
  ASSERT_NE(folder, nullptr) << "run ./test, or tests/fetch_meshes.sh DEST and set "
                                "BOZZETTO_TEST_MESHES=DEST";
  int meshes = 0, errors = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    std::string extension = entry.path().extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), ::tolower);
    static const std::string known[] = {".stl", ".ply", ".obj", ".off", ".glb"};
    if (!entry.is_regular_file() || std::count(known, known + 5, extension) == 0) continue;
    const auto start = std::chrono::steady_clock::now();
    try {
      checkMesh(readMesh(entry.path()));
      ++meshes;
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(entry.path().string()), std::string::npos);
      ++errors;
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5)) << entry.path();
  }
  EXPECT_GT(meshes, 100);
  EXPECT_GT(errors, 5);
  EXPECT_LT(errors, 30);
}

}  // namespace
}  // namespace bozzetto
