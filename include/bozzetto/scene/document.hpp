// Everything a scene file holds, as plain values. Copies share the clay's blocks.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/clay/stroke.hpp"
#include "bozzetto/field/field.hpp"
#include "bozzetto/scene/shelf.hpp"
#include "bozzetto/scene/view.hpp"

namespace bozzetto {

/// 16 random bytes that a scene gets once and keeps over all saves: what its history knows it by.
struct SceneIdentity {
  std::array<std::uint8_t, 16> bytes{};

  /// From the system's source of randomness.
  static SceneIdentity random();
  /// 32 hexadecimal digits.
  std::string text() const;
  friend bool operator==(const SceneIdentity&, const SceneIdentity&) = default;
};

/// All but the clay.
struct SceneParts {
  SceneIdentity identity = SceneIdentity::random();
  std::map<std::string, std::string> settings;  ///< whatever the program wants to find again
  View view;
  std::vector<ShelfItem> shelf;
  Bytes thumbnail;  ///< a PNG, or empty
  Bytes solid;      ///< the solid being worked on, as encodeSolid gives it, or empty
  std::vector<clay::Support> supports;  ///< what pushed and gripped clay meets
  clay::Stiffness stiffness;            ///< painted

  friend bool operator==(const SceneParts&, const SceneParts&) = default;
};

struct Document {
  Clay field;
  SceneParts parts;
};

}  // namespace bozzetto
