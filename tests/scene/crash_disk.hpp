// A small scene on a disk that can fail and lose power, and what a session does with it.
#pragma once
#include <gtest/gtest.h>

#include "bozzetto/base/file.hpp"
#include "bozzetto/base/hash.hpp"
#include "scene/scenes.hpp"
#include "support/crash_file_system.hpp"

namespace bozzetto::testing {

inline constexpr const char* kScene = "/disk/a.bzt";

/// A few chunks of clay in all its forms; some pages of file.
inline Document smallDocument() {
  Document document;
  document.field = ball<8>(5.5f, {3, -4, 5}, {10, 20, 30});
  document.parts.identity = SceneIdentity{{1, 2, 3}};
  document.parts.settings = {{"name", "Faun"}};
  document.parts.shelf = {{"thumb", {"round"}, bytesOf("{\"op\":\"tool\"}"), smallPng()}};
  return document;
}

/// The same document some work later: clay changes, comes and goes, parts change.
inline Document worked(Document document, int step) {
  fill<8>(document.field, {{step * 9, 0, 0}, {step * 9 + 4, 3, 3}},
          [&](Key) { return 0.1f + 0.01f * static_cast<float>(step); });
  if (step % 2 == 1) document.parts.settings["step"] = std::to_string(step);
  if (step % 3 == 2) document.parts.shelf[0].payload.assign(20000, std::byte(step));
  return document;
}

inline std::uint64_t stateOf(const Document& document) {
  Hasher hasher;
  ByteWriter bytes;
  bytes.put(fieldHash(document.field));
  for (const auto& [name, value] : document.parts.settings) bytes.put(name + "=" + value + ";");
  for (const ShelfItem& item : document.parts.shelf) bytes.put(std::span(item.payload));
  hasher.add(bytes.bytes());
  return hasher.result();
}

}  // namespace bozzetto::testing
