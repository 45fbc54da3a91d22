// A checksum at the end of every database page, so that no byte of a scene file can change unseen:
// not in rows, not in SQLite's own structures, not in the slack between them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace bozzetto {

inline constexpr std::size_t kPageBytes = 8192;
inline constexpr std::size_t kPageCheckBytes = 8;  ///< reserved at the end of a page

/// Puts the checksum into its place at the end of page `number` (from 1).
void sealPage(std::span<std::byte, kPageBytes> page, std::uint64_t number);

/// The first page (from 1) of a database image whose checksum does not hold. Pages of zeros were
/// never written and hold. In parallel.
std::optional<std::size_t> firstBadPage(std::span<const std::byte> file);

}  // namespace bozzetto
