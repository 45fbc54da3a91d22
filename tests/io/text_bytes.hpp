// Bytes for readers, made by hand.
#pragma once
#include <string>
#include <string_view>

#include "bozzetto/base/bytes.hpp"

namespace bozzetto {

inline Bytes textBytes(std::string_view text) {
  const auto raw = std::as_bytes(std::span(text.data(), text.size()));
  return {raw.begin(), raw.end()};
}

/// A GLB of this JSON and this embedded buffer.
inline Bytes makeGlb(std::string json, std::span<const std::byte> binary = {}) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  ByteWriter out;
  const std::size_t total = 20 + json.size() + (binary.empty() ? 0 : 8 + binary.size());
  for (const std::size_t n : {std::size_t{0x46546c67}, std::size_t{2}, total, json.size()}) {
    out.put(static_cast<std::uint32_t>(n));
  }
  out.put(std::string_view("JSON"));
  out.put(std::string_view(json));
  if (binary.empty()) return out.take();
  out.put(static_cast<std::uint32_t>(binary.size()));
  out.put(std::string_view("BIN\0", 4));
  out.put(binary);
  return out.take();
}

/// The same GLB with a piece of its JSON replaced; throws when the piece is not there.
inline Bytes glbWithJson(std::span<const std::byte> glb, std::string_view from,
                         std::string_view to) {
  ByteReader reader(glb);
  reader.skip(12);
  const std::size_t size = reader.get<std::uint32_t>();
  reader.skip(4);
  const auto raw = reader.take(size);
  std::string json(reinterpret_cast<const char*>(raw.data()), raw.size());
  const auto at = json.find(from);
  if (at == std::string::npos) throw Error("no " + std::string(from) + " in " + json);
  json.replace(at, from.size(), to);
  if (reader.remaining() == 0) return makeGlb(json);
  reader.skip(8);
  return makeGlb(json, reader.take(reader.remaining()));
}

}  // namespace bozzetto
