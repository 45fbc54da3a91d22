// Somebody who works on a document with a history, for tests: small random changes of clay and
// solids, moves, and the hash of both after each.
#pragma once
#include <map>
#include <random>

#include "bozzetto/base/hash.hpp"
#include "bozzetto/history/recovery.hpp"
#include "bozzetto/solid/solid_codec.hpp"
#include "field/test_fields.hpp"

namespace bozzetto::testing {

using Block = CornerBlock<8>;

/// A box of a few corners somewhere in a small room: density, colour, or both.
inline Delta<Block> randomChange(Clay& clay, std::mt19937& random) {
  const auto at = [&] { return static_cast<std::int32_t>(random() % 40u) - 20; };
  const Key low{at(), at(), at()};
  const auto kind = random() % 4u;
  Edit<Block> edit(clay.tree);
  if (random() % 16u == 0) {
    const auto grey = Block::uniform(1, packAttributes({90, 90, 90}));
    edit.replace({{low.i / 8, low.j / 8, low.k / 8}, 3}, random() % 2u ? grey : nullptr);
  }
  for (std::int32_t i = 0; i < 3; ++i)
    for (std::int32_t j = 0; j < 3; ++j)
      for (std::int32_t k = 0; k < 4; ++k) {
        const Key corner = low + Key{i, j, k};
        Block& block = edit.write(BlockGeometry<8>::blockOf(corner));
        const int place = BlockGeometry<8>::indexOf(corner);
        if (kind != 0) block.value[place] = static_cast<float>(random() % 65536u) / 65535.0f;
        if (kind != 1) block.attributes[place] = static_cast<Attributes>(random());
      }
  return edit.commit();
}

inline BytesRef bytesOf(std::string_view text) {
  if (text.empty()) return nullptr;
  const auto bytes = std::as_bytes(std::span(text));
  return std::make_shared<const Bytes>(bytes.begin(), bytes.end());
}

/// Another solid made from one: a block where there was none, a point moved, more damping, none.
inline SolidRef changedSolid(const SolidRef& before, std::mt19937& random) {
  const auto kind = random() % 4u;
  if (before && kind == 0) return nullptr;
  Solid solid;
  if (before) {
    solid = *before;
  } else {
    NamedLattice block = makeBlock({});
    solid.control = std::move(block.lattice);
    solid.names = std::move(block.names);
  }
  if (kind == 1) solid.settings.damping += 0.125;
  auto& points = solid.control.points;
  points[random() % points.size()] += glm::dvec3(0.25, 0, -0.5);
  return std::make_shared<const Solid>(std::move(solid));
}

/// Of all that a history brings back.
inline std::uint64_t stateHash(const Clay& clay, const Beside& beside) {
  std::uint64_t hash = fieldHash(clay);
  if (beside.solid) hash ^= hash64(encodeSolid(beside.solid));
  if (beside.supports) hash ^= 3 * hash64(*beside.supports);
  if (beside.ledger) hash ^= 5 * hash64(*beside.ledger);
  return hash;
}
inline std::uint64_t stateHash(const OpenedHistory<8>& opened) {
  return stateHash(opened.field, opened.history.beside());
}

struct Sitting {
  std::mt19937 random{1};
  Clay clay;
  History<8> history;
  std::map<StepNumber, std::uint64_t> hashes{{0, fieldHash(Clay{})}};  ///< of every state seen

  Sitting() = default;
  explicit Sitting(OpenedHistory<8> opened)
      : clay(std::move(opened.field)), history(std::move(opened.history)) {
    hashes[history.place()] = hash();
  }

  StepNumber change(const std::string& label = "stroke") {
    auto delta = std::make_shared<const Delta<Block>>(randomChange(clay, random));
    Beside beside = history.beside();
    if (random() % 4u == 0) beside.solid = changedSolid(beside.solid, random);
    if (random() % 4u == 0)
      beside.supports = bytesOf(std::string(random() % 3u, 'S') + "with a sculpture");
    if (random() % 2u == 0) beside.ledger = bytesOf(std::to_string(random() % 5u));
    const StepNumber step =
        history.push(std::move(delta), {label, clay.scale, clay.scale}, std::move(beside));
    hashes[step] = hash();
    return step;
  }

  std::string goTo(StepNumber state) {
    const auto journey = history.goTo(state, clay.tree, clay.scale);
    clay.scale = journey.scale;
    return journey.trouble;
  }
  void undo(std::size_t count = 1) { goTo(history.tree().undoTarget(count)); }
  void redo(std::size_t count = 1) { goTo(history.tree().redoTarget(count)); }

  /// A stroke, an undo, a redo or a jump.
  void anything() {
    const auto kind = random() % 10u;
    if (kind == 6) return undo(1 + random() % 3u);
    if (kind == 7) return redo(1 + random() % 3u);
    if (kind == 8 && history.tree().size() > 0) {
      const auto steps = history.steps();
      goTo(steps[random() % steps.size()].number);
      return;
    }
    change();
  }

  std::uint64_t hash() const { return stateHash(clay, history.beside()); }
  bool asItWas() const {
    const auto known = hashes.find(history.place());
    return known != hashes.end() && known->second == hash();
  }
};

}  // namespace bozzetto::testing
