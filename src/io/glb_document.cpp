#include "io/glb_document.hpp"

#include <algorithm>
#include <array>

#include "bozzetto/base/bytes.hpp"
#include "io/text_reader.hpp"

namespace bozzetto {
namespace {

using Json = nlohmann::json;
using Component = GlbAccessor::Component;

constexpr std::uint32_t kMagic = 0x46546c67, kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;
constexpr std::size_t kMostJson = std::size_t{64} << 20;
constexpr int kDeepestJson = 64;

template <class T>
T load(const std::byte* at) {
  return ByteReader({at, sizeof(T)}).get<T>();
}

std::size_t sizeOf(Component component) {
  switch (component) {
    case Component::int8:
    case Component::uint8:
      return 1;
    case Component::int16:
    case Component::uint16:
      return 2;
    case Component::uint32:
    case Component::float32:
      return 4;
  }
  return 0;
}

// Brackets outside strings: deeper JSON would need a deeper stack to parse and to free.
int depthOf(std::string_view text) {
  int depth = 0, deepest = 0;
  bool inString = false;
  for (std::size_t n = 0; n < text.size(); ++n) {
    const char c = text[n];
    if (inString && c == '\\') ++n;  // the escaped character, a quote perhaps
    if (c == '"') inString = !inString;
    if (inString) continue;
    if (c == '[' || c == '{') deepest = std::max(deepest, ++depth);
    if (c == ']' || c == '}') --depth;
  }
  return deepest;
}

int componentsOf(std::string_view type) {
  static constexpr std::array<std::string_view, 4> names{"SCALAR", "VEC2", "VEC3", "VEC4"};
  for (std::size_t n = 0; n < names.size(); ++n) {
    if (type == names[n]) return static_cast<int>(n) + 1;
  }
  return 0;
}

}  // namespace

const Json* memberOf(const Json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

double GlbAccessor::number(std::size_t element, int channel) const {
  const std::byte* at =
      data + element * stride + static_cast<std::size_t>(channel) * sizeOf(component);
  const auto scaled = [this](double value, double full) {
    return normalised ? std::max(value / full, -1.0) : value;
  };
  switch (component) {
    case Component::int8:
      return scaled(load<std::int8_t>(at), 127);
    case Component::uint8:
      return scaled(load<std::uint8_t>(at), 255);
    case Component::int16:
      return scaled(load<std::int16_t>(at), 32767);
    case Component::uint16:
      return scaled(load<std::uint16_t>(at), 65535);
    case Component::uint32:
      return scaled(load<std::uint32_t>(at), 4294967295.0);
    case Component::float32:
      return load<float>(at);
  }
  return 0;
}

std::uint32_t GlbAccessor::index(std::size_t element) const {
  const std::byte* at = data + element * stride;
  if (component == Component::uint8) return load<std::uint8_t>(at);
  if (component == Component::uint16) return load<std::uint16_t>(at);
  return load<std::uint32_t>(at);
}

GlbDocument::GlbDocument(std::span<const std::byte> bytes, std::string_view name)
    : name_(name), fileBytes_(bytes.size()) {
  readChunks(bytes);
  refuseCompression();
}

void GlbDocument::fail(const std::string& found, std::string_view expected) const {
  throw Error(std::string(name_) + ": found " + found + ", expected " + std::string(expected));
}

void GlbDocument::readChunks(std::span<const std::byte> bytes) {
  ByteReader reader(bytes, name_);
  if (reader.get<std::uint32_t>() != kMagic) fail("no 'glTF' at byte 0", "a GLB file");
  const auto version = reader.get<std::uint32_t>();
  if (version != 2) fail("glTF version " + std::to_string(version) + " at byte 4", "2");
  const auto length = reader.get<std::uint32_t>();
  if (length > bytes.size()) {
    fail(std::to_string(bytes.size()) + " bytes", std::to_string(length) + " as byte 8 says");
  }
  bool jsonSeen = false;
  while (reader.remaining() >= 8) {
    const std::size_t start = reader.position();
    const std::size_t size = reader.get<std::uint32_t>();
    const auto kind = reader.get<std::uint32_t>();
    if (!jsonSeen && kind != kJsonChunk) {
      fail("another chunk at byte " + std::to_string(start), "JSON first");
    }
    const auto chunk = reader.take(size);
    if (!jsonSeen) {
      parseJson(chunk);
    } else if (kind == kBinaryChunk && binary_.empty()) {
      binary_ = chunk;
    }
    jsonSeen = true;
  }
  if (!jsonSeen) fail("no chunk at byte 12", "JSON");
}

void GlbDocument::parseJson(std::span<const std::byte> chunk) {
  const std::string_view text(reinterpret_cast<const char*>(chunk.data()), chunk.size());
  if (text.size() > kMostJson) fail("more than 64 MiB of JSON", "less");
  if (depthOf(text) > kDeepestJson) fail("JSON nested deeper than 64", "less");
  try {
    root_ = Json::parse(text);
  } catch (const Json::exception& fault) {
    fail("broken JSON: " + std::string(fault.what()), "glTF");
  }
  if (!root_.is_object()) fail("JSON that is no object", "glTF");
}

void GlbDocument::refuseCompression() const {
  const Json* required = memberOf(root_, "extensionsRequired");
  if (required == nullptr || !required->is_array()) return;
  for (const auto& extension : *required) {
    for (const char* refused : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
      if (extension == refused) fail(std::string(refused), "uncompressed geometry");
    }
  }
}

std::size_t GlbDocument::whole(const Json& object, const char* key,
                               std::optional<std::size_t> fallback) const {
  const Json* value = memberOf(object, key);
  if (value == nullptr && fallback) return *fallback;
  if (value == nullptr || !value->is_number_unsigned()) {
    fail(std::string("no whole number for '") + key + "'", "one");
  }
  return value->get<std::size_t>();
}

std::size_t GlbDocument::itemCount(const char* array) const {
  const Json* items = memberOf(root_, array);
  return items != nullptr && items->is_array() ? items->size() : 0;
}

const Json& GlbDocument::item(const char* array, std::size_t n) const {
  if (n >= itemCount(array)) {
    fail("number " + std::to_string(n) + " of '" + array + "'",
         "less than " + std::to_string(itemCount(array)));
  }
  return root_[array][n];
}

std::span<const std::byte> GlbDocument::bufferView(std::size_t n) const {
  const Json& view = item("bufferViews", n);
  const Json* extensions = memberOf(view, "extensions");
  if (extensions != nullptr && memberOf(*extensions, "EXT_meshopt_compression") != nullptr) {
    fail("EXT_meshopt_compression", "uncompressed geometry");
  }
  const std::size_t buffer = whole(view, "buffer");
  if (buffer != 0 || memberOf(item("buffers", 0), "uri") != nullptr) {
    fail("a buffer outside the file", "embedded geometry only");
  }
  const std::size_t offset = whole(view, "byteOffset", 0), length = whole(view, "byteLength");
  if (offset > binary_.size() || length > binary_.size() - offset) {
    fail("bufferView " + std::to_string(n) + " beyond the embedded buffer",
         "at most " + std::to_string(binary_.size()) + " bytes");
  }
  return binary_.subspan(offset, length);
}

GlbAccessor GlbDocument::accessor(std::size_t n) const {
  const Json& json = item("accessors", n);
  const auto wrong = [&](const char* what, const char* expected) {
    fail("accessor " + std::to_string(n) + " with " + what, expected);
  };
  if (memberOf(json, "sparse") != nullptr) wrong("sparse values", "plain ones");
  const Json* type = memberOf(json, "type");
  const Json* normalised = memberOf(json, "normalized");
  GlbAccessor result;
  result.component = static_cast<Component>(whole(json, "componentType") & 0xffff);
  result.components =
      type != nullptr && type->is_string() ? componentsOf(type->get_ref<const std::string&>()) : 0;
  result.normalised = normalised != nullptr && *normalised == true;
  result.count = whole(json, "count");
  const std::size_t size = sizeOf(result.component) * static_cast<std::size_t>(result.components);
  if (size == 0) wrong("an unknown type", "a scalar or vector");

  // The last element must end inside its view.
  const std::size_t viewNumber = whole(json, "bufferView");
  const auto view = bufferView(viewNumber);
  const std::size_t offset = whole(json, "byteOffset", 0);
  result.stride = whole(item("bufferViews", viewNumber), "byteStride", size);
  if (result.stride < size || result.stride > 252) wrong("a bad stride", "its size to 252");
  if (offset > view.size() || (result.count > 0 && view.size() - offset < size) ||
      (result.count > 0 && result.count - 1 > (view.size() - offset - size) / result.stride)) {
    wrong("elements beyond its bufferView", "less");
  }
  result.data = view.data() + offset;
  return result;
}

}  // namespace bozzetto
