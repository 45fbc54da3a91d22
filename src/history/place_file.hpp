// The file `place` of a history: the last move in the tree. Replaced as a whole at every move.
#pragma once
#include <string>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/history/step_tree.hpp"

namespace bozzetto::undo {

struct PlaceRecord {
  HistoryIdentity identity{};
  HistoryPlace place;
  std::uint64_t savedMoment = 0;  ///< of the last save of the scene that we know of
};

Bytes encodePlace(const PlaceRecord& record);

/// Throws Error with `name` first.
PlaceRecord decodePlace(std::span<const std::byte> bytes, const std::string& name);

}  // namespace bozzetto::undo
