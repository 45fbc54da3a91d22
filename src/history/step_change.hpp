// What a step changed: blocks of clay, and the solid that is worked on.
#pragma once
#include <memory>

#include "bozzetto/field/field.hpp"
#include "bozzetto/solid/solid.hpp"

namespace bozzetto::undo {

template <int Side>
struct StepChange {
  using DeltaPointer = std::shared_ptr<const Delta<CornerBlock<Side>>>;

  DeltaPointer clay;  ///< null: nothing is held
  SolidRef before{}, after{};

  const SolidRef& solid(Direction direction) const {
    return direction == Direction::forward ? after : before;
  }
};

}  // namespace bozzetto::undo
