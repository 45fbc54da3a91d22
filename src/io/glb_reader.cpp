#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

#include "bozzetto/io/glb.hpp"
#include "io/glb_document.hpp"
#include "io/linear_colour.hpp"
#include "io/mesh_builder.hpp"

namespace bozzetto {
namespace {

using Json = nlohmann::json;
using Component = GlbAccessor::Component;

// A small file may place one mesh thousands of times: what comes out is bounded by this or by the
// file's own length.
constexpr std::size_t kMostFromSmallFile = std::size_t{1} << 22;

class GlbReader {
 public:
  GlbReader(std::span<const std::byte> bytes, std::string_view name)
      : document_(bytes, name), budget_(std::max(bytes.size(), kMostFromSmallFile)) {}

  TriangleMesh read(Progress& progress) {
    const auto count = document_.itemCount("nodes");
    if (count == 0) {
      for (std::size_t n = 0; n < document_.itemCount("meshes"); ++n) addMesh(n, glm::dmat4(1));
    }
    pushRoots();
    for (std::size_t done = 0; !pending_.empty(); ++done) {
      progress.step("Reading GLB", static_cast<double>(done) / static_cast<double>(count));
      const auto [node, parent] = pending_.back();
      pending_.pop_back();
      visit(document_.item("nodes", node), parent);
    }
    if (coloured_) mesh_.colours.resize(mesh_.positions.size(), kWhite);
    return std::move(mesh_);
  }

 private:
  struct Pending {
    std::size_t node;
    glm::dmat4 worldFromParent;
  };
  static constexpr Colour kWhite{255, 255, 255};

  // The nodes of the scene, or, without scenes, those that are nobody's children.
  void pushRoots() {
    seen_.assign(document_.itemCount("nodes"), false);
    if (document_.itemCount("scenes") > 0) {
      pushAll(document_.item("scenes", document_.whole(document_.root(), "scene", 0)), "nodes",
              glm::dmat4(1));
      return;
    }
    auto isChild = seen_;
    for (std::size_t n = 0; n < seen_.size(); ++n) {
      const Json* children = memberOf(document_.item("nodes", n), "children");
      if (children == nullptr || !children->is_array()) continue;
      for (const auto& child : *children) isChild[nodeNumber(child)] = true;
    }
    for (std::size_t n = seen_.size(); n-- > 0;) {
      if (!isChild[n]) push(n, glm::dmat4(1));
    }
  }

  std::size_t nodeNumber(const Json& json) const {
    if (!json.is_number_unsigned() || json.get<std::size_t>() >= seen_.size()) {
      document_.fail("a node number that no node has", "less than the count of nodes");
    }
    return json.get<std::size_t>();
  }

  void pushAll(const Json& object, const char* key, const glm::dmat4& world) {
    const Json* numbers = memberOf(object, key);
    if (numbers == nullptr || !numbers->is_array()) return;
    for (auto number = numbers->rbegin(); number != numbers->rend(); ++number) {
      push(nodeNumber(*number), world);
    }
  }

  void push(std::size_t node, const glm::dmat4& world) {
    if (seen_[node]) document_.fail("node " + std::to_string(node) + " twice", "a tree of nodes");
    seen_[node] = true;
    pending_.push_back({node, world});
  }

  void visit(const Json& node, const glm::dmat4& parent) {
    const glm::dmat4 world = parent * placeOf(node);
    if (memberOf(node, "mesh") != nullptr) addMesh(document_.whole(node, "mesh"), world);
    pushAll(node, "children", world);
  }

  // `count` numbers under `key`; false when the key is absent.
  bool numbers(const Json& object, const char* key, double* out, std::size_t count) const {
    const Json* array = memberOf(object, key);
    if (array == nullptr) return false;
    bool good = array->is_array() && array->size() == count;
    for (std::size_t n = 0; good && n < count; ++n) {
      good = (*array)[n].is_number();
      if (good) out[n] = (*array)[n].get<double>();
    }
    if (!good) {
      document_.fail(std::string("a bad '") + key + "'", std::to_string(count) + " numbers");
    }
    return true;
  }

  // matrix, or translation · rotation · scale
  glm::dmat4 placeOf(const Json& node) const {
    glm::dmat4 place(1);
    if (numbers(node, "matrix", &place[0][0], 16)) return place;
    double t[3] = {0, 0, 0}, r[4] = {0, 0, 0, 1}, s[3] = {1, 1, 1};
    numbers(node, "translation", t, 3);
    numbers(node, "rotation", r, 4);
    numbers(node, "scale", s, 3);
    const glm::dquat rotation(r[3], r[0], r[1], r[2]);
    if (!(glm::length(rotation) > 0)) document_.fail("a rotation of length 0", "a quaternion");
    place = glm::mat4_cast(glm::normalize(rotation));
    for (int axis = 0; axis < 3; ++axis) place[axis] *= s[axis];
    place[3] = glm::dvec4(t[0], t[1], t[2], 1);
    return place;
  }

