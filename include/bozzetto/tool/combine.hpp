// Volume operations of a placed sculpture with the clay.
#pragma once
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <string_view>

#include "bozzetto/tool/dab.hpp"
#include "bozzetto/tool/sculpture.hpp"

namespace bozzetto {

/// With p the sculpture's density where it stands, scaled by what hold leaves free:
///   unite      v ← max(v, p), the sculpture's colours where it raises v
///   subtract   v ← min(v, 1 − p)
///   intersect  v ← min(v, p), and nothing outside its box
enum class Combining { unite, subtract, intersect };

/// "union", "subtract", "intersect".
std::string_view toText(Combining how);
std::optional<Combining> combiningNamed(std::string_view name);

struct CombinePose {
  glm::dvec3 at{0};  ///< where the world origin of the sculpture goes, world units
  glm::dquat rotation{1, 0, 0, 0};
  glm::dvec3 scale{1};
};

/// At {0, 0, 0}, unturned and unscaled, the sculpture stands where its own clay stands in the
/// world. Throws Error, before anything changes, for scales that are not above 0, for boxes that
/// leave the workspace and for sculptures that would grow beyond 2^32 corners. O(blocks in its box;
/// intersect: and of the clay).
template <int Side>
DabReport combine(Edit<CornerBlock<Side>>& edit, const FieldScale& scale,
                  std::shared_ptr<const Sculpture> sculpture, Combining how,
                  const CombinePose& pose);

extern template DabReport combine(Edit<CornerBlock<1>>&, const FieldScale&,
                                  std::shared_ptr<const Sculpture>, Combining, const CombinePose&);
extern template DabReport combine(Edit<CornerBlock<8>>&, const FieldScale&,
                                  std::shared_ptr<const Sculpture>, Combining, const CombinePose&);

/// Takes away all clay in the box of corners, what hold allows (hold < 128).
template <int Side>
DabReport clear(Edit<CornerBlock<Side>>& edit, const KeyBox& box);
/// Of that, what a lasso holds.
template <int Side>
DabReport clear(Edit<CornerBlock<Side>>& edit, const FieldScale& scale, const KeyBox& box,
                const Lasso& lasso);

extern template DabReport clear(Edit<CornerBlock<1>>&, const KeyBox&);
extern template DabReport clear(Edit<CornerBlock<8>>&, const KeyBox&);
extern template DabReport clear(Edit<CornerBlock<1>>&, const FieldScale&, const KeyBox&,
                                const Lasso&);
extern template DabReport clear(Edit<CornerBlock<8>>&, const FieldScale&, const KeyBox&,
                                const Lasso&);

}  // namespace bozzetto
