#include "clay/cells.hpp"

#include <sys/mman.h>

#include <new>

namespace bozzetto::clay {

void* zeroPages(std::size_t bytes) {
  constexpr int kind = MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE;
  void* pages = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, kind, -1, 0);
  if (pages == MAP_FAILED) throw std::bad_alloc();
  return pages;
}

void givePagesBack(void* pages, std::size_t bytes) noexcept { munmap(pages, bytes); }

}  // namespace bozzetto::clay
