#include "bozzetto/history/undo_stack.hpp"

#include "bozzetto/field/corner_block.hpp"

namespace bozzetto {

// Compiled here once, so that a mistake shows where it is made.
template class UndoStack<CornerBlock<8>, int>;

}  // namespace bozzetto
