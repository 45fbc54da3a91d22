// A checksum at the end of every database page, so that no byte of a scene file can change unseen:
// not in rows, not in SQLite's own structures, not in the slack between them.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace bozzetto {

inline constexpr std::size_t kPageBytes = 8192;
inline constexpr std::size_t kPageCheckBytes = 8;  ///< reserved at the end of a page

/// The name of the SQLite file layer that writes the checksums; made known to SQLite on first use.
const char* pageCheckLayer();

/// The first page (from 1) of a database image whose checksum does not hold. Pages of zeros were
/// never written and hold. In parallel.
std::optional<std::size_t> firstBadPage(std::span<const std::byte> file);

}  // namespace bozzetto
