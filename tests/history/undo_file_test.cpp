#include "history/undo_file.hpp"

#include <gtest/gtest.h>

#include <random>

#include "history/sittings.hpp"

namespace bozzetto {
namespace {

using testing::Block;
using undo::FileHead;
using undo::UndoFile;

FileHead sampleHead() {
  FileHead head;
  for (std::uint8_t n = 0; n < 16; ++n) head.identity[n] = n;
  head.moment = 77;
  head.step.number = 12;
  head.step.parent = 9;
  head.step.mark = 0x123456789abcdef0;
  head.step.parentMark = 42;
  head.step.time = 1'700'000'000'123;
  head.step.note = {"Strich über Ton", {0.5, 0.25f}, {0.25, 0.75f}};
  return head;
}

Delta<Block> dabs(Clay& clay, unsigned seed) {
  std::mt19937 random(seed);
  const auto at = [&] { return static_cast<std::int32_t>(random() % 24u) - 12; };
  Edit<Block> edit(clay.tree);
  for (int n = 0; n < 3; ++n) {
    const Key low{at(), at(), at()};
    for (std::int32_t i = 0; i < 12; ++i)
      for (std::int32_t j = 0; j < 12; ++j)
        for (std::int32_t k = 0; k < 12; ++k) {
          const Key corner = low + Key{i, j, k};
          Block& block = edit.write(BlockGeometry<8>::blockOf(corner));
          const int place = BlockGeometry<8>::indexOf(corner);
          block.value[place] = static_cast<float>(random() % 1000u) / 999.0f;
          block.attributes[place] = static_cast<Attributes>(random() % 5u) * 0x01020304u;
        }
  }
  return edit.commit();
}

/// Every kind of change: own blocks made, changed and gone, runs of uniform blocks, paint only.
Delta<Block> everyKind(Clay& clay) {
  Edit<Block> edit(clay.tree);
  const auto grey = Block::uniform(1, packAttributes({90, 90, 90}));
  edit.replace({{4, 0, -1000}, 3000}, grey);
  edit.replace({{-2, -2, -2}, 3}, nullptr);
  Block& painted = edit.write({0, 0, 0});
  for (Attributes& attributes : painted.attributes) attributes ^= 0x00ff00u;
  edit.write({7, 7, 7}).value[100] = 0.75f;
  return edit.commit();
}

TEST(UndoFile, leadsBackAndForth) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    Clay clay;
    dabs(clay, 100 + seed);
    const auto hashBefore = fieldHash(clay);
    const auto delta = seed == 0 ? everyKind(clay) : dabs(clay, seed);
    const auto hashAfter = fieldHash(clay);
    FileHead head = sampleHead();
    const Bytes bytes = undo::encodeUndoFile<8>(head, delta);
    const UndoFile<8> file(bytes, "test");
    const auto back = file.unpack(clay.tree, Direction::backward);
    back.apply(clay.tree, Direction::backward);
    ASSERT_EQ(fieldHash(clay), hashBefore);
    file.unpack(clay.tree, Direction::forward).apply(clay.tree, Direction::forward);
    ASSERT_EQ(fieldHash(clay), hashAfter);
    ASSERT_EQ(validate(clay), std::nullopt);
  }
}

TEST(UndoFile, aHeadComesBackAsItWas) {
  Clay clay;
  FileHead head = sampleHead();
  const auto delta = everyKind(clay);
  const Bytes picture(300, std::byte{7});
  const Bytes bytes = undo::encodeUndoFile<8>(head, delta, {picture, {}});
  const UndoFile<8> file(bytes, "test");
  const Step &read = file.head().step, &written = sampleHead().step;
  EXPECT_EQ(file.head().identity, sampleHead().identity);
  EXPECT_EQ(file.head().moment, 77u);
  EXPECT_EQ(read.number, written.number);
  EXPECT_EQ(read.parent, written.parent);
  EXPECT_EQ(read.mark, written.mark);
  EXPECT_EQ(read.parentMark, written.parentMark);
  EXPECT_EQ(read.time, written.time);
  EXPECT_EQ(read.note.label, written.note.label);
  EXPECT_EQ(read.note.before, written.note.before);
  EXPECT_EQ(read.note.after, written.note.after);
  EXPECT_EQ(read.bytes, bytes.size());
  EXPECT_TRUE(std::ranges::equal(file.thumbnail(), picture));
}

TEST(UndoFile, countsCorners) {
  Clay clay;
  const auto delta =
      testing::fill<8>(clay, {{0, 0, 0}, {9, 9, 9}}, [](Key p) { return p.i == 3 ? 0.0f : 0.5f; });
  FileHead head = sampleHead();
  undo::encodeUndoFile<8>(head, delta);
  EXPECT_EQ(head.step.changedCorners, 900u);
  Edit<Block> edit(clay.tree);
  edit.replace({{9, 9, 9}, 5}, Block::uniform(1, 0));
  undo::encodeUndoFile<8>(head, edit.commit());
  EXPECT_EQ(head.step.changedCorners, 5u * 512);
  EXPECT_EQ(head.step.changedBlocks, 5u);
}

