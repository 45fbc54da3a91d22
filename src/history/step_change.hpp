// What a step changed: blocks of clay, and what stands beside it.
#pragma once
#include <memory>

#include "bozzetto/field/field.hpp"
#include "bozzetto/history/beside.hpp"

namespace bozzetto::undo {

template <int Side>
struct StepChange {
  using DeltaPointer = std::shared_ptr<const Delta<CornerBlock<Side>>>;

  DeltaPointer clay;  ///< null: nothing is held
  Beside before{}, after{};

  const Beside& beside(Direction direction) const {
    return direction == Direction::forward ? after : before;
  }
};

}  // namespace bozzetto::undo
