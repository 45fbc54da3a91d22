// Memory of zeros for the arrays of a region. Boxes are mostly air, so pages are the system's until
// they are written; those of a finished stroke are kept for the next, for to be given a page costs
// more than to write zeros over what was left in it.
#pragma once
#include <cstddef>

namespace bozzetto::clay {

struct Pages {
  void* data = nullptr;
  std::size_t bytes = 0;
};

/// Zeros, so many bytes or more; throws std::bad_alloc. For several threads at once.
Pages takePages(std::size_t bytes);
/// They are kept, as far as no more than 32 MiB of memory stay in use by such.
void givePagesBack(Pages pages) noexcept;

}  // namespace bozzetto::clay