TEST(UndoFile, aCheckpointHoldsAllTheClay) {
  Clay clay = testing::noise<8>(5, 90);
  const auto grey = Block::uniform(1, 0x123456);
  Edit<Block> edit(clay.tree);
  edit.replace({{40, 0, -5000}, 10000}, grey);
  edit.commit();
  undo::CheckpointWriter<8> writer(sampleHead(), clay.tree);
  Bytes bytes;
  for (Bytes part = writer.next(); !part.empty(); part = writer.next()) {
    bytes.insert(bytes.end(), part.begin(), part.end());
  }
  Clay read;
  read.tree = UndoFile<8>(bytes, "test").tree();
  EXPECT_EQ(fieldHash(read), fieldHash(clay));
  EXPECT_EQ(read.tree.nodeCount(), clay.tree.nodeCount());
  EXPECT_EQ(validate(read), std::nullopt);
}

TEST(UndoFile, refusesClayThatItDoesNotFit) {
  Clay clay;
  dabs(clay, 1);
  const auto delta = dabs(clay, 2);
  FileHead head = sampleHead();
  const Bytes bytes = undo::encodeUndoFile<8>(head, delta);
  const UndoFile<8> file(bytes, "test");
  Clay other = clay;
  dabs(other, 3);
  EXPECT_THROW(file.unpack(other.tree, Direction::backward), Error);
  EXPECT_THROW(file.unpack(clay.tree, Direction::forward), Error);
  EXPECT_NO_THROW(file.unpack(clay.tree, Direction::backward));
}

TEST(UndoFile, leadsFromSolidToSolid) {
  std::mt19937 random(4);
  SolidRef before;
  for (int n = 0; n < 40; ++n) {
    const SolidRef after = testing::changedSolid(before, random);
    const Bytes part = undo::encodeBesidePart(before, after);
    FileHead head = sampleHead();
    const Bytes bytes = undo::encodeUndoFile<8>(head, {}, {{}, part});
    const UndoFile<8> file(bytes, "test");
    ASSERT_EQ(encodeSolid(file.beside(before, Direction::forward).solid), encodeSolid(after));
    ASSERT_EQ(encodeSolid(file.beside(after, Direction::backward).solid), encodeSolid(before));
    EXPECT_THROW(file.beside(after, Direction::forward), Error);
    EXPECT_TRUE(undo::encodeBesidePart(after, after).empty());
    before = after;
  }
}

// A file as an older program wrote it: its head says so, and its head's hash.
Bytes asVersion(int version, Bytes bytes) {
  const Bytes now = bytes;
  const auto isHash = [&](std::size_t at) {
    ByteReader in(std::span<const std::byte>(now).subspan(at), "");
    return in.get<std::uint64_t>() == hash64(std::span(now).first(at));
  };
  std::size_t hashAt = 100;
  while (!isHash(hashAt)) ++hashAt;
  bytes[8] = static_cast<std::byte>(version);
  ByteWriter hash;
  hash.put(hash64(std::span(bytes).first(hashAt)));
  std::ranges::copy(hash.bytes(), bytes.begin() + static_cast<std::ptrdiff_t>(hashAt));
  return bytes;
}

// Those of version 1 know no solids; nothing else is different.
TEST(UndoFile, theFirstVersionIsStillRead) {
  Clay clay;
  const auto delta = dabs(clay, 2);
  FileHead head = sampleHead();
  const Bytes bytes = asVersion(1, undo::encodeUndoFile<8>(head, delta));
  const UndoFile<8> file(bytes, "test");
  EXPECT_EQ(file.unpack(KeyTree<Block>(), Direction::forward).changes.size(), delta.changes.size());
  EXPECT_EQ(file.beside({}, Direction::forward).solid, nullptr);
}

// Those of version 2 know solids only.
TEST(UndoFile, theSecondVersionIsStillRead) {
  std::mt19937 random(4);
  const SolidRef after = testing::changedSolid(nullptr, random);
  const Bytes whole = undo::encodeBesidePart({}, after);
  ByteReader in(whole, "");
  const auto solid = in.take(in.get<std::uint32_t>());
  FileHead head = sampleHead();
  const Bytes bytes = asVersion(2, undo::encodeUndoFile<8>(head, {}, {{}, solid}));
  const UndoFile<8> file(bytes, "test");
  const Beside here{nullptr, testing::bytesOf("supports")};
  const Beside there = file.beside(here, Direction::forward);
  EXPECT_EQ(encodeSolid(there.solid), encodeSolid(after));
  EXPECT_EQ(there.supports, here.supports) << "stay";
}

