// Documents and files for tests of scenes.
#pragma once
#include <string>

#include "bozzetto/scene/scene_file.hpp"
#include "field/test_fields.hpp"
#include "support/folder.hpp"

namespace bozzetto::testing {

inline Bytes bytesOf(std::string_view text) {
  const auto raw = std::as_bytes(std::span(text.data(), text.size()));
  return {raw.begin(), raw.end()};
}

inline Bytes smallPng() { return bytesOf("\x89PNG\r\n\x1a\n and the rest of a picture"); }

/// Something in every part; the clay has runs, own blocks and several colours.
inline Document sampleDocument() {
  Document document;
  document.field = ball<8>(30.5f, {3, -4, 5}, {10, 20, 30});
  fill<8>(document.field, {{20, -20, -20}, {40, 0, 0}},
          [](Key p) { return static_cast<float>((p.i * 31 + p.j * 17 + p.k * 7) & 15) / 15.0f; });
  fill<8>(document.field, {{8, 0, 0}, {15, 7, 39}}, [](Key) { return 1.5f; }, {200, 1, 2});
  document.field.scale = {0.25, 0.4f};
  document.parts.settings = {{"name", "Faun"}, {"theme", "dusk"}, {"empty", ""}};
  document.parts.view.camera.target = {1, 2, 3};
  document.parts.view.camera.distance = 12.5;
  document.parts.view.lights = {Light{}, Light{{1, 0, 0}, {255, 200, 180}, 2.5, 0.5, true}};
  document.parts.view.workspace = WorkspaceBox{{-10, -10, -10}, {10, 10, 10}};
  document.parts.shelf = {{"thumb", {"round", "soft"}, bytesOf("{\"op\":\"tool\"}"), smallPng()},
                          {"häkchen", {}, {}, {}}};
  document.parts.thumbnail = smallPng();
  return document;
}

inline void expectEqual(const Document& a, const Document& b) {
  EXPECT_EQ(fieldHash(a.field), fieldHash(b.field));
  EXPECT_EQ(a.field.scale, b.field.scale);
  EXPECT_EQ(a.field.tree.nodeCount(), b.field.tree.nodeCount());
  EXPECT_TRUE(a.parts == b.parts);
}

}  // namespace bozzetto::testing