  void addMesh(std::size_t number, const glm::dmat4& world) {
    const Json* primitives = memberOf(document_.item("meshes", number), "primitives");
    if (primitives == nullptr || !primitives->is_array()) return;
    for (const auto& primitive : *primitives) addPrimitive(primitive, world);
  }

  void addPrimitive(const Json& primitive, const glm::dmat4& world) {
    const Json* extensions = memberOf(primitive, "extensions");
    if (extensions && memberOf(*extensions, "KHR_draco_mesh_compression")) {
      document_.fail("KHR_draco_mesh_compression", "uncompressed geometry");
    }
    const std::size_t mode = document_.whole(primitive, "mode", 4);
    const Json* attributes = memberOf(primitive, "attributes");
    if (mode < 4 || mode > 6 || !attributes || !memberOf(*attributes, "POSITION")) return;
    const auto positions = document_.accessor(document_.whole(*attributes, "POSITION"));
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    addPositions(positions, world);
    if (memberOf(*attributes, "COLOR_0")) {
      addColours(document_.accessor(document_.whole(*attributes, "COLOR_0")), positions.count);
    }
    const auto corners = cornersOf(primitive, positions.count);
    const bool mirrored = glm::determinant(glm::dmat3(world)) < 0;
    addTriangles(corners, mode, first, mirrored);
  }

  void spend(std::size_t count) {
    if (count > budget_) {
      document_.fail("far more triangles than the file is long", "less repetition");
    }
    budget_ -= count;
  }

  void addPositions(const GlbAccessor& positions, const glm::dmat4& world) {
    if (positions.components != 3) document_.fail("positions that are no VEC3", "VEC3");
    spend(positions.count);
    for (std::size_t v = 0; v < positions.count; ++v) {
      glm::dvec4 p(0, 0, 0, 1);
      for (int axis = 0; axis < 3; ++axis) p[axis] = positions.number(v, axis);
      p = world * p;
      if (!std::isfinite(p.x + p.y + p.z)) {
        document_.fail("vertex " + std::to_string(v) + " that is not finite", "numbers");
      }
      mesh_.positions.emplace_back(p);
    }
  }

  void addColours(const GlbAccessor& colours, std::size_t vertices) {
    if (colours.components < 3 || colours.count != vertices) {
      document_.fail("COLOR_0 unlike its positions", "one VEC3 or VEC4 each");
    }
    coloured_ = true;
    mesh_.colours.resize(mesh_.positions.size() - vertices, kWhite);
    for (std::size_t v = 0; v < vertices; ++v) {
      const auto channel = [&](int n) { return colourByte(srgbFromLinear(colours.number(v, n))); };
      mesh_.colours.push_back({channel(0), channel(1), channel(2)});
    }
  }

  std::vector<std::uint32_t> cornersOf(const Json& primitive, std::size_t vertices) {
    std::vector<std::uint32_t> corners;
    if (memberOf(primitive, "indices") == nullptr) {
      for (std::size_t v = 0; v < vertices; ++v) corners.push_back(static_cast<std::uint32_t>(v));
      return corners;
    }
    const auto indices = document_.accessor(document_.whole(primitive, "indices"));
    const bool whole = indices.component == Component::uint8 ||
                       indices.component == Component::uint16 ||
                       indices.component == Component::uint32;
    if (indices.components != 1 || !whole) {
      document_.fail("indices of a bad type", "unsigned scalars");
    }
    spend(indices.count);
    corners.reserve(indices.count);
    for (std::size_t n = 0; n < indices.count; ++n) {
      const auto vertex = indices.index(n);
      if (vertex >= vertices) {
        document_.fail("vertex number " + std::to_string(vertex),
                       "less than " + std::to_string(vertices));
      }
      corners.push_back(vertex);
    }
    return corners;
  }

  // Mode 4: triangles, 5: strip, 6: fan.
  void addTriangles(const std::vector<std::uint32_t>& corners, std::size_t mode,
                    std::uint32_t first, bool mirrored) {
    const std::size_t step = mode == 4 ? 3 : 1;
    for (std::size_t n = 0; n + 3 <= corners.size(); n += step) {
      TriangleMesh::Triangle t{corners[mode == 6 ? 0 : n], corners[n + 1], corners[n + 2]};
      for (auto& vertex : t) vertex += first;
      if (mirrored != (mode == 5 && n % 2 == 1)) std::swap(t[1], t[2]);
      mesh_.triangles.push_back(t);
    }
  }

  GlbDocument document_;
  std::size_t budget_;
  TriangleMesh mesh_;
  std::vector<Pending> pending_;
  std::vector<bool> seen_;
  bool coloured_ = false;
};

}  // namespace

TriangleMesh readGlb(std::span<const std::byte> bytes, std::string_view name, Progress& progress) {
  auto mesh = GlbReader(bytes, name).read(progress);
  requireMesh(mesh, name);
  return mesh;
}

}  // namespace bozzetto
