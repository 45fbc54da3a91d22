#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>

#include "bozzetto/io/ply.hpp"
#include "io/mesh_builder.hpp"
#include "io/ply_header.hpp"

namespace bozzetto {
namespace {

// Numbers of an ascii body.
class TextSource {
 public:
  TextSource(TextReader text, std::string_view) : text_(text) {}
  double number(PlyType) { return text_.number(); }
  std::size_t remaining() const { return text_.remaining(); }
  static std::size_t listBytes(PlyType) { return 2; }
  double fraction() const { return text_.fraction(); }
  [[noreturn]] void fail(const std::string& found, std::string_view expected) const {
    text_.fail(found, expected);
  }

 private:
  TextReader text_;
};

// Numbers of a binary body.
template <std::endian kOrder>
class BinarySource {
 public:
  BinarySource(std::span<const std::byte> bytes, std::size_t start, std::string_view name)
      : bytes_(bytes), position_(start), name_(name) {}

  double number(PlyType type) {
    switch (type) {
      case PlyType::int8:
        return get<std::int8_t>();
      case PlyType::uint8:
        return get<std::uint8_t>();
      case PlyType::int16:
        return get<std::int16_t>();
      case PlyType::uint16:
        return get<std::uint16_t>();
      case PlyType::int32:
        return get<std::int32_t>();
      case PlyType::uint32:
        return get<std::uint32_t>();
      case PlyType::float32:
        return get<float>();
      case PlyType::float64:
        return get<double>();
    }
    return 0;
  }
  std::size_t remaining() const { return bytes_.size() - position_; }
  static std::size_t listBytes(PlyType type) { return sizeOf(type); }
  double fraction() const {
    return static_cast<double>(position_) / static_cast<double>(bytes_.size());
  }
  [[noreturn]] void fail(const std::string& found, std::string_view expected) const {
    throw Error(std::string(name_) + ": byte " + std::to_string(position_) + ": found " + found +
                ", expected " + std::string(expected));
  }

 private:
  template <class T>
  T get() {
    if (remaining() < sizeof(T)) fail("the end", std::to_string(sizeof(T)) + " bytes more");
    std::array<std::byte, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes_.data() + position_, sizeof(T));
    if constexpr (kOrder != std::endian::native) std::reverse(raw.begin(), raw.end());
    position_ += sizeof(T);
    return std::bit_cast<T>(raw);
  }

  std::span<const std::byte> bytes_;
  std::size_t position_;
  std::string_view name_;
};

// What a property of the vertex means to us.
enum class Role : std::uint8_t { x, y, z, red, green, blue, none };

Role roleOf(const PlyProperty& property) {
  static constexpr std::array<std::string_view, 6> names{"x", "y", "z", "red", "green", "blue"};
  if (property.countType) return Role::none;
  std::string_view name = property.name;
  if (name.starts_with("diffuse_")) name.remove_prefix(8);
  const auto found = std::find(names.begin(), names.end(), name);
  return static_cast<Role>(found - names.begin());
}

// Colours of integer types fill their range; floats are 0…1.
double colourScale(PlyType type) {
  if (type == PlyType::float32 || type == PlyType::float64) return 1;
  return type == PlyType::uint16 || type == PlyType::int16 ? 1.0 / 65535 : 1.0 / 255;
}

template <class Source>
class PlyBody {
 public:
  PlyBody(const PlyHeader& header, Source source) : header_(header), source_(source) {}

  TriangleMesh read(Progress& progress) {
    for (const auto& element : header_.elements) {
      const std::size_t least = leastBytes(element, header_.format);
      if (least == 0) continue;
      // A last number needs no blank after it.
      if (element.count > (source_.remaining() + 1) / least) {
        source_.fail(std::to_string(element.count) + " of element " + shownText(element.name),
                     "no more than the file has room for");
      }
      readElements(element, progress);
    }
    return std::move(mesh_);
  }

