// Memory for blocks: equal pieces from huge-page slabs, reused. A brush over new ground pays for
// the first touch of memory more than for anything else; the pool keeps what was touched.
#pragma once
#include <cstddef>

namespace bozzetto {

/// `size` bytes aligned to 64, from the pool of this size. Thread-safe. Throws std::bad_alloc, also
/// for new slabs while the machine has little memory left: better than being killed by the system.
void* allocateBlock(std::size_t size);

/// Gives back what allocateBlock(size) returned.
void releaseBlock(void* block, std::size_t size) noexcept;

}  // namespace bozzetto
