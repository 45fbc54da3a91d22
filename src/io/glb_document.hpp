// The outside of a GLB file: header, JSON chunk, embedded buffer, and typed views into it. Every
// number that a stranger wrote is checked before it is used.
#pragma once
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace bozzetto {

/// Numbers of one accessor, in place in the file.
struct GlbAccessor {
  enum class Component : std::uint16_t {
    int8 = 5120,
    uint8 = 5121,
    int16 = 5122,
    uint16 = 5123,
    uint32 = 5125,
    float32 = 5126
  };

  const std::byte* data = nullptr;
  std::size_t count = 0, stride = 0;
  int components = 1;
  Component component = Component::float32;
  bool normalised = false;  ///< integers stand for 0…1 or -1…1

  /// As a number; integers of normalised accessors scaled.
  double number(std::size_t element, int channel) const;
  /// As a vertex number; unsigned component types only.
  std::uint32_t index(std::size_t element) const;
};

class GlbDocument {
 public:
  /// Throws Error for a broken container, JSON deeper than 64 or longer than 64 MiB, and for
  /// extensions that compress geometry.
  GlbDocument(std::span<const std::byte> bytes, std::string_view name);

  const nlohmann::json& root() const { return root_; }
  std::size_t fileBytes() const { return fileBytes_; }

  /// Element `n` of the array `array` of the root.
  const nlohmann::json& item(const char* array, std::size_t n) const;
  std::size_t itemCount(const char* array) const;
  GlbAccessor accessor(std::size_t n) const;

  /// A whole number from 0 under `key`; `fallback` where the key is absent.
  std::size_t whole(const nlohmann::json& object, const char* key,
                    std::optional<std::size_t> fallback = std::nullopt) const;

  [[noreturn]] void fail(const std::string& found, std::string_view expected) const;

 private:
  void readChunks(std::span<const std::byte> bytes);
  void parseJson(std::span<const std::byte> chunk);
  void refuseCompression() const;
  std::span<const std::byte> bufferView(std::size_t n) const;

  std::string_view name_;
  std::size_t fileBytes_ = 0;
  nlohmann::json root_;
  std::span<const std::byte> binary_;
};

/// The member `key` of an object, null when there is none.
const nlohmann::json* memberOf(const nlohmann::json& object, const char* key);

}  // namespace bozzetto
