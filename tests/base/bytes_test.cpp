// Numbers survive the way through bytes, in a fixed order, and no read passes the end.
#include "bozzetto/base/bytes.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>

namespace bozzetto {
namespace {

template <class T>
class BytesOf : public testing::Test {};

using Numbers =
    testing::Types<std::uint8_t, std::int8_t, std::uint16_t, std::int16_t, std::uint32_t,
                   std::int32_t, std::uint64_t, std::int64_t, float, double>;
TYPED_TEST_SUITE(BytesOf, Numbers);

TYPED_TEST(BytesOf, ExtremesComeBack) {
  using Limits = std::numeric_limits<TypeParam>;
  const TypeParam values[] = {Limits::lowest(), Limits::min(), Limits::max(),
                              TypeParam(0),     TypeParam(1),  TypeParam(-1)};
  ByteWriter writer;
  for (const TypeParam value : values) writer.put(value);
  ASSERT_EQ(writer.bytes().size(), sizeof(values));
  ByteReader reader(writer.bytes());
  for (const TypeParam value : values) EXPECT_EQ(reader.get<TypeParam>(), value);
  EXPECT_EQ(reader.remaining(), 0u);
}

TYPED_TEST(BytesOf, EveryTruncationIsAnError) {
  ByteWriter writer;
  writer.put(TypeParam(77));
  for (std::size_t size = 0; size < sizeof(TypeParam); ++size) {
    ByteReader reader(std::span(writer.bytes()).first(size));
    EXPECT_THROW(reader.get<TypeParam>(), Error) << size << " bytes";
    EXPECT_EQ(reader.position(), 0u) << "a failed read moves nothing";
  }
}

TEST(Bytes, LowByteComesFirst) {
  ByteWriter writer;
  writer.put(std::uint32_t{0x04030201});
  writer.put(1.0f);
  const unsigned char expected[] = {1, 2, 3, 4, 0x00, 0x00, 0x80, 0x3f};
  ASSERT_EQ(writer.bytes().size(), sizeof(expected));
  EXPECT_EQ(std::memcmp(writer.bytes().data(), expected, sizeof(expected)), 0);
}

TEST(Bytes, TextIsWrittenAsItIs) {
  ByteWriter writer;
  writer.put(std::string_view("clay"));
  ByteReader reader(writer.bytes());
  const auto raw = reader.take(4);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(raw.data()), raw.size()), "clay");
}

TEST(Bytes, TakingTheBufferEmptiesTheWriter) {
  ByteWriter writer;
  writer.put(std::uint16_t{5});
  EXPECT_EQ(writer.take().size(), 2u);
  EXPECT_TRUE(writer.bytes().empty());
}

TEST(Bytes, ErrorNamesFileEndAndPosition) {
  const Bytes bytes(10);
  ByteReader reader(bytes, "scan.ply");
  reader.skip(8);
  try {
    reader.get<std::uint32_t>();
    FAIL() << "read past the end";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "scan.ply: ends at byte 10, 4 bytes expected at byte 8");
  }
}

TEST(Bytes, AbsurdLengthsDoNotWrapAround) {
  const Bytes bytes(10);
  ByteReader reader(bytes);
  reader.skip(3);
  EXPECT_THROW(reader.take(std::numeric_limits<std::size_t>::max()), Error);
  EXPECT_THROW(reader.skip(std::numeric_limits<std::size_t>::max() - 2), Error);
  EXPECT_EQ(reader.take(7).size(), 7u);
  EXPECT_EQ(reader.take(0).size(), 0u);
}

}  // namespace
}  // namespace bozzetto
