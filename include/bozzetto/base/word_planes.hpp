// Words of 32 bits as four planes of bytes: equal exponents and colour channels come to lie
// together and compress.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "bozzetto/base/bytes.hpp"

namespace bozzetto {

/// The lowest byte of each, the next, …, the highest.
void putPlanes(ByteWriter& out, const std::vector<std::uint32_t>& words);

/// `count` words; all are known to be there before any is made.
std::vector<std::uint32_t> getPlanes(ByteReader& in, std::size_t count);

}  // namespace bozzetto