TEST(UndoFile, leadsFromSupportsToSupports) {
  const auto text = [](const BytesRef& bytes) {
    if (!bytes) return std::string();
    return std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  };
  const std::string long1(1000, 'x');
  const char* const cases[] = {"", "a table", "a table, a wall", "wall, a wall", "wall"};
  for (const char* first : cases) {
    for (const char* second : cases) {
      const auto beside = [&](const std::string& start) {
        return Beside{nullptr, testing::bytesOf(start + long1), testing::bytesOf(start),
                      testing::bytesOf(start + start)};
      };
      const Beside before = beside(first), after = beside(second);
      const Bytes part = undo::encodeBesidePart(before, after);
      EXPECT_LT(part.size(), 1200u) << "what both end with is there once";
      FileHead head = sampleHead();
      const Bytes bytes = undo::encodeUndoFile<8>(head, {}, {{}, part});
      const UndoFile<8> file(bytes, "test");
      const Beside on = file.beside(before, Direction::forward);
      const Beside back = file.beside(after, Direction::backward);
      EXPECT_EQ(text(on.supports), second + long1);
      EXPECT_EQ(text(on.ledger), second);
      EXPECT_EQ(text(on.stiffness), std::string(second) + second);
      EXPECT_EQ(text(back.supports), first + long1);
      EXPECT_EQ(text(back.ledger), first);
      EXPECT_EQ(text(back.stiffness), std::string(first) + first);
    }
  }
}

TEST(UndoFile, aCheckpointHoldsAllThatIsBeside) {
  std::mt19937 random(7);
  const Beside beside{testing::changedSolid(nullptr, random), testing::bytesOf("table"),
                      testing::bytesOf("12 added"), testing::bytesOf("soft")};
  const Clay clay;
  undo::CheckpointWriter<8> writer(sampleHead(), clay.tree, beside);
  Bytes bytes;
  for (Bytes more = writer.next(); !more.empty(); more = writer.next())
    bytes.insert(bytes.end(), more.begin(), more.end());
  const Beside read = UndoFile<8>(bytes, "test").beside();
  EXPECT_EQ(encodeSolid(read.solid), encodeSolid(beside.solid));
  EXPECT_EQ(*read.supports, *beside.supports);
  EXPECT_EQ(*read.ledger, *beside.ledger);
  EXPECT_EQ(*read.stiffness, *beside.stiffness);
}

const Bytes kPicture(20, std::byte{9});

// Reads everything that is in the file; true when it was taken for good.
bool sound(std::span<const std::byte> bytes, const Clay& before) {
  try {
    const UndoFile<8> file(bytes, "test");
    file.beside({}, Direction::forward);
    file.unpack(before.tree, Direction::forward);
    return true;
  } catch (const Error&) {
    return false;
  }
}

TEST(UndoFile, anyDamagedByteAndAnyMissingEndIsFound) {
  Clay clay;
  const Clay before = clay;
  const auto delta = testing::fill<8>(clay, {{0, 0, 0}, {4, 5, 9}}, [](Key p) {
    return static_cast<float>((p.i * 31 + p.j * 17 + p.k * 7) & 15) / 15.0f;
  });
  FileHead head = sampleHead();
  std::mt19937 random(1);
  const Bytes solid = undo::encodeBesidePart({}, testing::changedSolid(nullptr, random));
  Bytes bytes = undo::encodeUndoFile<8>(head, delta, {kPicture, solid});
  ASSERT_TRUE(sound(bytes, before));
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    for (int bit = 0; bit < 8; ++bit) {
      bytes[n] ^= static_cast<std::byte>(1 << bit);
      ASSERT_FALSE(sound(bytes, before)) << "byte " << n << " bit " << bit;
      bytes[n] ^= static_cast<std::byte>(1 << bit);
    }
    ASSERT_FALSE(sound(std::span(bytes).first(n), before)) << n << " bytes";
  }
  bytes.push_back(std::byte{0});
  EXPECT_FALSE(sound(bytes, before));
}

TEST(UndoFile, thePapersCornersAreKeptLikewise) {
  Field<1> clay = testing::noise<1>(3, 6);
  const auto hash = fieldHash(clay);
  const auto delta = testing::fill<1>(clay, {{2, 2, 2}, {9, 9, 9}}, [](Key) { return 0.25f; });
  FileHead head = sampleHead();
  const Bytes bytes = undo::encodeUndoFile<1>(head, delta);
  const undo::UndoFile<1> file(bytes, "test");
  file.unpack(clay.tree, Direction::backward).apply(clay.tree, Direction::backward);
  EXPECT_EQ(fieldHash(clay), hash);
  EXPECT_THROW(UndoFile<8>(bytes, "test"), Error);
}

}  // namespace
}  // namespace bozzetto
