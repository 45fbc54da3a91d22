#include <array>
#include <string>
#include <vector>

#include "bozzetto/io/off.hpp"
#include "io/mesh_builder.hpp"
#include "io/text_reader.hpp"

namespace bozzetto {
namespace {

// "0 0 0" and "0", with their line ends.
constexpr std::size_t kLeastVertexBytes = 6, kLeastFaceBytes = 2;

class OffReader {
 public:
  OffReader(std::span<const std::byte> bytes, std::string_view name) : text_(bytes, name, '#') {}

  TriangleMesh read(Progress& progress) {
    readHeader();
    for (std::size_t v = 0; v < vertices_; ++v) {
      if (v % 65536 == 0) progress.step("Reading OFF", text_.fraction());
      readVertex();
    }
    for (std::size_t f = 0; f < faces_; ++f) {
      if (f % 65536 == 0) progress.step("Reading OFF", text_.fraction());
      readFace();
    }
    return std::move(mesh_);
  }

 private:
  // [ST][C][N][4][n]OFF, then the counts of vertices, faces and edges.
  void readHeader() {
    const auto keyword = text_.word();
    if (!keyword.ends_with("OFF")) text_.fail(keyword, "OFF, COFF or NOFF");
    const auto prefix = keyword.substr(0, keyword.size() - 3);
    if (prefix.find_first_not_of("STCN") != std::string_view::npos) {
      text_.fail(keyword, "OFF in three dimensions");
    }
    normals_ = prefix.find('N') != std::string_view::npos;
    colours_ = prefix.find('C') != std::string_view::npos;
    if (const auto word = text_.wordOfLine(); word == "BINARY")
      text_.fail(word, "ascii OFF");
    else
      vertices_ = count(word.empty() ? text_.word() : word, kLeastVertexBytes);
    faces_ = count(text_.word(), kLeastFaceBytes);
    text_.restOfLine();
    mesh_.positions.reserve(vertices_);
    mesh_.triangles.reserve(faces_);
  }

  std::size_t count(std::string_view word, std::size_t leastBytes) const {
    const auto room = static_cast<std::int64_t>(text_.remaining() / leastBytes);
    return static_cast<std::size_t>(text_.toInteger(word, 0, room));
  }

  void readVertex() {
    glm::dvec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = text_.number();
    mesh_.positions.push_back(p);
    for (int skipped = 0; normals_ && skipped < 3; ++skipped) text_.number();
    if (colours_) readColour();
    text_.restOfLine();
  }

  // Integers are 0…255, numbers with a point 0…1.
  void readColour() {
    std::array<std::uint8_t, 3> rgb{};
    for (auto& channel : rgb) {
      const auto word = text_.word();
      const bool unit = word.find('.') != std::string_view::npos;
      channel = colourByte(text_.toNumber(word) / (unit ? 1 : 255));
    }
    mesh_.colours.push_back({rgb[0], rgb[1], rgb[2]});
  }

  void readFace() {
    const auto room = static_cast<std::int64_t>(text_.remaining());
    const auto corners = text_.integer(0, room);
    polygon_.clear();
    for (std::int64_t n = 0; n < corners; ++n) {
      polygon_.push_back(
          static_cast<std::uint32_t>(text_.integer(0, static_cast<std::int64_t>(vertices_) - 1)));
    }
    appendFan(mesh_, polygon_);
    text_.restOfLine();
  }

  TextReader text_;
  TriangleMesh mesh_;
  std::vector<std::uint32_t> polygon_;
  std::size_t vertices_ = 0, faces_ = 0;
  bool normals_ = false, colours_ = false;
};

}  // namespace

TriangleMesh readOff(std::span<const std::byte> bytes, std::string_view name, Progress& progress) {
  auto mesh = OffReader(bytes, name).read(progress);
  requireMesh(mesh, name);
  return mesh;
}

}  // namespace bozzetto
