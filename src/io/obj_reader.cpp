#include <algorithm>
#include <array>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "bozzetto/io/obj.hpp"
#include "io/mesh_builder.hpp"
#include "io/text_reader.hpp"

namespace bozzetto {
namespace {

class ObjReader {
 public:
  ObjReader(std::span<const std::byte> bytes, std::string_view name) : text_(bytes, name, '#') {}

  TriangleMesh read(Progress& progress) {
    for (std::size_t line = 0; !text_.atEnd(); ++line) {
      if (line % 65536 == 0) progress.step("Reading OBJ", text_.fraction());
      const auto word = text_.wordOfLine();
      if (word == "v") readVertex();
      if (word == "f" || word == "fo") readFace();
      skipStatement();
    }
    finishColours();
    return std::move(mesh_);
  }

 private:
  // A backslash at the end of a line joins the next one to it.
  std::string_view nextWord() {
    auto word = text_.wordOfLine();
    while (word == "\\") {
      text_.restOfLine();
      word = text_.wordOfLine();
    }
    return word;
  }

  void skipStatement() {
    while (text_.restOfLine().ends_with('\\')) {
    }
  }

  // v x y z [w], v x y z r g b or v x y z w r g b
  void readVertex() {
    std::array<double, 7> numbers{};
    std::size_t count = 0;
    for (auto word = nextWord(); !word.empty() && count < 7; word = nextWord()) {
      numbers[count++] = text_.toNumber(word);
    }
    if (count < 3) text_.fail("", "three coordinates");
    mesh_.positions.push_back({numbers[0], numbers[1], numbers[2]});
    if (count < 6) return;
    colours_.resize(mesh_.positions.size() - 1, {1, 1, 1});
    colours_.push_back({numbers[count - 3], numbers[count - 2], numbers[count - 1]});
  }

  void readFace() {
    polygon_.clear();
    for (auto word = nextWord(); !word.empty(); word = nextWord()) {
      const auto count = static_cast<std::int64_t>(mesh_.positions.size());
      const auto index = text_.toInteger(word.substr(0, word.find('/')), -count, count);
      if (index == 0) text_.fail(word, "a vertex number from 1 or below 0");
      polygon_.push_back(static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index));
    }
    appendFan(mesh_, polygon_);
  }

  // Some programs write 0…255 instead of 0…1.
  void finishColours() {
    if (colours_.empty()) return;
    colours_.resize(mesh_.positions.size(), {1, 1, 1});
    float greatest = 0;
    for (const auto& c : colours_) greatest = std::max({greatest, c.x, c.y, c.z});
    const float scale = greatest > 1 ? 1.0f / 255 : 1.0f;
    mesh_.colours.reserve(colours_.size());
    for (const auto& c : colours_) {
      mesh_.colours.push_back(
          {colourByte(c.x * scale), colourByte(c.y * scale), colourByte(c.z * scale)});
    }
  }

  TextReader text_;
  TriangleMesh mesh_;
  std::vector<glm::vec3> colours_;
  std::vector<std::uint32_t> polygon_;
};

}  // namespace

TriangleMesh readObj(std::span<const std::byte> bytes, std::string_view name, Progress& progress) {
  auto mesh = ObjReader(bytes, name).read(progress);
  requireMesh(mesh, name);
  return mesh;
}

}  // namespace bozzetto
