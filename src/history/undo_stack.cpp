// The stack is a template over blocks and lives in its header; this file proves that the header
// stands alone.
#include "bozzetto/history/undo_stack.hpp"
