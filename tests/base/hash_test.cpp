#include "bozzetto/base/hash.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string_view>
#include <vector>

namespace bozzetto {
namespace {

std::span<const std::byte> bytesOf(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

// The self-test of xxHash itself (its sanity_test.c): pseudo-random bytes, XXH3_64bits, seed 0.
TEST(Hash, KnownAnswers) {
  struct Known {
    std::size_t length;
    std::uint64_t hash;
  };
  std::vector<std::byte> bytes(403);
  std::uint64_t generator = 2654435761u;
  for (std::byte& byte : bytes) {
    byte = static_cast<std::byte>(generator >> 56);
    generator *= 11400714785074694797u;
  }
  for (const auto& [length, hash] :
       {Known{0, 0x2d06800538d394c2u}, Known{1, 0xc44bdff4074eecdbu}, Known{6, 0x27b56a84cd2d7325u},
        Known{12, 0xa713daf0dfbb77e7u}, Known{24, 0xa3fe70bf9d3510ebu},
        Known{48, 0x397da259ecba1f11u}, Known{80, 0xbcdefbbb2c47c90au},
        Known{195, 0xcd94217ee362ec3au}, Known{403, 0xcdeb804d65c6dea4u}})
    EXPECT_EQ(hash64(std::span(bytes).first(length)), hash) << length << " bytes";
}

TEST(Hash, PiecesGiveTheHashOfTheWhole) {
  std::vector<std::byte> bytes(3000);
  for (std::size_t n = 0; n < bytes.size(); ++n) bytes[n] = static_cast<std::byte>(n * n % 251);
  const std::uint64_t whole = hash64(bytes);
  for (const std::size_t piece : {1u, 7u, 64u, 255u, 256u, 1024u, 3000u}) {
    Hasher hasher;
    for (std::size_t begin = 0; begin < bytes.size(); begin += piece)
      hasher.add(std::span(bytes).subspan(begin, std::min(piece, bytes.size() - begin)));
    EXPECT_EQ(hasher.result(), whole) << "pieces of " << piece;
  }
}

TEST(Hash, ResultCanBeAskedOnTheWay) {
  Hasher hasher;
  EXPECT_EQ(hasher.result(), hash64({}));
  hasher.add(bytesOf("xx"));
  EXPECT_EQ(hasher.result(), hash64(bytesOf("xx")));
  hasher.add(bytesOf("hash"));
  EXPECT_EQ(hasher.result(), hash64(bytesOf("xxhash")));
}

TEST(Hash, EveryBitCounts) {
  std::vector<std::byte> bytes(300);
  std::set<std::uint64_t> seen{hash64(bytes)};
  for (std::size_t bit = 0; bit < bytes.size() * 8; ++bit) {
    bytes[bit / 8] ^= static_cast<std::byte>(1u << bit % 8);
    EXPECT_TRUE(seen.insert(hash64(bytes)).second) << "bit " << bit;
    bytes[bit / 8] ^= static_cast<std::byte>(1u << bit % 8);
  }
}

TEST(Hash, SixteenDigits) {
  EXPECT_EQ(hexDigits(0), "0000000000000000");
  EXPECT_EQ(hexDigits(0x0123456789abcdefu), "0123456789abcdef");
  EXPECT_EQ(hexDigits(~std::uint64_t{0}), "ffffffffffffffff");
}

}  // namespace
}  // namespace bozzetto