 private:
  void readElements(const PlyElement& element, Progress& progress) {
    const bool vertices = element.name == "vertex", faces = element.name == "face";
    if (vertices) prepareVertices(element);
    if (faces) mesh_.triangles.reserve(element.count);
    for (std::size_t n = 0; n < element.count; ++n) {
      if (n % 65536 == 0) progress.step("Reading PLY", source_.fraction());
      if (vertices) {
        readVertex(element);
      } else {
        for (const auto& property : element.properties) {
          readList(property);
          if (faces && isIndices(property)) appendFan(mesh_, polygon_);
        }
      }
    }
  }

  static bool isIndices(const PlyProperty& property) {
    return property.countType &&
           (property.name == "vertex_indices" || property.name == "vertex_index");
  }

  void prepareVertices(const PlyElement& element) {
    roles_.clear();
    std::array<int, 7> seen{};
    for (const auto& property : element.properties) {
      roles_.push_back(roleOf(property));
      ++seen[static_cast<std::size_t>(roles_.back())];
    }
    if (seen[0] != 1 || seen[1] != 1 || seen[2] != 1) {
      source_.fail("vertices without x, y, z", "each once");
    }
    if (!mesh_.positions.empty()) source_.fail("a second element 'vertex'", "one");
    coloured_ = seen[3] == 1 && seen[4] == 1 && seen[5] == 1;
    mesh_.positions.reserve(element.count);
    if (coloured_) mesh_.colours.reserve(element.count);
  }

  void readVertex(const PlyElement& element) {
    std::array<double, 7> numbers{};
    for (std::size_t p = 0; p < roles_.size(); ++p) {
      const auto& property = element.properties[p];
      if (property.countType) {
        readList(property);
        continue;
      }
      const double scale = roles_[p] >= Role::red ? colourScale(property.type) : 1;
      numbers[static_cast<std::size_t>(roles_[p])] = source_.number(property.type) * scale;
    }
    if (!std::isfinite(numbers[0]) || !std::isfinite(numbers[1]) || !std::isfinite(numbers[2])) {
      source_.fail("a coordinate that is not finite", "a number");
    }
    mesh_.positions.push_back({numbers[0], numbers[1], numbers[2]});
    if (!coloured_) return;
    mesh_.colours.push_back(
        {colourByte(numbers[3]), colourByte(numbers[4]), colourByte(numbers[5])});
  }

  // A list of vertex numbers into polygon_; other lists and single numbers are read over.
  void readList(const PlyProperty& property) {
    if (!property.countType) {
      source_.number(property.type);
      return;
    }
    const double count = source_.number(*property.countType);
    const double room = static_cast<double>(source_.remaining() + 1) /
                        static_cast<double>(Source::listBytes(property.type));
    if (!(count >= 0 && count <= room)) {
      source_.fail("a list of " + std::to_string(count), "no more than the file has room for");
    }
    polygon_.clear();
    const bool indices = isIndices(property);
    for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n) {
      const double index = source_.number(property.type);
      if (indices) polygon_.push_back(vertexNumber(index));
    }
  }

  // Faces may stand before their vertices; requireMesh checks the upper end.
  std::uint32_t vertexNumber(double index) const {
    if (!(index >= 0 && index <= 4294967295.0) || index != std::floor(index)) {
      source_.fail("vertex number " + std::to_string(index), "an integer from 0");
    }
    return static_cast<std::uint32_t>(index);
  }

  const PlyHeader& header_;
  Source source_;
  TriangleMesh mesh_;
  std::vector<Role> roles_;
  std::vector<std::uint32_t> polygon_;
  bool coloured_ = false;
};

}  // namespace

TriangleMesh readPly(std::span<const std::byte> bytes, std::string_view name, Progress& progress) {
  TextReader text(bytes, name);
  const auto header = readPlyHeader(text);
  const std::size_t body = text.position();
  using Little = BinarySource<std::endian::little>;
  using Big = BinarySource<std::endian::big>;
  auto mesh = header.format == PlyFormat::ascii
                  ? PlyBody(header, TextSource(text, name)).read(progress)
              : header.format == PlyFormat::littleEndian
                  ? PlyBody(header, Little(bytes, body, name)).read(progress)
                  : PlyBody(header, Big(bytes, body, name)).read(progress);
  requireMesh(mesh, name);
  return mesh;
}

}  // namespace bozzetto
