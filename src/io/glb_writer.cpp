#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "bozzetto/io/glb.hpp"
#include "bozzetto/mesh/check.hpp"
#include "io/linear_colour.hpp"
#include "io/mesh_precision.hpp"

namespace bozzetto {
namespace {

using Json = nlohmann::json;

enum Component { kUint16 = 5123, kUint32 = 5125, kFloat = 5126 };
enum Target { kVertices = 34962, kIndices = 34963 };

class GlbWriter {
 public:
  GlbWriter(const TriangleMesh& mesh, Progress& progress) : mesh_(mesh), progress_(progress) {}

  Bytes write() {
    root_["asset"] = {{"version", "2.0"}, {"generator", "bozzetto"}};
    root_["scene"] = 0;
    root_["scenes"] = Json::array({Json::object()});
    if (!mesh_.triangles.empty()) addMesh();
    return container();
  }

 private:
  void addMesh() {
    // A translation holds what single precision could not.
    Json node{{"mesh", 0}};
    if (needsDouble(mesh_)) {
      const auto bounds = boundsOf(mesh_);
      origin_ = bounds.min + bounds.size() * 0.5;
      node["translation"] = {origin_.x, origin_.y, origin_.z};
    }
    Json attributes{{"POSITION", addPositions()}};
    if (!mesh_.normals.empty()) attributes["NORMAL"] = addNormals();
    if (!mesh_.colours.empty()) attributes["COLOR_0"] = addColours();
    const auto indices = addIndices();
    root_["nodes"] = Json::array({node});
    root_["scenes"][0]["nodes"] = {0};
    root_["materials"] = Json::array(
        {{{"pbrMetallicRoughness", {{"metallicFactor", 0.0}, {"roughnessFactor", 0.8}}}}});
    const Json primitive{{"attributes", attributes}, {"indices", indices}, {"material", 0}};
    root_["meshes"] = Json::array({{{"primitives", Json::array({primitive})}}});
    root_["buffers"] = Json::array({{{"byteLength", binary_.bytes().size()}}});
  }

  std::size_t addPositions() {
    MeshBounds bounds;
    const std::size_t start = binary_.bytes().size();
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
      if (v % 65536 == 0) progress_.step("Writing GLB", double(v) / double(mesh_.positions.size()));
      const glm::vec3 p(mesh_.positions[v] - origin_);
      bounds.add(p);
      putVector(p);
    }
    const auto accessor = addAccessor(start, mesh_.positions.size(), kFloat, "VEC3");
    root_["accessors"][accessor]["min"] = {bounds.min.x, bounds.min.y, bounds.min.z};
    root_["accessors"][accessor]["max"] = {bounds.max.x, bounds.max.y, bounds.max.z};
    return accessor;
  }

  std::size_t addNormals() {
    const std::size_t start = binary_.bytes().size();
    for (const auto& n : mesh_.normals) putVector(n);
    return addAccessor(start, mesh_.normals.size(), kFloat, "VEC3");
  }

  // 16 bits of linear light keep every sRGB byte apart.
  std::size_t addColours() {
    const std::size_t start = binary_.bytes().size();
    for (const auto& c : mesh_.colours) {
      for (const auto channel : {c.r, c.g, c.b}) {
        binary_.put(
            static_cast<std::uint16_t>(std::lround(linearFromSrgb(channel / 255.0) * 65535)));
      }
      binary_.put(std::uint16_t{65535});
    }
    const auto accessor = addAccessor(start, mesh_.colours.size(), kUint16, "VEC4");
    root_["accessors"][accessor]["normalized"] = true;
    return accessor;
  }

  std::size_t addIndices() {
    const std::size_t start = binary_.bytes().size();
    for (const auto& t : mesh_.triangles) {
      for (const auto v : t) binary_.put(v);
    }
    const auto accessor = addAccessor(start, 3 * mesh_.triangles.size(), kUint32, "SCALAR");
    root_["bufferViews"][accessor]["target"] = kIndices;
    return accessor;
  }

  // One view for each accessor, so both have the same number.
  std::size_t addAccessor(std::size_t start, std::size_t count, int component, const char* type) {
    root_["bufferViews"].push_back({{"buffer", 0},
                                    {"byteOffset", start},
                                    {"byteLength", binary_.bytes().size() - start},
                                    {"target", kVertices}});
    const std::size_t number = root_["bufferViews"].size() - 1;
    root_["accessors"].push_back(
        {{"bufferView", number}, {"componentType", component}, {"count", count}, {"type", type}});
    return number;
  }

  void putVector(const glm::vec3& v) {
    for (int axis = 0; axis < 3; ++axis) binary_.put(v[axis]);
  }

  Bytes container() {
    std::string json = root_.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::size_t data = binary_.bytes().size();  // whole numbers of 4 bytes only
    const std::size_t total = 12 + 8 + json.size() + (data > 0 ? 8 + data : 0);
    if (total > std::numeric_limits<std::uint32_t>::max()) {
      throw Error("GLB: found " + std::to_string(total) + " bytes, expected less than 4 GiB");
    }
    ByteWriter out;
    for (const std::size_t n : {std::size_t{0x46546c67}, std::size_t{2}, total, json.size()}) {
      out.put(static_cast<std::uint32_t>(n));
    }
    out.put(std::string_view("JSON"));
    out.put(std::string_view(json));
    if (data == 0) return out.take();
    out.put(static_cast<std::uint32_t>(data));
    out.put(std::string_view("BIN\0", 4));
    out.put(binary_.bytes());
    return out.take();
  }

  const TriangleMesh& mesh_;
  Progress& progress_;
  glm::dvec3 origin_{0};
  Json root_;
  ByteWriter binary_;
};

}  // namespace

Bytes writeGlb(const TriangleMesh& mesh, Progress& progress) {
  validate(mesh);
  return GlbWriter(mesh, progress).write();
}

}  // namespace bozzetto
